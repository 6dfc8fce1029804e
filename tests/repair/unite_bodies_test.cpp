// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/unite_bodies.h"

#include "core/deadline.h"
#include "core/threads.h"
#include "mesh/boundary_loops.h"
#include "mesh/scan_attributes.h"
#include "mesh/self_intersections.h"
#include "mesh/surface_model.h"
#include "repair/watertight.h"
#include "repair/repair_surface.h"
#include "samples/analytic_surfaces.h"
#include "support/box.h"
#include "support/sharp_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

namespace loopmend {
namespace {

using test::box;

TriangleSoup ball(const Vec3& center, double radius = 1, int level = 3) {
  TriangleSoup soup = make_icosphere(level);
  for (Vec3& p : soup.points) p = radius * p + center;
  return soup;
}

TriangleSoup inward(TriangleSoup soup) {
  for (Triangle& t : soup.triangles) std::swap(t[1], t[2]);
  return soup;
}

/// A unit ball with a vertex far below, behind other faces: it crosses itself.
TriangleSoup spiked(const Vec3& center) {
  TriangleSoup soup = ball(center);
  *std::max_element(soup.points.begin(), soup.points.end(),
                    [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); }) = center + Vec3(0.02, 0.03, -1.4);
  return soup;
}

/// The box with a vertex twice in one place, and between both two faces without area.
TriangleSoup with_flat_faces(TriangleSoup soup) {
  const int copy = static_cast<int>(soup.points.size());
  soup.points.push_back(Vec3(soup.points[0]));
  soup.triangles[0][0] = soup.triangles[1][0] = copy;
  soup.triangles.push_back({0, soup.triangles[0][1], copy});
  soup.triangles.push_back({copy, soup.triangles[1][2], 0});
  return soup;
}

double volume_of(const TriangleSoup& soup) { return watertightness(soup).volume; }

/// One closed body without intersections, and the same again when it is united once more.
void expect_sound(const TriangleSoup& soup) {
  const Watertightness found = watertightness(soup);
  EXPECT_TRUE(found.printable()) << found.open_edges << " open, " << found.intersections << " intersections";
  EXPECT_TRUE(find_boundary_loops(make_surface_model(soup)).empty());
  const UnitedSurface again = unite_bodies(soup);
  EXPECT_EQ(again.counts.bodies, 0U);
  EXPECT_EQ(again.soup.points, soup.points);
  EXPECT_EQ(again.soup.triangles, soup.triangles);
}

TEST(UniteBodies, TwoCubesThatOverlapInACorner) {
  const TriangleSoup soup = joined({box({0, 0, 0}, {1, 1, 1}), box({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5})});
  const UnitedSurface united = unite_bodies(soup);
  EXPECT_EQ(united.counts.bodies, 2U);
  EXPECT_EQ(united.counts.made, 1U);
  EXPECT_DOUBLE_EQ(volume_of(united.soup), 2 - 0.125);
  expect_sound(united.soup);
  // The three far sides of each stay, 12 faces; the vertices keep their numbers, and six come where edges pierce faces.
  for (std::size_t v = 0; v < soup.points.size(); ++v) ASSERT_EQ(united.soup.points[v], soup.points[v]);
  EXPECT_EQ(united.soup.points.size(), soup.points.size() + 6);
  const std::size_t kept = united.soup.triangles.size() - united.counts.new_faces;
  EXPECT_EQ(kept, 12U);
  EXPECT_EQ(united.counts.removed_faces, 12U);
  auto next = soup.triangles.begin();
  for (std::size_t f = 0; f < kept; ++f) {  // in their order
    next = std::find(next, soup.triangles.end(), united.soup.triangles[f]);
    ASSERT_NE(next, soup.triangles.end()) << f;
  }
}

TEST(UniteBodies, ThreeBallsInARow) {
  const TriangleSoup a = ball({0, 0, 0}), b = ball({1.5, 0.1, 0.2}), c = ball({3, 0.3, 0.1});
  const auto united = [](const std::vector<TriangleSoup>& bodies) { return unite_bodies(joined(bodies)); };
  const UnitedSurface row = united({a, b, c});
  EXPECT_EQ(row.counts.bodies, 3U);
  EXPECT_EQ(row.counts.made, 1U);
  expect_sound(row.soup);
  // The outer ones do not meet.
  EXPECT_NEAR(volume_of(row.soup), volume_of(united({a, b}).soup) + volume_of(united({b, c}).soup) - volume_of(b),
              1e-12);
  // Two lenses less than three balls, up to the faces' distance from the sphere.
  const auto lens = [](double distance) {
    const double height = 1 - distance / 2;
    return 2 * M_PI * height * height * (3 - height) / 3;
  };
  const double ball_volume = 4 * M_PI / 3;
  EXPECT_NEAR(volume_of(row.soup),
              3 * ball_volume - lens(Vec3(1.5, 0.1, 0.2).norm()) - lens(Vec3(1.5, 0.2, -0.1).norm()), 0.15);
  const UnitedSurface two_rows = united({a, ball({0, 9, 0}), ball({1, 9, 0}), b, ball({0, 0, 9})});
  EXPECT_EQ(two_rows.counts.bodies, 4U);
  EXPECT_EQ(two_rows.counts.made, 2U);
}

TEST(UniteBodies, OneWithinAnotherGoes) {
  const TriangleSoup outer = ball({0, 0, 0});
  const UnitedSurface united = unite_bodies(joined({ball({0.2, 0, 0}, 0.3), outer, ball({0.1, 0.1, 0}, 0.3)}));
  EXPECT_EQ(united.counts.bodies, 3U);
  EXPECT_EQ(united.counts.new_faces, 0U);
  EXPECT_DOUBLE_EQ(volume_of(united.soup), volume_of(outer));
  EXPECT_EQ(united.soup.triangles.size(), outer.triangles.size());
  expect_sound(united.soup);
}

/// Without corefinement: CGAL would refuse the one with faces without area. A cavity goes with its body, and so does its content.
TEST(UniteBodies, OneWithinAnotherGoesWithoutAUnion) {
  const TriangleSoup outer = ball({0, 0, 0});
  const TriangleSoup hollow = joined({ball({0.3, 0, 0}, 0.5), inward(ball({0.3, 0, 0}, 0.3)), ball({0.3, 0, 0}, 0.1)});
  const UnitedSurface united =
      unite_bodies(joined({hollow, outer, with_flat_faces(box({-0.5, 0, 0}, {-0.4, 0.5, 0.5}))}));
  EXPECT_EQ(united.counts.bodies, 4U);
  EXPECT_EQ(united.counts.made, 1U);
  EXPECT_EQ(united.counts.refused, 0U);
  EXPECT_EQ(united.counts.removed_faces, hollow.triangles.size() + 14);
  EXPECT_DOUBLE_EQ(volume_of(united.soup), volume_of(outer));
  // In a chain: the one within goes, and the one that holds it is united with a third.
  const UnitedSurface chain =
      unite_bodies(joined({box({1, 1, 1}, {2, 2, 2}), box({0, 0, 0}, {3, 3, 3}), box({2, 2, 2}, {4, 4, 4})}));
  EXPECT_EQ(chain.counts.bodies, 3U);
  EXPECT_EQ(chain.counts.made, 1U);
  EXPECT_DOUBLE_EQ(volume_of(chain.soup), 27 + 8 - 1);
  expect_sound(chain.soup);
}

/// In a cavity it stays, also where it is a cavity of another body that the other one holds; within one that closes the cavity it goes.
TEST(UniteBodies, WhatACavityHoldsStays) {
  const TriangleSoup hollow = joined({box({0, 0, 0}, {8, 8, 8}), inward(box({1, 1, 1}, {7, 7, 7}))});
  const TriangleSoup doll = joined({hollow, box({2, 2, 2}, {6, 6, 6}), inward(box({3, 3, 3}, {5, 5, 5}))});
  const UnitedSurface apart = unite_bodies(doll);
  EXPECT_EQ(apart.counts.bodies, 0U);
  EXPECT_EQ(apart.soup.triangles, doll.triangles);
  const UnitedSurface filled = unite_bodies(joined({doll, box({-1, -1, -1}, {9, 9, 9})}));
  EXPECT_EQ(filled.counts.bodies, 3U);
  EXPECT_EQ(filled.soup.triangles.size(), 12U);
  EXPECT_DOUBLE_EQ(volume_of(filled.soup), 1000);
}

TEST(UniteBodies, CavitiesStayButForWhatAnotherBodyTakes) {
  const TriangleSoup hollow = joined({box({0, 0, 0}, {4, 4, 4}), inward(box({1, 1, 1}, {3, 3, 3}))});
  const UnitedSurface alone = unite_bodies(hollow);
  EXPECT_EQ(alone.counts.bodies, 0U);
  EXPECT_EQ(alone.soup.triangles, hollow.triangles);
  // A body in the cavity overlaps nothing.
  const UnitedSurface nested = unite_bodies(joined({hollow, box({1.5, 1.5, 1.5}, {2.5, 2.5, 2.5})}));
  EXPECT_EQ(nested.counts.bodies, 0U);
  EXPECT_DOUBLE_EQ(volume_of(nested.soup), 64 - 8 + 1);
  // One that leans against a wall of it, and one that goes through.
  const UnitedSurface leaning = unite_bodies(joined({hollow, box({0.5, 1.5, 1.5}, {2, 2.5, 2.5})}));
  EXPECT_DOUBLE_EQ(volume_of(leaning.soup), 64 - 8 + 1);
  expect_sound(leaning.soup);
  const UnitedSurface pierced = unite_bodies(joined({box({-1, 1.5, 1.5}, {5, 2.5, 2.5}), hollow}));
  EXPECT_DOUBLE_EQ(volume_of(pierced.soup), 64 - 8 + 2 + 2);
  expect_sound(pierced.soup);
  // The other body beside: outer shells are cut, the cavity is not.
  const UnitedSurface beside = unite_bodies(joined({hollow, box({3.5, 1, 1}, {5, 2, 2})}));
  EXPECT_DOUBLE_EQ(volume_of(beside.soup), 64 - 8 + 1);
  expect_sound(beside.soup);
}

TEST(UniteBodies, BodiesThatShareAFaceBecomeOne) {
  const UnitedSurface whole = unite_bodies(joined({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})}));
  EXPECT_EQ(whole.counts.made, 1U);
  EXPECT_DOUBLE_EQ(volume_of(whole.soup), 2);
  expect_sound(whole.soup);
  const UnitedSurface part = unite_bodies(joined({box({0, 0, 0}, {1, 1, 1}), box({1, 0.25, 0.25}, {2, 0.5, 0.5})}));
  EXPECT_EQ(part.counts.made, 1U);
  EXPECT_DOUBLE_EQ(volume_of(part.soup), 1 + 1.0 / 16);
  expect_sound(part.soup);
  const UnitedSurface same = unite_bodies(joined({ball({0, 0, 0}), ball({0, 0, 0})}));
  EXPECT_EQ(same.counts.bodies, 2U);
  EXPECT_DOUBLE_EQ(volume_of(same.soup), volume_of(ball({0, 0, 0})));
}

