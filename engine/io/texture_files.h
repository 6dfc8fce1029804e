// SPDX-License-Identifier: GPL-3.0-or-later
// Which picture, or which plain colour, the faces of a scan have by its material files.
#pragma once

#include "core/message.h"
#include "core/picture.h"
#include "core/types.h"
#include "io/material_library.h"
#include "mesh/material_table.h"
#include "mesh/scan_attributes.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace loopmend {

/// OBJ: usemtl names a material of a file that mtllib names. PLY as MeshLab has it: "comment TextureFile NAME", and the face
/// property texnumber where there are several. glTF and 3MF have materials and pictures in the file: their MaterialTable.
class TextureFiles {
 public:
  /// @param scan    kept by reference
  /// @param folder  of the scan; material files are looked for there
  TextureFiles(const ScanAttributes& scan, const std::filesystem::path& folder);

  /// The picture of a face of the file; it may not be there. One within the scan's file has a name beside it.
  std::optional<std::filesystem::path> picture_of(std::size_t face) const;
  /// @param path  as picture_of() named it. @throws ReadError as read_picture
  Picture read(const std::filesystem::path& path) const;
  /// The colour of its material (Kd, baseColorFactor).
  std::optional<Color> color_of(std::size_t face) const;
  /// The name of its material; null: none.
  const std::string* material_of(std::size_t face) const;
  /// Its number; −1: none.
  int material_number_of(std::size_t face) const;

  const std::vector<MaterialLibrary>& libraries() const { return libraries_; }
  /// PLY: the pictures in their order, as the file names them.
  const std::vector<std::string>& ply_pictures() const { return ply_pictures_; }
  /// PLY: the face property with the numbers of pictures; null: none.
  const AttributeColumn* picture_numbers() const { return numbers_; }
  /// Why material files cannot be used.
  const std::vector<Message>& problems() const { return problems_; }

  /// The name in a remark "comment TextureFile NAME" of PLY; empty where the remark is another one.
  static std::string name_in(const std::string& remark);

 private:
  const ScanMaterial* table_material_of(std::size_t face) const;
  std::filesystem::path name_of_picture(int picture) const;

  const ScanAttributes& scan_;
  std::filesystem::path folder_;
  std::vector<MaterialLibrary> libraries_;
  std::vector<std::string> ply_pictures_;
  std::vector<Message> problems_;
  const AttributeColumn* numbers_ = nullptr;
};

}  // namespace loopmend
