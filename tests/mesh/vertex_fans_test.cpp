// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/vertex_fans.h"

#include "mesh/boundary_loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loopmend {
namespace {

constexpr double pi = std::numbers::pi;

/// From one angle to another about the z axis, in steps of at most 45 degrees.
FanLink fan(double from, double to, double height = 0) {
  FanLink link;
  const int steps = static_cast<int>(std::ceil((to - from) / (pi / 4) - 1e-9));
  for (int k = 0; k <= steps; ++k) {
    const double angle = from + (to - from) * k / steps;
    link.emplace_back(std::cos(angle), std::sin(angle), height);
  }
  return link;
}

TEST(ArrangeFans, OrdersThemAboutTheirNormalAndMeasuresTheGaps) {
  const auto arrangement =
      arrange_fans(Vec3::Zero(), {fan(pi, 1.25 * pi), fan(-0.25 * pi, 0.25 * pi), fan(0.5 * pi, 0.75 * pi)});
  ASSERT_TRUE(arrangement);
  // From the fan that begins first, seen from any direction in the plane: compare cyclically.
  const auto first = std::find(arrangement->order.begin(), arrangement->order.end(), 1) - arrangement->order.begin();
  const std::vector<int> order{1, 2, 0};
  const std::vector<double> gap{0.25 * pi, 0.25 * pi, 0.5 * pi};
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(arrangement->order[(first + k) % 3], order[k]);
    EXPECT_NEAR(arrangement->gap[(first + k) % 3], gap[k], 1e-12);
  }
}

TEST(ArrangeFans, RefusesFansThatOverlapOrFaceAway) {
  EXPECT_FALSE(arrange_fans(Vec3::Zero(), {fan(0, pi), fan(0.9 * pi, 1.5 * pi, 0.1)}));
  FanLink turned = fan(pi, 1.5 * pi);
  std::reverse(turned.begin(), turned.end());
  EXPECT_FALSE(arrange_fans(Vec3::Zero(), {fan(0, 0.5 * pi), turned}));
}

TEST(GapAngle, IsWhatTheFacesLeaveOfATurn) {
  TriangleSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  soup.triangles = {{0, 1, 2}, {0, 3, 4}};  // opposite quarters
  const SurfaceModel model = make_surface_model(soup);
  ASSERT_EQ(model.mesh.n_vertices(), 5u);
  const TriMesh::VertexHandle middle(0);
  EXPECT_EQ(fan_count(model.mesh, middle), 2);
  int gaps = 0;
  for (const auto in : model.mesh.vih_range(middle)) {
    if (!model.mesh.is_boundary(in)) continue;
    EXPECT_NEAR(gap_angle(model.mesh, in), pi / 2, 1e-12);
    ++gaps;
  }
  EXPECT_EQ(gaps, 2);
  soup.triangles = {{0, 1, 2}};
  const SurfaceModel one = make_surface_model(soup);
  for (const auto in : one.mesh.vih_range(middle)) {
    if (!one.mesh.is_boundary(in)) continue;
    EXPECT_NEAR(gap_angle(one.mesh, in), 1.5 * pi, 1e-12);
  }
}

}  // namespace
}  // namespace loopmend
