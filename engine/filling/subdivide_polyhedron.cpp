// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/subdivide_polyhedron.h"

#include "core/error.h"
#include "filling/fair_closed_curve.h"
#include "filling/fairing.h"
#include "mesh/mesh_arrays.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <set>

namespace loopmend {

namespace {

constexpr int least_vertices = 4;
constexpr std::size_t most_triangles = 4'000'000;

/// A triangulation under refinement.
struct Subdivision {
  Points points;
  Triangles triangles;
  std::vector<BoundaryPlace> boundary_place;  ///< #points
};

void split_into_four(Subdivision& mesh) {
  struct Middle {
    int vertex;
    int faces;
  };
  std::map<std::pair<int, int>, Middle> middles;
  const auto middle = [&](int a, int b) {
    const auto [entry, added] = middles.try_emplace(std::minmax(a, b), Middle{static_cast<int>(mesh.points.size()), 0});
    if (added) mesh.points.emplace_back((mesh.points[a] + mesh.points[b]) / 2);
    ++entry->second.faces;
    return entry->second.vertex;
  };
  Triangles split;
  split.reserve(4 * mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    split.insert(split.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  mesh.triangles = std::move(split);
  for (BoundaryPlace& place : mesh.boundary_place) place.step *= 2;
  mesh.boundary_place.resize(mesh.points.size());
  for (const auto& [edge, m] : middles) {
    if (m.faces != 1) continue;
    const BoundaryPlace &a = mesh.boundary_place[edge.first], &b = mesh.boundary_place[edge.second];
    const auto [first, last] = std::minmax(a.step, b.step);
    mesh.boundary_place[m.vertex] = {a.boundary,
                                     last - first == 2 ? first + 1 : last + 1};  // or round the boundary's first corner
  }
}

/// Puts boundary vertices onto the boundaries' curves. The others follow smoothly, but for those that are fixed themselves.
void round_boundaries(Subdivision& mesh, const std::vector<Points>& boundaries, int subdivisions,
                      const std::vector<char>& fixed) {
  if (boundaries.empty()) return;
  std::vector<Points> curves;
  for (const Points& corners : boundaries) curves.push_back(fair_closed_curve(corners, 1 << subdivisions));
  Points way(mesh.points.size(), Vec3::Zero());
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    if (const BoundaryPlace& place = mesh.boundary_place[i]; place.boundary >= 0)
      way[i] = curves[place.boundary][place.step] - mesh.points[i];
  extend_evenly(mesh.triangles, fixed, way);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    if (const BoundaryPlace& place = mesh.boundary_place[i]; place.boundary >= 0)
      mesh.points[i] = curves[place.boundary][place.step];
    else if (!fixed[i])
      mesh.points[i] += way[i];
}

void check_flatness(const Points& points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) covariance += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(covariance);
  if (!(eigen.eigenvalues()[0] > 1e-12 * eigen.eigenvalues()[2]))
    throw InvalidArgument(
        say("all vertices of the polyhedron lie in one plane: there is no surface to find between them"));
}

void check_polyhedron(const SurfaceModel& polyhedron, const SubdivisionOptions& options) {
  if (options.subdivisions < 1 || options.subdivisions > 8)
    throw InvalidArgument(say("the number of subdivisions must lie between 1 and 8, not %1", options.subdivisions));
  const std::size_t count = polyhedron.mesh.n_vertices();
  if (count < least_vertices)
    throw InvalidArgument(say("the polyhedron has %1 vertices: too few for a surface, at least 4 are needed", count));
  const ModelRepairs& repairs = polyhedron.repairs;
  if (repairs.non_manifold_edges + repairs.non_manifold_vertices + repairs.degenerate_faces + repairs.duplicate_faces >
      0)
    throw InvalidArgument(
        say("the polyhedron is no simple surface: edges with more than two faces, faces that meet at a vertex alone, "
            "or faces that are double or without area. Repair it first."));
  const std::size_t faces = polyhedron.mesh.n_faces();
  if ((faces << (2 * options.subdivisions)) > most_triangles)
    throw InvalidArgument(
        say("the subdivided polyhedron would have more than 4 million triangles: fewer subdivisions do"));
  const std::vector<BoundaryLoop> boundaries = find_boundary_loops(polyhedron);
  if (options.boundary == PolyhedronBoundary::refuse && !boundaries.empty())
    throw InvalidArgument(joined(boundaries.size() == 1
                                     ? say("the polyhedron has 1 hole with %1 edges", boundaries.front().edges())
                                     : say("the polyhedron has %1 holes, the largest with %2 edges", boundaries.size(),
                                           boundaries.front().edges()),
                                 ": ", say("close it, or let its boundary loops become smooth curves (--open)")));
}

/// Which view vertices are interpolated.
std::vector<char> fixed_vertices(const SurfaceModel& polyhedron, const SubdivisionOptions& options) {
  std::vector<char> fixed(polyhedron.mesh.n_vertices(), options.fixed.empty());
  const std::set<int> wanted(options.fixed.begin(), options.fixed.end());
  for (int v : wanted)
    if (v < 0 || v >= static_cast<int>(polyhedron.soup.points.size()))
      throw InvalidArgument(
          say("vertex %1 is to be fixed, but the vertices are 0 to %2", v, polyhedron.soup.points.size() - 1));
  std::size_t count = 0;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (wanted.count(polyhedron.soup_vertex[i])) fixed[i] = 1;
    count += fixed[i] != 0;
  }
  if (count < least_vertices)
    throw InvalidArgument(say("%1 fixed vertices are too few for a surface: at least 4 are needed", count));
  return fixed;
}

void hold_boundaries(const Subdivision& mesh, std::vector<char>& fixed) {
  fixed.resize(mesh.points.size(), 0);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    if (mesh.boundary_place[i].boundary >= 0) fixed[i] = 1;
}

/// Free vertices first, then the fixed ones, each in their order. @param frame  its centre and scale count.
PolyhedronPatch numbered(const Patch& frame, const Subdivision& mesh, const std::vector<char>& fixed,
                         int view_vertices) {
  PolyhedronPatch result;
  Patch& patch = result.patch;
  patch.center = frame.center;
  patch.scale = frame.scale;
  std::vector<int> number(mesh.points.size(), -1);
  const auto add = [&](std::size_t i, int ring) {
    number[i] = patch.vertex_count();
    patch.positions.push_back(patch.to_frame(mesh.points[i]));
    patch.ring.push_back(ring);
    patch.view_vertex.push_back(ring > 0 && static_cast<int>(i) < view_vertices ? static_cast<int>(i) : -1);
    if (ring == 0) return;
    result.fixed.push_back(mesh.points[i]);
    result.boundary_place.push_back(mesh.boundary_place[i]);
  };
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    if (!fixed[i]) add(i, 0);
  patch.free_count = patch.vertex_count();
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    if (fixed[i]) add(i, 1);
  for (const Triangle& t : mesh.triangles) patch.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  patch.patch_triangles = static_cast<int>(patch.triangles.size());
  return result;
}

}  // namespace

PolyhedronPatch subdivide_polyhedron(const SurfaceModel& polyhedron, const SubdivisionOptions& options) {
  check_polyhedron(polyhedron, options);
  check_flatness(points_of(polyhedron.mesh));
  std::vector<char> fixed = fixed_vertices(polyhedron, options);
  Subdivision mesh{points_of(polyhedron.mesh), triangles_of(polyhedron.mesh), {}};
  mesh.boundary_place.resize(mesh.points.size());
  std::vector<Points> boundaries;
  for (const BoundaryLoop& loop : find_boundary_loops(polyhedron)) {
    Points corners;
    for (int v : loop.vertices) {
      mesh.boundary_place[v] = {static_cast<int>(boundaries.size()), static_cast<int>(corners.size())};
      corners.push_back(mesh.points[v]);
    }
    boundaries.push_back(std::move(corners));
  }
  for (int k = 0; k < options.subdivisions; ++k) split_into_four(mesh);
  hold_boundaries(mesh, fixed);
  round_boundaries(mesh, boundaries, options.subdivisions, fixed);

  Eigen::AlignedBox3d box;
  for (const Vec3& p : mesh.points) box.extend(p);
  Patch frame;
  frame.center = box.center();
  frame.scale = box.diagonal().norm();
  PolyhedronPatch result = numbered(frame, mesh, fixed, static_cast<int>(polyhedron.mesh.n_vertices()));
  result.boundaries = std::move(boundaries);
  result.subdivisions = options.subdivisions;
  return result;
}

PolyhedronPatch split_further(const PolyhedronPatch& start, const Patch& evolved) {
  // The fixed vertices first, as polyhedron_surface has them, so that they keep their order.
  TriangleSoup surface = polyhedron_surface(start, evolved);
  Subdivision mesh{std::move(surface.points), std::move(surface.triangles), start.boundary_place};
  mesh.boundary_place.resize(mesh.points.size());
  std::vector<char> fixed(start.fixed.size(), 1);
  split_into_four(mesh);
  hold_boundaries(mesh, fixed);
  round_boundaries(mesh, start.boundaries, start.subdivisions + 1, fixed);
  PolyhedronPatch result = numbered(evolved, mesh, fixed, static_cast<int>(start.fixed.size()));
  result.boundaries = start.boundaries;
  result.subdivisions = start.subdivisions + 1;
  return result;
}

TriangleSoup polyhedron_surface(const PolyhedronPatch& start, const Patch& evolved) {
  TriangleSoup soup;
  soup.points = start.fixed;
  const int shift = static_cast<int>(start.fixed.size());
  for (int i = 0; i < evolved.free_count; ++i) soup.points.push_back(evolved.to_mesh(evolved.positions[i]));
  for (int f = 0; f < evolved.patch_triangles; ++f) {
    Triangle t = evolved.triangles[f];
    for (int& v : t) v = v < evolved.free_count ? v + shift : v - evolved.free_count;
    soup.triangles.push_back(t);
  }
  return soup;
}

}  // namespace loopmend