TEST(UniteBodies, BodiesThatTouchAtAnEdgeOrAPointStayApart) {
  const TriangleSoup edge = joined({box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0.25}, {2, 2, 0.5})});
  const UnitedSurface at_edge = unite_bodies(edge);
  EXPECT_EQ(at_edge.counts.bodies, 0U);
  EXPECT_EQ(at_edge.counts.touching, 1U);
  EXPECT_EQ(at_edge.soup.triangles, edge.triangles);
  TriangleSoup point = joined({box({0, 0, 0}, {1, 1, 1}), make_icosphere(0)});
  const Vec3 tip = point.points[8];
  for (std::size_t v = 8; v < point.points.size(); ++v) point.points[v] = (point.points[v] - tip) * 0.3;
  // Its tip lies within a side of the cube, and all else beyond.
  Vec3 middle = Vec3::Zero();
  for (std::size_t v = 8; v < point.points.size(); ++v) middle += point.points[v] / 12;
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(middle, Vec3(1, 0, 0));
  for (std::size_t v = 8; v < point.points.size(); ++v) point.points[v] = turn * point.points[v] + Vec3(1, 0.4, 0.3);
  const UnitedSurface at_point = unite_bodies(point);
  EXPECT_EQ(at_point.counts.bodies, 0U);
  EXPECT_EQ(at_point.counts.touching, 1U);
  EXPECT_EQ(at_point.soup.triangles, point.triangles);
}

