// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/written_triangles.h"

#include "io/format_writers.h"

#include <algorithm>

namespace loopmend {

namespace {

const ScanAttributes* continued_of(const TriangleSoup& soup) { return soup.continued.get(); }

/// All three or none.
std::array<int, 3> places(const WrittenFace& face, const CornerNumbers& numbers, const TriangleSoup& soup,
                          CornerValues ScanAttributes::*values) {
  constexpr std::array<int, 3> none = {-1, -1, -1};
  if (face.corners.empty() || !face.row.table) return none;
  const CornerValues& mine = face.row.table->*values;
  if (mine.dimension == 0 || mine.at.empty()) return none;
  std::array<int, 3> result{};
  const int first = face.row.table == continued_of(soup) ? static_cast<int>(numbers.old_count()) : 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const int at = face.corners[k] < 0 ? -1 : mine.at[face.corners[k]];
    if (at < 0) return none;
    result[k] = first + at;
  }
  return result;
}

/// Names of the file's faces, and those that `continued` adds.
std::vector<std::string> all_names(const TriangleSoup& soup, std::string_view keyword) {
  const FaceNames* given = find_names(attributes_of(soup), keyword);
  const FaceNames* more = soup.continued ? find_names(*soup.continued, keyword) : nullptr;
  if (more && (!given || more->names.size() >= given->names.size())) return more->names;
  return given ? given->names : std::vector<std::string>{};
}

}  // namespace

CornerNumbers::CornerNumbers(const TriangleSoup& soup, CornerValues ScanAttributes::*values)
    : old_(&(attributes_of(soup).*values)),
      continued_(soup.continued ? &(*soup.continued.*values) : nullptr),
      old_count_(old_->count()) {}

double CornerNumbers::value(int at, int component) const {
  const auto place = static_cast<std::size_t>(at);
  const CornerValues& table = place < old_count_ ? *old_ : *continued_;
  if (component >= table.dimension) return 0;
  return table.values[(place < old_count_ ? place : place - old_count_) * static_cast<std::size_t>(table.dimension) +
                      static_cast<std::size_t>(component)];
}

std::vector<WrittenTriangle> written_triangles(const TriangleSoup& soup) {
  std::vector<WrittenTriangle> result;
  result.reserve(soup.triangles.size());
  const ScanAttributes& scan = attributes_of(soup);
  const CornerNumbers texture(soup, &ScanAttributes::texture), normals(soup, &ScanAttributes::normals);
  const FaceNames* objects = find_names(scan, "o");
  const FaceNames* materials = find_names(scan, "usemtl");
  for_each_triangle(soup, [&](const WrittenFace& face) {
    WrittenTriangle& triangle = result.emplace_back();
    std::copy(face.vertices.begin(), face.vertices.end(), triangle.points.begin());
    triangle.row = face.row;
    triangle.texture = places(face, texture, soup, &ScanAttributes::texture);
    triangle.normals = places(face, normals, soup, &ScanAttributes::normals);
    if (objects) triangle.object = name_of(*objects, face.row);
    if (materials) triangle.material = name_of(*materials, face.row);
  });
  return result;
}

std::vector<std::string> object_names(const TriangleSoup& soup) { return all_names(soup, "o"); }

MaterialTable written_materials(const TriangleSoup& soup) {
  MaterialTable table;
  if (const auto& given = attributes_of(soup).materials) table = *given;
  if (soup.continued && soup.continued->materials) table = *soup.continued->materials;
  const std::vector<std::string> names = all_names(soup, "usemtl");
  for (std::size_t k = table.materials.size(); k < names.size(); ++k) table.materials.push_back({names[k], {}, -1, {}});
  return table;
}

}  // namespace loopmend
