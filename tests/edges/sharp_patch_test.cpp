// SPDX-License-Identifier: GPL-3.0-or-later
#include "edges/sharp_patch.h"

#include "core/error.h"
#include "core/random.h"
#include "filling/loop_patch.h"
#include "mesh/boundary_loops.h"
#include "pipeline/edge_preview.h"
#include "pipeline/fill_holes.h"
#include "pipeline/flat_cut.h"
#include "samples/analytic_surfaces.h"
#include "support/sharp_surfaces.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace loopmend {
namespace {

using testing::Contains;
using testing::Not;

/// Distance from the surface of the cube [0, 1]³.
double off_cube(const Vec3& p) {
  const Vec3 q = (p - Vec3::Constant(0.5)).cwiseAbs() - Vec3::Constant(0.5);
  return std::abs(q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0));
}

/// Distance from the closed cylinder of radius 1 about z, −1 ≤ z ≤ 1.
double off_cylinder(const Vec3& p) {
  const double r = p.head<2>().norm() - 1, z = std::abs(p.z()) - 1;
  return std::max(r, z) < 0 ? -std::max(r, z) : std::hypot(std::max(r, 0.0), std::max(z, 0.0));
}

struct Filled {
  SurfaceModel model;
  std::size_t points = 0;  ///< of the scan
  std::vector<HoleResult> holes;

  const PatchResult& patch() const { return holes.front().outcome(); }
  double farthest(double (*distance)(const Vec3&)) const {
    double largest = 0;
    for (std::size_t i = points; i < model.soup.points.size(); ++i)
      largest = std::max(largest, distance(model.soup.points[i]));
    return largest;
  }
};

Filled fill(const TriangleSoup& scan, const FillOptions& options = {}) {
  Filled filled{make_surface_model(scan), scan.points.size(), {}};
  filled.holes = fill_all_holes(filled.model, options);
  for (std::size_t i = 0; i < scan.points.size(); ++i) EXPECT_EQ(filled.model.soup.points[i], scan.points[i]);
  EXPECT_TRUE(find_boundary_loops(filled.model).empty());
  return filled;
}

/// The hole of a sheet alone, not its outline.
Filled fill_hole(const TriangleSoup& scan) {
  Filled filled{make_surface_model(scan), scan.points.size(), {}};
  std::vector<BoundaryLoop> holes = find_boundary_loops(filled.model);
  std::erase_if(holes, [](const BoundaryLoop& loop) { return loop.kind == LoopKind::outer_rim || loop.is_polygon; });
  filled.holes = fill_holes(filled.model, holes, {}, {}, CancelToken());
  return filled;
}

TriangleSoup without_ball(const TriangleSoup& soup, const Vec3& center, double radius) {
  return cut(soup, [&](const Vec3& p) { return (p - center).norm() < radius; });
}

TriangleSoup with_noise(TriangleSoup soup, double height) {
  Random random(7);
  for (Vec3& p : soup.points) p += height * Vec3(random.bell(), random.bell(), random.bell());
  return soup;
}

TEST(SharpEdges, AHoleAcrossAnEdgeOfACubeComesBack) {
  const Filled filled = fill(without_ball(test::make_cube(24), {1, 1, 0.5}, 0.2));
  ASSERT_EQ(filled.holes.size(), 1U);
  EXPECT_EQ(filled.patch().made_by, "sharp edges");
  EXPECT_EQ(filled.holes.front().verdict().grade, Grade::good) << filled.holes.front().verdict().message();
  EXPECT_LT(filled.farthest(off_cube), 1e-9);
  // The edge has a row of vertices on it, as dense as the neighborhood.
  int on_edge = 0;
  for (std::size_t i = filled.points; i < filled.model.soup.points.size(); ++i)
    on_edge += (filled.model.soup.points[i].head<2>() - Eigen::Vector2d(1, 1)).norm() < 1e-9;
  EXPECT_GE(on_edge, 8);
}

