// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/tile_outlines.h"

#include "mesh/pieces.h"
#include "mesh/point_tree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace loopmend {

namespace {

namespace bg = boost::geometry;

constexpr std::size_t most_places = 100;  ///< of an outline that are looked at
constexpr double least_distance = 0.01;   ///< to propose, in edges
constexpr double least_share = 0.05;      ///< of an outline that runs over another piece
constexpr double looks_alike = 0.7;       ///< cosine of the angle between the normals
constexpr double beside = 0.2;            ///< distance from a boundary edge, in edges
/// In barycentric coordinates: a place over a vertex of a convex surface lies beside each of the triangles there.
constexpr double edge_slack = 0.05;
constexpr int fewest_edges_of_a_tile = 8;

/// A vertex of an outline.
struct Place {
  Vec3 point, normal;
  double edge = 0;   ///< length of the boundary edge there
  double reach = 0;  ///< farthest that it lies over a triangle
  int part = 0;
  std::size_t outline = 0;
  std::optional<double> over;  ///< distance from the nearest triangle of another part, over which it lies
  int over_part = -1;          ///< of that triangle
  bool is_beside = false;      ///< a boundary edge of one
};

Vec3 normal_at(const TriMesh& mesh, TriMesh::VertexHandle v) {
  Vec3 sum = Vec3::Zero();
  for (const auto f : mesh.vf_range(v)) {
    Vec3 corner[3];
    int k = 0;
    for (const auto w : mesh.fv_range(f)) corner[k++] = mesh.point(w);
    sum += (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  }
  return sum.normalized();
}

/// Distance from a triangle that the point lies before or behind, no further from it than it reaches.
std::optional<double> distance_over(const Place& place, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = (b - a).cross(c - a);
  const double area = n.norm();
  if (!(area > 0) || n.dot(place.normal) < looks_alike * area) return std::nullopt;
  const double distance = std::abs(n.dot(place.point - a)) / area;
  if (distance > place.reach) return std::nullopt;
  const auto is_left_of = [&](const Vec3& p, const Vec3& q) {
    return (q - p).cross(place.point - p).dot(n) >= -edge_slack * area * area;
  };
  if (!is_left_of(a, b) || !is_left_of(b, c) || !is_left_of(c, a)) return std::nullopt;
  return distance;
}

/// Whether the point lies at a boundary edge, as vertices of tiles that abut do.
bool lies_beside(const Place& place, const Vec3& a, const Vec3& b) {
  const double along = std::clamp((place.point - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (a + along * (b - a) - place.point).norm() < beside * place.edge;
}

}  // namespace

OverlappingOutlines find_overlapping_outlines(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                              double distance) {
  std::vector<char> is_asked(loops.size(), 0), at_boundary(model.soup.points.size(), 0);
  for (std::size_t k = 0; k < loops.size(); ++k) {
    is_asked[k] = (loops[k].kind == LoopKind::outer_rim || loops[k].kind == LoopKind::hole) &&
                  loops[k].edges() >= fewest_edges_of_a_tile;
    for (const int v : loops[k].vertices)
      at_boundary[static_cast<std::size_t>(model.soup_vertex[static_cast<std::size_t>(v)])] = 1;
  }
  if (std::count(is_asked.begin(), is_asked.end(), 1) == 0) return {};
  int parts = 0;
  const std::vector<int> part_of = parts_of_points(model, parts);
  if (parts < 2) return {};
  std::vector<Place> places;
  double farthest = 0;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const std::vector<int>& vertices = loops[k].vertices;
    const std::size_t stride = std::max<std::size_t>(1, vertices.size() / most_places);
    for (std::size_t i = 0; is_asked[k] && i < vertices.size(); i += stride) {
      const TriMesh::VertexHandle v(vertices[i]), w(vertices[(i + 1) % vertices.size()]);
      const int point = model.soup_vertex[static_cast<std::size_t>(v.idx())];
      Place& place = places.emplace_back();
      place.point = model.mesh.point(v);
      place.normal = normal_at(model.mesh, v);
      place.edge = (model.mesh.point(w) - place.point).norm();
      place.reach = std::max(place.edge, distance);
      place.part = part_of[static_cast<std::size_t>(point)];
      place.outline = k;
      farthest = std::max(farthest, places.back().reach);
    }
  }
  std::vector<std::pair<TreePoint, int>> entries;
  for (std::size_t k = 0; k < places.size(); ++k)
    entries.emplace_back(tree_point(places[k].point), static_cast<int>(k));
  const PointTree tree(entries);
  for_each_soup_triangle(model, [&](int f) {
    const Triangle& t = model.soup.triangles[static_cast<std::size_t>(f)];
    const auto at = [](int v) { return static_cast<std::size_t>(v); };
    const Points& p = model.soup.points;
    Eigen::AlignedBox3d box(p[at(t[0])]);
    box.extend(p[at(t[1])]).extend(p[at(t[2])]);
    const Vec3 around = Vec3::Constant(farthest);
    const TreeBox query(tree_point(box.min() - around), tree_point(box.max() + around));
    for (auto it = tree.qbegin(bg::index::intersects(query)); it != tree.qend(); ++it) {
      Place& place = places[static_cast<std::size_t>(it->second)];
      if (place.is_beside || place.part == part_of[at(t[0])]) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = t[k], b = t[(k + 1) % 3];
        place.is_beside |= at_boundary[at(a)] && at_boundary[at(b)] && lies_beside(place, p[at(a)], p[at(b)]);
      }
      const std::optional<double> over = distance_over(place, p[at(t[0])], p[at(t[1])], p[at(t[2])]);
      if (over && (!place.over || *over < *place.over)) {
        place.over = over;
        place.over_part = part_of[at(t[0])];
      }
    }
  });
  std::vector<std::size_t> all(loops.size(), 0), over(loops.size(), 0);
  for (const Place& place : places) {
    ++all[place.outline];
    over[place.outline] += place.over && !place.is_beside;
  }
  OverlappingOutlines found;
  std::vector<char> is_over(loops.size(), 0);
  for (std::size_t k = 0; k < loops.size(); ++k) {
    is_over[k] = is_asked[k] && static_cast<double>(over[k]) >= least_share * static_cast<double>(all[k]);
    found.count += is_over[k] != 0;
  }
  found.is_tile.assign(static_cast<std::size_t>(parts), 0);
  for (const Place& place : places)
    if (is_over[place.outline] && place.over && !place.is_beside) {
      found.distance = std::max({found.distance, 1.5 * *place.over, least_distance * place.edge});
      for (const int part : {place.part, place.over_part}) found.is_tile[static_cast<std::size_t>(part)] = 1;
    }
  return found;
}

}  // namespace loopmend
