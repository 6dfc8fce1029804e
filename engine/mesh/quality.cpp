#include "mesh/quality.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

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
  std::map<std::pair<int, int>, int> face_of;
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (int k = 0; k < 3; ++k) face_of[{triangles[f][k], triangles[f][(k + 1) % 3]}] = static_cast<int>(f);
  const auto normal = [&](int f) {
    const Triangle& t = triangles[f];
    return unit_normal(points[t[0]], points[t[1]], points[t[2]]);
  };
  int folds = 0;
  for (int f = 0; f < count; ++f)
    for (int k = 0; k < 3; ++k) {
      const auto other = face_of.find({triangles[f][(k + 1) % 3], triangles[f][k]});
      if (other == face_of.end() || (other->second < count && other->second < f)) continue;
      if (normal(f).dot(normal(other->second)) <= 0) ++folds;
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
