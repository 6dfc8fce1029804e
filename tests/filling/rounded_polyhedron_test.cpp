// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/rounded_polyhedron.h"

#include "mesh/validity.h"
#include "samples/analytic_surfaces.h"
#include "samples/paper_inputs.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace loopmend {
namespace {

TEST(RoundedPolyhedron, VerticesOnASphereGiveTheSphereWithoutFolds) {
  const PolyhedronPatch flat = subdivide_polyhedron(make_surface_model(make_dodecahedron()), {});
  const std::optional<Patch> round = rounded_polyhedron(flat);
  ASSERT_TRUE(round);
  EXPECT_EQ(patch_validity(*round).folds, 0);
  for (const Vec3& p : round->positions) EXPECT_NEAR(round->to_mesh(p).norm(), 1, 1e-12);
}

TEST(RoundedPolyhedron, GoesThroughVerticesOffTheSphere) {
  TriangleSoup ball = make_icosphere(0);
  ball.points[3] *= 1.3;
  const PolyhedronPatch flat = subdivide_polyhedron(make_surface_model(ball), {});
  const std::optional<Patch> round = rounded_polyhedron(flat);
  ASSERT_TRUE(round);
  EXPECT_EQ(patch_validity(*round).folds, 0);
  for (int i = round->free_count; i < round->vertex_count(); ++i)
    EXPECT_EQ(round->positions[i], flat.patch.positions[i]);
  // The free vertices around the one that sticks out follow it.
  double farthest = 0;
  for (int i = 0; i < round->free_count; ++i) farthest = std::max(farthest, round->to_mesh(round->positions[i]).norm());
  EXPECT_GT(farthest, 1.1);
}

}  // namespace
}  // namespace loopmend
