// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/sphere_cap.h"

#include "pipeline/fill_holes.h"
#include "pipeline/initial_patch.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace loopmend {
namespace {

/// Largest distance of the new vertices from the unit sphere.
double farthest(const TriangleSoup& open, const char* name) {
  SurfaceModel model = make_surface_model(open);
  for (const HoleResult& hole : fill_all_holes(model)) {
    EXPECT_NE(hole.verdict().grade, Grade::bad) << name << ": " << hole.verdict().message();
    EXPECT_EQ(hole.outcome().validity.intersections, 0) << name;
    if (hole.method() == "sphere") {
      EXPECT_EQ(hole.reason().code, "sphere");
    }
  }
  EXPECT_TRUE(find_boundary_loops(make_surface_model(model.soup)).empty()) << name;
  double largest = 0;
  for (std::size_t v = open.points.size(); v < model.soup.points.size(); ++v)
    largest = std::max(largest, std::abs(model.soup.points[v].norm() - 1));
  return largest;
}

/// From the south pole to a height, by equal angles.
TriangleSoup globe(double top, int around, int rows) {
  const double to = std::acos(-top);
  TriangleSoup soup = make_revolution([](double) { return 1.0; }, 0, 1, around, rows);
  for (Vec3& p : soup.points) {
    const double angle = 0.02 + p.z() * (to - 0.02), turn = std::atan2(p.y(), p.x());
    p = Vec3(std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), -std::cos(angle));
  }
  return soup;
}

TEST(SphereCap, SpheresOfUnevenAndOfFewTrianglesComeBack) {
  for (const double top : {0.0, 0.17})
    for (const auto& [around, rows] : {std::pair{100, 20}, {64, 16}, {20, 40}})
      EXPECT_LT(farthest(globe(top, around, rows), "globe"), 1e-3) << top << ' ' << around << ' ' << rows;
  for (const int level : {2, 3})
    for (const double degrees : {60, 90, 115, 125})
      EXPECT_LT(farthest(cut(make_icosphere(level),
                             [&](const Vec3& p) { return p.z() > std::cos(degrees * std::numbers::pi / 180); }),
                         "icosphere"),
                1e-3)
          << level << ' ' << degrees;
}

/// More than half of it is missing: a bubble anywhere else.
TEST(SphereCap, TheFlowAskedForByNameIsNotBadWhereItEndsOnTheSphere) {
  SurfaceModel ball = make_surface_model(
      cut(make_icosphere(4), [](const Vec3& p) { return p.z() > std::cos(125 * std::numbers::pi / 180); }));
  FillOptions options;
  options.evolution->boundary = BoundaryTrust::exact;
  const std::vector<HoleResult> results = fill_all_holes(ball, options);
  ASSERT_EQ(results.size(), 1U);
  EXPECT_EQ(results[0].method(), "mmcvf");
  EXPECT_EQ(results[0].verdict().grade, Grade::good) << results[0].verdict().message();
}

TEST(SphereCap, WallsAreNoSpheresThoughTheirCornersLieOnOne) {
  for (const int rows : {1, 2}) {
    const SurfaceModel tube = make_surface_model(make_revolution([](double) { return 1.0; }, -0.2, 0.2, 24, rows));
    const BoundaryLoop loop = find_boundary_loops(tube).front();
    const InitialPatch initial = make_initial_patch(tube, {loop}, {}, CancelToken());
    ASSERT_TRUE(initial.patch);
    EXPECT_FALSE(sphere_around(*initial.patch)) << rows;
  }
}

}  // namespace
}  // namespace loopmend
