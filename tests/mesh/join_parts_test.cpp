// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/join_parts.h"

#include "core/error.h"
#include "support/tubes.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

TEST(JoinParts, KeepsOrderAndNumbersLoopsPerPart) {
  const TriangleSoup a = make_tube({{0, 0, 1}, {0, 0, 1}, 1, 2, 24}),
                     b = make_tube({{0, 0, -1}, {0, 0, -1}, 0.5, 2, 16});
  const JoinedParts joined_parts = join_parts({a, b});
  EXPECT_EQ(joined_parts.first_point,
            (std::vector<std::size_t>{0, a.points.size(), a.points.size() + b.points.size()}));
  ASSERT_EQ(joined_parts.loops.size(), 2u);
  for (const auto& loops : joined_parts.loops) EXPECT_EQ(loops.size(), 2u);
  EXPECT_EQ(joined_parts.loops[0][0].edges(), 24);
  EXPECT_EQ(joined_parts.loops[1][1].edges(), 16);
  for (std::size_t i = 0; i < b.points.size(); ++i)
    EXPECT_EQ(joined_parts.model.soup.points[a.points.size() + i], b.points[i]);
}

TEST(JoinParts, RefusesPartsThatOverlap) {
  const TriangleSoup a = make_tube({{0, 0, 0}, {0, 0, 1}, 1, 2, 24}), b = make_tube({{0, 0, 1}, {1, 0, 0}, 0.5, 2, 16});
  EXPECT_THROW(join_parts({a, b}), InvalidArgument);
  EXPECT_NO_THROW(join_parts({a, make_tube({{3, 0, 1}, {1, 0, 0}, 0.5, 2, 16})}));
}

TEST(TurnOpposedPieces, TurnsThePieceAndFindsItsLoopsAgain) {
  const std::vector<TubeShape> tubes{test::tube_towards({0, 0, 1}), test::tube_towards({0, 0, -1})};
  SurfaceModel model = test::tubes_model(tubes);
  std::vector<BoundaryLoop> loops = test::inner_boundaries(model, tubes);
  const std::vector<BoundaryLoop> before = loops;
  EXPECT_EQ(turn_opposed_pieces(model, loops, {}), 0u);
  EXPECT_EQ(turn_opposed_pieces(model, loops, {1}), model.soup.triangles.size() / 2);
  EXPECT_EQ(loops[0].vertices, before[0].vertices);
  EXPECT_NEAR((loops[1].center - before[1].center).norm(), 0, 1e-12);
  std::vector<int> reversed(before[1].vertices.rbegin(), before[1].vertices.rend());
  EXPECT_TRUE(std::is_permutation(reversed.begin(), reversed.end(), loops[1].vertices.begin()));
}

TEST(TurnOpposedPieces, RefusesAPieceThatWouldHaveToBeBoth) {
  const std::vector<TubeShape> tubes{test::tube_towards({0, 0, 1})};
  SurfaceModel model = test::tubes_model(tubes);
  std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  EXPECT_THROW(turn_opposed_pieces(model, loops, {1}), InvalidArgument);
}

}  // namespace
}  // namespace loopmend
