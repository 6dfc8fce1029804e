// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/repair_surface.h"

#include "io/read_mesh.h"
#include "mesh/boundary_loops.h"
#include "mesh/surface_model.h"
#include "repair/watertight.h"
#include "samples/analytic_surfaces.h"
#include "support/sharp_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace loopmend {
namespace {

ModelRepairs left_to_repair(const TriangleSoup& soup) { return make_surface_model(soup).repairs; }

TEST(RepairSurface, LeavesASoundMeshAsItIs) {
  const TriangleSoup soup = cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.8; });
  const RepairedSurface repaired = repair_surface(soup);
  EXPECT_FALSE(repaired.counts.any());
  EXPECT_EQ(repaired.soup.points, soup.points);
  EXPECT_EQ(repaired.soup.triangles, soup.triangles);
}

TEST(RepairSurface, RemovesAFinAndCountsWhatIsDegenerateOrTwice) {
  TriangleSoup soup = make_icosphere(3);
  const std::size_t sound = soup.triangles.size(), points = soup.points.size();
  const Triangle first = soup.triangles.front();
  soup.points.emplace_back(0, 0, 5);
  soup.triangles.push_back({first[0], first[1], static_cast<int>(points)});  // a fin
  soup.triangles.push_back({first[1], first[2], first[0]});
  soup.triangles.push_back({first[1], first[1], first[0]});
  const RepairedSurface repaired = repair_surface(soup);
  EXPECT_EQ(repaired.counts.degenerate_faces, 1u);
  EXPECT_EQ(repaired.counts.duplicate_faces, 1u);
  EXPECT_EQ(repaired.counts.separated_edges, 1u);
  EXPECT_EQ(repaired.counts.separated_vertices, 2u);
  EXPECT_EQ(repaired.counts.removed_pieces, 1u);
  EXPECT_EQ(repaired.soup.triangles.size(), sound);
  EXPECT_EQ(repaired.soup.points.size(), points + 3);
  for (std::size_t v = 0; v <= points; ++v) EXPECT_EQ(repaired.soup.points[v], soup.points[v]);
  const ModelRepairs left = left_to_repair(repaired.soup);
  EXPECT_EQ(left.non_manifold_edges + left.non_manifold_vertices + left.duplicate_faces + left.degenerate_faces, 0u);
  EXPECT_FALSE(repair_surface(repaired.soup).counts.any());  // once is enough
}

/// Two balls that touch along an edge, all triangles apart: joined as far as the surface stays a manifold, and no further.
TEST(RepairSurface, AllRepairsTogetherLeaveNothingToRepair) {
  const TriangleSoup ball = make_icosphere(2);
  const Vec3 a = ball.points[ball.triangles[0][0]], b = ball.points[ball.triangles[0][1]];
  TriangleSoup soup;
  for (const Triangle& t : ball.triangles)
    for (const double side : {1.0, -1.0}) {
      const int first = static_cast<int>(soup.points.size());
      // The second ball is the first one turned by half a turn about the middle of the edge.
      const Vec3 middle = (a + b) / 2, along = (b - a).normalized(), out = middle.normalized();
      for (int v : t) {
        const Vec3 d = ball.points[v] - middle;
        const Vec3 turned = 2 * along.dot(d) * along - d;  // about the edge's own direction: a and b stay
        soup.points.push_back(side > 0                                       ? ball.points[v]
                              : (ball.points[v] == a || ball.points[v] == b) ? ball.points[v]
                                                                             : Vec3(middle + turned));
      }
      EXPECT_LT(std::abs(along.dot(out)), 1e-12);
      soup.triangles.push_back({first, first + 1, first + 2});
    }
  const std::set<Defect> all{Defect::coincident_points, Defect::degenerate_faces, Defect::duplicate_faces,
                             Defect::non_manifold, Defect::fragments};
  const RepairedSurface once = repair_surface(soup, all);
  EXPECT_GT(once.counts.joined_points, 1000U);
  const SurfaceModel model = make_surface_model(once.soup);
  EXPECT_TRUE(find_boundary_loops(model).empty());
  EXPECT_FALSE(count_defects(once.soup).any());
  EXPECT_FALSE(repair_surface(once.soup, all).counts.any());
}

/// Their points in one place were joined and separated in turns, 193 and 36 of snowden_bust.obj.
TEST(RepairSurface, OfEverythingIsEnoughOnceOnScans) {
  const std::filesystem::path shared = LOOPMEND_SHARED_DIR;
  const std::set<Defect> all{Defect::coincident_points, Defect::degenerate_faces, Defect::duplicate_faces,
                             Defect::intersections,     Defect::non_manifold,     Defect::handles,
                             Defect::fragments};
  for (const char* name : {"scans2/snowden_bust.obj", "scans2/skull_scp1.ply", "scans2/adonis.obj", "data/doll.obj"}) {
    if (!std::filesystem::exists(shared / name)) GTEST_SKIP() << shared / name << " is not here";
    const RepairedSurface once = repair_surface(read_mesh(shared / name).soup, all);
    EXPECT_TRUE(once.counts.any()) << name;
    EXPECT_FALSE(count_defects(once.soup).any()) << name;
  }
}

