#include "rim/rim_blend.h"

#include "analysis/seam_report.h"
#include "evolution/evolution.h"
#include "evolution/mesh_care.h"
#include "mesh/quality.h"
#include "operators/local_fit.h"
#include "operators/operator_set.h"
#include "rim/rim_roughness.h"
#include "samples/random.h"
#include "support/patches.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
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

Eigen::VectorXd trust_of(const Patch& patch) {
  const double radius = rim_roughness(patch).radius;
  return rim_trust(patch, radius, data_trust(patch, radius));
}

TEST(RimBlend, EvenRimIsTrusted) {
  const Patch patch = test::exact_sphere_patch(4, 0.8);
  EXPECT_GT(trust_of(patch).minCoeff(), 0.999);
}

/// A patch in the unit sphere with ever finer triangles towards x = 1, where alone the surroundings are scattered.
Patch patch_with_fine_and_scattered_side() {
  TriangleSoup soup = make_icosphere(5);
  Random random(4);
  constexpr double pull = 0.8;  // conformal: the sphere is mapped to itself
  for (Vec3& p : soup.points) {
    const double x = (p.x() + pull) / (1 + pull * p.x()), shrink = std::sqrt(1 - pull * pull) / (1 + pull * p.x());
    p = Vec3(x, shrink * p.y(), shrink * p.z()).normalized();
    if (p.x() > 0.3) p *= 1 + 0.02 * random.bell();
  }
  return test::start_of(make_surface_model(trim_rims(cut(soup, [](const Vec3& p) { return p.z() > 0.8; }))));
}