TEST(SharpEdges, ACornerOfACubeComesBack) {
  for (const double radius : {0.15, 0.25, 0.4}) {
    const Filled filled = fill(without_ball(test::make_cube(24), {1, 1, 1}, radius));
    EXPECT_EQ(filled.patch().made_by, "sharp edges") << radius;
    EXPECT_LT(filled.farthest(off_cube), 1e-9) << radius;
    double nearest = 1;
    for (std::size_t i = filled.points; i < filled.model.soup.points.size(); ++i)
      nearest = std::min(nearest, (filled.model.soup.points[i] - Vec3(1, 1, 1)).norm());
    EXPECT_LT(nearest, 1e-9) << radius;
  }
}

TEST(SharpEdges, TheEdgeBetweenLidAndWallOfACylinderComesBack) {
  for (const Vec3& center : {Vec3(1, 0, 1), Vec3(0.85, 0, 1), Vec3(1, 0, 0.85)}) {
    const Filled filled = fill(without_ball(test::make_closed_cylinder(72), center, 0.35));
    EXPECT_EQ(filled.patch().made_by, "sharp edges");
    EXPECT_LT(filled.farthest(off_cylinder), 1e-6);
  }
}

/// All vertices of a wall of one row lie on two planes, so that many surfaces go through them.
TEST(SharpEdges, AWindowInAWallOfOneRowComesBack) {
  for (const int rows : {1, 2})
    for (const double height : {0.7, 2.0, 3.0})
      for (const double half_angle : {15, 30, 40}) {
        const Filled filled = fill(test::make_windowed_cylinder(48, rows, height, half_angle));
        EXPECT_EQ(filled.patch().made_by, "sharp edges") << rows << ' ' << height << ' ' << half_angle;
        const auto off_wall = [](const Vec3& p) { return std::abs(p.head<2>().norm() - 1); };
        EXPECT_LT(filled.farthest(off_wall), 1e-5) << rows << ' ' << height << ' ' << half_angle;
      }
}

TEST(SharpEdges, AConcaveEdgeComesBack) {
  // The cube's faces seen from within: turned inside out, its edges are concave.
  TriangleSoup inside = test::make_cube(24);
  for (Triangle& t : inside.triangles) std::swap(t[1], t[2]);
  const Filled filled = fill(without_ball(inside, {1, 0, 0.4}, 0.25));
  EXPECT_EQ(filled.patch().made_by, "sharp edges");
  EXPECT_LT(filled.farthest(off_cube), 1e-9);
}

/// A sheet [−1, 1]² that is folded along lines y = constant, with a round hole in its middle.
struct FoldedSheet {
  std::vector<double> folds;       ///< x in the sheet, ascending
  std::vector<double> directions;  ///< degrees from the x axis to z: of the parts between
  double hole;                     ///< radius in the sheet

  Eigen::Vector2d corner(std::size_t k) const {  // where part k begins
    if (k == 0) return {0, 0};
    const double from = k == 1 ? -1 : folds[k - 2], angle = directions[k - 1] * std::numbers::pi / 180;
    return corner(k - 1) + (folds[k - 1] - from) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  Vec3 place(const Vec3& p) const {
    const auto k = static_cast<std::size_t>(std::upper_bound(folds.begin(), folds.end(), p.x() + 1e-9) - folds.begin());
    const double angle = directions[k] * std::numbers::pi / 180, along = p.x() - (k == 0 ? -1 : folds[k - 1]);
    const Eigen::Vector2d q = corner(k) + along * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    return {q.x(), p.y(), q.y()};
  }
  TriangleSoup scan() const {
    TriangleSoup soup =
        cut(make_graph([](double, double) { return 0.0; }, 2, 48), [this](const Vec3& p) { return p.norm() < hole; });
    for (Vec3& p : soup.points) p = place(p);
    return soup;
  }
  double distance(const Vec3& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const double begin = k == 0 ? -1 : folds[k - 1], end = k == folds.size() ? 1 : folds[k];
      const double angle = directions[k] * std::numbers::pi / 180;
      const Eigen::Vector2d axis(std::cos(angle), std::sin(angle)), d = Eigen::Vector2d(p.x(), p.z()) - corner(k);
      least = std::min(least, (d - std::clamp(d.dot(axis), 0.0, end - begin) * axis).norm());
    }
    return least;
  }
  double farthest(const Filled& filled) const {
    double largest = 0;
    for (std::size_t i = filled.points; i < filled.model.soup.points.size(); ++i)
      largest = std::max(largest, distance(filled.model.soup.points[i]));
    return largest;
  }
};

