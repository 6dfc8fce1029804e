// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/quality.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>
#include <vector>

namespace loopmend {

double min_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto angle = [](const Vec3& u, const Vec3& v) { return std::atan2(u.cross(v).norm(), u.dot(v)); };
  return std::min({angle(b - a, c - a), angle(c - b, a - b), angle(a - c, b - c)});
}

std::vector<Bend> bends(const Points& points, const Triangles& triangles, int count) {
  // The sides of all triangles in buckets by their lower vertex; each bucket in order.
  struct Side {
    int high, face;
  };
  std::vector<int> begin(points.size() + 1, 0);
  const auto lower = [&](const Triangle& t, int k) { return std::min(t[k], t[(k + 1) % 3]); };
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) ++begin[lower(t, k) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Side> sides(3 * triangles.size());
  std::vector<int> next(begin.begin(), begin.end() - 1);
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const Triangle& t = triangles[f];
      sides[next[lower(t, k)]++] = {std::max(t[k], t[(k + 1) % 3]), static_cast<int>(f)};
    }
  Points normal;
  normal.reserve(triangles.size());
  for (const Triangle& t : triangles) normal.push_back(unit_normal(points[t[0]], points[t[1]], points[t[2]]));
  std::vector<Bend> result;
  result.reserve(2 * triangles.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const auto first = sides.begin() + begin[v], last = sides.begin() + begin[v + 1];
    std::sort(first, last,
              [](const Side& a, const Side& b) { return std::tie(a.high, a.face) < std::tie(b.high, b.face); });
    for (auto s = first; s != last && s + 1 != last; ++s) {
      if (s->high != (s + 1)->high || s->face >= count) continue;
      result.push_back(
          {static_cast<int>(v), s->high, s->face, (s + 1)->face, normal[s->face].dot(normal[(s + 1)->face])});
    }
  }
  return result;
}

std::vector<std::pair<int, int>> folded_pairs(const Points& points, const Triangles& triangles, int count) {
  std::vector<std::pair<int, int>> folds;
  for (const Bend& bend : bends(points, triangles, count))
    if (bend.cosine <= 0) folds.emplace_back(bend.face, bend.other);
  return folds;
}

int count_folds(const Points& points, const Triangles& triangles, int count) {
  return static_cast<int>(folded_pairs(points, triangles, count).size());
}

double min_angle_deg(const Points& points, const Triangles& triangles, int count) {
  double smallest = std::numbers::pi;
  for (int f = 0; f < count; ++f)
    smallest = std::min(smallest, min_angle(points[triangles[f][0]], points[triangles[f][1]], points[triangles[f][2]]));
  return smallest * 180 / std::numbers::pi;
}

double mean_edge_length(const Points& points, const Triangles& triangles, int count) {
  double sum = 0;
  for (int f = 0; f < count; ++f)
    for (int k = 0; k < 3; ++k) sum += (points[triangles[f][k]] - points[triangles[f][(k + 1) % 3]]).norm();
  return count > 0 ? sum / (3.0 * count) : 0;
}

}  // namespace loopmend