TEST(UniteBodies, WhatIsOpenOrCrossesItselfIsLeft) {
  const TriangleSoup open = cut(ball({1.2, 0, 0}), [](const Vec3& p) { return p.x() > 2; });
  const TriangleSoup crossing = spiked({-1.2, 0, 0});
  const TriangleSoup soup = joined({ball({0, 0, 0}), open, crossing, ball({0, 1, 0})});
  const UnitedSurface united = unite_bodies(soup);
  EXPECT_EQ(united.counts.bodies, 2U);  // the two sound ones
  EXPECT_EQ(united.counts.made, 1U);
  EXPECT_EQ(united.counts.open_pieces, 1U);
  EXPECT_EQ(united.counts.crossing, 1U);
  const std::set<Triangle> after(united.soup.triangles.begin(), united.soup.triangles.end());
  const auto first = static_cast<int>(ball({0, 0, 0}).points.size());
  const auto last = first + static_cast<int>(open.points.size() + crossing.points.size());
  for (const Triangle& t : soup.triangles)
    if (t[0] >= first && t[0] < last) {
      ASSERT_TRUE(after.contains(t));
    }
}

/// The surface of a box, meshed on a grid.
TriangleSoup grid_box(const Vec3& low, const Vec3& high, double cell) {
  test::GridSurface surface;
  const Vec3 size = high - low;
  for (int axis = 0; axis < 3; ++axis)
    for (const int end : {0, 1}) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      surface.add(static_cast<int>(std::lround(size[u] / cell)), static_cast<int>(std::lround(size[v] / cell)),
                  [&](double x, double y) {
                    Vec3 p = low;
                    p[axis] = end == 0 ? low[axis] : high[axis];
                    p[u] += size[u] * (end == 1 ? x : y);
                    p[v] += size[v] * (end == 1 ? y : x);
                    return p;
                  });
    }
  return std::move(surface.soup);
}