/// Their ends may lie a vertex beside the folds of the sheet.
TEST(SharpEdges, SeveralEdgesRunAcrossAHoleWiderThanTheirDistance) {
  const double cell = 1.0 / 24;
  const FoldedSheet step{{-3 * cell, 3 * cell}, {0, 90, 0}, 0.45}, plate{{-3 * cell, 3 * cell}, {0, 90, 180}, 0.35},
      ramp{{-4 * cell, 4 * cell}, {0, 60, 0}, 0.45};
  for (const FoldedSheet& sheet : {step, plate, ramp}) {
    const Filled filled = fill_hole(sheet.scan());
    EXPECT_EQ(filled.patch().made_by, "sharp edges") << sheet.directions[1];
    EXPECT_NE(filled.holes.front().verdict().grade, Grade::bad) << filled.holes.front().verdict().message();
    EXPECT_LT(sheet.farthest(filled), 1.01 * cell);
  }
}

/// Two paraboloids that meet at the rim by 153°: fits of curved sides know their outside.
TEST(SharpEdges, TheRimOfALensComesBack) {
  constexpr double height = 0.12;
  test::GridSurface lens;
  for (const double side : {1.0, -1.0})
    lens.add(72, 24, [&](double x, double r) {
      const double angle = -side * 2 * std::numbers::pi * x;
      return Vec3(r * std::cos(angle), r * std::sin(angle), side * height * (1 - r * r));
    });
  for (const double radius : {0.2, 0.35}) {
    const Filled filled = fill(without_ball(lens.soup, {1, 0, 0}, radius));
    EXPECT_EQ(filled.patch().made_by, "sharp edges") << radius;
    EXPECT_EQ(filled.holes.front().verdict().grade, Grade::good) << filled.holes.front().verdict().message();
    EXPECT_LT(filled.farthest(
                  [](const Vec3& p) { return std::abs(std::abs(p.z()) - height * (1 - p.head<2>().squaredNorm())); }),
              1e-3)
        << radius;
  }
}

/// An edge of 25° to 40° bends by more than the 150° that count as a fold elsewhere, or by nearly as much.
TEST(SharpEdges, AKnifesEdgeIsNoFold) {
  for (const double bend : {140.0, 155.0}) {
    const FoldedSheet sheet{{0}, {0, bend}, 0.25};
    const Filled filled = fill_hole(sheet.scan());
    EXPECT_EQ(filled.patch().made_by, "sharp edges") << bend;
    EXPECT_EQ(filled.holes.front().verdict().grade, Grade::good) << filled.holes.front().verdict().message();
    EXPECT_LT(sheet.farthest(filled), 1e-9);
  }
}

/// The roof |n · (x, y)| ≤ 1 − z over a regular polygon, n normal to one of its sides, without its tip: rings of
/// triangles down to z = 0. The hole is not plane, else it would be the end of a cut body.
struct Roof {
  int sides = 4;
  double slope = 1;