TEST(RepairSurface, TurnsFacesAndRemovesFragments) {
  TriangleSoup soup = make_icosphere(3);
  std::swap(soup.triangles[7][1], soup.triangles[7][2]);
  const int first = static_cast<int>(soup.points.size());
  for (const Vec3& p : {Vec3(2, 0, 0), Vec3(2.01, 0, 0), Vec3(2, 0.01, 0)}) soup.points.push_back(p);
  soup.triangles.push_back({first, first + 1, first + 2});
  const RepairedSurface repaired = repair_surface(soup);
  EXPECT_EQ(repaired.counts.turned_faces, 1u);
  EXPECT_EQ(repaired.counts.removed_pieces, 1u);
  EXPECT_EQ(repaired.counts.removed_faces, 1u);
  EXPECT_EQ(repaired.soup.triangles.size(), 1280u);
  EXPECT_TRUE(find_boundary_loops(make_surface_model(repaired.soup)).empty());
}

/// A wall across a box is a part of it; a closed body that touches it along an edge, too.
TEST(RepairSurface, KeepsLargeSheetsAndBodiesAtAnEdge) {
  TriangleSoup soup = test::make_cube(4);
  soup.points.emplace_back(2, 2, 0);
  soup.points.emplace_back(2, 2, 1);
  const auto at = [&](const Vec3& p) {
    return static_cast<int>(std::ranges::find(soup.points, p) - soup.points.begin());
  };
  const int low = at(Vec3(1, 1, 0)), high = at(Vec3(1, 1, 0.25)), out = static_cast<int>(soup.points.size()) - 2;
  ASSERT_LT(high, out);
  soup.triangles.push_back({low, high, out});
  soup.triangles.push_back({high, out + 1, out});  // a third of the cube's area with the next
  EXPECT_EQ(repair_surface(soup).counts.removed_pieces, 0U);
  TriangleSoup body = test::make_cube(4);
  body.points.emplace_back(1.1, 1, 0.1);
  body.points.emplace_back(1, 1.1, 0.1);
  const int a = out, b = out + 1;
  body.triangles.insert(body.triangles.end(), {{low, high, a}, {low, a, b}, {high, b, a}, {low, b, high}});
  const RepairedSurface touching = repair_surface(body);
  EXPECT_EQ(touching.counts.removed_pieces, 0U);
  EXPECT_EQ(touching.soup.triangles.size(), body.triangles.size());
}

TEST(RepairSurface, FlatFoldGoesAndNothingOpens) {
  TriangleSoup soup = make_icosphere(2);
  const Triangle t = soup.triangles[5];
  const int tip = static_cast<int>(soup.points.size());
  // A flap of no thickness over an edge of the sphere: it adds no volume, and its two sides lie on each other.
  soup.points.push_back(2 * soup.points[static_cast<std::size_t>(t[0])]);
  soup.triangles.push_back({t[0], t[1], tip});
  soup.triangles.push_back({t[1], t[0], tip});
  ASSERT_TRUE(watertightness(soup).encloses());
  ASSERT_GT(watertightness(soup).intersections, 0u);
  const RepairedSurface repaired = repair_surface(soup, {Defect::duplicate_faces});
  EXPECT_EQ(repaired.counts.duplicate_faces, 2u);
  EXPECT_TRUE(watertightness(repaired.soup).printable());
  EXPECT_FALSE(repair_surface(repaired.soup).counts.any());
}

TEST(RepairSurface, DuplicateThatFacesTheOtherWayGoesAlone) {
  TriangleSoup soup = make_icosphere(2);
  const Triangle t = soup.triangles[5];
  soup.triangles.push_back({t[1], t[0], t[2]});
  const RepairedSurface repaired = repair_surface(soup, {Defect::duplicate_faces});
  EXPECT_EQ(repaired.counts.duplicate_faces, 1u);
  EXPECT_EQ(repaired.soup.triangles, make_icosphere(2).triangles);
}

TEST(RepairSurface, IntersectingFacesAreCutOutAndLeaveHoles) {
  const TriangleSoup sphere = make_icosphere(3);
  TriangleSoup soup = sphere;
  soup.points[100] *= 0.2;  // a spike through the other side
  soup.points[100] *= -6;
  const std::size_t before = watertightness(soup).intersections;
  ASSERT_GT(before, 0u);
  const RepairedSurface repaired = repair_surface(soup, {Defect::intersections});
  EXPECT_GT(repaired.counts.intersecting_faces, 5u);
  const Watertightness left = watertightness(repaired.soup);
  EXPECT_EQ(left.intersections, 0u);
  EXPECT_GT(left.open_boundaries, 0u);
  EXPECT_EQ(repaired.soup.points, soup.points);
}

