// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/ring_bridge.h"

#include "core/random.h"
#include "filling/bridge_loops.h"
#include "filling/find_rings.h"
#include "pipeline/blend.h"
#include "pipeline/fill_holes.h"
#include "samples/analytic_surfaces.h"
#include "samples/paper_inputs.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

namespace loopmend {
namespace {

using std::numbers::pi;

/// Counter-clockwise about z.
Points circle(int count, double radius, double height = 0, double phase = 0) {
  Points points;
  for (int k = 0; k < count; ++k) {
    const double angle = phase + 2 * pi * k / count;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
  }
  return points;
}

Points square(int along, double half) {
  const Vec3 corners[] = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
  Points points;
  for (std::size_t side = 0; side < 4; ++side)
    for (int k = 0; k < along; ++k)
      points.push_back(corners[side] + (corners[(side + 1) % 4] - corners[side]) * k / along);
  return points;
}

Points star(int count, double least, double most) {
  Points points = circle(count, 1);
  for (int k = 0; k < count; ++k) points[k] *= k % 2 == 0 ? least : most;
  return points;
}

enum class Side { outer, inner };

/// The wall below a closed curve, of length 1.
TriangleSoup wall(const Points& top, Side side) {
  constexpr int rows = 12;
  const int n = static_cast<int>(top.size());
  TriangleSoup soup;
  for (int r = 0; r <= rows; ++r)
    for (const Vec3& p : top) soup.points.push_back(p - Vec3(0, 0, static_cast<double>(r) / rows));
  for (int r = 0; r < rows; ++r)
    for (int k = 0; k < n; ++k) {
      const int a = r * n + k, b = r * n + (k + 1) % n;
      soup.triangles.push_back({a, a + n, b + n});
      soup.triangles.push_back({a, b + n, b});
    }
  if (side == Side::inner)
    for (Triangle& t : soup.triangles) std::swap(t[1], t[2]);
  return soup;
}

/// Of the curve seen along z.
double area_in(const Points& curve) {
  double area = 0;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const Vec3 &p = curve[k], &q = curve[(k + 1) % curve.size()];
    area += (p.x() * q.y() - p.y() * q.x()) / 2;
  }
  return area;
}

struct Joined {
  SurfaceModel model;
  BlendResult result;
  std::size_t given_points = 0, given_triangles = 0;

