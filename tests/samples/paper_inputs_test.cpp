// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/paper_inputs.h"

#include "mesh/boundary_loops.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

std::size_t loops_of(const TriangleSoup& soup) { return find_boundary_loops(make_surface_model(soup)).size(); }

TEST(PaperInputs, HaveTheLoopsOfThePapersPictures) {
  EXPECT_EQ(loops_of(make_pierced_cylinder()), 5u);  // three parts missing, two ends
  EXPECT_EQ(loops_of(make_sphere_wireframe()), 8u);
  EXPECT_EQ(loops_of(make_holed_head()), 3u);
  EXPECT_EQ(loops_of(make_dodecahedron()), 0u);
}

TEST(PaperInputs, ATubeLiesWhereItWasAskedFor) {
  const TubeShape shape{{1, 2, 3}, Vec3(1, 1, 0).normalized(), 0.5, 2, 20};
  const TriangleSoup tube = make_tube(shape);
  double low = 1e9, high = -1e9;
  for (const Vec3& p : tube.points) {
    const double along = (p - shape.start).dot(shape.direction);
    EXPECT_NEAR((p - shape.start - along * shape.direction).norm(), 0.5, 1e-12);
    low = std::min(low, along);
    high = std::max(high, along);
  }
  EXPECT_NEAR(low, 0, 1e-12);
  EXPECT_NEAR(high, 2, 1e-12);
}

TEST(PaperInputs, TheBumpsStandAtTheQuarters) {
  EXPECT_NEAR(bumps_height(0.5, 0.5), 1, 0.02);
  EXPECT_NEAR(bumps_height(-0.5, 0.5), 1, 0.02);
  EXPECT_LT(bumps_height(0, 0), 0.35);
}

}  // namespace
}  // namespace loopmend
