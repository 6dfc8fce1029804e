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

/// Adds the column to those of what is new, or puts it where the file has one of that name that is no list.
void put_column(const std::string& name, ScalarType type, const std::vector<double>& values,
                const std::vector<AttributeColumn>& scan, std::vector<AttributeColumn>& continued) {
  const AttributeColumn* given = find_column(scan, name);
  if (given && given->is_list()) return;
  AttributeColumn column(name, given ? given->type() : type);
  for (double value : values) column.push(value);
  if (given)
    continued[given - scan.data()] = std::move(column);
  else
    continued.push_back(std::move(column));
}

std::shared_ptr<ScanAttributes> continued_of(TriangleSoup& soup) {
  if (!soup.attributes) soup.attributes = std::make_shared<ScanAttributes>();
  return std::make_shared<ScanAttributes>(soup.continued ? *soup.continued : ScanAttributes{});
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
  const auto continued = continued_of(soup);
  const std::size_t count = count_new_faces(soup);
  if (format == Format::ply || format == Format::polydata)
    put_column("patch", ScalarType::uint8, std::vector<double>(count, 1), soup.attributes->faces, continued->faces);
  else
    mark_by_name(format == Format::obj ? "g" : "o", soup, *continued, count);
  soup.continued = continued;
  return true;
}

bool label_expected_deviation(const std::filesystem::path& path, TriangleSoup& soup,
                              const std::vector<double>& values) {
  const Format format = format_of(path);
  if (format != Format::ply && format != Format::polydata) return false;
  const auto continued = continued_of(soup);
  std::vector<double> rows;
  const std::size_t first = soup.points.size() - values.size();
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    if (point_row(soup, v) < 0) rows.push_back(v < first ? 0 : values[v - first]);
  put_column("expected_deviation", ScalarType::float32, rows, soup.attributes->points, continued->points);
  soup.continued = continued;
  return true;
}

}  // namespace loopmend
