// SPDX-License-Identifier: GPL-3.0-or-later
#include "rim/rim_roughness.h"

#include "known_surfaces.h"
#include "mesh/quality.h"
#include "samples/random.h"
#include "support/patches.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

/// The unit sphere with noise of this standard deviation along its normals, where x > −0.3 of another one; without its cap.
SurfaceModel noisy_open_sphere(double sigma, double there) {
  TriangleSoup soup = make_icosphere(5);
  Random random(5);
  for (Vec3& p : soup.points) p *= 1 + (p.x() > -0.3 ? there : sigma) * random.bell();
  return make_surface_model(trim_rims(cut(soup, [](const Vec3& p) { return p.z() > 0.8; })));
}

TEST(RimRoughness, SmoothSurroundingsAskForThePureFlowRoughOnesForBending) {
  for (const SurfaceModel& model : {test::open_sphere(4, 0.8), test::rough_open_sphere(4, 0.8)}) {
    const RimRoughness smooth = rim_roughness(test::start_of(model));
    EXPECT_EQ(smooth.bending, 0);
    EXPECT_EQ(smooth.kind, Surroundings::smooth);
    EXPECT_GT(smooth.growth, 3);
    EXPECT_EQ(smooth.rough_share, 0);
    EXPECT_EQ(smooth.noise_share, 0);
  }
  TriangleSoup scan = make_icosphere(5);
  for (Vec3& p : scan.points) p *= 1 + 0.02 * std::sin(31 * p.x()) * std::sin(29 * p.y()) * std::cos(33 * p.z());
  const RimRoughness rough = rim_roughness(
      test::start_of(make_surface_model(trim_rims(cut(scan, [](const Vec3& p) { return p.z() > 0.85; })))));
  EXPECT_GT(rough.bending, 1);
  EXPECT_LT(rough.correlation, 0.9);
}

constexpr double edge = 0.038;  // mean, of the icosphere

TEST(RimRoughness, RecoversTheStandardDeviationOfWhiteNoise) {
  for (double share : {0.003, 0.01, 0.03, 0.1}) {
    const Patch patch = test::start_of(noisy_open_sphere(share * edge, share * edge));
    const RimRoughness rim = rim_roughness(patch);
    EXPECT_NEAR(rim.noise * patch.scale, share * edge, 0.12 * share * edge) << share;
    EXPECT_EQ(rim.kind, Surroundings::noisy) << share;
    EXPECT_GT(rim.spread, 1.1) << share;
    EXPECT_LT(rim.spread, 1.6) << share;
  }
}

TEST(RimRoughness, WhiteNoiseIsAlikeEverywhere) {
  const RimRoughness white = rim_roughness(test::start_of(noisy_open_sphere(0.03 * edge, 0.03 * edge)));
  const RimRoughness almost = rim_roughness(test::start_of(noisy_open_sphere(0.03 * edge, 0.02 * edge)));
  const RimRoughness patchy = rim_roughness(test::start_of(noisy_open_sphere(0.005 * edge, 0.03 * edge)));
  EXPECT_EQ(white.noise_share, 1);
  EXPECT_EQ(almost.noise_share, 1);
  // Its residual does not grow with the fits either, but it is no noise that the flow could be spared.
  EXPECT_LT(patchy.growth, 0.27);
  EXPECT_GT(patchy.spread, 2.6);
  EXPECT_EQ(patchy.noise_share, 0);
  EXPECT_EQ(patchy.kind, Surroundings::rough);
}

/// Nothing in these is rough, however much their curvature changes from one vertex to the next.
TEST(RimRoughness, CleanBentSheetsAreSmooth) {
  int looked_at = 0;
  for (unsigned seed = 1; seed <= 12; ++seed)
    for (bench::MeshKind kind : {bench::MeshKind::regular, bench::MeshKind::irregular}) {
      const bench::KnownSurface sheet = bench::with_mesh(bench::known_sheet(seed, 40), kind, 3);
      const Vec3 center = sheet.project({0.1, -0.1, 0});
      const SurfaceModel model =
          make_surface_model(trim_rims(cut(sheet.mesh, [&](const Vec3& p) { return (p - center).norm() < 0.35; })));
      for (const BoundaryLoop& loop : find_boundary_loops(model)) {
        if (loop.kind != LoopKind::hole) continue;
        const RimRoughness rim = rim_roughness(*make_initial_patch(model, {loop}, {}, {}).patch);
        EXPECT_EQ(rim.rough_share, 0) << "sheet " << seed << ", " << to_string(kind) << ": growth " << rim.local_growth
                                      << ", residual " << rim.noise_per_edge;
        EXPECT_EQ(rim.kind, Surroundings::smooth);
        ++looked_at;
      }
    }
  EXPECT_EQ(looked_at, 24);
}

TEST(RimRoughness, TheExactSolutionOfTheEquationIsSmooth) {
  const bench::KnownSurface surface = bench::known_mvc_cylinder(64);
  const Vec3 center = surface.project({0.2, 0, 0.1});
  const SurfaceModel model =
      make_surface_model(trim_rims(cut(surface.mesh, [&](const Vec3& p) { return (p - center).norm() < 0.45; })));
  int holes = 0;
  for (const BoundaryLoop& loop : find_boundary_loops(model)) {
    if (loop.kind != LoopKind::hole) continue;
    ++holes;
    const RimRoughness rim = rim_roughness(*make_initial_patch(model, {loop}, {}, {}).patch);
    EXPECT_EQ(rim.rough_share, 0);
    EXPECT_EQ(rim.noise_share, 0);
    EXPECT_EQ(rim.bending, 0);
  }
  EXPECT_EQ(holes, 1);
}

}  // namespace
}  // namespace loopmend
