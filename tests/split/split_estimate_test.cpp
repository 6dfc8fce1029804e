// SPDX-License-Identifier: GPL-3.0-or-later
#include "split/split_estimate.h"

#include "core/random.h"
#include "core/threads.h"
#include "support/patches.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>

namespace loopmend {
namespace {

/// A sphere of edges of about 0.038 without its cap, its points moved outward.
Patch start_with(const std::function<double(std::size_t)>& height) {
  TriangleSoup soup = make_icosphere(5);
  for (std::size_t i = 0; i < soup.points.size(); ++i) soup.points[i] *= 1 + height(i);
  return test::start_of(make_surface_model(trim_boundaries(cut(soup, [](const Vec3& p) { return p.z() > 0.85; }))));
}

TEST(SplitEstimate, ASphereIsExact) {
  const SplitEstimate estimate = estimate_split(start_with([](std::size_t) { return 0; }));
  EXPECT_TRUE(estimate.is_exact());
  EXPECT_EQ(estimate.kind(), NeighborhoodKind::smooth);
  EXPECT_GT(estimate.relief, 0) << "estimated, not given up";
  EXPECT_NEAR(estimate.radius, std::sqrt(1 - 0.85 * 0.85) / Patch(start_with([](std::size_t) { return 0; })).scale,
              0.05);
}

/// White noise of 1/1000 to 1/10 of an edge. Measured: 0.55, 0.60 and 0.76 of its height, the rest taken for shape or relief.
TEST(SplitEstimate, FindsWhiteNoiseAndAboutItsHeight) {
  for (const double share : {0.001, 0.01, 0.1}) {
    Random random(3);
    const double sigma = share * 0.038;
    const SplitEstimate estimate = estimate_split(start_with([&](std::size_t) { return sigma * random.bell(); }));
    EXPECT_FALSE(estimate.is_exact());
    EXPECT_EQ(estimate.kind(), NeighborhoodKind::noisy);
    EXPECT_GT(estimate.noise_height / estimate.edge, 0.5 * share);
    EXPECT_LT(estimate.noise_height / estimate.edge, 1.1 * share);
    EXPECT_LT(estimate.relief_height, 0.5 * estimate.noise_height);
  }
}

TEST(SplitEstimate, IsTheSameInAnyUnitAndForAnyNumberOfThreads) {
  TriangleSoup soup = make_icosphere(4);
  const std::vector<double> relief = test::random_relief(soup, 5);
  for (std::size_t i = 0; i < soup.points.size(); ++i) soup.points[i] *= 1 + 0.01 * relief[i];
  soup = trim_boundaries(cut(soup, [](const Vec3& p) { return p.z() > 0.8; }));
  const Patch patch = test::start_of(make_surface_model(soup));
  for (Vec3& p : soup.points) p *= 1024;
  const SplitEstimate one = with_thread_budget(1, [&] { return estimate_split(patch); }), all = estimate_split(patch),
                      large = estimate_split(test::start_of(make_surface_model(soup)));
  EXPECT_EQ(one.relief, all.relief);
  EXPECT_EQ(one.noise, all.noise);
  EXPECT_EQ(one.relief_height, all.relief_height);
  EXPECT_EQ(all.relief, large.relief);
  EXPECT_NEAR(all.relief_height, large.relief_height, 1e-9 * all.relief_height);
}

/// Noise of a third of an edge turns normals so far that the fits at many vertices are hardly determined.
TEST(SplitEstimate, IsTheSameHoweverTheScanIsTurned) {
  for (const double share : {0.02, 0.3}) {
    Random random(4);
    Patch patch = start_with([&](std::size_t) { return share * 0.038 * random.bell(); });
    const SplitEstimate given = estimate_split(patch);
    const Eigen::AngleAxisd turn(1, Vec3(1, -2, 0.5).normalized());
    for (Vec3& p : patch.positions) p = turn * p;
    const SplitEstimate turned = estimate_split(patch);
    EXPECT_EQ(given.relief, turned.relief);
    EXPECT_EQ(given.noise, turned.noise);
    EXPECT_NEAR(given.relief_height, turned.relief_height, 1e-6 * given.relief_height);
    EXPECT_NEAR(given.noise_height, turned.noise_height, 1e-6 * given.noise_height);
  }
}

/// Whole numbers have no curvature at all, a slope has rounding errors: both are as smooth as can be.
TEST(SplitEstimate, APlaneIsExact) {
  for (const double slope : {0.0, 0.5, 0.1}) {
    const TriangleSoup plane = make_graph([&](double x, double) { return slope * x; }, 12, 24);
    const SurfaceModel model =
        make_surface_model(cut(plane, [](const Vec3& p) { return std::max(std::abs(p.x()), std::abs(p.y())) < 3.5; }));
    const auto loops = find_boundary_loops(model);
    ASSERT_EQ(loops.size(), 2);
    ASSERT_EQ(loops[1].kind, LoopKind::hole);
    const auto start = make_initial_patch(model, {loops[1]}, InitialPatchOptions{}, CancelToken());
    const SplitEstimate estimate = estimate_split(*start.patch);
    EXPECT_TRUE(estimate.is_exact()) << slope << ": " << estimate.relief_height << ' ' << estimate.noise_height;
  }
}

/// What encloses no loop has no neighborhood to tell anything.
TEST(SplitEstimate, WithoutLoopsNothingIsEstimated) {
  Patch patch;
  patch.positions = make_icosphere(1).points;
  patch.triangles = make_icosphere(1).triangles;
  patch.free_count = patch.vertex_count();
  patch.patch_triangles = static_cast<int>(patch.triangles.size());
  patch.ring.assign(patch.positions.size(), 0);
  const SplitEstimate estimate = estimate_split(patch);
  EXPECT_EQ(estimate.relief, 0);
  EXPECT_TRUE(estimate.is_exact());
}

}  // namespace
}  // namespace loopmend