/// Their meshes have all edges in common along the curve where they cross: no two faces cross.
TEST(UniteBodies, BodiesOnOneGrid) {
  const TriangleSoup one = grid_box({0, 0, 0}, {2, 2, 2}, 1);
  ASSERT_NEAR(volume_of(one), 8, 1e-12);
  const UnitedSurface united = unite_bodies(joined({one, grid_box({1, 1, 1}, {3, 3, 3}, 1)}));
  EXPECT_EQ(united.counts.made, 1U);
  EXPECT_NEAR(volume_of(united.soup), 15, 1e-12);
}

/// A clamp sunk into a block, one edge of which lies on an edge of the block: around both there is no manifold.
TEST(UniteBodies, AnOverlapWithoutAManifoldIsRefused) {
  const TriangleSoup block = box({0, 0, 0}, {2, 2, 1});
  const TriangleSoup foot = box({0.5, 0.5, 0.5}, {1, 1, 3}), bar = box({0.5, 0.5, 2.5}, {4, 1, 3}),
                     jaw = box({2, 0.5, 1}, {4, 1, 3});
  const UnitedSurface clamp = unite_bodies(joined({foot, bar, jaw}));
  ASSERT_EQ(clamp.counts.made, 1U);
  const TriangleSoup both = joined({block, clamp.soup});
  const UnitedSurface united = unite_bodies(both);
  EXPECT_EQ(united.counts.refused, 1U);
  EXPECT_EQ(united.counts.touching, 0U);
  EXPECT_EQ(united.soup.triangles, both.triangles);
}

/// CGAL does not take them; other bodies are still united.
TEST(UniteBodies, ABodyWithFacesWithoutAreaIsLeftAndOthersAreUnited) {
  const TriangleSoup soup = joined({with_flat_faces(box({0, 0, 0}, {1, 1, 1})),
                                    box({0.25, -0.5, -0.5}, {0.75, 0.5, 0.5}), ball({9, 0, 0}), ball({10, 0, 0})});
  const UnitedSurface united = unite_bodies(soup);
  EXPECT_EQ(united.counts.made, 1U);
  EXPECT_EQ(united.counts.refused, 1U);
}

