// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/expected_deviation.h"
#include "core/random.h"
#include "operators/operator_set.h"
#include "support/patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace loopmend {
namespace {

TriangleSoup open_sphere(double scale) {
  TriangleSoup soup = trim_boundaries(cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.8; }));
  for (Vec3& p : soup.points) p *= scale;
  return soup;
}

HoleResult filled(const TriangleSoup& soup, const EvolutionOptions& evolution = {}) {
  SurfaceModel model = make_surface_model(soup);
  FillOptions options;
  options.evolution = evolution;
  return fill_all_holes(model, options).front();
}

TEST(ExpectedDeviation, BoundsAreInOrderAndGrowWithTheDifferenceOfTheFairings) {
  double last = 0;
  for (double difference : {0.0, 1e-6, 1e-4, 1e-3, 1e-2, 0.1}) {
    const ExpectedDeviation bounds = expected_deviation({difference, 0.7, 1, 5});
    EXPECT_LT(bounds.half, bounds.likely);
    EXPECT_LT(bounds.likely, bounds.most);
    EXPECT_GE(bounds.likely, last);
    last = bounds.likely;
  }
}

TEST(ExpectedDeviation, GrowsWithTheBendsAtTheSeam) {
  const double smooth = expected_deviation({1e-3, 0.7, 0.5, 5}).likely;
  EXPECT_GT(expected_deviation({1e-3, 0.7, 5, 5}).likely, 1.5 * smooth);
  EXPECT_GT(expected_deviation({1e-3, 0.7, 0.5, 20}).likely, smooth);
}

TEST(ExpectedDeviation, IsUnknownWhereTheSeamIsNotMeasured) {
  SurfaceModel model = make_surface_model(cut(make_icosphere(2), [](const Vec3& p) { return p.z() > 0.8; }));
  Patch patch = fill_all_holes(model).front().outcome().patch;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<SeamReport> measured{{1, 1, 1, 1, 1}}, unmeasured{{nan, nan, nan, nan, nan}};
  EXPECT_TRUE(expected_deviation(patch, measured, measured).loops[0].is_known());
  EXPECT_FALSE(expected_deviation(patch, unmeasured, measured).loops[0].is_known());
  EXPECT_FALSE(expected_deviation(patch, measured, unmeasured).loops[0].is_known());
}

/// The bends at the seam of a smooth surface vanish as the edges do, and the error of the patch does not.
TEST(ExpectedDeviation, OfASmoothSurfaceHardlyDependsOnTheMesh) {
  const auto likely = [](int level) {
    TriangleSoup soup = make_icosphere(level);
    for (Vec3& p : soup.points) p *= 1 + 0.08 * std::sin(6 * p.x() + 1) * std::sin(6 * p.y() + 2);
    return filled(trim_boundaries(cut(soup, [](const Vec3& p) { return p.z() > 0.83; }))).deviation().likely;
  };
  EXPECT_GT(likely(5), 0.6 * likely(4));
}

/// Noise hardly changes the difference of the two fairings; it shows in the bends at the seam.
TEST(ExpectedDeviation, IsLargerUnderNoise) {
  const TriangleSoup smooth = open_sphere(1);
  TriangleSoup noisy = smooth;
  Random random(7);
  for (Vec3& p : noisy.points) p *= 1 + random.uniform(-0.017, 0.017);
  EXPECT_GT(filled(noisy).deviation().likely, 3 * filled(smooth).deviation().likely);
}

TEST(ExpectedDeviation, IsInMeshUnits) {
  const HoleResult small = filled(open_sphere(1)), large = filled(open_sphere(1000));
  ASSERT_TRUE(small.deviation().is_known());
  EXPECT_NEAR(large.deviation().likely / small.deviation().likely, 1000, 1e-3);
}

