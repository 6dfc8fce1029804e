// SPDX-License-Identifier: GPL-3.0-or-later
// The files with materials that OBJ names by mtllib.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace loopmend {

struct MaterialLibrary {
  std::filesystem::path path;  ///< of the file
  std::map<std::string, std::string>
      color_pictures;  ///< material → picture of its colour (map_Kd), as the file names it
  std::map<std::string, std::vector<std::string>> statements;  ///< material → its lines that name no picture
  std::vector<std::string> pictures;                           ///< all that the file names, each once
};

/// What we need of it; statements that are not known are left alone. @throws ReadError as load_file
MaterialLibrary read_material_library(const std::filesystem::path& path);

}  // namespace loopmend
