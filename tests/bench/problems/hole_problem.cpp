// SPDX-License-Identifier: GPL-3.0-or-later
#include "hole_problem.h"

#include "operators/topology.h"
#include "samples/analytic_surfaces.h"

#include <algorithm>

namespace loopmend::bench {

namespace {

Points boundary_points(const TriangleSoup& soup) {
  const Topology topology(static_cast<int>(soup.points.size()), soup.triangles);
  Points points;
  for (int v = 0; v < topology.vertex_count(); ++v)
    if (topology.is_boundary(v)) points.push_back(soup.points[v]);
  return points;
}

}  // namespace

double HoleProblem::diameter() const {
  double largest = 0;
  for (const BoundaryLoop& loop : loops) largest = std::max(largest, loop.diameter);
  return largest;
}

PlaceSet::PlaceSet(const Points& points) {
  for (const Vec3& p : points) places_.insert({p.x(), p.y(), p.z()});
}

HoleProblem open_problem(std::string name, TriangleSoup open, const std::function<bool(const Vec3&)>& on_cut,
                         std::function<double(const Vec3&)> distance) {
  HoleProblem problem;
  problem.name = std::move(name);
  problem.model = make_surface_model(std::move(open));
  problem.distance = std::move(distance);
  for (const BoundaryLoop& loop : find_boundary_loops(problem.model)) {
    const auto counts = [&](int v) { return on_cut(problem.model.mesh.point(TriMesh::VertexHandle(v))); };
    if (2 * std::count_if(loop.vertices.begin(), loop.vertices.end(), counts) > loop.edges())
      problem.loops.push_back(loop);
  }
  return problem;
}

HoleProblem cut_problem(std::string name, const TriangleSoup& whole, const std::function<bool(const Vec3&)>& inside,
                        std::function<double(const Vec3&)> distance) {
  const PlaceSet old(boundary_points(whole));
  TriangleSoup open = trim_boundaries(cut(whole, inside));
  const int removed = static_cast<int>(whole.points.size() - open.points.size());
  HoleProblem problem = open_problem(
      std::move(name), std::move(open), [&](const Vec3& p) { return !old.contains(p); }, std::move(distance));
  problem.removed = removed;
  return problem;
}

}  // namespace loopmend::bench
