#include "rim/rim_roughness.h"

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

}  // namespace
}  // namespace loopmend
