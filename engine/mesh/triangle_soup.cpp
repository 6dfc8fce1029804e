// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/triangle_soup.h"

#include "mesh/scan_attributes.h"

#include <numeric>
#include <utility>

namespace loopmend {

namespace {

int row_of(const std::vector<int>& rows, std::size_t count, std::size_t k) {
  if (!rows.empty()) return k < rows.size() ? rows[k] : -1;
  return k < count ? static_cast<int>(k) : -1;
}

void drop_attributes(TriangleSoup& soup) {
  soup.attributes = soup.continued = nullptr;
  soup.point_rows.clear();
  soup.triangle_rows.clear();
}

}  // namespace

int point_row(const TriangleSoup& soup, std::size_t point) {
  return soup.attributes ? row_of(soup.point_rows, soup.attributes->point_count, point) : -1;
}

int triangle_row(const TriangleSoup& soup, std::size_t triangle) {
  return soup.attributes ? row_of(soup.triangle_rows, soup.attributes->triangle_count, triangle) : -1;
}

void copy_rows(const TriangleSoup& from, const std::vector<int>& points, const std::vector<int>& triangles,
               TriangleSoup& to) {
  drop_attributes(to);
  if (!from.attributes) return;
  to.attributes = from.attributes;
  for (int v : points) to.point_rows.push_back(v < 0 ? -1 : point_row(from, static_cast<std::size_t>(v)));
  for (int f : triangles) to.triangle_rows.push_back(f < 0 ? -1 : triangle_row(from, static_cast<std::size_t>(f)));
  // An empty list would stand for all.
  if (to.point_rows.empty()) to.point_rows.push_back(-1);
  if (to.triangle_rows.empty()) to.triangle_rows.push_back(-1);
}

TriangleSoup with_faces(const TriangleSoup& soup, const std::vector<char>& kept) {
  TriangleSoup result = soup;
  result.triangles.clear();
  std::vector<int> points(soup.points.size()), rows;
  std::iota(points.begin(), points.end(), 0);
  for (std::size_t f = 0; f < kept.size(); ++f)
    if (kept[f]) rows.push_back(static_cast<int>(f));
  for (const int f : rows) result.triangles.push_back(soup.triangles[static_cast<std::size_t>(f)]);
  copy_rows(soup, points, rows, result);
  return result;
}

void append(TriangleSoup& all, const TriangleSoup& part) {
  if (all.points.empty() && all.triangles.empty()) {
    all = part;
    return;
  }
  constexpr Color white{255, 255, 255, 255};
  const int shift = static_cast<int>(all.points.size());
  drop_attributes(all);
  if (!part.colors.empty()) all.colors.resize(all.points.size(), white);
  all.points.insert(all.points.end(), part.points.begin(), part.points.end());
  all.colors.insert(all.colors.end(), part.colors.begin(), part.colors.end());
  if (!all.colors.empty()) all.colors.resize(all.points.size(), white);
  for (const Triangle& t : part.triangles) all.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
}

TriangleSoup joined(std::vector<TriangleSoup> parts) {
  if (parts.empty()) return {};
  TriangleSoup all = std::move(parts.front());
  for (std::size_t k = 1; k < parts.size(); ++k) append(all, parts[k]);
  return all;
}

}  // namespace loopmend