  Vec3 place(double radius, double turn) const {
    const double side = std::floor(turn * sides), share = turn * sides - side;
    const auto corner = [&](double k) -> Eigen::Vector2d {
      const double angle = 2 * std::numbers::pi * k / sides;
      return {std::cos(angle), std::sin(angle)};
    };
    const Eigen::Vector2d p = radius * ((1 - share) * corner(side) + share * corner(side + 1));
    return {p.x(), p.y(), slope * (1 - radius)};
  }
  TriangleSoup without_tip(double hole) const {
    constexpr int rings = 16;
    const int around = 24 / sides * sides;
    TriangleSoup soup;
    for (int i = 0; i <= rings; ++i)
      for (int j = 0; j < around; ++j) {
        const double turn = static_cast<double>(j) / around;
        const double inner = hole * (1 + 0.3 * std::sin(4 * std::numbers::pi * turn + 0.3));
        soup.points.push_back(place(inner + (1 - inner) * i / rings, turn));
      }
    for (int i = 0; i < rings; ++i)
      for (int j = 0; j < around; ++j) {
        const int a = i * around + j, b = i * around + (j + 1) % around;
        soup.triangles.push_back({a, a + around, b});
        soup.triangles.push_back({b, a + around, b + around});
      }
    return soup;
  }
  /// How far p is above or below it.
  double height_over(const Vec3& p) const {
    double farthest = 0;
    for (int k = 0; k < sides; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.5) / sides;
      farthest = std::max(farthest, std::cos(angle) * p.x() + std::sin(angle) * p.y());
    }
    return p.z() - slope * (1 - farthest / std::cos(std::numbers::pi / sides));
  }
};

/// All sides meet in one point, far above a smooth patch.
TEST(SharpEdges, TheTipOfAPyramidComesBack) {
  for (const int sides : {3, 4, 5, 6, 8}) {
    const double steepness = sides == 3 ? 2 : 1.2;  // steeper ones are cut bodies
    const Roof roof{sides, steepness * std::cos(std::numbers::pi / sides)};
    const Filled filled = fill_hole(roof.without_tip(0.3));
    EXPECT_EQ(filled.patch().made_by, "sharp edges") << sides;
    EXPECT_EQ(filled.holes.front().verdict().grade, Grade::good) << filled.holes.front().verdict().message();
    double off = 0, from_tip = 1;
    for (std::size_t i = filled.points; i < filled.model.soup.points.size(); ++i) {
      off = std::max(off, std::abs(roof.height_over(filled.model.soup.points[i])));
      from_tip = std::min(from_tip, (filled.model.soup.points[i] - Vec3(0, 0, roof.slope)).norm());
    }
    EXPECT_LT(off, 1e-9) << sides;
    EXPECT_LT(from_tip, 1e-9) << sides;
  }
}

/// A plate so thin that the hole is seven times as wide.
TEST(SharpEdges, ThatAreNotContinuedAreNamed) {
  const double cell = 1.0 / 24;
  const Filled filled = fill_hole(FoldedSheet{{-3 * cell, 0, 3 * cell}, {0, 150, 0, 150}, 0.35}.scan());
  ASSERT_NE(filled.patch().made_by, "sharp edges");
  EXPECT_NE(filled.holes.front().reason().english().find("sharp edges of the scan end at this hole"), std::string::npos)
      << filled.holes.front().reason();
  EXPECT_EQ(filled.holes.front().verdict().findings.at(0).code, NoticeCode::edges_rounded);
}

TEST(SharpEdges, AStripMissingInAFaceBetweenTwoEdgesIsPlane) {
  const TriangleSoup cube = test::make_cube(24);
  const Filled filled = fill(cut(cube, [](const Vec3& p) {
    return p.z() > 0.999 && std::abs(p.x() - 0.5) < 0.12 && p.y() > 0.001 && p.y() < 0.999;
  }));
  EXPECT_LT(filled.farthest(off_cube), 1e-9);
}

/// A roof whose ridge is rounded from some distance of the hole on: there both its sides are one.
TEST(SharpEdges, AnEdgeThatFadesOutNearTheHoleRunsOn) {
  const auto roof = [](double x, double y) { return -0.8 * std::hypot(x, 1.25 * std::max(0.0, std::abs(y) - 0.25)); };
  const TriangleSoup scan = without_ball(make_graph(roof, 2, 96), Vec3::Zero(), 0.15);
  const auto farthest = [&](SharpEdges edges) {
    SurfaceModel model = make_surface_model(scan);
    FillOptions options;
    options.evolution->edges = edges;
    EXPECT_FALSE(fill_all_holes(model, options).empty());
    double largest = 0;
    for (std::size_t i = scan.points.size(); i < model.soup.points.size(); ++i)
      largest = std::max(largest, std::abs(model.soup.points[i].z() + 0.8 * std::abs(model.soup.points[i].x())));
    return largest;
  };
  EXPECT_LT(farthest(SharpEdges::continued), 0.2 * farthest(SharpEdges::rounded));
}

