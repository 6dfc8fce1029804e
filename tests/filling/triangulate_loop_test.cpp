// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/triangulate_loop.h"
#include "filling/sorted_triangles.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

namespace loopmend {
namespace {

/// A loop of n points with a collar of triangles around it, and the numbers of the loop in the order of its halfedges.
struct Boundary {
  Points points;
  Triangles collar;
  std::vector<int> loop;
};

/// In the wall of a cylinder. @param uneven  0: with two planes of symmetry
Boundary window(int n, double uneven, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> noise(-uneven, uneven);
  Boundary boundary;
  for (double radius : {1.0, 1.1})
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5) / n, turn = radius * std::cos(angle);
      boundary.points.emplace_back(std::cos(turn) + noise(random), std::sin(turn) + noise(random),
                                   radius * std::sin(angle) + noise(random));
    }
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    boundary.collar.push_back({i, n + i, next});
    boundary.collar.push_back({next, n + i, n + next});
  }
  boundary.loop.resize(n);
  std::iota(boundary.loop.begin(), boundary.loop.end(), 0);
  return boundary;
}

/// By CGAL's hole filling over Delaunay triangles.
Triangles triangulation_by_cgal(const Boundary& boundary) {
  using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
  const auto vertex = [](int v) { return Mesh::Vertex_index(static_cast<Mesh::size_type>(v)); };
  Mesh mesh;
  for (const Vec3& p : boundary.points) mesh.add_vertex({p.x(), p.y(), p.z()});
  for (const Triangle& t : boundary.collar) mesh.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2]));
  std::vector<Mesh::Face_index> faces;
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"  // CGAL 6 has another signature, which CGAL 5 has not
  CGAL::Polygon_mesh_processing::triangulate_hole(
      mesh, mesh.halfedge(vertex(boundary.loop[0]), vertex(boundary.loop[1])), std::back_inserter(faces),
      CGAL::parameters::use_2d_constrained_delaunay_triangulation(false)
          .use_delaunay_triangulation(true)
          .do_not_use_cubic_algorithm(true));
#pragma GCC diagnostic pop
  Triangles triangles;
  for (Mesh::Face_index f : faces) {
    Triangle& t = triangles.emplace_back();
    int k = 0;
    for (Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f))) t[k++] = static_cast<int>(v.idx());
  }
  return triangles;
}

TEST(TriangulateLoop, OverDelaunayTrianglesFindsWhatCgalFinds) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    const Boundary boundary = window(10 + 7 * static_cast<int>(seed), 0.02, seed);
    const Triangles found =
        triangulate_loop(boundary.points, boundary.collar, boundary.loop, {}, TriangulationMethod::delaunay_only);
    ASSERT_EQ(found.size(), boundary.loop.size() - 2) << "seed " << seed;
    EXPECT_EQ(sorted(found), sorted(triangulation_by_cgal(boundary))) << "seed " << seed;
  }
}

/// On symmetric loops CGAL's own answer depends on where its cells lie in memory.
TEST(TriangulateLoop, IsTheSameWhereverMemoryLies) {
  std::mt19937 random(1);
  for (int n : {60, 74, 112})
    for (auto method : {TriangulationMethod::delaunay, TriangulationMethod::delaunay_only, TriangulationMethod::planar,
                        TriangulationMethod::cubic}) {
      const Boundary boundary = window(n, 0, 0);
      std::set<Triangles> found;
      std::vector<std::unique_ptr<char[]>> blocks;
      for (int run = 0; run < 20; ++run) {
        found.insert(triangulate_loop(boundary.points, boundary.collar, boundary.loop, {}, method));
        for (int k = 0; k < 20; ++k) blocks.push_back(std::make_unique<char[]>(random() % 5000));
        std::shuffle(blocks.begin(), blocks.end(), random);
        blocks.resize(blocks.size() / 2);
      }
      EXPECT_EQ(found.size(), 1u) << n << " edges, method " << static_cast<int>(method);
      EXPECT_EQ(found.begin()->size(), static_cast<std::size_t>(n - 2));
    }
}

TEST(TriangulateLoop, FlatLoopsHaveTheirDelaunayTriangulation) {
  Boundary boundary = window(30, 0.02, 3);
  for (Vec3& p : boundary.points) p.z() = 0;
  const Triangles found =
      triangulate_loop(boundary.points, boundary.collar, boundary.loop, {}, TriangulationMethod::delaunay_only);
  ASSERT_EQ(found.size(), 28u);
  EXPECT_EQ(sorted(found), sorted(triangulation_by_cgal(boundary)));
}

}  // namespace
}  // namespace loopmend