Eigen::VectorXd bend_of(const Patch& patch) {
  std::vector<int> all(patch.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  Eigen::MatrixX3d x(patch.vertex_count(), 3);
  for (int i = 0; i < patch.vertex_count(); ++i) x.row(i) = patch.positions[i].transpose();
  const SparseMatrix C = clamped_cotan_stiffness(patch.positions, patch.triangles, all, robust_clamp);
  const Eigen::VectorXd mass = barycentric_areas(patch.positions, patch.triangles);
  return (mass.cwiseInverse().asDiagonal() * Eigen::MatrixX3d(C * x)).rowwise().norm();
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
  const Patch patch = passage_between(literal, robust, 0.3, trust);
  for (int i = 0; i < patch.free_count; ++i) {
    EXPECT_GE(share_at(patch, i), 0.3 - 1e-9);
    EXPECT_LE(share_at(patch, i), 0.3 / (0.3 + 0.07) + 1e-9);
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

/// Most vertices of the rim lie on its fine side, most of its length on the other.
TEST(RimBlend, TheFinestPartOfTheRimDoesNotDecideWhatIsUsual) {
  Patch patch = patch_with_fine_and_scattered_side();
  const double radius = rim_roughness(patch).radius;
  ASSERT_TRUE(blend_once(patch, SeamContinuity::tangent, {}, radius));  // no crease at the loop
  const Eigen::VectorXd bend = bend_of(patch);
  std::vector<double> rim;
  for (int v = patch.free_count; v < patch.vertex_count(); ++v)
    if (patch.ring[v] <= 2) rim.push_back(bend[v]);
  std::nth_element(rim.begin(), rim.begin() + static_cast<long>(rim.size() / 2), rim.end());
  const double limit_by_vertices = 1 / (1 / (8 * rim[rim.size() / 2]) + radius / 8);
  const Eigen::VectorXd known = Eigen::VectorXd::Ones(patch.vertex_count() - patch.free_count);
  const Eigen::VectorXd trust = rim_trust(patch, radius, known);
  int doubted = 0;
  for (int v : patch.loops[0]) {
    if (trust[v] == 1) continue;
    ++doubted;
    EXPECT_LT(std::sqrt(trust[v]) * bend[v], 0.9 * limit_by_vertices);
  }
  EXPECT_GT(doubted, 0);
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
  const Patch expected = solved(start, {}).patch(), patch = solved(turned, {}).patch(),
              literal = solved(turned, fixed).patch();
  const auto way = [&](const Patch& other) {
    double most = 0;
    for (int i = 0; i < start.free_count; ++i)
      most = std::max(most, (other.positions[i] - expected.positions[i]).norm());
    return most;
  };
  EXPECT_LT(way(patch), 0.01 * way(literal)) << way(literal);
  EXPECT_EQ(literal.triangles, turned.triangles);
}

TEST(RimBlend, AreaThatWasLostIsTakenFromTheWiderPatchAndNoOther) {
  const Patch patch = test::exact_sphere_patch(4, 0.8);
  const auto swollen = [&](double by) {
    Patch other = patch;
    for (int i = 0; i < patch.free_count; ++i) other.positions[i] *= 1 + by;
    return other;
  };
  const Patch wide = swollen(0.05), narrow = swollen(-0.05), hardly = swollen(0.002);
  EXPECT_EQ(with_lost_area(patch, narrow, wide).positions, patch.positions);
  EXPECT_EQ(with_lost_area(patch, wide, narrow).positions, patch.positions);
  for (const Patch& between : {with_lost_area(patch, hardly, wide), with_lost_area(patch, wide, hardly)})
    for (int i = 0; i < patch.free_count; ++i) {
      EXPECT_GT(between.positions[i].norm(), patch.positions[i].norm());
      EXPECT_LT(between.positions[i].norm(), wide.positions[i].norm());
    }
  const Patch all = with_lost_area(patch, wide, wide);
  for (int i = 0; i < patch.free_count; ++i) EXPECT_LT((all.positions[i] - wide.positions[i]).norm(), 1e-12);
}

TEST(RimBlend, FairingsAfterTheFirstMoveAlongNormals) {
  EvolutionOptions options;
  options.triangles = PatchTriangles::fixed;
  Evolution evolution(rough_start(), options);
  evolution.step({});
  for (int k = 1; k < 3; ++k) {
    const Patch before = evolution.patch();
    evolution.step({});
    const Patch& after = evolution.patch();
    ASSERT_EQ(after.triangles, before.triangles);
    const Points normals = angle_weighted_normals(after.positions, after.triangles);
    double along = 0, across = 0;
    for (int i = 0; i < after.free_count; ++i) {
      const Vec3 way = after.positions[i] - before.positions[i];
      along += std::pow(normals[i].dot(way), 2);
      across += normals[i].cross(way).squaredNorm();
    }
    EXPECT_GT(along, 0);
    EXPECT_LT(across, 0.05 * along);
  }
}

/// Two thirds of rough spheres are missing: in some, the vertices of the second fairing must slide, or folds are left.
TEST(RimBlend, AFairingThatWouldFoldAlongNormalsSpreadsTheVerticesAnew) {
  const auto folds_of = [](const Patch& patch) {
    return count_folds(patch.positions, patch.triangles, patch.patch_triangles);
  };
  EvolutionOptions options;
  options.boundary = BoundaryTrust::robust;
  options.triangles = PatchTriangles::fixed;
  int spread_anew = 0;
  for (double height : {-0.3, -0.4, -0.5, -0.6})
    for (double relief : {1.0, 2.0, 3.0, 6.0}) {
      const Patch start = rough_start(4, height, relief);
      options.roughness = rim_roughness(start);
      const double radius = options.roughness->radius;
      Evolution evolution(start, options);
      evolution.step({});
      const Patch before = evolution.patch();
      Patch spread = before;
      const Eigen::VectorXd trust = rim_trust(before, radius, data_trust(start, radius));
      ASSERT_TRUE(blend_once(spread, SeamContinuity::curvature, trust, radius));
      const Patch mended = along_normals(before, spread);
      const bool folds = folds_of(mended) > folds_of(spread);
      spread_anew += folds;
      evolution.step({});
      EXPECT_EQ(evolution.patch().positions, (folds ? spread : mended).positions);
    }
  EXPECT_GT(spread_anew, 0);
  EXPECT_LT(spread_anew, 16);
}

TEST(RimBlend, ASpikeDoesNotBendThePatch) {
  Patch patch = test::start_of(test::open_sphere(5, 0.8));
  patch.positions[patch.loops[0][7]] *= 1.08;
  EvolutionOptions smooth;
  smooth.boundary = BoundaryTrust::robust;
  EvolutionOptions unjudged;
  unjudged.bending = rough_bending;
  unjudged.boundary = BoundaryTrust::exact;
  const double robust = largest_distance_to_unit_sphere(solved(patch, smooth).patch());
  Evolution literal(patch, unjudged);
  literal.run(nullptr, {});
  EXPECT_LT(robust, 0.3 * largest_distance_to_unit_sphere(literal.patch()));
}

TEST(RimBlend, CleanSurroundingsGiveTheSameBitsWithAndWithoutTheJudgement) {
  const Patch start = test::start_of(test::rough_open_sphere(4, 0.6));
  EvolutionOptions exact;
  exact.boundary = BoundaryTrust::exact;
  const Evolution automatic = solved(start, {}), literal = solved(start, exact);
  EXPECT_EQ(automatic.patch().positions, literal.patch().positions);
  EXPECT_EQ(automatic.roughness()->kind, Surroundings::smooth);
}

TEST(RimBlend, RoughSurroundingsAreBlendedLinearly) {
  const Patch start = rough_start();
  const Evolution evolution = solved(start, {});
  EXPECT_EQ(evolution.roughness()->kind, Surroundings::rough);
  EXPECT_EQ(evolution.history().size(), 3U);
  EXPECT_EQ(evolution.bending(), rough_bending);
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
    const Evolution evolution = solved(start, options);
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
