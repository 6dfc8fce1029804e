// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces with one plane of symmetry that is known, on meshes that have none.
#pragma once

#include "mesh/surface_model.h"
#include "samples/analytic_surfaces.h"

#include <Eigen/Geometry>

#include <cmath>

namespace loopmend::test {

/// An ellipsoid with a bump on each side of x = 0 and one on its back, turned and moved.
struct BumpyEllipsoid {
  Vec3 left_bump = Vec3(-0.8, 0.5, 0.33).normalized(), right_bump = Vec3(0.8, 0.5, 0.33).normalized();
  double left_height = 0.25, right_height = 0.25;

  static Eigen::Isometry3d motion() {
    return Eigen::Translation3d(30, -20, 10) * Eigen::AngleAxisd(0.7, Vec3(1, 2, -0.5).normalized());
  }
  static Vec3 plane_point() { return motion() * Vec3(0, 0, 0); }
  static Vec3 plane_normal() { return motion().linear() * Vec3::UnitX(); }

  double radius(const Vec3& direction) const {
    const auto bump = [&](const Vec3& at, double height, double width) {
      return height * std::exp(-(direction - at).squaredNorm() / width);
    };
    const double ellipsoid = 1 / std::sqrt(direction.cwiseQuotient(Vec3(1, 1.3, 0.8)).squaredNorm());
    return ellipsoid + bump(left_bump, left_height, 0.03) + bump(right_bump, right_height, 0.03) +
           bump(Vec3(0, -0.6, 0.8), 0.2, 0.1);
  }

  /// Of the mesh whose points are on the surface. @param level  of the icosphere.
  TriangleSoup mesh(int level) const {
    TriangleSoup soup = make_icosphere(level);
    const Eigen::AngleAxisd turn(1.1, Vec3(0.3, -1, 0.6).normalized());  // else the mesh would be symmetric, too
    for (Vec3& p : soup.points) {
      const Vec3 direction = turn * p;
      p = motion() * Vec3(radius(direction) * direction);
    }
    return soup;
  }

  /// Along the ray from the middle: no less than the distance from the surface.
  double distance(const Vec3& p) const {
    const Vec3 own = motion().inverse() * p;
    return std::abs(own.norm() - radius(own.normalized()));
  }

  /// Without the top of the right bump.
  TriangleSoup open_mesh(int level, double size = 0.2) const {
    return trim_boundaries(cut(mesh(level), [&](const Vec3& p) {
      return ((motion().inverse() * p).normalized() - right_bump).norm() < size;
    }));
  }
};

}  // namespace loopmend::test