/// The rim of a bowl is an edge, and a lid takes that in: a void is left, and some of each face of both.
TEST(UniteBodies, ALidThatLeavesAVoidAndSomeOfEachFaceIsUnited) {
  TriangleSoup bowl = box({0, 0, 0}, {4, 4, 4});
  bowl.triangles.erase(bowl.triangles.begin() + 2, bowl.triangles.begin() + 4);  // its top
  for (const Vec3& p : {Vec3(1.5, 1.5, 1), Vec3(2.5, 1.5, 1), Vec3(1.5, 2.5, 1), Vec3(2.5, 2.5, 1)})
    bowl.points.push_back(p);
  for (const std::array<int, 4>& q : {std::array{4, 5, 9, 8}, std::array{5, 7, 11, 9}, std::array{7, 6, 10, 11},
                                      std::array{6, 4, 8, 10}, std::array{8, 9, 11, 10}}) {
    bowl.triangles.push_back({q[0], q[1], q[2]});
    bowl.triangles.push_back({q[0], q[2], q[3]});
  }
  ASSERT_DOUBLE_EQ(volume_of(bowl), 64 - 21);  // 21: of the frustum
  const UnitedSurface united = unite_bodies(joined({bowl, box({-1, -1, 3.5}, {5, 5, 5})}));
  EXPECT_EQ(united.counts.made, 1U);
  EXPECT_EQ(united.counts.touching, 0U);
  EXPECT_NEAR(volume_of(united.soup), 16 * 3.5 - (3.5 * 3.5 * 3.5 - 1) / 3 + 54, 1e-12);
  expect_sound(united.soup);
}

/// An arm that stands on a face and touches an edge: as one they would have no manifold, and they do more than touch.
TEST(UniteBodies, AFaceInCommonIsMoreThanTouching) {
  const UnitedSurface arm = unite_bodies(
      joined({box({1, 0, 0}, {2, 2, 0.5}), box({1.5, 1.25, 0.25}, {2, 2, 2}), box({0.25, 1, 1}, {2, 2, 2})}));
  ASSERT_EQ(arm.counts.made, 1U);
  const UnitedSurface both = unite_bodies(joined({box({0, 0, 0}, {1, 1, 1}), arm.soup}));
  EXPECT_EQ(both.counts.refused, 1U);
  EXPECT_EQ(both.counts.touching, 0U);
}

/// Two cubes, and a block that overlaps both where they touch.
TEST(UniteBodies, BodiesWithAVertexOrAnEdgeInCommonTouchUntilAThirdJoinsThem) {
  for (const double z : {0.0, 1.0}) {
    const TriangleSoup cubes = joined({box({0, 0, 0}, {1, 1, 1}), box({1, 1, z}, {2, 2, z + 1})});
    const UnitedSurface apart = unite_bodies(cubes);
    EXPECT_EQ(apart.counts.touching, 1U) << z;
    EXPECT_EQ(apart.counts.bodies, 0U) << z;
    EXPECT_EQ(apart.soup.triangles, cubes.triangles);
    const UnitedSurface united = unite_bodies(joined({cubes, box({0.5, 0.5, -1}, {1.5, 1.5, 3})}));
    EXPECT_EQ(united.counts.touching, 0U) << z;
    EXPECT_EQ(united.counts.bodies, 3U) << z;
    EXPECT_EQ(united.counts.made, 1U) << z;
    EXPECT_DOUBLE_EQ(volume_of(united.soup), 2 + 4 - 0.5);
    expect_sound(united.soup);
  }
}

