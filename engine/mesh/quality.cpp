#include "mesh/quality.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

namespace loopmend {

Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const double norm = normal.norm();
  return norm > 0 ? Vec3(normal / norm) : Vec3::Zero();
}

double min_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto angle = [](const Vec3& u, const Vec3& v) { return std::atan2(u.cross(v).norm(), u.dot(v)); };
  return std::min({angle(b - a, c - a), angle(c - b, a - b), angle(a - c, b - c)});
}

int count_folds(const Points& points, const Triangles& triangles, int count) {
  struct Side {
    int low, high, face;
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles[f][k], triangles[f][(k + 1) % 3]);
      sides.push_back({low, high, static_cast<int>(f)});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
  });
  const auto normal = [&](int f) {
    const Triangle& t = triangles[f];
    return unit_normal(points[t[0]], points[t[1]], points[t[2]]);
  };
  int folds = 0;
  for (std::size_t s = 0; s + 1 < sides.size(); ++s) {
    if (sides[s].low != sides[s + 1].low || sides[s].high != sides[s + 1].high || sides[s].face >= count) continue;
    if (normal(sides[s].face).dot(normal(sides[s + 1].face)) <= 0) ++folds;
  }
  return folds;
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
