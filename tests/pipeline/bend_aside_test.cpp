// SPDX-License-Identifier: GPL-3.0-or-later
// A hole with fragments of other surface in it.
#include "pipeline/bend_aside.h"

#include "mesh/join_parts.h"
#include "mesh/triangle_soup.h"
#include "pipeline/fill_holes.h"
#include "samples/analytic_surfaces.h"
#include "support/filled_surface.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace loopmend {
namespace {

TriangleSoup small_ball(const Vec3& at, double radius) {
  TriangleSoup ball = make_icosphere(1);
  for (Vec3& p : ball.points) p = radius * p + at;
  return ball;
}

/// A ball of radius 1 without its cap, with balls of radius 0.04 about where the cap was.
SurfaceModel open_ball(const std::vector<Vec3>& fragments, double radius = 0.04) {
  std::vector<TriangleSoup> parts{trim_boundaries(cut(make_icosphere(5), [](const Vec3& p) { return p.z() > 0.8; }))};
  for (const Vec3& at : fragments) parts.push_back(small_ball(at, radius));
  return make_surface_model(joined(parts));
}

Patch initial_patch(const SurfaceModel& model) {
  return *make_initial_patch(model, find_boundary_loops(model), {}, {}).patch;
}

/// On the sphere that the cap is a part of.
Vec3 on_cap(double x, double y, double radius = 1) { return radius * Vec3(x, y, 1).normalized(); }

TEST(BendAside, OnlyFreeVerticesNearTheFragmentMove) {
  const SurfaceModel model = open_ball({Vec3(0.1, 0, 0.8)});
  const ScanIndex scan(model);
  Patch patch = initial_patch(open_ball({}));
  // Flat, at the height of the fragment's middle.
  for (int i = 0; i < patch.free_count; ++i) {
    const Vec3 p = patch.to_mesh(patch.positions[i]);
    patch.positions[i] = patch.to_frame({p.x(), p.y(), 0.8});
  }
  ASSERT_GT(validate(scan, patch).intersections, 0);
  const auto bent = bent_aside(scan, patch, validate(scan, patch), {});
  ASSERT_TRUE(bent);
  EXPECT_EQ(bent->fragments, 1);
  EXPECT_EQ(bent->validity.intersections, 0);
  EXPECT_EQ(validate(scan, bent->patch).intersections, 0);
  int moved = 0;
  for (int i = 0; i < patch.vertex_count(); ++i) {
    if (bent->patch.positions[i] == patch.positions[i]) continue;
    ++moved;
    EXPECT_LT(i, patch.free_count);
    EXPECT_LT((patch.to_mesh(patch.positions[i]) - Vec3(0.1, 0, 0.8)).norm(), 0.45);
    EXPECT_LT(std::abs((bent->patch.to_mesh(bent->patch.positions[i])).z() - 0.8), 0.12);
  }
  EXPECT_GT(moved, 3);
}

TEST(BendAside, WhatIsNoFragmentIsNotPassed) {
  const Patch patch = initial_patch(open_ball({}));
  const SurfaceModel large = open_ball({on_cap(0, 0)}, 0.3);
  const ScanIndex scan(large);
  ASSERT_GT(validate(scan, patch).intersections, 0);
  EXPECT_FALSE(bent_aside(scan, patch, validate(scan, patch), {}));
}

TEST(BendAside, AHoleWithFragmentsInItIsFilled) {
  for (const std::vector<Vec3>& fragments :
       {std::vector<Vec3>{on_cap(0.05, 0)}, {on_cap(0.2, 0.1), on_cap(-0.15, -0.2), on_cap(0, 0.3)}}) {
    SurfaceModel model = open_ball(fragments);
    const TriangleSoup before = model.soup;
    const HoleResult result = fill_holes(model, find_boundary_loops(model), {}, nullptr, {}).at(0);
    ASSERT_TRUE(is_filled(result.status)) << result.message;
    EXPECT_EQ(result.outcome().made_by, "flow");
    EXPECT_NE(result.message.english().find("bent past loose fragments"), std::string::npos) << result.message;
    EXPECT_TRUE(find_boundary_loops(model).empty());
    EXPECT_EQ(test::count_self_intersections(before, model.soup), 0u);
    EXPECT_TRUE(std::equal(before.points.begin(), before.points.end(), model.soup.points.begin()));
    EXPECT_LT(result.seam_after().g1_rms_deg, 1) << "the seam is far from the fragments";
  }
}

TEST(BendAside, SoIsThePatchWithoutAFlow) {
  const Patch patch = initial_patch(open_ball({}));
  ASSERT_GT(patch.free_count, 0);
  SurfaceModel model = open_ball({patch.to_mesh(patch.positions.front())});
  const TriangleSoup before = model.soup;
  FillOptions options;
  options.evolution.reset();
  options.evolution.reset();
  const HoleResult result = fill_holes(model, find_boundary_loops(model), options, nullptr, {}).at(0);
  ASSERT_TRUE(is_filled(result.status)) << result.message;
  EXPECT_EQ(result.outcome().made_by, "bent past fragments");
  EXPECT_TRUE(find_boundary_loops(model).empty());
  EXPECT_EQ(test::count_self_intersections(before, model.soup), 0u);
}

TEST(BendAside, WithoutFragmentsNothingIsTried) {
  SurfaceModel model = open_ball({Vec3(0, 0, 0.5)});
  const HoleResult result = fill_holes(model, find_boundary_loops(model), {}, nullptr, {}).at(0);
  EXPECT_EQ(result.status, PatchStatus::converged) << result.message;
  const std::vector<std::string>& attempts = result.outcome().attempts;
  EXPECT_EQ(std::count(attempts.begin(), attempts.end(), "bent past fragments"), 0);
}

}  // namespace
}  // namespace loopmend
