// SPDX-License-Identifier: GPL-3.0-or-later
// Materials, textures and pictures of glTF: read into a MaterialTable, and written from one.
#pragma once

#include "io/gltf_document.h"
#include "io/not_kept.h"
#include "mesh/material_table.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace loopmend {

/// All materials of the file, as text that is written again, with what is shown of them. Null where there are none.
/// Pictures at other texture coordinates than the first are left out, counted. @throws ReadError for damaged materials
std::shared_ptr<const MaterialTable> read_gltf_materials(GltfDocument& document, std::vector<NotKept>& not_kept);

/// What a glTF file has of a table: its materials with their textures, and the packed pictures. Pictures that cannot be
/// read are left out.
struct GltfMaterials {
  nlohmann::json members;  ///< "materials", "textures", "samplers", "extensionsUsed", …; without "images"
  std::string copyright;
  std::vector<ScanPicture> images;  ///< with their bytes

  /// The material for triangles without texture coordinates: itself where it has no pictures, else one of the same colour
  /// without them, made where it is first asked for.
  int without_pictures(int material);

 private:
  std::map<int, int> plain_;  ///< by the material that has pictures
};
GltfMaterials write_gltf_materials(const MaterialTable& table);

}  // namespace loopmend