TEST(SharpEdges, NoiseOfAScanKeepsTheEdge) {
  for (const double noise : {0.001, 0.004, 0.0075}) {  // edges of 1/24
    const Filled filled = fill(with_noise(without_ball(test::make_cube(24), {1, 1, 0.5}, 0.25), noise));
    EXPECT_EQ(filled.patch().made_by, "sharp edges") << noise;
    EXPECT_LT(filled.farthest(off_cube), 6 * noise);
  }
}

/// The soup point of a hole's boundary that is nearest to a place.
int boundary_point(const TriangleSoup& scan, const Vec3& place) {
  const SurfaceModel model = make_surface_model(scan);
  int best = -1;
  for (const BoundaryLoop& loop : find_boundary_loops(model))
    for (int v : loop.vertices) {
      const int point = model.soup_vertex[v];
      const auto distance = [&](int p) { return (scan.points[p] - place).norm(); };
      if (best < 0 || distance(point) < distance(best)) best = point;
    }
  return best;
}

/// The ridge of a roof with a bend of 20°, less than what counts as sharp by itself.
TEST(SharpEdges, AnEdgeThatIsDrawnRunsAcross) {
  const auto height = [](double x, double) { return -std::tan(10 * std::numbers::pi / 180) * std::abs(x); };
  const TriangleSoup scan = without_ball(make_graph(height, 2, 96), Vec3::Zero(), 0.3);
  const auto rms = [&](const EdgeEdits& edits) {
    SurfaceModel model = make_surface_model(scan);
    FillOptions options;
    options.evolution->edge_edits = edits;
    const std::vector<HoleResult> holes = fill_all_holes(model, options);
    EXPECT_EQ(holes.front().outcome().made_by == "sharp edges", !edits.empty());
    double sum = 0;
    for (std::size_t i = scan.points.size(); i < model.soup.points.size(); ++i)
      sum += std::pow(model.soup.points[i].z() - height(model.soup.points[i].x(), model.soup.points[i].y()), 2);
    return std::sqrt(sum / static_cast<double>(model.soup.points.size() - scan.points.size()));
  };
  const EdgeEdits drawn{{{boundary_point(scan, {0, -0.3, 0}), boundary_point(scan, {0, 0.3, 0})}}, {}};
  EXPECT_LT(rms(drawn), 1e-9);
  EXPECT_GT(rms({}), 1e-3);
}

/// Seen along the normal of its side, the outline of a part crosses itself.
TEST(SharpEdges, APartThatIsNotSimpleSeenFlatIsMeshed) {
  const TriangleSoup scan = with_noise(without_ball(test::make_cube(40), {1, 1, 0.5}, 0.3), 0.008);
  const SurfaceModel model = make_surface_model(scan);
  const std::vector<ContinuedEdge> edges = continued_edges(model, find_boundary_loops(model)[0], {}, 1, {});
  ASSERT_EQ(edges.size(), 1U);
  for (const Vec3& p : edges[0].line) EXPECT_LT((p.head<2>() - Eigen::Vector2d(1, 1)).norm(), 4 * 0.008);
}

TEST(SharpEdges, AnEdgeThatIsStoppedIsRounded) {
  const TriangleSoup scan = without_ball(test::make_cube(24), {1, 1, 0.5}, 0.2);
  FillOptions options;
  options.evolution->edge_edits.stopped = {boundary_point(scan, {1, 1, 0.3})};
  EXPECT_THAT(fill(scan, options).patch().attempts, Not(Contains("sharp edges")));
  options.evolution->edge_edits.stopped = {boundary_point(scan, {1, 0.8, 0.5})};  // where no edge ends
  EXPECT_EQ(fill(scan, options).patch().made_by, "sharp edges");
}

