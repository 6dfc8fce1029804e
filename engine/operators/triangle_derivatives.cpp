// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/triangle_derivatives.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace loopmend {

namespace {

/// One corner of a triangle: its angle, and how that changes when the three vertices move.
struct Corner {
  double angle = 0, sine = 0;
  Vec3 of_next, of_last;  ///< derivative of the angle; of the corner itself: less their sum
};

/// @param normal  of the triangle, unit.
Corner corner_at(const Points& points, const Triangle& t, int k, const Vec3& normal) {
  const Vec3 a = points[t[(k + 1) % 3]] - points[t[k]], b = points[t[(k + 2) % 3]] - points[t[k]];
  Corner corner;
  const double area = a.cross(b).norm();
  corner.angle = std::atan2(area, a.dot(b));
  corner.sine = area / (a.norm() * b.norm());
  corner.of_next = -normal.cross(a) / a.squaredNorm();
  corner.of_last = normal.cross(b) / b.squaredNorm();
  return corner;
}

/// @returns false where the triangle has no area.
bool normal_of(const Points& points, const Triangle& t, Vec3& normal, double& twice_area) {
  const Vec3 cross = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
  twice_area = cross.norm();
  if (!(twice_area > 0)) return false;
  normal = cross / twice_area;
  return true;
}

void add_angle_derivative(const Corner& corner, const Triangle& t, int k, double factor, Points& derivative) {
  derivative[t[(k + 1) % 3]] += factor * corner.of_next;
  derivative[t[(k + 2) % 3]] += factor * corner.of_last;
  derivative[t[k]] -= factor * (corner.of_next + corner.of_last);
}

}  // namespace

void add_stiffness_derivative(const Points& points, const Triangles& triangles, const std::vector<int>& faces,
                              const SparseMatrix& stiffness, CotanClamp clamp, const std::function<double(int, int)>& f,
                              Points& derivative) {
  Vec3 normal;
  double twice_area = 0;
  for (int face : faces) {
    const Triangle& t = triangles[face];
    if (!normal_of(points, t, normal, twice_area)) continue;
    for (int k = 0; k < 3; ++k) {
      const int i = t[(k + 1) % 3], j = t[(k + 2) % 3];
      const double weight = -stiffness.coeff(i, j);
      if (!(weight > clamp.low && weight < clamp.high)) continue;
      const Corner corner = corner_at(points, t, k, normal);
      add_angle_derivative(corner, t, k, -0.5 * f(i, j) / (corner.sine * corner.sine), derivative);
    }
  }
}

void add_area_derivative(const Points& points, const Triangles& triangles, const Eigen::VectorXd& areas,
                         const Eigen::VectorXd& f, Points& derivative) {
  const double least = areas.minCoeff();
  Vec3 normal;
  double twice_area = 0;
  for (const Triangle& t : triangles) {
    if (!normal_of(points, t, normal, twice_area)) continue;
    double share = 0;
    for (int v : t)
      if (areas[v] > least) share += f[v] / 3;
    for (int k = 0; k < 3; ++k)
      derivative[t[k]] += share / 2 * normal.cross(points[t[(k + 2) % 3]] - points[t[(k + 1) % 3]]);
  }
}

void add_normal_derivative(const Points& points, const Triangles& triangles, const Points& f, Points& derivative) {
  Points sums(points.size(), Vec3::Zero()), pull(points.size(), Vec3::Zero());
  Vec3 normal;
  double twice_area = 0;
  for (const Triangle& t : triangles)
    if (normal_of(points, t, normal, twice_area))
      for (int k = 0; k < 3; ++k) sums[t[k]] += corner_at(points, t, k, normal).angle * normal;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (const double length = sums[i].norm(); length > 0) {
      const Vec3 n = sums[i] / length;
      pull[i] = (f[i] - n.dot(f[i]) * n) / length;
    }
  for (const Triangle& t : triangles) {
    if (!normal_of(points, t, normal, twice_area)) continue;
    Vec3 of_normal = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      const Corner corner = corner_at(points, t, k, normal);
      add_angle_derivative(corner, t, k, pull[t[k]].dot(normal), derivative);
      of_normal += corner.angle * pull[t[k]];
    }
    // dN = −Σ ⟨N, dp_k⟩ ∇b_k, b_k the linear basis functions.
    for (int k = 0; k < 3; ++k) {
      const Vec3 hat = normal.cross(points[t[(k + 2) % 3]] - points[t[(k + 1) % 3]]) / twice_area;
      derivative[t[k]] -= hat.dot(of_normal) * normal;
    }
  }
}

}  // namespace loopmend
