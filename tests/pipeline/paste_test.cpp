// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/paste.h"

#include "pipeline/initial_patch.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace loopmend {
namespace {

/// A sphere with a hole at each pole.
SurfaceModel open_at_both_poles() {
  return make_surface_model(cut(make_icosphere(3), [](const Vec3& p) { return std::abs(p.z()) > 0.85; }));
}

std::vector<Patch> patches_of(const SurfaceModel& model) {
  std::vector<Patch> patches;
  for (const BoundaryLoop& loop : find_boundary_loops(model))
    patches.push_back(*make_initial_patch(model, {loop}, {}, {}).patch);
  return patches;
}

TEST(PastePatches, TheOrderInWhichTheyComeDoesNotMatter) {
  const SurfaceModel open = open_at_both_poles();
  const std::vector<Patch> patches = patches_of(open);
  ASSERT_EQ(patches.size(), 2u);
  SurfaceModel one = open, other = open;
  const auto in_order = paste_patches(one, {&patches[0], &patches[1]});
  const auto reversed = paste_patches(other, {&patches[1], &patches[0]});
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_TRUE(in_order[k].fault.empty());
    EXPECT_TRUE(reversed[k].fault.empty());
    EXPECT_EQ(in_order[k].first_point, reversed[1 - k].first_point);
    EXPECT_EQ(in_order[k].first_triangle, reversed[1 - k].first_triangle);
  }
  EXPECT_EQ(in_order[0].first_point, static_cast<int>(open.soup.points.size()));
  EXPECT_EQ(in_order[1].first_point, in_order[0].first_point + patches[0].free_count);
  EXPECT_EQ(in_order[1].first_triangle, in_order[0].first_triangle + patches[0].patch_triangles);
  EXPECT_EQ(one.soup.points, other.soup.points);
  EXPECT_EQ(one.soup.triangles, other.soup.triangles);
  EXPECT_TRUE(find_boundary_loops(one).empty());
}

TEST(PastePatches, OneThatIntersectsAnEarlierOneIsLeftOut) {
  const SurfaceModel open = open_at_both_poles();
  std::vector<Patch> patches = patches_of(open);
  // The second is pulled through the first.
  Patch& second = patches[1];
  const Vec3 far = second.to_frame(patches[0].to_mesh(Vec3::Zero()) * 3);
  second.positions[0] = far;
  SurfaceModel model = open;
  const std::vector<PastedPatch> outcomes = paste_patches(model, {&second, &patches[0]});
  EXPECT_TRUE(outcomes[1].fault.empty());
  EXPECT_NE(outcomes[0].fault.english().find("would cut that of loop 1"), std::string::npos) << outcomes[0].fault;
  EXPECT_EQ(outcomes[0].first_point, -1);
  EXPECT_EQ(find_boundary_loops(model).size(), 1u);
}

TEST(SoupRecord, SeesAMovedPointAndWhichTrianglesWereTurned) {
  const TriangleSoup before = make_icosphere(7);  // several checksums of each
  const SoupRecord record = record_of(before);
  TriangleSoup now = before;
  now.points.push_back(Vec3(1, 2, 3));
  now.triangles.push_back({0, 1, static_cast<int>(now.points.size()) - 1});
  EXPECT_NO_THROW(check_exterior(record, now));
  const std::vector<int> turned{3, 4, 70000, 300000};
  for (int f : turned) std::swap(now.triangles[f][1], now.triangles[f][2]);
  EXPECT_THROW(check_exterior(record, now), std::logic_error);
  EXPECT_THROW(check_exterior(record, now, {3, 4, 70000}), std::logic_error);
  EXPECT_NO_THROW(check_exterior(record, now, turned));
  EXPECT_EQ(record_of(now, turned).points, before.points.size() + 1);
  now.points[100000].x() = std::nextafter(now.points[100000].x(), 2.0);
  EXPECT_THROW(check_exterior(record, now, turned), std::logic_error);
  now = before;
  now.triangles.pop_back();
  EXPECT_THROW(check_exterior(record, now), std::logic_error);
}

TEST(CheckExterior, SeesAMovedPointAndAWrongNumberOfTurnedTriangles) {
  const TriangleSoup before = make_icosphere(1);
  TriangleSoup now = before;
  EXPECT_NO_THROW(check_exterior(before, now, 0));
  now.points.push_back(Vec3(1, 2, 3));
  now.triangles.push_back({0, 1, static_cast<int>(now.points.size()) - 1});
  EXPECT_NO_THROW(check_exterior(before, now, 0));
  EXPECT_THROW(check_exterior(before, now, 1), std::logic_error);
  std::swap(now.triangles[3][1], now.triangles[3][2]);
  EXPECT_THROW(check_exterior(before, now, 0), std::logic_error);
  EXPECT_NO_THROW(check_exterior(before, now, 1));
  now.points[5].x() = std::nextafter(now.points[5].x(), 2.0);
  EXPECT_THROW(check_exterior(before, now, 1), std::logic_error);
}

}  // namespace
}  // namespace loopmend
