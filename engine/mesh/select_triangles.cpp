// SPDX-License-Identifier: GPL-3.0-or-later
#include "select_triangles.h"

namespace loopmend {

TriangleSelection select_triangles(const TriangleSoup& whole, const std::vector<char>& chosen) {
  TriangleSelection selection;
  TriangleSoup& soup = selection.soup;
  std::vector<int>& number = selection.point_number;
  number.assign(whole.points.size(), -1);
  std::vector<int> points, triangles;
  for (std::size_t f = 0; f < whole.triangles.size(); ++f) {
    if (!chosen[f]) continue;
    triangles.push_back(static_cast<int>(f));
    for (const int v : whole.triangles[f]) number[v] = 0;
  }
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    number[v] = static_cast<int>(points.size());
    points.push_back(static_cast<int>(v));
    soup.points.push_back(Vec3(whole.points[v]));
    if (!whole.colors.empty()) soup.colors.push_back(whole.colors[v]);
  }
  const auto numbered = [&](int v) { return number[v]; };
  for (const int f : triangles) {
    const Triangle& t = whole.triangles[f];
    soup.triangles.push_back({numbered(t[0]), numbered(t[1]), numbered(t[2])});
  }
  copy_rows(whole, points, triangles, soup);
  soup.continued = whole.continued;
  return selection;
}

}  // namespace loopmend
