// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/texture_files.h"

#include "core/error.h"
#include "core/path_text.h"
#include "io/picture_file.h"
#include "io/text_cursor.h"

#include <algorithm>
#include <cmath>

namespace loopmend {

namespace {

namespace fs = std::filesystem;

/// "Kd r g b", each 0..1.
std::optional<Color> diffuse_color(const std::vector<std::string>& statements) {
  for (const std::string& statement : statements) {
    TextCursor cursor(statement);
    if (!cursor.next_line() || cursor.next_token() != "Kd") continue;
    Color color{0, 0, 0, 255};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::optional<double> value = parse_double(cursor.next_token());
      if (!value || !std::isfinite(*value)) return {};
      color[k] = static_cast<unsigned char>(std::lround(255 * std::clamp(*value, 0.0, 1.0)));
    }
    return color;
  }
  return {};
}

}  // namespace

TextureFiles::TextureFiles(const ScanAttributes& scan, const fs::path& folder) : scan_(scan), folder_(folder) {
  for (const std::string& name : scan.material_libraries) {
    try {
      libraries_.push_back(read_material_library(folder / path_of_text(name)));
    } catch (const ReadError& error) {
      problems_.push_back(error.message());
    }
  }
  if (scan.materials)
    for (const ScanPicture& picture : scan.materials->pictures)
      if (!picture.problem.empty()) problems_.push_back(picture.problem);
  numbers_ = find_column(scan.faces, "texnumber");
  if (scan.format != "PLY" || (numbers_ && numbers_->is_list()))
    return;  // else it is not known which picture a face has
  for (const std::string& remark : scan.remarks)
    if (std::string name = name_in(remark); !name.empty()) ply_pictures_.push_back(std::move(name));
}

std::string TextureFiles::name_in(const std::string& remark) {
  static const std::string keyword = "comment TextureFile ";
  if (remark.substr(0, keyword.size()) != keyword) return {};
  std::string name = remark.substr(keyword.size());
  name.erase(0, name.find_first_not_of(' '));
  return name;
}

int TextureFiles::material_number_of(std::size_t face) const {
  for (const FaceNames& names : scan_.names)
    if (names.keyword == "usemtl") return face < names.of_face.size() ? names.of_face[face] : -1;
  return -1;
}

const std::string* TextureFiles::material_of(std::size_t face) const {
  const int number = material_number_of(face);
  for (const FaceNames& names : scan_.names)
    if (names.keyword == "usemtl" && number >= 0) return &names.names[number];
  return nullptr;
}

const ScanMaterial* TextureFiles::table_material_of(std::size_t face) const {
  const int number = scan_.materials ? material_number_of(face) : -1;
  if (number < 0 || static_cast<std::size_t>(number) >= scan_.materials->materials.size()) return nullptr;
  return &scan_.materials->materials[number];
}

/// Pictures in the scan's file: the name is its own, with their number.
fs::path TextureFiles::name_of_picture(int picture) const {
  const ScanPicture& mine = scan_.materials->pictures[picture];
  return mine.path.empty() ? path_of_text(path_text(scan_.file) + ", picture " + std::to_string(picture)) : mine.path;
}

Picture TextureFiles::read(const fs::path& path) const {
  if (scan_.materials)
    for (std::size_t k = 0; k < scan_.materials->pictures.size(); ++k)
      if (const ScanPicture& picture = scan_.materials->pictures[k];
          !picture.bytes.empty() && path == name_of_picture(static_cast<int>(k)))
        return read_picture(FileContent{path, picture.bytes});
  return read_picture(path);
}

std::optional<fs::path> TextureFiles::picture_of(std::size_t face) const {
  if (!ply_pictures_.empty()) {
    const double number = numbers_ ? numbers_->value(face) : 0;
    if (!(number >= 0) || number >= static_cast<double>(ply_pictures_.size())) return {};
    return folder_ / ply_pictures_[number];
  }
  if (const ScanMaterial* material = table_material_of(face)) {
    if (material->picture < 0 || !scan_.materials->pictures[material->picture].problem.empty()) return {};
    return name_of_picture(material->picture);
  }
  if (const std::string* material = material_of(face))
    for (const MaterialLibrary& library : libraries_)
      if (const auto named = library.color_pictures.find(*material); named != library.color_pictures.end())
        return (library.path.has_parent_path() ? library.path.parent_path() : fs::path(".")) /
               path_of_text(named->second);
  return {};
}

std::optional<Color> TextureFiles::color_of(std::size_t face) const {
  if (const ScanMaterial* material = table_material_of(face)) return material->color;
  if (const std::string* material = material_of(face))
    for (const MaterialLibrary& library : libraries_)
      if (const auto lines = library.statements.find(*material); lines != library.statements.end())
        return diffuse_color(lines->second);
  return {};
}

}  // namespace loopmend