/// A ball in one with a small hole, in one that crosses itself and in the cavity of one with a hole; and those in a sound one.
TEST(UniteBodies, WhatIsUnsoundAndHoldsOrLiesInABodyIsCounted) {
  const TriangleSoup small = ball({0, 0, 0}, 0.3),
                     cracked = cut(ball({0, 0, 0}), [](const Vec3&p) { return p.x() > 0.98; });
  const auto counts = [](const std::vector<TriangleSoup>& shells) {
    const TriangleSoup soup = joined(shells);
    const UnitedSurface united = unite_bodies(soup);
    EXPECT_EQ(united.soup.triangles, soup.triangles);
    EXPECT_EQ(united.counts.bodies, 0U);
    return std::array{united.counts.open_pieces, united.counts.crossing};
  };
  using Counts = std::array<std::size_t, 2>;
  EXPECT_EQ(counts({small, cracked}), (Counts{1, 0}));
  EXPECT_EQ(counts({small, spiked({0, 0, 0})}), (Counts{0, 1}));
  EXPECT_EQ(counts({small, cracked, inward(ball({0, 0, 0}, 0.6))}), (Counts{0, 0}));
  EXPECT_EQ(counts({cracked, ball({0, 0, 0}, 2)}), (Counts{1, 0}));
  EXPECT_EQ(counts({spiked({0, 0, 0}), ball({0, 0, 0}, 2)}), (Counts{0, 1}));
}

TEST(UniteBodies, StopsWhenCancelledOrItsTimeIsOver) {
  const TriangleSoup soup = joined({ball({0, 0, 0}, 1, 4), ball({0.7, 0, 0}, 1, 4)});
  const CancelToken cancel;
  cancel.cancel();
  EXPECT_EQ(unite_bodies(soup, cancel).soup.triangles, soup.triangles);
  for (const double seconds : {0.005, 0.04}) {
    const CancelToken later;
    const Deadline deadline(std::chrono::steady_clock::now(), seconds, later);
    const UnitedSurface united = unite_bodies(soup, later);
    EXPECT_TRUE(united.counts.made == 1 || united.soup.triangles == soup.triangles);
  }
}

TEST(UniteBodies, DoesNotDependOnWhereItRunsNorOnThreads) {
  const TriangleSoup soup = joined(
      {ball({0, 0, 0}), ball({0.7, 0.1, 0}, 0.9), ball({0.2, 0.8, 0.1}, 0.7), box({-2, 0.1, 0.2}, {2, 0.3, 0.4})});
  const UnitedSurface once = with_thread_budget(1, [&] { return unite_bodies(soup); });
  const auto elsewhere = std::make_unique<std::array<char, 1234567>>();
  const UnitedSurface again = with_thread_budget(4, [&] { return unite_bodies(soup); });
  EXPECT_EQ(once.counts.made, 1U);
  EXPECT_EQ(once.soup.points, again.soup.points);
  EXPECT_EQ(once.soup.triangles, again.soup.triangles);
  expect_sound(once.soup);
}

TEST(UniteBodies, ThroughRepairBodiesInsideOutAreTurnedFirst) {
  const TriangleSoup soup = joined({inward(box({0, 0, 0}, {1, 1, 1})), box({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5})});
  const RepairedSurface alone = repair_surface(soup, {Defect::overlaps});
  EXPECT_EQ(alone.counts.turned_shells, 1U);
  EXPECT_DOUBLE_EQ(volume_of(alone.soup), 2 - 0.125);
  std::set<Defect> defects = harmless_repairs;
  defects.insert({Defect::overlaps, Defect::intersections});
  const RepairedSurface all = repair_surface(soup, defects);
  EXPECT_EQ(all.soup.triangles, alone.soup.triangles);
  EXPECT_EQ(all.counts.intersecting_faces + all.counts.overlapping_bodies, 0U);
  EXPECT_TRUE(all.counts.any());
  EXPECT_FALSE(repair_surface(all.soup, defects).counts.any());
}

/// Bodies that are one within another, or touch in a face, are to be united; those that touch at a vertex or stay in a cavity are not.
TEST(UniteBodies, WhatIsToBeUnitedIsCounted) {
  const TriangleSoup cube = box({0, 0, 0}, {4, 4, 4});
  const auto counted = [&](const TriangleSoup& other) { return count_defects(joined({cube, other})).united.bodies; };
  EXPECT_EQ(counted(box({3, 3, 3}, {5, 5, 5})), 2U);
  EXPECT_EQ(counted(box({1, 1, 1}, {2, 2, 2})), 2U);
  EXPECT_EQ(counted(box({4, 1, 1}, {5, 2, 2})), 2U);
  EXPECT_EQ(counted(box({4, 4, 4}, {5, 5, 5})), 0U);
  EXPECT_EQ(counted(box({4, 4, 1}, {5, 5, 2})), 0U);
  EXPECT_EQ(counted(inward(box({1, 1, 1}, {2, 2, 2}))), 0U);
  EXPECT_EQ(counted(box({6, 1, 1}, {7, 2, 2})), 0U);
}

