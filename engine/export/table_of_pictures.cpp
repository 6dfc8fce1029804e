// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/table_of_pictures.h"

#include "core/path_text.h"
#include "io/texture_files.h"
#include "mesh/material_table.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace loopmend {

namespace {

namespace fs = std::filesystem;

/// glTF knows no other kinds.
bool is_png_or_jpeg(const fs::path& path) {
  std::array<char, 4> bytes{};
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), bytes.size());
  const std::string_view begin(bytes.data(), bytes.size());
  return begin == "\x89PNG" || begin.substr(0, 2) == "\xFF\xD8";
}

/// The pictures of a table, each once.
class PictureList {
 public:
  PictureList(MaterialTable& table, std::vector<Message>& problems) : table_(table), problems_(problems) {}

  /// −1: it cannot be in the file, which is said once.
  int number_of(const fs::path& path) {
    const auto [entry, is_new] = numbers_.try_emplace(path_text(path), -1);
    if (!is_new) return entry->second;
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) {
      problems_.push_back(say("The picture %1 is not there, and not in the output.", path_text(path)));
    } else if (!is_png_or_jpeg(path)) {
      problems_.push_back(say("The picture %1 is neither PNG nor JPEG, and not in the output.", path_text(path)));
    } else {
      entry->second = static_cast<int>(table_.pictures.size());
      ScanPicture picture;
      picture.name = path_text(path.filename());
      picture.path = fs::absolute(path);
      table_.pictures.push_back(std::move(picture));
    }
    return entry->second;
  }

 private:
  MaterialTable& table_;
  std::vector<Message>& problems_;
  std::map<std::string, int> numbers_;
};

/// PLY: the number of its picture is the material of a face. @returns the names of the materials
FaceNames names_by_picture(const ScanAttributes& scan, const TextureFiles& files) {
  FaceNames names{"usemtl", files.ply_pictures(), {}};
  const std::size_t faces = scan.ends.empty() ? scan.triangle_count : scan.ends.size();
  const auto count = static_cast<double>(names.names.size());
  for (std::size_t f = 0; f < faces; ++f) {
    const double number = files.picture_numbers() ? files.picture_numbers()->value(f) : 0;
    names.of_face.push_back(number >= 0 && number < count ? static_cast<int>(number) : -1);
  }
  return names;
}

}  // namespace

std::shared_ptr<const ScanAttributes> with_table_of_pictures(const ScanAttributes& scan,
                                                             std::vector<Message>& problems) {
  if (scan.materials || (scan.format != "PLY" && scan.format != "OBJ")) return nullptr;
  const TextureFiles files(scan, scan.file.parent_path());
  if (files.ply_pictures().empty() && scan.material_libraries.empty()) return nullptr;
  auto result = std::make_shared<ScanAttributes>(scan);
  if (scan.format == "PLY") {
    result->names.push_back(names_by_picture(scan, files));
    std::erase_if(result->faces, [](const AttributeColumn& column) { return column.name() == "texnumber"; });
    std::erase_if(result->remarks, [](const std::string& remark) { return !TextureFiles::name_in(remark).empty(); });
  }
  const auto names = std::find_if(result->names.begin(), result->names.end(),
                                  [](const FaceNames& mine) { return mine.keyword == "usemtl"; });
  if (names == result->names.end()) return nullptr;
  auto table = std::make_shared<MaterialTable>();
  PictureList pictures(*table, problems);
  for (const std::string& name : names->names) table->materials.push_back({name, {}, -1, {}});
  std::vector<char> known(table->materials.size(), 0);
  for (std::size_t f = 0; f < names->of_face.size(); ++f) {
    const int number = names->of_face[f];
    if (number < 0 || std::exchange(known[number], 1)) continue;
    ScanMaterial& material = table->materials[number];
    material.color = files.color_of(f);
    if (const std::optional<fs::path> path = files.picture_of(f)) material.picture = pictures.number_of(*path);
  }
  if (table->pictures.empty())  // else they are said where the pictures are painted on
    for (const Message& problem : files.problems())
      problems.push_back(say("The scan's material file cannot be used: %1", problem));
  result->materials = std::move(table);
  result->format = "glTF";
  return result;
}

}  // namespace loopmend
