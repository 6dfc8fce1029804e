// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/problem_base.h"

#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace loopmend::test {
namespace {

/// A large shape has its triangles in another order than the view.
TEST(ShapeWithout, LeavesOutTheseTrianglesOfALargeScan) {
  ProblemBase base;
  base.model = make_shared_surface_model(make_icosphere(7));
  base.shape = std::make_shared<SurfaceShape>(with_reduced(shape_of(base.model->mesh, Vec3::Zero())));
  ASSERT_NE(base.shape->reduced, nullptr);
  const TriangleSoup& soup = base.model->soup;
  const auto is_cap = [](double z) { return z > 0.9; };
  std::vector<int> cap;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    if (std::any_of(soup.triangles[t].begin(), soup.triangles[t].end(),
                    [&](int v) { return is_cap(soup.points[v].z()); }))
      cap.push_back(static_cast<int>(t));
  ASSERT_GT(cap.size(), 10'000U);
  const auto rest = shape_without(base, cap);
  EXPECT_EQ(rest->triangles.size(), 3 * (soup.triangles.size() - cap.size()));
  for (int v : rest->triangles) ASSERT_FALSE(is_cap(rest->points[3 * static_cast<std::size_t>(v) + 2]));
  EXPECT_EQ(shape_without(base, {}), base.shape);
}

}  // namespace
}  // namespace loopmend::test
