#include "hole_problem.h"

#include "operators/topology.h"
#include "samples/analytic_surfaces.h"

#include <algorithm>
#include <array>
#include <set>

namespace loopmend::bench {

namespace {

using Place = std::array<double, 3>;

Place place(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

std::set<Place> boundary_places(const TriangleSoup& soup) {
  const Topology topology(static_cast<int>(soup.points.size()), soup.triangles);
  std::set<Place> places;
  for (int v = 0; v < topology.vertex_count(); ++v)
    if (topology.is_boundary(v)) places.insert(place(soup.points[v]));
  return places;
}

}  // namespace

double HoleProblem::diameter() const {
  double largest = 0;
  for (const BoundaryLoop& loop : loops) largest = std::max(largest, loop.diameter);
  return largest;
}

HoleProblem open_problem(std::string name, const TriangleSoup& whole, TriangleSoup open,
                         std::function<double(const Vec3&)> distance) {
  HoleProblem problem;
  problem.name = std::move(name);
  problem.removed = static_cast<int>(whole.points.size() - open.points.size());
  problem.model = make_surface_model(std::move(open));
  problem.distance = std::move(distance);
  const std::set<Place> old = boundary_places(whole);
  for (const BoundaryLoop& loop : find_boundary_loops(problem.model)) {
    const auto was_there = [&](int v) {
      return old.contains(place(problem.model.mesh.point(TriMesh::VertexHandle(v))));
    };
    if (2 * std::count_if(loop.vertices.begin(), loop.vertices.end(), was_there) <= loop.edges())
      problem.loops.push_back(loop);
  }
  return problem;
}

HoleProblem cut_problem(std::string name, const TriangleSoup& whole, const std::function<bool(const Vec3&)>& inside,
                        std::function<double(const Vec3&)> distance) {
  return open_problem(std::move(name), whole, trim_rims(cut(whole, inside)), std::move(distance));
}

}  // namespace loopmend::bench