TEST(SharpEdges, AreKnownBeforeTheHoleIsFilled) {
  const TriangleSoup scan = without_ball(test::make_cube(24), {1, 1, 0.5}, 0.2);
  const SurfaceModel model = make_surface_model(scan);
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  ASSERT_EQ(loops.size(), 1U);
  const std::vector<ContinuedEdge> edges = continued_edges(model, loops[0], {}, 1, {});
  ASSERT_EQ(edges.size(), 1U);
  for (const Vec3& p : edges[0].line) EXPECT_LT((p.head<2>() - Eigen::Vector2d(1, 1)).norm(), 1e-9);
  EXPECT_EQ(std::minmax(edges[0].begin, edges[0].end),
            std::minmax(boundary_point(scan, {1, 1, 0.3}), boundary_point(scan, {1, 1, 0.7})));
  EXPECT_TRUE(continued_edges(model, loops[0], {{}, {edges[0].begin}}, 1, {}).empty());
}

TEST(SharpEdges, DrawnEdgesJoinTwoPlacesOfOneHole) {
  TriangleSoup scan = without_ball(test::make_cube(24), {1, 1, 0.5}, 0.2);
  scan = without_ball(scan, {0, 0, 0.5}, 0.2);
  const SurfaceModel model = make_surface_model(scan);
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  ASSERT_EQ(loops.size(), 2U);
  const int first = boundary_point(scan, {1, 1, 0.3}), second = boundary_point(scan, {0, 0, 0.3});
  EXPECT_NO_THROW(check(EdgeEdits{{{first, boundary_point(scan, {1, 1, 0.7})}}, {}}, model, loops));
  EXPECT_THROW(check(EdgeEdits{{{first, second}}, {}}, model, loops), InvalidArgument);
  EXPECT_THROW(check(EdgeEdits{{{first, first}}, {}}, model, loops), InvalidArgument);
  EXPECT_THROW(check(EdgeEdits{{}, {-1}}, model, loops), InvalidArgument);
}

TEST(SharpEdges, EditsActBesideTheDefaultFlowAlone) {
  const TriangleSoup scan = without_ball(test::make_cube(24), {1, 1, 0.5}, 0.2);
  const int below = boundary_point(scan, {1, 1, 0.3}), above = boundary_point(scan, {1, 1, 0.7});
  std::vector<FillOptions> others(4);
  others[0].evolution->flow = FlowKind::wf;
  others[1].evolution->continuity = SeamContinuity::tangent;
  others[2].evolution->boundary = BoundaryTrust::exact;
  others[3].evolution->edges = SharpEdges::rounded;
  for (FillOptions& options : others) {
    const Filled without = fill(scan, options);
    options.evolution->edge_edits = {{{below, above}}, {below}};
    const Filled with = fill(scan, options);
    EXPECT_EQ(with.model.soup.points, without.model.soup.points);
    EXPECT_EQ(with.patch().reason.english(), without.patch().reason.english());
  }
}

TEST(SharpEdges, AnEdgeIsDrawnWhereAnotherIsStopped) {
  const TriangleSoup scan = without_ball(test::make_cube(24), {1, 1, 0.5}, 0.2);
  const int below = boundary_point(scan, {1, 1, 0.3}), above = boundary_point(scan, {1, 1, 0.7});
  FillOptions options;
  options.evolution->edge_edits = {{{above, below}}, {below}};
  const Filled filled = fill(scan, options);
  EXPECT_EQ(filled.patch().made_by, "sharp edges");
  EXPECT_LT(filled.farthest(off_cube), 1e-9);
}

