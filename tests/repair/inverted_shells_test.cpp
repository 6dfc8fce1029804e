// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/inverted_shells.h"

#include "repair/repair_surface.h"
#include "repair/watertight.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace loopmend {
namespace {

enum class Facing { outward, inward };

TriangleSoup ball(double radius, const Vec3& center, Facing facing) {
  TriangleSoup soup = make_icosphere(2);
  for (Vec3& p : soup.points) p = radius * p + center;
  if (facing == Facing::inward)
    for (Triangle& t : soup.triangles) std::swap(t[1], t[2]);
  return soup;
}

double volume(const TriangleSoup& soup) { return watertightness(soup).volume; }
const double of_unit_ball = volume(make_icosphere(2));

InvertedShells found_in(const TriangleSoup& soup) {
  const SurfaceModel model = make_surface_model(soup);
  return find_inverted_shells(model, find_boundary_loops(model));
}

TEST(InvertedShells, ABodyInsideOutIsTurned) {
  const TriangleSoup soup = joined(
      {ball(1, {0, 0, 0}, Facing::inward), ball(1, {3, 0, 0}, Facing::outward), ball(1, {1e5, 0, 0}, Facing::inward)});
  const RepairedSurface repaired = repair_surface(soup);
  EXPECT_EQ(repaired.counts.turned_shells, 2u);
  EXPECT_EQ(repaired.counts.turned_faces, 2u * 320u);
  EXPECT_EQ(repaired.soup.points, soup.points);
  EXPECT_NEAR(volume(repaired.soup), 3 * of_unit_ball, 1e-4);
  EXPECT_FALSE(repair_surface(repaired.soup).counts.any());
}

/// Hollow balls, as they should be, inside out as a whole, and with the outer shell alone inside out.
TEST(InvertedShells, CavitiesStayCavities) {
  const double wall = of_unit_ball * (1 - 0.125);
  const auto hollow = [](Facing outer, Facing inner) {
    return joined({ball(0.5, {0.1, 0, 0}, inner), ball(1, {0, 0, 0}, outer)});
  };
  const RepairedSurface sound = repair_surface(hollow(Facing::outward, Facing::inward));
  EXPECT_FALSE(sound.counts.any());
  const RepairedSurface whole = repair_surface(hollow(Facing::inward, Facing::outward));
  EXPECT_EQ(whole.counts.turned_shells, 2u);
  EXPECT_NEAR(volume(whole.soup), wall, 1e-9);
  const RepairedSurface outer = repair_surface(hollow(Facing::inward, Facing::inward));
  EXPECT_EQ(outer.counts.turned_shells, 1u);
  EXPECT_NEAR(volume(outer.soup), wall, 1e-9);
}

TEST(InvertedShells, ABodyInACavityIsABodyAndOneInAnotherBodyIsLeft) {
  const TriangleSoup rattle = joined({ball(1, {0, 0, 0}, Facing::outward), ball(0.8, {0, 0, 0}, Facing::inward),
                                      ball(0.3, {0.2, 0, 0}, Facing::inward)});
  const RepairedSurface repaired = repair_surface(rattle);
  EXPECT_EQ(repaired.counts.turned_shells, 1u);
  EXPECT_NEAR(volume(repaired.soup), of_unit_ball * (1 - 0.512 + 0.027), 1e-9);
  const TriangleSoup parts = joined({ball(1, {0, 0, 0}, Facing::outward), ball(0.5, {0, 0, 0}, Facing::outward)});
  EXPECT_FALSE(repair_surface(parts).counts.any());
}

/// A cavity in a body that is part of another one.
TEST(InvertedShells, ABodyInABodyKeepsItsCavity) {
  const TriangleSoup nest = joined({ball(1, {0, 0, 0}, Facing::outward), ball(0.7, {0, 0, 0}, Facing::outward),
                                    ball(0.3, {0, 0, 0}, Facing::inward)});
  EXPECT_FALSE(repair_surface(nest).counts.any());
  EXPECT_TRUE(watertightness(nest).printable());
}

/// What overlaps is in nothing.
TEST(InvertedShells, BodiesThatCrossAreBodies) {
  const TriangleSoup soup = joined({ball(1, {0, 0, 0}, Facing::outward), ball(0.8, {0.5, 0, 0}, Facing::inward)});
  EXPECT_EQ(repair_surface(soup).counts.turned_shells, 1u);
}

TEST(InvertedShells, SmallHolesChangeNothingBesideAnotherBody) {
  TriangleSoup soup = cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.95; });
  EXPECT_EQ(found_in(soup).closed, 0u);
  for (Triangle& t : soup.triangles) std::swap(t[1], t[2]);
  for (const Facing facing : {Facing::outward, Facing::inward}) {
    const InvertedShells found = found_in(joined({soup, ball(1, {3, 0, 0}, facing)}));
    EXPECT_EQ(found.closed, facing == Facing::inward ? 2u : 1u);
    EXPECT_EQ(found.open, 0u);
  }
}

/// A room with a window, also with what stands in it; with a crack alone it is a body inside out.
TEST(InvertedShells, ALoneBodyWithAnOpeningMayBeARoom) {
  TriangleSoup room = cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.95; });
  for (Triangle& t : room.triangles) std::swap(t[1], t[2]);
  for (const TriangleSoup& soup : {room, joined({room, ball(0.3, {0, 0, -0.3}, Facing::outward)})}) {
    const InvertedShells found = found_in(soup);
    EXPECT_EQ(found.closed, 0u);
    EXPECT_EQ(found.open, 1u);
    EXPECT_FALSE(repair_surface(soup).counts.any());
  }
  TriangleSoup cracked = ball(1, {0, 0, 0}, Facing::inward);
  const int v = cracked.triangles[0][0];
  cracked.points.push_back(cracked.points[v]);
  cracked.triangles[0][0] = static_cast<int>(cracked.points.size()) - 1;
  EXPECT_EQ(found_in(cracked).closed, 1u);
}

