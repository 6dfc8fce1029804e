#include "rim/trim_rim.h"

#include "core/error.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

/// A flat grid of 9 by 9 cells with the middle 3 by 3 cells missing, and its triangle at cell (x, y), half 0 or 1.
constexpr int cells = 9;

int grid_vertex(int x, int y) { return y * (cells + 1) + x; }

TriangleSoup holed_grid() {
  TriangleSoup soup;
  for (int y = 0; y <= cells; ++y)
    for (int x = 0; x <= cells; ++x) soup.points.emplace_back(x, y, 0);
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      if (x >= 3 && x < 6 && y >= 3 && y < 6) continue;
      soup.triangles.push_back({grid_vertex(x, y), grid_vertex(x + 1, y), grid_vertex(x + 1, y + 1)});
      soup.triangles.push_back({grid_vertex(x, y), grid_vertex(x + 1, y + 1), grid_vertex(x, y + 1)});
    }
  return soup;
}

int add(TriangleSoup& soup, Triangle t) {
  soup.triangles.push_back(t);
  return static_cast<int>(soup.triangles.size()) - 1;
}

std::vector<BoundaryLoop> holes_of(const SurfaceModel& model) {
  std::vector<BoundaryLoop> holes;
  for (const BoundaryLoop& loop : find_boundary_loops(model))
    if (loop.kind == LoopKind::hole) holes.push_back(loop);
  return holes;
}

TEST(TrimRim, AGoodRimHasNoBadFaces) {
  const SurfaceModel model = make_surface_model(holed_grid());
  ASSERT_EQ(holes_of(model).size(), 1U);
  EXPECT_TRUE(bad_rim_faces(model, holes_of(model)).empty());
  EXPECT_TRUE(trim_rim(model, holes_of(model), 3).removed.empty());
}

TEST(TrimRim, RemovesWhatDanglesFaceByFaceAndRoundByRound) {
  TriangleSoup soup = holed_grid();
  const std::size_t good = soup.triangles.size();
  // Two triangles into the hole, the second standing on the first.
  soup.points.emplace_back(3.5, 3.8, 0);
  const int tip = static_cast<int>(soup.points.size()) - 1;
  soup.points.emplace_back(3.9, 4.3, 0);
  const int first = add(soup, {grid_vertex(3, 3), grid_vertex(4, 3), tip});
  const int second = add(soup, {tip, grid_vertex(4, 3), tip + 1});
  const SurfaceModel model = make_surface_model(soup);

  const auto bad = bad_rim_faces(model, holes_of(model));
  ASSERT_EQ(bad.size(), 1U);
  EXPECT_EQ(bad[0].face, second);
  EXPECT_EQ(bad[0].fault, RimFault::dangling);

  const TrimmedModel once = trim_rim(model, holes_of(model), 1);
  ASSERT_EQ(once.removed.size(), 1U);
  EXPECT_EQ(once.removed[0].face, second);
  const TrimmedModel all = trim_rim(model, holes_of(model), 5);
  ASSERT_EQ(all.removed.size(), 2U);
  EXPECT_EQ(all.removed[1].face, first);
  EXPECT_EQ(all.removed[1].ring, 2);
  EXPECT_EQ(all.model.soup.triangles,
            Triangles(soup.triangles.begin(), soup.triangles.begin() + static_cast<long>(good)));
  EXPECT_EQ(all.model.soup.points, soup.points);
  ASSERT_EQ(all.loops.size(), 1U);
  EXPECT_EQ(all.loops[0].edges(), 12);
}

TEST(TrimRim, FindsSliversSpikesAndFlippedTriangles) {
  const auto with_tip = [](const Vec3& tip) {
    // The rim triangle below the hole's edge (4,3)-(5,3) has its third corner at (5,2) or (4,2); raising the rim itself
    // would bend others, so a strip of two triangles is put onto the edge instead.
    TriangleSoup soup = holed_grid();
    soup.points.push_back(tip);
    const int v = static_cast<int>(soup.points.size()) - 1;
    add(soup, {grid_vertex(3, 3), grid_vertex(4, 3), v});
    add(soup, {v, grid_vertex(4, 3), grid_vertex(5, 3)});
    add(soup, {grid_vertex(3, 4), grid_vertex(3, 3), v});
    return soup;
  };
  const TriangleSoup flat = with_tip({3.6, 3.6, 0});
  const SurfaceModel flat_model = make_surface_model(flat);
  EXPECT_TRUE(bad_rim_faces(flat_model, holes_of(flat_model)).empty() ||
              bad_rim_faces(flat_model, holes_of(flat_model))[0].fault == RimFault::sliver);

  const SurfaceModel thin_model = make_surface_model(with_tip({4.0, 3.03, 0}));
  const auto thin = bad_rim_faces(thin_model, holes_of(thin_model));
  ASSERT_FALSE(thin.empty());
  for (const BadRimFace& bad : thin) EXPECT_EQ(bad.fault, RimFault::sliver);
}

TEST(TrimRim, RefusesWhatMakesNoSense) {
  const SurfaceModel model = make_surface_model(holed_grid());
  EXPECT_THROW(trim_rim(model, holes_of(model), -1), InvalidArgument);
  EXPECT_THROW(trim_rim(model, holes_of(model), 101), InvalidArgument);
}

}  // namespace
}  // namespace loopmend