/// Texture coordinates, colours, a smooth and a whole number of each vertex: linear over a part of a face, or its face's.
TEST(UniteBodies, PartsHaveTheAttributesOfTheirFace) {
  TriangleSoup soup = joined({box({0, 0, 0}, {1, 1, 1}), box({0.5, 0.25, 0.25}, {1.5, 0.75, 0.75})});
  auto attributes = std::make_shared<ScanAttributes>();
  attributes->format = "PLY";
  attributes->points.emplace_back("height", ScalarType::float64);
  attributes->points.emplace_back("body", ScalarType::uint8);
  attributes->faces.emplace_back("number", ScalarType::int32);
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    const Vec3& p = soup.points[v];
    attributes->points[0].push(p.x() + 2 * p.y() + 4 * p.z());
    attributes->points[1].push(v < 8 ? 1 : 2);
    soup.colors.push_back(
        {static_cast<unsigned char>(100 * p.y()), v < 8 ? std::uint8_t{10} : std::uint8_t{20}, 30, 255});
  }
  FaceNames materials{"usemtl", {"first", "second"}, {}};
  for (int f = 0; f < 24; ++f) {
    attributes->faces[0].push(f);
    materials.of_face.push_back(f < 12 ? 0 : 1);
  }
  attributes->names.push_back(materials);
  attributes->texture.dimension = 2;
  for (const Triangle& t : soup.triangles)
    for (int v : t) {
      attributes->corners.push_back(v);
      attributes->texture.at.push_back(static_cast<int>(attributes->texture.count()));
      for (const double u : {soup.points[v].x() - soup.points[v].z(), 3 * soup.points[v].y()})
        attributes->texture.values.push_back(u);
    }
  attributes->point_count = soup.points.size();
  attributes->triangle_count = soup.triangles.size();
  soup.attributes = attributes;
  const UnitedSurface united = unite_bodies(soup);
  const TriangleSoup& after = united.soup;
  EXPECT_DOUBLE_EQ(volume_of(after), 1 + 0.125);
  ASSERT_EQ(after.colors.size(), after.points.size());
  ASSERT_GT(united.counts.new_faces, 0U);
  const ScanAttributes& made = *after.attributes;
  EXPECT_EQ(made.triangle_count, 24 + united.counts.new_faces);
  for (std::size_t v = 0; v < after.points.size(); ++v) {
    const Vec3& p = after.points[v];
    const auto row = static_cast<std::size_t>(point_row(after, v));
    ASSERT_LT(row, made.point_count);
    EXPECT_NEAR(made.points[0].value(row), p.x() + 2 * p.y() + 4 * p.z(), 1e-12);
    EXPECT_TRUE(made.points[1].value(row) == 1 || made.points[1].value(row) == 2);
    EXPECT_NEAR(after.colors[v][0], 100 * p.y(), 0.51);
  }
  for (std::size_t f = 0; f < after.triangles.size(); ++f) {
    const auto row = static_cast<std::size_t>(triangle_row(after, f));
    const auto number = static_cast<std::size_t>(made.faces[0].value(row));
    EXPECT_EQ(made.names[0].of_face[row], number < 12 ? 0 : 1);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = after.points[after.triangles[f][k]];
      const auto at = 2 * static_cast<std::size_t>(made.texture.at[3 * row + k]);
      EXPECT_NEAR(made.texture.values[at], p.x() - p.z(), 1e-12);
      EXPECT_NEAR(made.texture.values[at + 1], 3 * p.y(), 1e-12);
    }
    // Its normal is that of the face that it is a part of.
    const auto normal = [](const TriangleSoup& of, std::size_t face) {
      const Triangle& t = of.triangles[face];
      return Vec3((of.points[t[1]] - of.points[t[0]]).cross(of.points[t[2]] - of.points[t[0]]).normalized());
    };
    EXPECT_NEAR((normal(after, f) - normal(soup, number)).norm(), 0, 1e-12);
  }
}

}  // namespace
}  // namespace loopmend
