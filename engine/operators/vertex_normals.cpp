// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/vertex_normals.h"

#include "mesh/quality.h"

#include <Eigen/Geometry>

#include <cmath>

namespace loopmend {

namespace {

/// The share of corner k of the triangle in the normal there.
double angle_at(std::span<const Vec3> points, const Triangle& t, int k) {
  const Vec3 a = points[t[(k + 1) % 3]] - points[t[k]], b = points[t[(k + 2) % 3]] - points[t[k]];
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

Vec3 unit_or_zero(const Vec3& sum) {
  const double norm = sum.norm();
  return norm > 0 ? Vec3(sum / norm) : Vec3::Zero();
}

}  // namespace

Points angle_weighted_normals(std::span<const Vec3> points, const Triangles& triangles) {
  Points normals(points.size(), Vec3::Zero());
  for (const Triangle& t : triangles) {
    const Vec3 normal = unit_normal(points[t[0]], points[t[1]], points[t[2]]);
    for (int k = 0; k < 3; ++k) normals[t[k]] += angle_at(points, t, k) * normal;
  }
  for (Vec3& n : normals) n = unit_or_zero(n);
  return normals;
}

Vec3 angle_weighted_normal(std::span<const Vec3> points, const Triangles& triangles, const Topology& topology, int i) {
  Vec3 sum = Vec3::Zero();
  for (int f : topology.faces(i)) {
    const Triangle& t = triangles[f];
    const int k = t[0] == i ? 0 : t[1] == i ? 1 : 2;
    sum += angle_at(points, t, k) * unit_normal(points[t[0]], points[t[1]], points[t[2]]);
  }
  return unit_or_zero(sum);
}

}  // namespace loopmend
