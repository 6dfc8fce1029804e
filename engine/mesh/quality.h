// SPDX-License-Identifier: GPL-3.0-or-later
// Figures that tell whether a triangulation is fit to compute on: angles, folds.
#pragma once

#include "core/types.h"

#include <Eigen/Geometry>

#include <utility>
#include <vector>

namespace loopmend {

/// Unit normal of a triangle; zero when it has no area. Here, since remeshing asks for it all the time.
inline Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const double norm = normal.norm();
  return norm > 0 ? Vec3(normal / norm) : Vec3::Zero();
}

/// Smallest angle of the triangle in radians; 0 when degenerate.
double min_angle(const Vec3& a, const Vec3& b, const Vec3& c);

/// Edges shared by two triangles whose normals differ by more than 90°, where at least one of the two is among the first
/// `count` triangles. A degenerate triangle counts as folded against each neighbour.
int count_folds(const Points& points, const Triangles& triangles, int count);

/// An edge between two triangles.
struct Bend {
  int low = 0, high = 0;    ///< its vertices, low < high
  int face = 0, other = 0;  ///< the triangles beside it, face < other
  double cosine = 1;        ///< of the angle between their normals; 0 where one is degenerate
};

/// All edges shared by two triangles of which at least one is among the first `count`, by lower, then higher vertex.
std::vector<Bend> bends(const Points& points, const Triangles& triangles, int count);

/// The edges that count_folds counts, each as the pair of triangles beside it.
std::vector<std::pair<int, int>> folded_pairs(const Points& points, const Triangles& triangles, int count);

/// Smallest angle of the first `count` triangles, in degrees; 180 when there are none.
double min_angle_deg(const Points& points, const Triangles& triangles, int count);

/// Mean length of the edges of the first `count` triangles; 0 when there are none.
double mean_edge_length(const Points& points, const Triangles& triangles, int count);

}  // namespace loopmend
