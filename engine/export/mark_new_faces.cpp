// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/mark_new_faces.h"

#include "io/format_writers.h"
#include "mesh/scan_attributes.h"

#include <algorithm>
#include <memory>
#include <string>

namespace loopmend {

namespace {

std::size_t count_new_faces(const TriangleSoup& soup) {
  std::size_t count = 0;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) count += triangle_row(soup, f) < 0;
  return count;
}

/// Adds the column, or puts it where the file has one of that name; 0 where it is no whole number.
void mark_by_property(const ScanAttributes& scan, ScanAttributes& continued, std::size_t count) {
  const AttributeColumn* given = find_column(scan.faces, "patch");
  const bool usable = given && !given->is_list();
  AttributeColumn column("patch", usable ? given->type() : ScalarType::uint8);
  for (std::size_t f = 0; f < count; ++f) column.push(1);
  if (usable)
    continued.faces[static_cast<std::size_t>(given - scan.faces.data())] = std::move(column);
  else if (!given)
    continued.faces.push_back(std::move(column));
}

FaceNames& names_under(const std::string& keyword, ScanAttributes& attributes) {
  for (FaceNames& names : attributes.names)
    if (names.keyword == keyword) return names;
  return attributes.names.emplace_back(FaceNames{keyword, {}, {}});
}

/// The scan's own names stay what they are; where it has none under the keyword, it gets an empty table.
void mark_by_name(const std::string& keyword, TriangleSoup& soup, ScanAttributes& continued, std::size_t count) {
  const std::string label = "loopmend_patch";
  if (!find_names(*soup.attributes, keyword)) {
    auto scan = std::make_shared<ScanAttributes>(*soup.attributes);
    names_under(keyword, *scan);
    soup.attributes = std::move(scan);
  }
  FaceNames& names = names_under(keyword, continued);
  if (names.names.empty()) names.names = find_names(*soup.attributes, keyword)->names;
  auto at = std::find(names.names.begin(), names.names.end(), label);
  if (at == names.names.end()) at = names.names.insert(names.names.end(), label);
  names.of_face.assign(count, static_cast<int>(at - names.names.begin()));
}

}  // namespace

bool mark_new_faces(const std::filesystem::path& path, TriangleSoup& soup) {
  const Format format = format_of(path);
  if (format == Format::stl || format == Format::off) return false;
  if (!soup.attributes) soup.attributes = std::make_shared<ScanAttributes>();
  auto continued = std::make_shared<ScanAttributes>(soup.continued ? *soup.continued : ScanAttributes{});
  const std::size_t count = count_new_faces(soup);
  if (format == Format::ply)
    mark_by_property(*soup.attributes, *continued, count);
  else
    mark_by_name(format == Format::obj ? "g" : "o", soup, *continued, count);
  soup.continued = std::move(continued);
  return true;
}

}  // namespace loopmend
