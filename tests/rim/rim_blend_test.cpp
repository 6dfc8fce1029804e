// SPDX-License-Identifier: GPL-3.0-or-later
#include "rim/rim_blend.h"

#include "analysis/seam_report.h"
#include "evolution/evolution.h"
#include "evolution/mesh_improvement.h"
#include "operators/curvature_energy.h"
#include "rim/rim_roughness.h"
#include "samples/random.h"
#include "support/patches.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace loopmend {
namespace {

/// A sphere whose roughness is that of scans: relief of several wavelengths down to a few edges.
Patch rough_start(int level = 5, double height = 0.85, double relief = 1) {
  TriangleSoup scan = make_icosphere(level);
  for (Vec3& p : scan.points)
    p *= 1 + relief * (0.01 * std::sin(17 * p.x()) * std::sin(19 * p.y()) + 0.004 * std::sin(43 * p.x() + 7 * p.z()) +
                       0.002 * std::cos(71 * p.y() - 23 * p.x()));
  return test::start_of(make_surface_model(trim_rims(cut(scan, [=](const Vec3& p) { return p.z() > height; }))));
}

/// Run to its end, whatever that is called: a linear fairing converges to nothing.
Evolution evolved(const Patch& start, const EvolutionOptions& options) {
  Evolution evolution(start, options);
  const PatchStatus status = evolution.run(nullptr, {});
  EXPECT_NE(status, PatchStatus::stalled) << evolution.message();
  EXPECT_NE(status, PatchStatus::step_limit) << evolution.message();
  return evolution;
}

double largest_distance_to_unit_sphere(const Patch& patch) {
  double largest = 0;
  for (int i = 0; i < patch.free_count; ++i)
    largest = std::max(largest, std::abs(patch.to_mesh(patch.positions[i]).norm() - 1));
  return largest;
}

Eigen::VectorXd trust_of(const Patch& patch) {
  const double radius = rim_roughness(patch).radius;
  return rim_trust(patch, radius, data_trust(patch, radius));
}

TEST(RimBlend, EvenRimIsTrusted) {
  const Patch patch = test::exact_sphere_patch(4, 0.8);
  EXPECT_GT(trust_of(patch).minCoeff(), 0.999);
}

/// One half of the surroundings is left as it is: there the curvature is known, and on the other it is not.
TEST(RimBlend, ScatteredDataAreTrustedLessVertexByVertex) {
  TriangleSoup soup = make_icosphere(5);
  Random random(4);
  for (Vec3& p : soup.points)
    if (p.x() > 0) p *= 1 + 0.02 * random.bell();
  const Patch patch =
      test::start_of(make_surface_model(trim_rims(cut(soup, [](const Vec3& p) { return p.z() > 0.85; }))));
  const Eigen::VectorXd trust = data_trust(patch, rim_roughness(patch).radius);
  double noisy = 0, clean = 1;
  for (int v : patch.loops[0]) {
    const double x = patch.to_mesh(patch.positions[v]).x();
    if (x > 0.2) noisy = std::max(noisy, trust[v - patch.free_count]);
    if (x < -0.25) clean = std::min(clean, trust[v - patch.free_count]);
  }
  EXPECT_LT(noisy, 0.95);
  EXPECT_GT(clean, 0.999);
}

TEST(RimBlend, PassageKeepsTheLiteralPatchLongestWhereTheRimIsTrusted) {
  const Patch literal = test::exact_sphere_patch(5, 0.8);
  Patch robust = literal;
  for (int i = 0; i < robust.free_count; ++i) robust.positions[i] *= 1.01;
  Eigen::VectorXd trust = Eigen::VectorXd::Ones(literal.vertex_count());
  const auto share_at = [&](const Patch& patch, int i) {
    return (patch.positions[i] - literal.positions[i]).norm() / (robust.positions[i] - literal.positions[i]).norm();
  };
  for (double share : {0.0, 0.3, 1.0})
    for (int i = 0; i < literal.free_count; ++i)
      EXPECT_NEAR(share_at(passage_between(literal, robust, share, trust), i), share, 1e-9);
  EXPECT_EQ(passage_between(literal, robust, 0, trust).positions, literal.positions);
  for (int v : literal.loops[0])
    if (literal.to_mesh(literal.positions[v]).x() > 0) trust[v] = 0.1;
  double last = 0;
  for (double share : {0.1, 0.3, 0.6, 0.9}) {
    const Patch patch = passage_between(literal, robust, share, trust);
    double doubted = 0, trusted = 0, middle = 0, of_doubted = 0, of_trusted = 0, of_middle = 0;
    for (int i = 0; i < patch.free_count; ++i) {
      const Vec3 p = literal.to_mesh(literal.positions[i]);
      const double way = std::hypot(p.x(), p.y()) / 0.6, at = share_at(patch, i);  // 0.6: radius of the loop
      if (way > 0.9 && p.x() > 0.4) doubted += at, ++of_doubted;
      if (way > 0.9 && p.x() < -0.4) trusted += at, ++of_trusted;
      if (way < 0.15) middle += at, ++of_middle;
    }
    doubted /= of_doubted, trusted /= of_trusted, middle /= of_middle;
    EXPECT_NEAR(trusted, share, 0.02);
    // Ten times as many for the robust patch: measured 0.51, 0.80, 0.93 and 0.99.
    EXPECT_GT(doubted, 0.95 * 10 * share / (1 + 9 * share));
    // A harmonic function has its mean in the middle, and each side has half of the circle.
    EXPECT_NEAR(middle, (doubted + trusted) / 2, 0.02);
    EXPECT_GT(middle, last);
    last = middle;
  }
}

TEST(RimBlend, OneSpikeAtTheRimLosesItsTrustAndTheRestKeepsIt) {
  Patch patch = test::exact_sphere_patch(5, 0.8);
  const int spike = patch.loops[0][7];
  patch.positions[spike] *= 1.08;
  const Eigen::VectorXd trust = trust_of(patch);
  EXPECT_LT(trust[spike], 0.1);
  int doubted = 0;
  for (int i = 0; i < patch.vertex_count(); ++i) doubted += trust[i] < 0.5;
  EXPECT_LE(doubted, 9);  // the spike and what has an edge to it
}

/// Every so often an edge between two of the patch's triangles is turned to the other diagonal.
Patch with_turned_edges(Patch patch) {
  std::map<std::pair<int, int>, std::pair<int, int>> side;  // from, to: triangle, corner
  for (int f = 0; f < patch.patch_triangles; ++f)
    for (int k = 0; k < 3; ++k) side[{patch.triangles[f][k], patch.triangles[f][(k + 1) % 3]}] = {f, k};
  std::vector<char> taken(patch.triangles.size(), 0);
  for (int f = 0; f < patch.patch_triangles; f += 5) {
    const auto [a, b, c] = patch.triangles[f];
    const auto other = side.find({b, a});
    if (other == side.end() || taken[f] || taken[other->second.first]) continue;
    const auto [g, corner] = other->second;
    const int d = patch.triangles[g][(corner + 2) % 3];
    if (side.contains({c, d}) || side.contains({d, c})) continue;
    taken[f] = taken[g] = 1;
    patch.triangles[f] = {c, d, b};
    patch.triangles[g] = {d, c, a};
  }
  return patch;
}

TEST(RimBlend, FairingsTurnEdgesThatAreNotDelaunay) {
  const Patch start = with_delaunay_flips(rough_start()), turned = with_turned_edges(start);
  ASSERT_NE(turned.triangles, start.triangles);
  EvolutionOptions fixed;
  fixed.triangles = PatchTriangles::fixed;
  const Patch expected = evolved(start, {}).patch(), patch = evolved(turned, {}).patch(),
              literal = evolved(turned, fixed).patch();
  const auto way = [&](const Patch& other) {
    double most = 0;
    for (int i = 0; i < start.free_count; ++i)
      most = std::max(most, (other.positions[i] - expected.positions[i]).norm());
    return most;
  };
  EXPECT_LT(way(patch), 0.01 * way(literal)) << way(literal);
  EXPECT_EQ(literal.triangles, turned.triangles);
}

TEST(RimBlend, ASpikeDoesNotBendThePatch) {
  Patch patch = test::start_of(test::open_sphere(5, 0.8));
  patch.positions[patch.loops[0][7]] *= 1.08;
  EvolutionOptions smooth;
  smooth.boundary = BoundaryTrust::robust;
  EvolutionOptions unjudged;
  unjudged.bending = rough_bending;
  unjudged.boundary = BoundaryTrust::exact;
  const double robust = largest_distance_to_unit_sphere(evolved(patch, smooth).patch());
  Evolution literal(patch, unjudged);
  literal.run(nullptr, {});
  EXPECT_LT(robust, 0.3 * largest_distance_to_unit_sphere(literal.patch()));
}

TEST(RimBlend, CleanSurroundingsGiveTheSameBitsWithAndWithoutTheJudgement) {
  const Patch start = test::start_of(test::rough_open_sphere(4, 0.6));
  EvolutionOptions exact;
  exact.boundary = BoundaryTrust::exact;
  const Evolution automatic = evolved(start, {}), literal = evolved(start, exact);
  EXPECT_EQ(automatic.patch().positions, literal.patch().positions);
  EXPECT_EQ(automatic.roughness()->kind, Surroundings::smooth);
}

TEST(RimBlend, OnRoughSurroundingsThePatchBulgesLikeTheSphere) {
  const Patch start = rough_start();
  const Evolution evolution = evolved(start, {});
  EXPECT_EQ(evolution.roughness()->kind, Surroundings::rough);
  EXPECT_GT(largest_distance_to_unit_sphere(start), 0.15);
  // Measured: 0.032, of which 0.016 is the relief.
  EXPECT_LT(largest_distance_to_unit_sphere(evolution.patch()), 0.04);
  ASSERT_EQ(evolution.patch().vertex_count(), start.vertex_count());
  for (int i = start.free_count; i < start.vertex_count(); ++i)
    EXPECT_EQ(evolution.patch().positions[i], start.positions[i]);
}

/// Position: least area among all, and a kink. Tangent: no kink, a jump of H. Curvature: neither.
TEST(SeamContinuity, EachOrderHasWhatItPromisesAndNoMore) {
  const Patch start = test::start_of(test::open_sphere(5, 0.7));
  std::map<SeamContinuity, SeamReport> seam;
  std::map<SeamContinuity, double> top;  // of the patch, on the axis
  for (SeamContinuity continuity : {SeamContinuity::position, SeamContinuity::tangent, SeamContinuity::curvature}) {
    EvolutionOptions options;
    options.continuity = continuity;
    const Evolution evolution = evolved(start, options);
    const Patch& patch = evolution.patch();
    seam[continuity] = seam_reports(patch).front();
    for (int i = 0; i < patch.free_count; ++i) {
      const Vec3 p = patch.to_mesh(patch.positions[i]);
      if (std::hypot(p.x(), p.y()) < 0.1) top[continuity] = std::max(top[continuity], p.z());
    }
  }
  double rim = 0;
  for (int v : start.loops[0])
    rim += start.to_mesh(start.positions[v]).z() / static_cast<double>(start.loops[0].size());
  // The minimal surface through a circle is the flat disc; a harmonic function has its mean in the middle.
  EXPECT_NEAR(top[SeamContinuity::position], rim, 0.005);
  EXPECT_GT(seam[SeamContinuity::position].g1_rms_deg, 20);
  EXPECT_LT(seam[SeamContinuity::tangent].g1_rms_deg, 2);
  EXPECT_GT(seam[SeamContinuity::tangent].h_jump_rms_times_diameter, 0.05);
  EXPECT_LT(seam[SeamContinuity::curvature].g1_rms_deg, 0.05);
  EXPECT_LT(seam[SeamContinuity::curvature].h_jump_rms_times_diameter, 0.005);
  EXPECT_NEAR(top[SeamContinuity::curvature], 1, 1e-4);
  EXPECT_LT(top[SeamContinuity::tangent], 0.999);
}

}  // namespace
}  // namespace loopmend
