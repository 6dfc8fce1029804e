#include "rim/rim_blend.h"

#include "analysis/seam_report.h"
#include "evolution/evolution.h"
#include "rim/rim_roughness.h"
#include "support/patches.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

/// A sphere whose roughness is that of scans: relief of several wavelengths down to a few edges.
Patch rough_start() {
  TriangleSoup scan = make_icosphere(5);
  for (Vec3& p : scan.points)
    p *= 1 + 0.01 * std::sin(17 * p.x()) * std::sin(19 * p.y()) + 0.004 * std::sin(43 * p.x() + 7 * p.z()) +
         0.002 * std::cos(71 * p.y() - 23 * p.x());
  return test::start_of(make_surface_model(trim_rims(cut(scan, [](const Vec3& p) { return p.z() > 0.85; }))));
}

Evolution solved(const Patch& start, const EvolutionOptions& options) {
  Evolution evolution(start, options);
  EXPECT_EQ(evolution.run(nullptr, {}), EvolutionStatus::converged);
  return evolution;
}

double largest_distance_to_unit_sphere(const Patch& patch) {
  double largest = 0;
  for (int i = 0; i < patch.free_count; ++i)
    largest = std::max(largest, std::abs(patch.to_mesh(patch.positions[i]).norm() - 1));
  return largest;
}

TEST(RimBlend, EvenRimIsTrustedWholly) {
  const Patch patch = test::exact_sphere_patch(4, 0.8);
  EXPECT_EQ(rim_trust(patch, rim_roughness(patch).radius).minCoeff(), 1);
}

TEST(RimBlend, OneSpikeAtTheRimLosesItsTrustAndTheRestKeepsIt) {
  Patch patch = test::exact_sphere_patch(5, 0.8);
  const int spike = patch.loops[0][7];
  patch.positions[spike] *= 1.08;
  const Eigen::VectorXd trust = rim_trust(patch, rim_roughness(patch).radius);
  EXPECT_LT(trust[spike], 0.1);
  int doubted = 0;
  for (int i = 0; i < patch.vertex_count(); ++i) doubted += trust[i] < 1;
  EXPECT_LE(doubted, 9);  // the spike and what has an edge to it
}

TEST(RimBlend, ASpikeDoesNotBendThePatch) {
  Patch patch = test::start_of(test::open_sphere(5, 0.8));
  patch.positions[patch.loops[0][7]] *= 1.08;
  EvolutionOptions smooth;
  smooth.rim = RimTrust::smooth;
  EvolutionOptions unjudged;
  unjudged.bending = rough_bending;
  unjudged.rim = RimTrust::exact;
  const double robust = largest_distance_to_unit_sphere(solved(patch, smooth).patch());
  Evolution literal(patch, unjudged);
  literal.run(nullptr, {});
  EXPECT_LT(robust, 0.3 * largest_distance_to_unit_sphere(literal.patch()));
}

TEST(RimBlend, CleanSurroundingsGiveTheSameBitsWithAndWithoutTheJudgement) {
  const Patch start = test::start_of(test::rough_open_sphere(4, 0.6));
  EvolutionOptions exact;
  exact.rim = RimTrust::exact;
  const Evolution automatic = solved(start, {}), literal = solved(start, exact);
  EXPECT_EQ(automatic.patch().positions, literal.patch().positions);
  EXPECT_EQ(automatic.roughness()->kind, Surroundings::smooth);
}

TEST(RimBlend, RoughSurroundingsAreBlendedLinearly) {
  const Patch start = rough_start();
  const Evolution evolution = solved(start, {});
  EXPECT_EQ(evolution.roughness()->kind, Surroundings::rough);
  EXPECT_EQ(evolution.history().size(), 4U);
  EXPECT_EQ(evolution.bending(), rough_bending);
  for (int i = start.free_count; i < start.vertex_count(); ++i)
    EXPECT_EQ(evolution.patch().positions[i], start.positions[i]);
}

/// Position: least area among all, and a kink. Tangent: no kink, a jump of H. Curvature: neither.
TEST(SeamContinuity, EachOrderHasWhatItPromisesAndNoMore) {
  const Patch start = test::start_of(test::open_sphere(5, 0.7));
  std::map<SeamContinuity, SeamReport> seam;
  for (SeamContinuity continuity : {SeamContinuity::position, SeamContinuity::tangent, SeamContinuity::curvature}) {
    EvolutionOptions options;
    options.continuity = continuity;
    const Evolution evolution = solved(start, options);
    seam[continuity] = seam_reports(evolution.patch()).front();
  }
  // The minimal surface through a circle is the flat disc: the angle is that of the sphere with its plane, 45.6 degrees.
  EXPECT_NEAR(seam[SeamContinuity::position].g1_rms_deg, std::acos(0.7) * 180 / 3.14159265358979, 2);
  EXPECT_LT(seam[SeamContinuity::tangent].g1_rms_deg, 2);
  EXPECT_GT(seam[SeamContinuity::tangent].h_jump_rms_times_diameter, 0.05);
  EXPECT_LT(seam[SeamContinuity::curvature].g1_rms_deg, 0.05);
  EXPECT_LT(seam[SeamContinuity::curvature].h_jump_rms_times_diameter, 0.005);
}

}  // namespace
}  // namespace loopmend
