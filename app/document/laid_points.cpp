// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/laid_points.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace loopmend {
namespace {

bool comes_first(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

Points sorted(Points points) {
  std::sort(points.begin(), points.end(), comes_first);
  return points;
}

}  // namespace

Points with_laid_points(Points laid, const Points& before, const Points& after) {
  const Points old = sorted(before), now = sorted(after);
  std::set_difference(now.begin(), now.end(), old.begin(), old.end(), std::back_inserter(laid), comes_first);
  return sorted(std::move(laid));
}

LaidTriangles laid_triangles(const TriangleSoup& soup, const Points& laid) {
  LaidTriangles found;
  if (laid.empty()) return found;
  const auto is_laid = [&](int v) { return std::binary_search(laid.begin(), laid.end(), soup.points[v], comes_first); };
  for (const Triangle& t : soup.triangles) {
    if (std::none_of(t.begin(), t.end(), is_laid)) continue;
    const Vec3 &a = soup.points[t[0]], &b = soup.points[t[1]], &c = soup.points[t[2]];
    found.area += 0.5 * (b - a).cross(c - a).norm();
    ++found.count;
  }
  return found;
}

}  // namespace loopmend
