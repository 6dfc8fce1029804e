// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighborhood/weighted_fairing.h"

#include "analysis/seam_report.h"
#include "core/random.h"
#include "evolution/evolution.h"
#include "evolution/mesh_improvement.h"
#include "operators/curvature_energy.h"
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

/// A sphere whose relief has all wavelengths, and no cap.
Patch rough_start(int level = 5, double height = 0.85, double relief = 0.01) {
  TriangleSoup scan = make_icosphere(level);
  const std::vector<double> rough = test::random_relief(scan, 7);
  for (std::size_t i = 0; i < scan.points.size(); ++i) scan.points[i] *= 1 + relief * rough[i];
  return test::start_of(make_surface_model(trim_boundaries(cut(scan, [=](const Vec3& p) { return p.z() > height; }))));
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

Eigen::VectorXd confidence_of(const Patch& patch) {
  const double radius = patch_radius(patch);
  return confidence_weights(patch, radius, data_confidence(patch, radius));
}

TEST(WeightedFairing, EvenBoundaryIsTrusted) {
  const Patch patch = test::exact_sphere_patch(4, 0.8);
  EXPECT_GT(confidence_of(patch).minCoeff(), 0.999);
}

/// One half of the neighborhood is left as it is: there the curvature is known, and on the other it is not.
TEST(WeightedFairing, ScatteredDataAreTrustedLessVertexByVertex) {
  TriangleSoup soup = make_icosphere(5);
  Random random(4);
  for (Vec3& p : soup.points)
    if (p.x() > 0) p *= 1 + 0.02 * random.bell();
  const Patch patch =
      test::start_of(make_surface_model(trim_boundaries(cut(soup, [](const Vec3& p) { return p.z() > 0.85; }))));
  const Eigen::VectorXd confidence = data_confidence(patch, patch_radius(patch));
  double noisy = 0, clean = 1;
  for (int v : patch.loops[0]) {
    const double x = patch.to_mesh(patch.positions[v]).x();
    if (x > 0.2) noisy = std::max(noisy, confidence[v - patch.free_count]);
    if (x < -0.25) clean = std::min(clean, confidence[v - patch.free_count]);
  }
  EXPECT_LT(noisy, 0.95);
  EXPECT_GT(clean, 0.999);
}

TEST(WeightedFairing, OneSpikeAtTheBoundaryLosesItsTrustAndTheRestKeepsIt) {
  Patch patch = test::exact_sphere_patch(5, 0.8);
  const int spike = patch.loops[0][7];
  patch.positions[spike] *= 1.08;
  const Eigen::VectorXd confidence = confidence_of(patch);
  EXPECT_LT(confidence[spike], 0.1);
  int doubted = 0;
  for (int i = 0; i < patch.vertex_count(); ++i) doubted += confidence[i] < 0.5;
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

TEST(WeightedFairing, FairingsTurnEdgesThatAreNotDelaunay) {
  const Patch start = with_delaunay_flips(rough_start()), turned = with_turned_edges(start);
  ASSERT_NE(turned.triangles, start.triangles);
  EvolutionOptions fixed;
  fixed.triangles = PatchTriangles::fixed;
  EvolutionOptions free;
  fixed.boundary = free.boundary = BoundaryTrust::robust;
  const Patch expected = evolved(start, free).patch(), patch = evolved(turned, free).patch(),
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

TEST(WeightedFairing, ASpikeDoesNotBendThePatch) {
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

TEST(WeightedFairing, ACleanNeighborhoodGivesTheSameBitsWithAndWithoutTheJudgement) {
  const Patch start = test::start_of(test::open_sphere(4, 0.6));
  EvolutionOptions exact;
  exact.boundary = BoundaryTrust::exact;
  const Evolution automatic = evolved(start, {}), literal = evolved(start, exact);
  EXPECT_EQ(automatic.patch().positions, literal.patch().positions);
  EXPECT_TRUE(automatic.split()->is_exact());
}

TEST(WeightedFairing, InARoughNeighborhoodThePatchBulgesLikeTheSphere) {
  const Patch start = rough_start();
  const Evolution evolution = evolved(start, {});
  EXPECT_FALSE(evolution.split()->is_exact());
  EXPECT_EQ(evolution.method(), Method::split_flow);
  EXPECT_GT(largest_distance_to_unit_sphere(start), 0.15);
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
  double boundary = 0;
  for (int v : start.loops[0])
    boundary += start.to_mesh(start.positions[v]).z() / static_cast<double>(start.loops[0].size());
  // The minimal surface through a circle is the flat disc; a harmonic function has its mean in the middle.
  EXPECT_NEAR(top[SeamContinuity::position], boundary, 0.005);
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
