// SPDX-License-Identifier: GPL-3.0-or-later
// Holes over both sides of a plate: two long edges, and those of its corners.
#include "core/random.h"
#include "mesh/boundary_loops.h"
#include "pipeline/fill_holes.h"
#include "support/sharp_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

constexpr double thickness = 0.25;

/// Distance from the surface of [0, 1] × [0, 1] × [0, thickness].
double off_plate(const Vec3& p) {
  const Vec3 half(0.5, 0.5, thickness / 2), q = (p - half).cwiseAbs() - half;
  return std::abs(q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0));
}

/// Without the faces whose middles lie in an ellipsoid about a place on a long edge.
TriangleSoup holed_plate(Random& random) {
  TriangleSoup plate = test::make_cube(16);
  for (Vec3& p : plate.points) p.z() *= thickness;
  const Vec3 center(random.uniform(0, 1), random.uniform() < 0.5 ? 0 : 1, random.uniform() < 0.5 ? 0 : thickness);
  const double radius = random.uniform(0.15, 0.4);
  const Vec3 axes(random.uniform(0.7, 1.4), random.uniform(0.7, 1.4), random.uniform(0.7, 1.4));
  std::erase_if(plate.triangles, [&](const Triangle& t) {
    const Vec3 middle = (plate.points[t[0]] + plate.points[t[1]] + plate.points[t[2]]) / 3;
    return (middle - center).cwiseQuotient(axes).norm() < radius;
  });
  return plate;
}

TEST(Plates, HolesOverBothSidesComeBack) {
  constexpr int plates = 24;
  Random random(11);
  int continued = 0, exact = 0;
  for (int k = 0; k < plates; ++k) {
    const TriangleSoup plate = holed_plate(random);
    SurfaceModel model = make_surface_model(plate);
    const std::vector<HoleResult> holes = fill_all_holes(model, {});
    ASSERT_EQ(holes.size(), 1U) << k;
    EXPECT_TRUE(find_boundary_loops(model).empty()) << k;
    const bool runs_on = holes.front().outcome().made_by == "sharp edges";
    continued += runs_on;
    // A rounded edge is never called good.
    EXPECT_EQ(holes.front().verdict().grade, runs_on ? Grade::good : Grade::look) << k;
    if (!runs_on) continue;
    double farthest = 0;
    for (std::size_t i = plate.points.size(); i < model.soup.points.size(); ++i)
      farthest = std::max(farthest, off_plate(model.soup.points[i]));
    exact += farthest < 1e-3 * holes.front().loop.diameter;
  }
  EXPECT_GE(continued, plates - 1);
  EXPECT_GE(exact, plates - 2);
}

}  // namespace
}  // namespace loopmend
