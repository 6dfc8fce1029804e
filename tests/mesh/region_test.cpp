// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/region.h"

#include "core/error.h"
#include "samples/analytic_surfaces.h"
#include "samples/paper_inputs.h"

#include <gtest/gtest.h>

#include <numeric>

namespace loopmend {
namespace {

std::vector<int> above(const TriangleSoup& soup, double z) {
  std::vector<int> points;
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    if (soup.points[i].z() > z) points.push_back(static_cast<int>(i));
  return points;
}

TEST(Region, OfTheBumpsHasThePapersSizeAndFourBoundaries) {
  const SurfaceModel model = make_surface_model(make_bumps());
  const Region region = make_region(model, above(model.soup, bumps_threshold));
  EXPECT_EQ(region.patch.free_count, 840);  // Table 5.1: 2520 unknowns / 3
  EXPECT_EQ(region.patch.loops.size(), 4u);
  for (int v = 0; v < region.patch.vertex_count(); ++v) {
    EXPECT_EQ(region.patch.ring[v] == 0, v < region.patch.free_count);
    if (v > 0) {
      EXPECT_LE(region.patch.ring[v - 1], region.patch.ring[v]);
    }
  }
  for (const auto& loop : region.patch.loops)
    for (int v : loop) EXPECT_EQ(region.patch.ring[v], 1);
}

TEST(Region, ComesBackAsItWasWhenNothingMoved) {
  const SurfaceModel model = make_surface_model(make_icosphere(3));
  const Region region = make_region(model, above(model.soup, 0.5));
  const TriangleSoup same = with_region(model, region, region.patch);
  EXPECT_EQ(same.triangles, model.soup.triangles);
  for (std::size_t i = 0; i < same.points.size(); ++i) EXPECT_LT((same.points[i] - model.soup.points[i]).norm(), 1e-15);
  for (std::size_t i = 0; i < same.points.size(); ++i)
    if (model.soup.points[i].z() <= 0.5) {
      EXPECT_EQ(same.points[i], model.soup.points[i]);
    }
}

TEST(Region, KeepsTheRestWhenRemeshed) {
  const SurfaceModel model = make_surface_model(make_icosphere(3));
  const Region region = make_region(model, above(model.soup, 0.5));
  Patch fewer = region.patch;  // the last free vertex and its triangles are gone
  const int last = fewer.free_count - 1;
  Triangles kept;
  for (int f = 0; f < fewer.patch_triangles; ++f) {
    const Triangle& t = fewer.triangles[f];
    if (t[0] != last && t[1] != last && t[2] != last) kept.push_back(t);
  }
  fewer.patch_triangles = static_cast<int>(kept.size());
  fewer.triangles = kept;
  const TriangleSoup result = with_region(model, region, fewer);
  EXPECT_EQ(result.points.size(), model.soup.points.size());
  EXPECT_LT(result.triangles.size(), model.soup.triangles.size());
  for (const Triangle& t : result.triangles)
    for (int v : t) EXPECT_LT(v, static_cast<int>(result.points.size()));
}

TEST(Region, VerticesOnTheSurfacesOwnBoundaryStay) {
  const SurfaceModel model = make_surface_model(make_graph([](double, double) { return 0.0; }, 1, 10));
  const Region region = make_region(model, {0, 12, 13, 24});
  EXPECT_EQ(region.held_at_boundary, 1);
  EXPECT_EQ(region.patch.free_count, 3);
}

TEST(Region, RefusesWhatCannotEvolve) {
  const SurfaceModel model = make_surface_model(make_icosphere(1));
  std::vector<int> all(model.soup.points.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_THROW(make_region(model, all), InvalidArgument);
  EXPECT_THROW(make_region(model, {}), InvalidArgument);
  EXPECT_THROW(make_region(model, {-1}), InvalidArgument);
  EXPECT_THROW(make_region(model, {42}), InvalidArgument);
}

}  // namespace
}  // namespace loopmend