  double new_area() const {
    double area = 0;
    const Points& p = model.soup.points;
    for (std::size_t f = given_triangles; f < model.soup.triangles.size(); ++f) {
      const Triangle& t = model.soup.triangles[f];
      area += (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm() / 2;
    }
    return area;
  }
};

/// The loops at the top of both walls, joined.
Joined join_tops(const TriangleSoup& soup) {
  Joined joined{make_surface_model(soup), {}, soup.points.size(), soup.triangles.size()};
  std::vector<BoundaryLoop> tops;
  for (const BoundaryLoop& loop : find_boundary_loops(joined.model))
    if (loop.center.z() > -0.5) tops.push_back(loop);
  EXPECT_EQ(tops.size(), 2U);
  joined.result = blend_loops(joined.model, tops, {}, {});
  return joined;
}

void expect_sound(const Joined& joined) {
  const PatchResult& outcome = joined.result.outcome;
  ASSERT_EQ(outcome.status, PatchStatus::filled) << outcome.message;
  EXPECT_EQ(outcome.validity.intersections, 0);
  EXPECT_EQ(worst(outcome.verdicts), Grade::good);
  const std::vector<BoundaryLoop> left = find_boundary_loops(joined.model);
  EXPECT_EQ(left.size(), 2U);  // the lower ends
  for (const BoundaryLoop& loop : left) EXPECT_LT(loop.center.z(), -0.5);
}

void expect_flat_ring(const Points& outer, const Points& inner) {
  const Joined ring = join_tops(joined({wall(outer, Side::outer), wall(inner, Side::inner)}));
  expect_sound(ring);
  for (std::size_t v = ring.given_points; v < ring.model.soup.points.size(); ++v)
    EXPECT_NEAR(ring.model.soup.points[v].z(), 0, 1e-9);
  EXPECT_NEAR(ring.new_area(), area_in(outer) - area_in(inner), 1e-9);
  EXPECT_EQ(ring.result.turned_faces, 0U);
}

TEST(RingBridge, ConcentricCirclesAreJoinedFlat) {
  expect_flat_ring(circle(48, 1), circle(48, 0.8));
  expect_flat_ring(circle(48, 1), circle(31, 0.8, 0, 0.05));
  expect_flat_ring(circle(20, 1), circle(90, 0.5));
  expect_flat_ring(circle(64, 1), circle(40, 0.2));
}

TEST(RingBridge, SquareRingsAndThinWallsAreJoinedFlat) {
  expect_flat_ring(square(10, 1), square(10, 0.7));
  expect_flat_ring(square(10, 1), square(10, 0.97));  // thinner than an edge
  expect_flat_ring(square(9, 1), square(13, 0.9));
  expect_flat_ring(square(2, 1), square(3, 0.9));
}

TEST(RingBridge, CurvesThatAreNotConvexAreJoinedFlat) {
  expect_flat_ring(square(12, 1), star(40, 0.4, 0.8));
  expect_flat_ring(star(40, 1, 1.4), circle(36, 0.7));
  Points aside = circle(30, 0.5);
  for (Vec3& p : aside) p += Vec3(0.3, 0.1, 0);
  expect_flat_ring(circle(48, 1), aside);
}

TEST(RingBridge, ParallelCirclesAreJoinedByACone) {
  for (const double height : {0.05, 0.3, -0.4}) {
    const Joined ring =
        join_tops(joined({wall(circle(48, 1), Side::outer), wall(circle(48, 0.6, height), Side::inner)}));
    expect_sound(ring);
    ASSERT_GT(ring.model.soup.points.size(), ring.given_points);
    for (std::size_t v = ring.given_points; v < ring.model.soup.points.size(); ++v) {
      const Vec3& p = ring.model.soup.points[v];
      EXPECT_NEAR(std::hypot(p.x(), p.y()), 1 - 0.4 * p.z() / height, 1e-9);
    }
  }
}

/// Other numbers of vertices: the cone is met up to the height of a chord, 1 − cos(π/40) = 0.003.
TEST(RingBridge, ParallelCirclesOfOtherCountsAreJoinedByACone) {
  const Joined ring = join_tops(joined({wall(circle(48, 1), Side::outer), wall(circle(40, 0.6, 0.3), Side::inner)}));
  expect_sound(ring);
  for (std::size_t v = ring.given_points; v < ring.model.soup.points.size(); ++v) {
    const Vec3& p = ring.model.soup.points[v];
    EXPECT_NEAR(std::hypot(p.x(), p.y()), 1 - 0.4 * p.z() / 0.3, 0.004);
  }
}

TEST(RingBridge, NoiseOfTheWallsStaysInItsBounds) {
  TriangleSoup soup = joined({wall(circle(60, 1), Side::outer), wall(circle(50, 0.7), Side::inner)});
  Random random(3);
  for (Vec3& p : soup.points) p += 0.003 * Vec3(random.bell(), random.bell(), random.bell());
  const Joined ring = join_tops(soup);
  expect_sound(ring);
  for (std::size_t v = ring.given_points; v < ring.model.soup.points.size(); ++v)
    EXPECT_LT(std::abs(ring.model.soup.points[v].z()), 0.012);
}

TEST(RingBridge, AWallThatIsInsideOutIsTurned) {
  const Joined ring = join_tops(joined({wall(circle(48, 1), Side::outer), wall(circle(48, 0.8), Side::outer)}));
  expect_sound(ring);
  EXPECT_EQ(ring.result.turned_faces, 48U * 24U);
}

TEST(RingBridge, FindsTheRingsOfAPipe) {
  const SurfaceModel model =
      make_surface_model(joined({wall(circle(48, 1), Side::outer), wall(circle(40, 0.8), Side::inner)}));
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  const std::vector<std::vector<int>> rings = find_rings(model, loops, {});
  ASSERT_EQ(rings.size(), 2U);
  for (const std::vector<int>& ring : rings) {
    ASSERT_EQ(ring.size(), 2U);
    EXPECT_NEAR(loops[ring[0]].center.z(), loops[ring[1]].center.z(), 1e-9);
  }
}

/// The walls of a block with bores beside each other, without either end face, turned by some degrees.
TriangleSoup block_with_bores(int bores, double degrees) {
  std::vector<TriangleSoup> walls{wall(square(12, 2), Side::outer)};
  for (int k = 0; k < bores; ++k) {
    Points rim = circle(24 + 3 * k, 0.4);
    for (Vec3& p : rim) p += Vec3(-1.2 + 1.2 * k, 0.1 * k, 0);
    walls.push_back(wall(rim, Side::inner));
  }
  TriangleSoup soup = joined(walls);
  const Eigen::AngleAxisd turn(degrees * pi / 180, Vec3(1, 2, 3).normalized());
  for (Vec3& p : soup.points) p = turn * p;
  return soup;
}

TEST(RingBridge, ABlockWithBoresGetsAFaceWithHoles) {
  for (const int bores : {2, 3})
    for (const double degrees : {0.0, 50.0}) {
      SCOPED_TRACE(testing::Message() << bores << " bores, turned by " << degrees);
      const TriangleSoup soup = block_with_bores(bores, degrees);
      SurfaceModel model = make_surface_model(soup);
      const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
      const std::vector<std::vector<int>> rings = find_rings(model, loops, {});
      ASSERT_EQ(rings.size(), 2U);
      double area = 16;
      for (int k = 0; k < bores; ++k) area -= area_in(circle(24 + 3 * k, 0.4));
      Joined block{model, {}, soup.points.size(), soup.triangles.size()};
      for (const std::vector<int>& ring : rings) {
        ASSERT_EQ(ring.size(), static_cast<std::size_t>(bores) + 1);
        std::vector<BoundaryLoop> face;
        for (const int k : ring) face.push_back(loops[k]);
        Joined one = block;
        std::ranges::reverse(face);  // the outline need not come first
        one.result = blend_loops(one.model, face, {}, {});
        ASSERT_EQ(one.result.outcome.status, PatchStatus::filled) << one.result.outcome.message;
        EXPECT_EQ(worst(one.result.outcome.verdicts), Grade::good);
        EXPECT_EQ(one.result.turned_faces, 0U);
        EXPECT_NEAR(one.new_area(), area, 1e-9);
        EXPECT_EQ(find_boundary_loops(one.model).size(), static_cast<std::size_t>(bores) + 1);
      }
    }
}

/// A wall below the outer curve, one above each inner curve, which stands on the face between them.
TriangleSoup stepped(const Points& outer, const std::vector<Points>& inner, Side side) {
  std::vector<TriangleSoup> walls{wall(outer, Side::outer)};
  for (const Points& rim : inner) {
    walls.push_back(wall(rim, side == Side::outer ? Side::inner : Side::outer));
    for (Vec3& p : walls.back().points) p.z() = -p.z();  // turns it over, too
  }
  return joined(walls);
}

std::vector<HoleResult> filled_middle(SurfaceModel& model, const FillOptions& options = {}) {
  std::vector<BoundaryLoop> middle = find_boundary_loops(model);
  std::erase_if(middle, [](const BoundaryLoop& loop) { return std::abs(loop.center.z()) > 0.5; });
  return fill_holes(model, middle, options, {}, {});
}

TEST(RingBridge, TheFaceBelowBossesAndTheShoulderOfAShaftAreFilled) {
  Points left = circle(30, 0.5), right = circle(24, 0.4);
  for (Vec3& p : left) p.x() -= 1;
  for (Vec3& p : right) p += Vec3(1, 0.2, 0);
  const double plate = area_in(square(12, 2));
  const std::tuple<Points, std::vector<Points>, double> cases[] = {
      {circle(48, 1), {circle(40, 0.6)}, area_in(circle(48, 1)) - area_in(circle(40, 0.6))},
      {square(12, 2), {left}, plate - area_in(left)},
      {square(12, 2), {left, right}, plate - area_in(left) - area_in(right)},
      {square(1, 2), {left, right}, plate - area_in(left) - area_in(right)}};
  for (const auto& [outer, inner, area] : cases) {
    const TriangleSoup soup = stepped(outer, inner, Side::outer);
    Joined part{make_surface_model(soup), {}, soup.points.size(), soup.triangles.size()};
    const std::vector<HoleResult> holes = filled_middle(part.model);
    ASSERT_EQ(holes.size(), inner.size() + 1);
    for (const HoleResult& hole : holes) {
      ASSERT_EQ(hole.status, PatchStatus::filled) << hole.message;
      EXPECT_EQ(hole.patch, holes.front().patch);
      EXPECT_EQ(hole.verdict().grade, Grade::good);
    }
    EXPECT_NEAR(part.new_area(), area, 1e-9);
    for (std::size_t v = part.given_points; v < part.model.soup.points.size(); ++v)
      EXPECT_NEAR(part.model.soup.points[v].z(), 0, 1e-9);
    EXPECT_EQ(find_boundary_loops(part.model).size(), inner.size() + 1);
  }
}

/// A boss that is inside out is a cup without a bottom, and a single loop is closed by itself.
TEST(RingBridge, WallsThatFaceTheOtherWayAndSingleLoopsAreNotJoined) {
  const auto count_of_patches = [](const std::vector<HoleResult>& holes) {
    std::set<const PatchResult*> patches;
    for (const HoleResult& hole : holes)
      if (hole.patch) patches.insert(hole.patch.get());
    return patches.size();
  };
  SurfaceModel inside_out = make_surface_model(stepped(circle(48, 1), {circle(40, 0.6)}, Side::inner));
  EXPECT_EQ(count_of_patches(filled_middle(inside_out)), 2U);
  SurfaceModel shaft = make_surface_model(stepped(circle(48, 1), {circle(40, 0.6)}, Side::outer));
  std::vector<BoundaryLoop> one = find_boundary_loops(shaft);
  std::erase_if(one, [](const BoundaryLoop& loop) { return std::abs(loop.center.z()) > 0.5 || loop.edges() != 40; });
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(fill_holes(shaft, one, {}, {}, {}).at(0).patch->patch.loops.size(), 1U);
  FillOptions apart;
  apart.islands = FillOptions::Islands::cover;
  SurfaceModel pipe =
      make_surface_model(joined({wall(circle(48, 1), Side::outer), wall(circle(40, 0.8), Side::inner)}));
  SurfaceModel same = pipe;
  EXPECT_EQ(count_of_patches(filled_middle(same)), 1U);
  EXPECT_EQ(count_of_patches(filled_middle(pipe, apart)), 2U);
}

/// Loops of sheets with holes, as of a skull, are no rims of one missing face.
TEST(RingBridge, LoopsThatLieInNoPlaneAreNoGroup) {
  const auto groups_of_waves = [](double height) {
    TriangleSoup soup = block_with_bores(2, 0);
    for (Vec3& p : soup.points) p.z() += height * std::sin(1.5 * p.x()) * std::cos(1.5 * p.y());
    const SurfaceModel model = make_surface_model(soup);
    return std::ranges::count_if(find_rings(model, find_boundary_loops(model), {}),
                                 [](const std::vector<int>& ring) { return ring.size() == 3; });
  };
  EXPECT_EQ(groups_of_waves(0.02), 2);
  EXPECT_EQ(groups_of_waves(0.5), 0);
}

/// A bore that is inside out is turned, whichever loop is named first.
TEST(RingBridge, ABoreOfABlockThatIsInsideOutIsTurned) {
  TriangleSoup soup = block_with_bores(2, 0);
  const std::size_t bore = 2 * 12 * 24;
  for (std::size_t f = 2 * 12 * 48; f < 2 * 12 * 48 + bore; ++f) std::swap(soup.triangles[f][1], soup.triangles[f][2]);
  SurfaceModel model = make_surface_model(soup);
  std::vector<BoundaryLoop> tops;
  for (const BoundaryLoop& loop : find_boundary_loops(model))
    if (loop.center.z() > -0.5) tops.push_back(loop);
  ASSERT_EQ(tops.size(), 3U);
  const BlendResult result = blend_loops(model, tops, {}, {});
  ASSERT_EQ(result.outcome.status, PatchStatus::filled) << result.outcome.message;
  EXPECT_EQ(result.turned_faces, bore);
}

TEST(RingBridge, HalvesOfATorusRunOn) {
  const TriangleSoup half = cut(make_torus(2, 0.5, 80, 40), [](const Vec3& p) { return p.z() > 1e-9; });
  SurfaceModel model = make_surface_model(half);
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_FALSE(ring_between(model, loops, 1, {}));
  const BlendResult result = blend_loops(model, loops, {}, {});
  ASSERT_TRUE(is_filled(result.outcome.status)) << result.outcome.message;
  double highest = 0;
  for (const Vec3& p : model.soup.points) highest = std::max(highest, p.z());
  EXPECT_NEAR(highest, 0.5, 0.02);
}

TEST(RingBridge, TubesThatFaceEachOtherOrLieSideBySideAreNoWalls) {
  const Points points = circle(24, 1);
  const auto end = [&](const Vec3& center, double radius, const Vec3& onward, double sense) {
    BridgeEnd made{{}, sense * Vec3::UnitZ(), onward, {}};
    for (const Vec3& p : points) {
      made.points.push_back(radius * p + center);
      made.conormals.push_back(onward);
    }
    return made;
  };
  const BridgeEnd outer = end({0, 0, 0}, 1, Vec3::UnitZ(), 1);
  const auto is_ring = [&](const BridgeEnd& other) { return outline_of_a_ring({outer, other}) == 0; };
  EXPECT_TRUE(is_ring(end({0, 0, 0.2}, 0.5, Vec3::UnitZ(), -1)));
  EXPECT_FALSE(is_ring(end({0, 0, 2}, 0.5, -Vec3::UnitZ(), -1)));
  EXPECT_FALSE(is_ring(end({3, 0, 0}, 0.5, Vec3::UnitZ(), 1)));
  EXPECT_FALSE(is_ring(end({0.8, 0, 0}, 0.5, Vec3::UnitZ(), -1)));
  const BridgeEnd left = end({-0.5, 0, 0}, 0.3, Vec3::UnitZ(), -1), right = end({0.5, 0, 0}, 0.3, Vec3::UnitZ(), -1);
  EXPECT_EQ(outline_of_a_ring({left, outer, right}), 1U);
  EXPECT_FALSE(outline_of_a_ring({left, right}));
  EXPECT_FALSE(outline_of_a_ring({outer, left, end({-0.5, 0, 0}, 0.1, Vec3::UnitZ(), 1)}));  // one within another
}

}  // namespace
}  // namespace loopmend
