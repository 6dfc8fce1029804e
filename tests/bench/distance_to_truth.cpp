// SPDX-License-Identifier: GPL-3.0-or-later
// How far patches lie from a surface that is known: fills each hole of SCAN by itself with the default settings and
// prints the distance of the new vertices to TRUTH, in units of the hole's diameter.
#include "io/read_mesh.h"
#include "pipeline/fill_holes.h"

#define CGAL_NO_DEPRECATION_WARNINGS 1  // CGAL 6, of Debian 13, has AABB_traits_3 beside AABB_traits, CGAL 5 has not
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdio>

namespace {

using namespace loopmend;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>>;

Mesh to_cgal(const TriangleSoup& soup) {
  Mesh mesh;
  for (const Vec3& p : soup.points) mesh.add_vertex({p.x(), p.y(), p.z()});
  for (const Triangle& t : soup.triangles)
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  return mesh;
}

void measure(const SurfaceModel& scan, const BoundaryLoop& loop, const Tree& truth) {
  SurfaceModel model = scan;
  const HoleResult result = fill_holes(model, {loop}, {}, nullptr, {}).front();
  double sum = 0, largest = 0;
  std::size_t count = 0;
  for (std::size_t i = scan.soup.points.size(); i < model.soup.points.size(); ++i, ++count) {
    const Vec3& p = model.soup.points[i];
    const double d = std::sqrt(truth.squared_distance({p.x(), p.y(), p.z()}));
    sum += d * d;
    largest = std::max(largest, d);
  }
  const double unit = 1000 / loop.diameter;
  std::printf("%4d  %5d  %10.4g  %6zu  %9.3f  %9.3f  %7.2f  %7.3f  %s\n", loop.number, loop.edges(), loop.diameter,
              count, unit * std::sqrt(sum / static_cast<double>(std::max<std::size_t>(count, 1))), unit * largest,
              result.outcome().bending, result.seconds, to_string(result.status));
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) {
    std::fprintf(stderr, "usage: distance_to_truth SCAN TRUTH\n");
    return 2;
  }
  const SurfaceModel scan = make_surface_model(read_mesh(argv[1]).soup);
  const Mesh truth = to_cgal(read_mesh(argv[2]).soup);
  Tree tree(faces(truth).begin(), faces(truth).end(), truth);
  tree.accelerate_distance_queries();
  std::printf(
      "distances in 1e-3 of the hole's diameter\nloop  edges    diameter     new        rms        max  bending  "
      "seconds\n");
  for (const BoundaryLoop& loop : find_boundary_loops(scan))
    if (loop.kind == LoopKind::hole) measure(scan, loop, tree);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "distance_to_truth: %s\n", error.what());
  return 1;
}