TEST(RepairSurface, ClosedBodiesThatOverlapStayClosed) {
  TriangleSoup moved = make_icosphere(3);
  for (Vec3& p : moved.points) p.x() += 1;
  const TriangleSoup soup = joined({make_icosphere(3), moved});
  ASSERT_GT(watertightness(soup).intersections, 0u);
  const RepairedSurface both = repair_surface(soup, {Defect::intersections});
  EXPECT_EQ(both.counts.intersecting_faces, 0u);
  EXPECT_EQ(both.soup.triangles, soup.triangles);
  EXPECT_EQ(both.counts.overlapping_bodies, 2u);
  // Of an open sheet through one of them, what cuts goes.
  TriangleSoup sheet = make_graph([](double, double) { return 0.1; }, 0.5, 8);
  for (Vec3& p : sheet.points) p.x() -= 1;
  const RepairedSurface cut_open = repair_surface(joined({soup, sheet}), {Defect::intersections});
  EXPECT_GT(cut_open.counts.intersecting_faces, 0u);
  EXPECT_LT(cut_open.counts.intersecting_faces, sheet.triangles.size());
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    ASSERT_EQ(cut_open.soup.triangles[f], soup.triangles[f]);  // both stay closed
}

TEST(RepairSurface, OnlyWhatIsNamedIsMended) {
  TriangleSoup soup = make_icosphere(3);
  soup.triangles.push_back({3, 3, 4});
  soup.triangles.push_back(soup.triangles.front());
  EXPECT_EQ(repair_surface(soup, {Defect::degenerate_faces}).soup.triangles.size(), soup.triangles.size() - 1);
  EXPECT_EQ(repair_surface(soup, {Defect::duplicate_faces}).soup.triangles.size(), soup.triangles.size() - 1);
  EXPECT_EQ(repair_surface(soup, {}).soup.triangles, soup.triangles);
  EXPECT_FALSE(repair_surface(soup, {Defect::fragments}).counts.any());
}

TEST(RepairSurface, EachDefectIsCountedByItself) {
  // Bodies that overlap are no defect.
  const TriangleSoup open_ball = cut(make_icosphere(2), [](const Vec3& p) { return p.z() > 0.7; });
  TriangleSoup soup = joined({make_icosphere(2), open_ball});
  soup.triangles.push_back({3, 3, 4});
  soup.triangles.push_back(soup.triangles.front());
  const RepairCounts counts = count_defects(soup);
  EXPECT_EQ(counts.joined_points, open_ball.points.size());
  EXPECT_EQ(counts.degenerate_faces, 1u);
  EXPECT_EQ(counts.duplicate_faces, 1u);
  EXPECT_EQ(counts.intersecting_faces,
            open_ball.triangles.size() + 1);  // all of the open ball, and the face that is there twice
  EXPECT_EQ(counts.removed_pieces, 0u);
  EXPECT_FALSE(count_defects(make_icosphere(2)).any());
}

TEST(RepairSurface, NamesEachStageAsItBegins) {
  TriangleSoup soup = make_icosphere(2);
  soup.triangles.push_back({3, 3, 4});
  std::vector<RepairStep> steps;
  const std::set<Defect> defects{Defect::degenerate_faces, Defect::intersections, Defect::non_manifold};
  repair_surface(soup, defects, {}, [&](const RepairStep& step) { steps.push_back(step); });
  const std::vector<RepairStage> stages{RepairStage::remove_degenerate, RepairStage::cut_intersections,
                                        RepairStage::separate, RepairStage::turn_outward};
  const std::vector<std::size_t> numbers{1, 2, 3, 3};
  ASSERT_EQ(steps.size(), stages.size());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    EXPECT_EQ(steps[k].stage, stages[k]);
    EXPECT_EQ(steps[k].number, numbers[k]);
    EXPECT_EQ(steps[k].of, defects.size());
    EXPECT_EQ(steps[k].so_far.degenerate_faces, k == 0 ? 0u : 1u);
  }
}

TEST(RepairSurface, PointsInTheSamePlaceAreJoined) {
  TriangleSoup soup = joined({make_icosphere(1), make_icosphere(1)});
  const RepairedSurface repaired = repair_surface(soup, {Defect::coincident_points});
  EXPECT_EQ(repaired.counts.joined_points, soup.points.size() / 2);
  const std::size_t half = soup.triangles.size() / 2;
  for (std::size_t f = 0; f < half; ++f) EXPECT_EQ(repaired.soup.triangles[f + half], soup.triangles[f]);
}

}  // namespace
}  // namespace loopmend