TEST(SharpEdges, AreDrawnAcrossAHoleOfFewTriangles) {
  const TriangleSoup scan = without_ball(test::make_cube(12), {1, 1, 0.5}, 0.05);
  ASSERT_LE(find_boundary_loops(make_surface_model(scan)).front().edges(), 8);
  const int below = boundary_point(scan, {1, 1, 0.4}), above = boundary_point(scan, {1, 1, 0.6});
  FillOptions options;
  options.evolution->edge_edits.drawn = {{below, above}};
  const Filled filled = fill(scan, options);
  EXPECT_NE(filled.patch().made_by, "few triangles");
}

/// The edges of the wall end at its cut; the cap is plane.
TEST(SharpEdges, NoneRunOnIntoAFlatCut) {
  const SurfaceModel model = make_surface_model(cut(test::make_cube(16), [](const Vec3& p) { return p.z() > 0.97; }));
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  ASSERT_EQ(loops.size(), 1U);
  ASSERT_NE(loop_end(model, loops[0]), LoopEnd::runs_on);
  EXPECT_TRUE(continued_edges(model, loops[0], {}, 1, {}).empty());
}

TEST(SharpEdges, AreRoundWhereAPersonWantsThatSo) {
  const TriangleSoup scan = without_ball(test::make_cube(24), {1, 1, 0.5}, 0.2);
  FillOptions options;
  options.evolution->edges = SharpEdges::rounded;
  EXPECT_THAT(fill(scan, options).patch().attempts, Not(Contains("sharp edges")));
  options.evolution->edges = SharpEdges::continued;
  options.evolution->boundary = BoundaryTrust::exact;
  EXPECT_THAT(fill(scan, options).patch().attempts, Not(Contains("sharp edges")));
}

TEST(SharpEdges, ASmoothSurfaceHasNone) {
  std::vector<TriangleSoup> scans;
  scans.push_back(cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.8; }));
  scans.push_back(with_noise(scans[0], 0.02));  // a fifth of an edge
  scans.push_back(cut(make_torus(1, 0.4, 48, 24), [](const Vec3& p) { return (p - Vec3(1.4, 0, 0)).norm() < 0.35; }));
  scans.push_back(cut(make_graph([](double x, double y) { return 0.2 * std::sin(4 * x) * std::cos(3 * y); }, 1, 40),
                      [](const Vec3& p) { return p.head<2>().norm() < 0.3; }));
  for (const TriangleSoup& scan : scans) {
    SurfaceModel model = make_surface_model(scan);
    for (const HoleResult& hole : fill_all_holes(model))
      EXPECT_THAT(hole.outcome().attempts, Not(Contains("sharp edges")));
  }
}

/// Holes so near to each other that the surface between them hangs together by single vertices.
TEST(SharpEdges, ASmoothSurfaceThatOtherHolesPartHasNone) {
  Random random(3);
  TriangleSoup ball = make_icosphere(4);
  std::erase_if(ball.triangles, [&](const Triangle& t) { return ball.points[t[0]].z() > 0 && random.uniform() < 0.2; });
  SurfaceModel model = make_surface_model(ball);
  for (const HoleResult& result : fill_all_holes(model))
    if (is_filled(result.status)) {
      EXPECT_NE(result.method(), "sharp_edges") << result.loop.number;
    }
}

TEST(SharpEdges, TwoHolesAcrossOneEdgeEachHaveIt) {
  const TriangleSoup cube = test::make_cube(32);
  const Filled filled = fill(without_ball(without_ball(cube, {1, 1, 0.35}, 0.1), {1, 1, 0.65}, 0.1));
  ASSERT_EQ(filled.holes.size(), 2U);
  for (const HoleResult& hole : filled.holes) EXPECT_EQ(hole.outcome().made_by, "sharp edges");
  EXPECT_LT(filled.farthest(off_cube), 1e-9);
}

TEST(SharpEdges, AreTheSameForAnyNumberOfThreads) {
  const TriangleSoup scan = without_ball(test::make_closed_cylinder(72), {1, 0, 1}, 0.35);
  FillOptions one, two;
  one.threads = 1;
  two.threads = 2;
  EXPECT_EQ(fill(scan, one).model.soup.points, fill(scan, two).model.soup.points);
}

}  // namespace
}  // namespace loopmend
