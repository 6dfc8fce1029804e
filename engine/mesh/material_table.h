// SPDX-License-Identifier: GPL-3.0-or-later
// Materials and pictures that stand in the scan's own file, as glTF and 3MF have them.
#pragma once

#include "core/message.h"
#include "core/types.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace loopmend {

/// PNG, JPEG or another kind, packed as in the file.
struct ScanPicture {
  std::string name;            ///< of the file; empty: none
  std::string kind;            ///< media type: "image/png"; empty: not said
  std::string bytes;           ///< empty: `path`
  std::filesystem::path path;  ///< of a file beside the scan's, absolute; empty: `bytes`
  Message problem;             ///< a sentence: why there is neither
};

struct ScanMaterial {
  std::string name;            ///< as FaceNames "usemtl" has it
  std::optional<Color> color;  ///< sRGB
  int picture = -1;            ///< of its colour, in `pictures`; −1: none that can be shown
  std::string source;          ///< glTF: its text
};

/// The names of FaceNames "usemtl" are those of the materials, in their order.
struct MaterialTable {
  std::vector<ScanMaterial> materials;
  std::vector<ScanPicture> pictures;
  std::string source;                                         ///< glTF: textures, samplers and copyright, as text
  std::vector<std::pair<std::string, std::string>> metadata;  ///< 3MF: name, value
};

}  // namespace loopmend
