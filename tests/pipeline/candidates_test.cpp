// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/candidates.h"
#include "core/random.h"
#include "filling/fairing.h"
#include "mesh/mesh_arrays.h"
#include "samples/analytic_surfaces.h"
#include "support/patches.h"
#include "support/sharp_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace loopmend {
namespace {

PatchResult solved(const ScanIndex& scan, const Patch& initial, const std::vector<BoundaryLoop>& loops) {
  return solve_patch({scan, initial, loops}, {}, nullptr, {});
}

/// A sphere with relief and white noise, without its cap: the same triangles and the same hole, whatever their heights.
SurfaceModel rough_open_sphere(double relief, double noise) {
  TriangleSoup soup = trim_boundaries(cut(make_icosphere(5), [](const Vec3& p) { return p.z() > 0.85; }));
  const std::vector<double> rough = test::random_relief(soup, 7);
  Random random(7);
  for (std::size_t i = 0; i < soup.points.size(); ++i) soup.points[i] *= 1 + noise * random.bell() + relief * rough[i];
  return make_surface_model(soup);
}

/// What becomes of one initial patch when its neighborhood changes: the triangles stay, the free vertices are carried along. The
/// initial patch that belongs to each boundary would have triangles of its own, which change one by one as the boundary does; on a rough
/// boundary another triangulation alone moves the patch by up to 5 % of an edge, whatever the kinds do.
struct Family {
  std::function<SurfaceModel(double)> surface;  ///< t = 0..1
  Patch initial;                                ///< of t = 0

  explicit Family(std::function<SurfaceModel(double)> of)
      : surface(std::move(of)),
        initial(test::start_of(surface(0))) {}

  struct Member {
    Patch patch;
    SplitEstimate split;
  };

  Member at(double t) const {
    const SurfaceModel model = surface(t);
    Patch moved = initial;
    for (int i = moved.free_count; i < moved.vertex_count(); ++i)
      moved.positions[i] = moved.to_frame(model.mesh.point(TriMesh::VertexHandle(moved.view_vertex[i])));
    const Patch start = carried_along(moved);
    PatchResult evolved = solved(ScanIndex(model), start, {});
    EXPECT_TRUE(is_at_end(evolved.status)) << to_string(evolved.status) << evolved.message;
    EXPECT_EQ(evolved.patch.free_count, initial.free_count) << "remeshed at t = " << t;
    return {std::move(evolved.patch), estimate_split(start)};
  }

