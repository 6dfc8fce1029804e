// SPDX-License-Identifier: GPL-3.0-or-later
// What a scan is filled with does not depend on how its file numbers vertices and faces.
#include "mesh/by_position.h"
#include "pipeline/fill_holes.h"
#include "support/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace loopmend {
namespace {

/// The same surface under other numbers: each point's new number, and the soup.
struct Renumbered {
  std::vector<int> number;
  TriangleSoup soup;
};

Renumbered renumbered(const TriangleSoup& soup, unsigned seed) {
  std::mt19937 random(seed);
  Renumbered result;
  result.number.resize(soup.points.size());
  std::iota(result.number.begin(), result.number.end(), 0);
  std::shuffle(result.number.begin(), result.number.end(), random);
  result.soup.points.resize(soup.points.size());
  for (std::size_t v = 0; v < soup.points.size(); ++v) result.soup.points[result.number[v]] = soup.points[v];
  for (Triangle t : soup.triangles) {
    for (int& v : t) v = result.number[v];
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    result.soup.triangles.push_back(t);
  }
  std::shuffle(result.soup.triangles.begin(), result.soup.triangles.end(), random);
  return result;
}

/// A rough sphere with a large hole, two that lie near each other, and two that touch.
TriangleSoup rough_with_holes() {
  const TriangleSoup soup = roughen(make_icosphere(3), 0.2, 0.25, 11, test::onto_sphere);
  const auto is_near = [&](const Triangle& t, const Vec3& direction, double cosine) {
    const Vec3 middle = soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]];
    return middle.normalized().dot(direction.normalized()) > cosine;
  };
  TriangleSoup open = soup;
  std::erase_if(open.triangles, [&](const Triangle& t) {
    const bool touching = std::count(t.begin(), t.end(), 100) + std::count(t.begin(), t.end(), 101) > 0;
    return is_near(t, {0, 0, 1}, 0.85) || is_near(t, {1, 0, -0.3}, 0.97) || is_near(t, {1, 0.6, -0.3}, 0.97) ||
           touching;
  });
  return open;
}

TEST(Numbering, DoesNotMatterToLoops) {
  const TriangleSoup soup = rough_with_holes();
  const SurfaceModel model = make_surface_model(soup);
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  ASSERT_GE(loops.size(), 4u);
  for (const BoundaryLoop& loop : loops)
    for (int v : loop.vertices)
      EXPECT_FALSE(precedes(model.mesh.point(TriMesh::VertexHandle(v)),
                            model.mesh.point(TriMesh::VertexHandle(loop.vertices.front()))));
  const Renumbered other = renumbered(soup, 5);
  const SurfaceModel other_model = make_surface_model(other.soup);
  const std::vector<BoundaryLoop> other_loops = find_boundary_loops(other_model);
  ASSERT_EQ(other_loops.size(), loops.size());
  for (std::size_t l = 0; l < loops.size(); ++l) {
    EXPECT_EQ(other_loops[l].perimeter, loops[l].perimeter);
    EXPECT_EQ(other_loops[l].turning, loops[l].turning);
    EXPECT_EQ(other_loops[l].joined, loops[l].joined);
    ASSERT_EQ(other_loops[l].edges(), loops[l].edges());
    for (int i = 0; i < loops[l].edges(); ++i)
      EXPECT_EQ(other_model.soup_vertex[other_loops[l].vertices[i]],
                other.number[model.soup_vertex[loops[l].vertices[i]]]);
  }
}

TEST(Numbering, DoesNotMatterToPatches) {
  const TriangleSoup soup = rough_with_holes();
  const std::size_t points = soup.points.size(), triangles = soup.triangles.size();
  SurfaceModel model = make_surface_model(soup);
  const auto results = fill_all_holes(model, {}, {});
  EXPECT_TRUE(find_boundary_loops(model).empty());
  for (unsigned seed : {5u, 6u}) {
    const Renumbered other = renumbered(soup, seed);
    SurfaceModel other_model = make_surface_model(other.soup);
    const auto other_results = fill_all_holes(other_model, {}, {});
    ASSERT_EQ(other_results.size(), results.size());
    for (std::size_t k = 0; k < results.size(); ++k) EXPECT_EQ(other_results[k].status, results[k].status);
    ASSERT_EQ(other_model.soup.points.size(), model.soup.points.size());
    for (std::size_t v = points; v < model.soup.points.size(); ++v)
      EXPECT_EQ(other_model.soup.points[v], model.soup.points[v]) << v;
    ASSERT_EQ(other_model.soup.triangles.size(), model.soup.triangles.size());
    for (std::size_t f = triangles; f < model.soup.triangles.size(); ++f) {
      Triangle t = model.soup.triangles[f];
      for (int& v : t) v = v < static_cast<int>(points) ? other.number[v] : v;
      EXPECT_EQ(other_model.soup.triangles[f], t);
    }
  }
}

}  // namespace
}  // namespace loopmend
