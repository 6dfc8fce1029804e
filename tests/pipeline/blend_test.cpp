// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/blend.h"

#include "core/error.h"
#include "samples/analytic_surfaces.h"
#include "support/patches.h"
#include "support/tubes.h"

#include <gtest/gtest.h>

#include <cstring>

namespace loopmend {
namespace {

template <class Distance>
double rms(const Patch& patch, const Distance& distance) {
  double sum = 0;
  for (int i = 0; i < patch.free_count; ++i) sum += std::pow(distance(patch.to_mesh(patch.positions[i])), 2);
  return std::sqrt(sum / patch.free_count);
}

void expect_good(const BlendResult& result) {
  EXPECT_EQ(result.outcome.status, PatchStatus::converged) << result.outcome.message;
  EXPECT_EQ(result.outcome.validity.folds, 0);
  EXPECT_EQ(result.outcome.validity.intersections, 0);
  double worst = 0;
  for (const SeamReport& seam : result.outcome.seams) worst = std::max(worst, seam.g1_rms_deg);
  EXPECT_EQ(result.outcome.message.english().find("crease") != std::string::npos, worst > 5)
      << worst << " " << result.outcome.message;
}

TEST(BlendLoops, TubesAtOddAnglesConverge) {
  for (const std::vector<TubeShape>& tubes : std::vector<std::vector<TubeShape>>{
           {test::tube_towards({1, 0, 0}, 2), test::tube_towards({0, 1, 0}, 2)},
           {test::tube_towards({1, 0, 0}, 2), test::tube_towards({0.5, 0.8, 0.2}, 2, 0.5)},
           {test::tube_towards({1, 0, 0}), test::tube_towards({0, 1, 0}), test::tube_towards({0, 0, 1})},
           {test::tube_towards({1, 0.1, 0}, 1.8), test::tube_towards({-1, 0.3, 0.2}, 1.5, 0.5),
            test::tube_towards({0.3, 1, 0.2}, 1.6, 0.6), test::tube_towards({0.1, -1, 0.8}, 1.7, 0.7)},
           six_tubes(24)}) {
    SurfaceModel model = test::tubes_model(tubes);
    const SurfaceModel before = model;
    const BlendResult result = blend_loops(model, test::inner_boundaries(model, tubes), {}, {});
    expect_good(result);
    EXPECT_LT(result.outcome.energy.final, result.outcome.energy.initial);
    EXPECT_EQ(find_boundary_loops(model).size(), tubes.size());
    EXPECT_EQ(
        std::memcmp(model.soup.points.data(), before.soup.points.data(), before.soup.points.size() * sizeof(Vec3)), 0);
  }
}

/// Between these tubes ∫‖∇H‖² falls on and on while a neck grows ever thinner (random sets 12 and 142).
TEST(BlendLoops, ComesToRestWhereANeckGrowsThin) {
  const auto tube = [](const Vec3& start, double radius, int around) {
    return TubeShape{start, start.normalized(), radius, 2, around};
  };
  for (const std::vector<TubeShape>& tubes : std::vector<std::vector<TubeShape>>{
           {tube({1.24423, -0.894402, 1.44239}, 0.641074, 19), tube({0.792144, 0.680567, 0.992102}, 0.52344, 28)},
           {tube({-1.03357, -0.125675, 0.599922}, 0.476552, 37), tube({1.2977, -0.636319, 0.24795}, 0.518127, 35),
            tube({1.04764, -0.885301, -1.57802}, 0.649545, 18),
            tube({-0.0524648, -1.45332, 0.374658}, 0.473592, 22)}}) {
    SurfaceModel model = test::tubes_model(tubes);
    const BlendResult result = blend_loops(model, test::inner_boundaries(model, tubes), {}, {});
    expect_good(result);
    EXPECT_EQ(result.outcome.reason.empty(), result.outcome.bending == 0) << "bending energy must be told of";
  }
}

/// Radius of the unduloid with H = −1/2 · 2/(0.7 + 1.3) between its neck 0.7 at z = 0 and its belly 1.3, by the midpoint
/// rule for r″ from r/√(1 + r′²) = (r² + 0.7 · 1.3)/(0.7 + 1.3).
double unduloid_radius(double z) {
  static const std::vector<double> table = [] {
    const auto acceleration = [](double r) {
      const double p = r * r + 0.91, w = 2 * r / p;
      return w * 2 * (0.91 - r * r) / (p * p);
    };
    std::vector<double> radius;
    double r = 0.7, v = 0;
    for (int i = 0; i <= 50000; ++i) {
      radius.push_back(r);
      const double middle = r + v * 5e-5, speed = v + acceleration(r) * 5e-5;
      r += speed * 1e-4;
      v += acceleration(middle) * 1e-4;
    }
    return radius;
  }();
  return table[static_cast<std::size_t>(std::lround(std::abs(z) * 1e4))];
}

/// A ring is cut out of a surface of revolution about z: −2 ≤ z ≤ 4, without |z − 1| < 0.7.
struct MissingRing {
  double (*radius)(double z);
  double best_peers_jump;  ///< docs/math/energy_to_matrix.md, "Peers"
};

void expect_back(const MissingRing& ring, int around) {
  SCOPED_TRACE(around);
  SurfaceModel model = make_surface_model(cut(make_revolution(ring.radius, -2, 4, around, around),
                                              [](const Vec3& p) { return std::abs(p.z() - 1) < 0.7; }));
  std::vector<BoundaryLoop> gap;
  for (const BoundaryLoop& loop : find_boundary_loops(model))
    if (std::abs(loop.center.z() - 1) < 1.5) gap.push_back(loop);
  ASSERT_EQ(gap.size(), 2u);
  const double diameter = std::max(gap[0].diameter, gap[1].diameter);
  const BlendResult result = blend_loops(model, gap, {}, {});
  expect_good(result);
  const double distance =
      rms(result.outcome.patch, [&](const Vec3& p) { return std::hypot(p.x(), p.y()) - ring.radius(p.z()); }) /
      diameter;
  EXPECT_LT(distance, 1e-4);
  for (const SeamReport& seam : result.outcome.seams) EXPECT_LT(seam.h_jump_rms_times_diameter, ring.best_peers_jump);
  EXPECT_EQ(find_boundary_loops(model).size(), 2u);
  std::printf("%d around: %.1e diameters, jump of H x diameter %.1e and %.1e\n", around, distance,
              result.outcome.seams[0].h_jump_rms_times_diameter, result.outcome.seams[1].h_jump_rms_times_diameter);
}

TEST(BlendLoops, ARingThatIsMissingFromACylinderComesBack) {
  for (int around : {40, 60}) expect_back({[](double) { return 1.0; }, 0.026}, around);
}

TEST(BlendLoops, ARingThatIsMissingFromAnUnduloidComesBack) {
  for (int around : {40, 60}) expect_back({unduloid_radius, 0.036}, around);
}

TEST(BlendLoops, IslandsInAHoleStayWhereTheyAre) {
  SurfaceModel model = make_surface_model(cut(make_icosphere(5), [](const Vec3& p) {
    return p.z() > 0.6 && (p - Vec3(0.4, 0, 0.9).normalized()).norm() > 0.15 &&
           (p - Vec3(-0.4, 0.1, 0.9).normalized()).norm() > 0.15;
  }));
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  ASSERT_EQ(loops.size(), 3u);
  const BlendResult result = blend_loops(model, loops, {}, {});
  expect_good(result);
  EXPECT_LT(rms(result.outcome.patch, [](const Vec3& p) { return p.norm() - 1; }), 1e-5);
  EXPECT_TRUE(find_boundary_loops(model).empty());
}

TEST(BlendLoops, AnInsideOutPartIsTurnedRound) {
  const TriangleSoup a = make_tube({{0, 0, 1}, {0, 0, 1}, 1, 2, 24});
  TriangleSoup b = make_tube({{0, 0, -1}, {0, 0, -1}, 1, 2, 24});
  for (Triangle& t : b.triangles) std::swap(t[1], t[2]);
  SurfaceModel model = make_surface_model(joined({a, b}));
  std::vector<BoundaryLoop> loops;
  for (const BoundaryLoop& loop : find_boundary_loops(model))
    if (std::abs(loop.center.z()) < 1.5) loops.push_back(loop);
  if (loops.front().center.z() < 0) std::swap(loops[0], loops[1]);
  const BlendResult result = blend_loops(model, loops, {}, {});
  expect_good(result);
  EXPECT_EQ(result.turned_faces, b.triangles.size());
}

// The patch has to turn right round within a few edges.
TEST(BlendLoops, ACreaseThatIsLeftBetweenATubesOwnEndsIsToldOf) {
  SurfaceModel model = make_surface_model(make_cylinder(3, 24));
  const BlendResult result = blend_loops(model, find_boundary_loops(model), {}, {});
  ASSERT_NE(result.outcome.status, PatchStatus::failed) << result.outcome.message;
  double worst = 0;
  for (const SeamReport& seam : result.outcome.seams) worst = std::max(worst, seam.g1_rms_deg);
  EXPECT_GT(worst, 5);  // measured: 30
  EXPECT_NE(result.outcome.message.english().find("crease"), std::string::npos) << result.outcome.message;
}

TEST(BlendLoops, OnCancelTheModelIsAsItWas) {
  const std::vector<TubeShape> tubes = six_tubes(24);
  SurfaceModel model = test::tubes_model(tubes);
  const std::size_t faces = model.soup.triangles.size();
  CancelToken cancel;
  cancel.cancel();
  EXPECT_TRUE(blend_loops(model, test::inner_boundaries(model, tubes), {}, cancel).outcome.patch.positions.empty());
  EXPECT_EQ(model.soup.triangles.size(), faces);
}

}  // namespace
}  // namespace loopmend