 private:
  /// Free vertices that go along with the boundary.
  Patch carried_along(Patch moved) const {
    Points way(moved.vertex_count());
    for (int i = 0; i < moved.vertex_count(); ++i) way[i] = moved.positions[i] - initial.positions[i];
    std::vector<int> own(initial.patch_triangles);
    std::iota(own.begin(), own.end(), 0);
    minimise_quadratic_form(clamped_cotan_stiffness(initial.positions, initial.triangles, own, robust_clamp), way, 0,
                            initial.free_count);
    for (int i = 0; i < moved.free_count; ++i) moved.positions[i] += way[i];
    return moved;
  }
};

/// The greatest change of height over the sphere, mesh units: vertices may slide along it.
double change(const Family::Member& a, const Family::Member& b) {
  double most = 0;
  for (int i = 0; i < std::min(a.patch.free_count, b.patch.free_count); ++i)
    most = std::max(
        most, std::abs(a.patch.to_mesh(a.patch.positions[i]).norm() - b.patch.to_mesh(b.patch.positions[i]).norm()));
  return most;
}

constexpr double edge = 0.038;  // mean, of the icosphere
enum class Ends { smooth, split };

/// Measured: up to 0.1 of an edge, under a relief of 0.05 edges; the wavelengths of the split go in steps.
constexpr double tolerance = 0.15 * edge;

/// Where the patch changes most, and where the kind changes, the interval is halved again and again: a jump stays.
/// @returns what is left of the change over 1/4000 of the family or less.
double steepest(const Family& family, int intervals, Ends first, Ends last) {
  std::vector<Family::Member> members;
  for (int k = 0; k <= intervals; ++k) members.push_back(family.at(static_cast<double>(k) / intervals));
  EXPECT_EQ(members.front().split.is_exact(), first == Ends::smooth);
  EXPECT_EQ(members.back().split.is_exact(), last == Ends::smooth);
  EXPECT_GT(change(members.front(), members.back()), 0.01 * edge);
  double most = 0, left = 0;
  for (int k = 0; k < intervals; ++k) most = std::max(most, change(members[k], members[k + 1]));
  for (int k = 0; k < intervals; ++k) {
    Family::Member a = members[k], b = members[k + 1];
    if (change(a, b) < most && a.split.is_exact() == b.split.is_exact()) continue;
    double from = static_cast<double>(k) / intervals, to = static_cast<double>(k + 1) / intervals;
    while (to - from > 1.0 / 4000) {
      const double middle = (from + to) / 2;
      Family::Member m = family.at(middle);
      if (change(a, m) > change(m, b)) {
        b = std::move(m);
        to = middle;
      } else {
        a = std::move(m);
        from = middle;
      }
    }
    left = std::max(left, change(a, b));
  }
  return left;
}

TEST(InterpolationOfKinds, FromSmoothToRoughWithoutAJump) {
  EXPECT_LT(
      steepest(Family([](double t) { return rough_open_sphere(0.1 * edge * t, 0); }), 8, Ends::smooth, Ends::split),
      tolerance);
}

TEST(InterpolationOfKinds, FromSmoothToNoisyWithoutAJump) {
  EXPECT_LT(
      steepest(Family([](double t) { return rough_open_sphere(0, 0.01 * edge * t); }), 8, Ends::smooth, Ends::split),
      tolerance);
}

TEST(InterpolationOfKinds, FromRoughToNoisyWithoutAJump) {
  EXPECT_LT(steepest(Family([](double t) { return rough_open_sphere(0.1 * edge * (1 - t), 0.05 * edge * t); }), 8,
                     Ends::split, Ends::split),
            tolerance);
}

/// Almost two thirds of a cylinder's circumference are missing, over a short length: the triangulation joins the two arcs
/// along the generators, and the minimal surface sinks in between.
struct Gutter {
  SurfaceModel model;
  BoundaryLoop hole;