TEST(ExpectedDeviation, OfVerticesHasTheBoundOfTheLoopAsItsMean) {
  const HoleResult hole = filled(open_sphere(1));
  const PatchResult& result = hole.outcome();
  const std::vector<double>& vertices = result.deviation.vertices;
  ASSERT_EQ(vertices.size(), static_cast<std::size_t>(result.patch.free_count));
  const Eigen::VectorXd area = barycentric_areas(result.patch.positions, result.patch.triangles);
  double squares = 0, sum = 0;
  for (int v = 0; v < result.patch.free_count; ++v) {
    EXPECT_GT(vertices[v], 0);
    squares += area[v] * vertices[v] * vertices[v];
    sum += area[v];
  }
  EXPECT_NEAR(std::sqrt(squares / sum), hole.deviation().likely, 1e-9 * hole.deviation().likely);
}

TEST(ExpectedDeviation, OnASphereTheBoundHolds) {
  const HoleResult hole = filled(open_sphere(1));
  const Patch& patch = hole.outcome().patch;
  double squares = 0;
  for (int v = 0; v < patch.free_count; ++v)
    squares += std::pow(patch.to_mesh(patch.positions[v]).norm() - 1, 2) / patch.free_count;
  EXPECT_LT(std::sqrt(squares), hole.deviation().half);
}

/// Most of the sphere is missing, but all vertices around lie on it: there is nothing to look at.
TEST(ExpectedDeviation, IsNoRemarkOnASphere) {
  const HoleResult hole = filled(cut(make_icosphere(4), [](const Vec3& p) { return p.z() > -0.6; }));
  EXPECT_GT(hole.deviation().likely, 0.05 * hole.loop.diameter);
  EXPECT_EQ(hole.verdict().grade, Grade::good);
}

/// A fairing of second order differs much from a cap over half a sphere, and little from a shallow one.
TEST(ExpectedDeviation, IsLargerForAnOpeningThatLeavesLess) {
  const auto share = [](double height) {
    const TriangleSoup soup = trim_boundaries(cut(make_icosphere(4), [=](const Vec3& p) { return p.z() > height; }));
    const HoleResult hole = filled(soup);
    return hole.deviation().likely / hole.loop.diameter;
  };
  EXPECT_GT(share(0.2), 2 * share(0.9));
}

TEST(ExpectedDeviation, IsOfTheDefaultAlone) {
  EvolutionOptions tangent, exact, wf;
  tangent.continuity = SeamContinuity::tangent;
  exact.boundary = BoundaryTrust::exact;
  wf.flow = FlowKind::wf;
  for (const EvolutionOptions& options : {tangent, exact, wf}) {
    const HoleResult hole = filled(open_sphere(1), options);
    ASSERT_TRUE(is_filled(hole.status));
    EXPECT_FALSE(hole.deviation().is_known());
    EXPECT_TRUE(hole.outcome().deviation.vertices.empty());
  }
}

TEST(ExpectedDeviation, OfAllNewPointsStandsInTheirOrder) {
  const TriangleSoup soup = cut(make_icosphere(4), [](const Vec3& p) { return std::abs(p.z()) > 0.9; });
  SurfaceModel model = make_surface_model(trim_boundaries(soup));
  const std::size_t given = model.soup.points.size();
  const std::vector<HoleResult> holes = fill_all_holes(model);
  ASSERT_EQ(holes.size(), 2U);
  const std::vector<double> all = expected_deviations(holes);
  ASSERT_EQ(all.size(), model.soup.points.size() - given);
  // Largest in the middle of each cap, where nothing is near.
  for (double side : {-1.0, 1.0}) {
    double at_pole = 0, at_rim = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const double height = side * model.soup.points[given + k].z();
      if (height > 0.995) at_pole = std::max(at_pole, all[k]);
      if (height > 0 && height < 0.92) at_rim = std::max(at_rim, all[k]);
    }
    EXPECT_GT(at_pole, at_rim);
  }
}

}  // namespace
}  // namespace loopmend
