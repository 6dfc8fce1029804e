// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/hybrid_curvature.h"

#include "core/random.h"
#include "operators/vertex_normals.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

namespace loopmend {
namespace {

Eigen::VectorXd curvature_of(const Points& points, const Triangles& triangles) {
  std::vector<int> all(triangles.size());
  for (std::size_t f = 0; f < all.size(); ++f) all[f] = static_cast<int>(f);
  const Points normals = angle_weighted_normals(points, triangles);
  return hybrid_curvature(points, normals, fit_neighbors(Topology(static_cast<int>(points.size()), triangles)),
                          clamped_cotan_stiffness(points, triangles, all, robust_clamp),
                          barycentric_areas(points, triangles))
      .H;
}

/// Where normals turn far between neighbors, few samples are left, and the ridge decides.
TEST(HybridCurvature, IsTheSameInEveryFrame) {
  TriangleSoup soup = make_icosphere(4);
  Random random(2);
  for (Vec3& p : soup.points) p *= 1 + 0.03 * random.bell();
  const Eigen::VectorXd given = curvature_of(soup.points, soup.triangles);
  for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(1, 2, 3)}) {
    Points turned = soup.points;
    for (Vec3& p : turned) p = Eigen::AngleAxisd(0.7, axis.normalized()) * p;
    const Eigen::VectorXd H = curvature_of(turned, soup.triangles);
    EXPECT_LT((H - given).cwiseAbs().maxCoeff(), 1e-7 * given.cwiseAbs().maxCoeff());
  }
}

}  // namespace
}  // namespace loopmend