  explicit Gutter(double relief) {
    TriangleSoup soup = trim_boundaries(cut(make_cylinder(4, 100), [](const Vec3& p) {
      return std::abs(p.z() - 2) < 0.5 && std::abs(std::atan2(p.y(), p.x())) < 2;
    }));
    for (Vec3& p : soup.points) {
      const double way =
          1 + relief * (0.01 * std::sin(17 * p.x()) * std::sin(19 * p.y()) + 0.004 * std::sin(43 * p.x() + 7 * p.z()) +
                        0.002 * std::cos(71 * p.y() - 23 * p.x()));
      p.x() *= way;
      p.y() *= way;
    }
    model = make_surface_model(soup);
    for (const BoundaryLoop& loop : find_boundary_loops(model))
      if (loop.center.x() > 0.2) hole = loop;
  }
  Patch start(InitialShape shape) const { return *make_initial_patch(model, {hole}, {1, shape}, {}).patch; }
  /// rms over the free vertices, of the radius.
  static double off(const Patch& patch) {
    double sum = 0;
    for (int i = 0; i < patch.free_count; ++i) {
      const Vec3 p = patch.to_mesh(patch.positions[i]);
      sum += std::pow(std::hypot(p.x(), p.y()) - 1, 2);
    }
    return std::sqrt(sum / patch.free_count);
  }
};

TEST(RoughStart, TheTriangulationLiesNearerToABulgeThanTheMinimalSurface) {
  const Gutter gutter(0);  // measured: 0.0006 and 0.097
  EXPECT_LT(Gutter::off(gutter.start(InitialShape::triangulated)), 0.002);
  EXPECT_GT(Gutter::off(gutter.start(InitialShape::minimal)), 0.05);
}

TEST(RoughStart, FairingsSetOutFromTheTriangulation) {
  const Gutter gutter(1);
  const Patch initial = gutter.start(InitialShape::minimal), triangulated = gutter.start(InitialShape::triangulated);
  const ScanIndex index(gutter.model);
  const PatchResult evolved = solved(index, initial, {gutter.hole});
  EXPECT_TRUE(is_at_end(evolved.status)) << to_string(evolved.status) << evolved.message;
  EXPECT_EQ(evolved.method, Method::split_flow);
  EXPECT_EQ(evolved.validity.intersections + evolved.validity.folds, 0);
  Evolution expected(triangulated, {});
  expected.run(nullptr, {});
  EXPECT_EQ(evolved.patch.positions, expected.patch().positions);
}

TEST(RoughStart, APatchThatIsNoFillerOfTheLoopsIsItsOwnStart) {
  const Gutter gutter(1);
  const Patch initial = gutter.start(InitialShape::minimal);
  BoundaryLoop other = gutter.hole;
  other.number += 1;
  const ScanIndex index(gutter.model);
  EXPECT_EQ(solved(index, initial, {other}).patch.positions, solved(index, initial, {}).patch.positions);
}

TEST(RoughStart, ASmoothNeighborhoodGivesTheSameBitsWithAndWithoutLoops) {
  const Gutter gutter(0);
  const Patch initial = gutter.start(InitialShape::minimal);
  ASSERT_TRUE(estimate_split(initial).is_exact());
  const ScanIndex index(gutter.model);
  EXPECT_EQ(solved(index, initial, {gutter.hole}).patch.positions, solved(index, initial, {}).patch.positions);
}

/// A sheet of its own stands across the top of where the patch would run: the split flow loses to a candidate that passes under it.
TEST(RoughBoundary, APatchThatCutsGivesWayToACandidateThatDoesNot) {
  const SurfaceModel open = rough_open_sphere(0.2 * edge, 0);
  const BoundaryLoop hole = find_boundary_loops(open).at(0);
  const Patch initial = *make_initial_patch(open, {hole}, {}, {}).patch;
  ASSERT_FALSE(estimate_split(initial).is_exact());
  const PatchResult free = solved(ScanIndex(open), initial, {});
  ASSERT_EQ(free.validity.intersections, 0);
  double top = 0;
  for (int i = 0; i < free.patch.free_count; ++i) top = std::max(top, free.patch.to_mesh(free.patch.positions[i]).z());

  TriangleSoup soup;
  soup.points = points_of(open.mesh);
  soup.triangles = triangles_of(open.mesh);
  const int first = static_cast<int>(soup.points.size());
  // Too large for a fragment, past which the patch would be bent.
  for (const Vec3& corner : {Vec3(-edge, 0, top + 1), Vec3(edge, 0, top + 1), Vec3(0, 0, top - edge / 2)})
    soup.points.push_back(corner);
  soup.triangles.push_back({first, first + 1, first + 2});
  const SurfaceModel barred = make_surface_model(soup);
  const ScanIndex index(barred);
  ASSERT_EQ(validate(index, initial).intersections, 0);
  ASSERT_GT(validate(index, free.patch).intersections, 0);

  const PatchResult evolved = solved(index, initial, {});
  EXPECT_EQ(evolved.validity.intersections + evolved.validity.folds, 0);
  EXPECT_NE(worst(evolved.verdicts), Grade::bad);
  ASSERT_GE(evolved.attempts.size(), 2u);
  EXPECT_EQ(evolved.attempts.front(), "split flow");
  EXPECT_EQ(evolved.made_by, evolved.attempts.back());
  EXPECT_NE(evolved.reason.english().find("split flow: crosses the surface"), std::string::npos) << evolved.reason;
}

/// Noise of nearly half an edge at the boundary makes the split flow rise 0.43 diameters, where the ball rose 0.2.
TEST(RoughBoundary, APatchWithARemarkGivesWayToAGoodFairing) {
  TriangleSoup soup = trim_boundaries(cut(make_icosphere(4), [](const Vec3& p) {
    return p.z() > 0.74 * (1 + 0.1 * std::cos(3 * std::atan2(p.y(), p.x())));
  }));
  Random random(14);
  for (Vec3& p : soup.points) p *= 1 + 0.03 * random.bell();
  const SurfaceModel open = make_surface_model(soup);
  const std::vector<BoundaryLoop> loops = find_boundary_loops(open);
  const Patch initial = *make_initial_patch(open, loops, {}, {}).patch;
  const PatchResult result = solved(ScanIndex(open), initial, loops);
  EXPECT_EQ(result.attempts, (std::vector<std::string>{"split flow", "robust fairing"}));
  EXPECT_EQ(result.reason.code, "first_candidate_remarked") << result.reason;
  ASSERT_EQ(result.verdicts.size(), 1u);
  EXPECT_EQ(result.verdicts.front().grade, Grade::good);
  EXPECT_LT(result.verdicts.front().height, 0.2);
}

}  // namespace
}  // namespace loopmend
