// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/append_colored_patch.h"

#include "mesh/boundary_loops.h"
#include "pipeline/fill_holes.h"
#include "pipeline/hand_bridge.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace loopmend {
namespace {

using Paint = Color (*)(const Vec3&);

Color one_color(const Vec3&) { return {17, 200, 93, 40}; }
/// Harmonic in the plane, and nearly so on a shallow cap.
Color slope(const Vec3& p) {
  return {static_cast<unsigned char>(128 + 120 * p.x()), static_cast<unsigned char>(128 - 120 * p.y()), 7, 255};
}

SurfaceModel painted(TriangleSoup soup, Paint paint) {
  for (const Vec3& p : soup.points) soup.colors.push_back(paint(p));
  return make_surface_model(std::move(soup));
}

TriangleSoup open_sphere() {
  return cut(make_icosphere(5), [](const Vec3& p) { return p.z() > 0.95; });
}

/// @returns the colours of the vertices that filling adds; what was there must stay.
std::vector<Color> added_by_filling(SurfaceModel& model) {
  const std::vector<Color> before = model.soup.colors;
  const auto results = fill_holes(model, find_boundary_loops(model), {}, {}, CancelToken());
  EXPECT_TRUE(is_filled(results.front().status));
  EXPECT_EQ(model.soup.colors.size(), model.soup.points.size());
  EXPECT_TRUE(std::equal(before.begin(), before.end(), model.soup.colors.begin()));
  return {model.soup.colors.begin() + static_cast<std::ptrdiff_t>(before.size()), model.soup.colors.end()};
}

TEST(AppendColoredPatch, OneColorGoesOn) {
  SurfaceModel model = painted(open_sphere(), one_color);
  const std::vector<Color> added = added_by_filling(model);
  ASSERT_GT(added.size(), 100u);
  for (const Color& color : added) EXPECT_EQ(color, one_color({}));
}

TEST(AppendColoredPatch, ASlopeOfColorRunsOn) {
  SurfaceModel model = painted(open_sphere(), slope);
  const std::size_t old = model.soup.points.size();
  const std::vector<Color> added = added_by_filling(model);
  ASSERT_GT(added.size(), 100u);
  int worst = 0;
  for (std::size_t k = 0; k < added.size(); ++k) {
    const Color wanted = slope(model.soup.points[old + k]);
    for (std::size_t c = 0; c < 4; ++c) worst = std::max(worst, std::abs(added[k][c] - wanted[c]));
  }
  EXPECT_LE(worst, 2);
}

TEST(AppendColoredPatch, WithoutColorsThereAreNone) {
  SurfaceModel model = make_surface_model(open_sphere());
  const auto results = fill_holes(model, find_boundary_loops(model), {}, {}, CancelToken());
  EXPECT_TRUE(is_filled(results.front().status));
  EXPECT_TRUE(model.soup.colors.empty());
}

TEST(AppendColoredPatch, ABridgeRunsFromColorToColor) {
  const SurfaceModel model = painted(open_sphere(), slope);
  const std::vector<int> loop = find_boundary_loops(model).front().vertices;
  const auto soup_point = [&](std::size_t k) { return model.soup_vertex[loop[k]]; };
  const TriangleSoup soup = with_bridge(model, soup_point(0), soup_point(loop.size() / 2));
  ASSERT_GT(soup.points.size(), model.soup.points.size());
  ASSERT_EQ(soup.colors.size(), soup.points.size());
  for (std::size_t v = model.soup.points.size(); v < soup.points.size(); ++v)
    for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(soup.colors[v][c], slope(soup.points[v])[c], 12);
}

}  // namespace
}  // namespace loopmend