TEST(InvertedShells, WideOpeningsAreToldAndLeft) {
  // A ball without its top third: no cover over it could change the sign of the volume.
  TriangleSoup soup = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.75; });
  for (Triangle& t : soup.triangles) std::swap(t[1], t[2]);
  EXPECT_EQ(found_in(soup).open, 1u);
  EXPECT_EQ(found_in(soup).closed, 0u);
  EXPECT_FALSE(repair_surface(soup).counts.any());
}

/// What lies in a shell that stays as it is stays with it: it may be a cavity of that.
TEST(InvertedShells, WhatLiesInAnOpenShellIsLeft) {
  TriangleSoup outer = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.75; });
  for (Triangle& t : outer.triangles) std::swap(t[1], t[2]);
  for (const Facing facing : {Facing::outward, Facing::inward}) {
    const InvertedShells found = found_in(joined({outer, ball(0.3, {0, 0, -0.3}, facing)}));
    EXPECT_EQ(found.open, 1u);
    EXPECT_EQ(found.closed, 0u);
  }
  const TriangleSoup bowl = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > -0.2; });  // no inside for sure
  const InvertedShells found = found_in(joined({bowl, ball(0.1, {0, 0, -0.5}, Facing::inward)}));
  EXPECT_EQ(found.open + found.closed, 0u);
}

/// Both end at the same height.
TriangleSoup turned(TriangleSoup soup, const std::vector<char>& faces) {
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (faces[f]) std::swap(soup.triangles[f][1], soup.triangles[f][2]);
  return soup;
}

std::vector<char> inside_out(const TriangleSoup& soup) {
  const SurfaceModel model = make_surface_model(soup);
  return faces_inside_out(model, find_boundary_loops(model));
}

/// A wide bowl that looks inward as a whole, with a cavity, and two balls beside it, of which one is sound.
TEST(InvertedShells, TurningAroundLeavesWhatIsRight) {
  TriangleSoup bowl = cut(ball(1, {0, 0, 0}, Facing::inward), [](const Vec3& p) { return p.z() > 0.3; });
  const TriangleSoup soup = joined({bowl, ball(0.2, {0, 0, -0.4}, Facing::outward),
                                    ball(0.3, {3, 0, 0}, Facing::outward), ball(0.3, {6, 0, 0}, Facing::inward)});
  EXPECT_EQ(found_in(soup).open, 1u);
  EXPECT_EQ(found_in(soup).closed, 1u);
  const std::vector<char> faces = inside_out(soup);
  ASSERT_EQ(faces.size(), soup.triangles.size());
  const std::size_t of_bowl = bowl.triangles.size(), of_ball = make_icosphere(2).triangles.size();
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::size_t body = f < of_bowl ? 0 : 1 + (f - of_bowl) / of_ball;
    EXPECT_EQ(faces[f] != 0, body != 2) << f;  // the sound ball alone stays
  }
  const InvertedShells after = found_in(turned(soup, faces));
  EXPECT_EQ(after.open, 0u);
  EXPECT_EQ(after.closed, 0u);
  EXPECT_TRUE(inside_out(turned(soup, faces)).empty());
}

TEST(InvertedShells, TheInnerWallOfACupIsNone) {
  const auto is_above = [](const Vec3& p) { return p.z() > 0.4; };
  const TriangleSoup outer = cut(ball(1, {0, 0, 0}, Facing::outward), is_above);
  const TriangleSoup inner = cut(ball(0.9, {0, 0, 0}, Facing::inward), is_above);
  EXPECT_EQ(found_in(inner).open, 1U);
  EXPECT_EQ(found_in(joined({outer, inner})).open, 0U);
  EXPECT_EQ(found_in(joined({inner, outer})).open, 0U);
}

TEST(InvertedShells, SheetsHaveNoInside) {
  for (const double height : {-0.5, 0.2, 0.9, -0.9}) {
    TriangleSoup soup = make_graph([&](double x, double y) { return height * std::exp(-4 * (x * x + y * y)); }, 1, 16);
    const InvertedShells found = found_in(soup);
    EXPECT_EQ(found.open + found.closed, 0u) << height;
    EXPECT_FALSE(repair_surface(soup).counts.any()) << height;
  }
}

/// Spikes down to a mark for missing data have a large area, so that the sheet is closed but for a small opening.
TEST(InvertedShells, ASheetWithSpikesHasNoInside) {
  for (const double mark : {-9999.0, -32768.0}) {
    TriangleSoup soup = make_graph([&](double x, double y) { return std::hypot(x, y) < 0.4 ? mark : 0.1; }, 1, 16);
    const InvertedShells found = found_in(soup);
    EXPECT_EQ(found.open + found.closed, 0u) << mark;
    EXPECT_FALSE(repair_surface(soup).counts.any()) << mark;
  }
}

/// Of a large scan the view holds no more than what lies around the loops.
TEST(InvertedShells, AreFoundInAViewAroundTheLoops) {
  TriangleSoup holed = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.95; });
  for (Triangle& t : holed.triangles) std::swap(t[1], t[2]);
  const TriangleSoup soup = joined({holed, ball(1, {5, 0, 0}, Facing::inward), ball(1, {9, 0, 0}, Facing::outward)});
  const SurfaceModel view = make_view_around_loops(soup, {});
  ASSERT_LT(view.mesh.n_faces(), soup.triangles.size());
  EXPECT_EQ(find_inverted_shells(view, find_boundary_loops(view)).closed, 2u);
}

}  // namespace
}  // namespace loopmend
