// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/region.h"

#include "core/error.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <set>

namespace loopmend {

namespace {

using VertexHandle = TriMesh::VertexHandle;

/// View vertices that may move: named, and not on the boundary of the surface.
std::vector<char> movable(const SurfaceModel& model, const std::vector<int>& vertices, int& held) {
  const int points = static_cast<int>(model.soup.points.size());
  std::vector<char> wanted(points, 0);
  for (int v : vertices) {
    if (v < 0 || v >= points)
      throw InvalidArgument(say("the region names vertex %1, but the vertices are 0 to %2", v, points - 1));
    wanted[v] = 1;
  }
  std::vector<char> free(model.mesh.n_vertices(), 0);
  std::set<int> at_boundary;
  for (const auto v : model.mesh.vertices()) {
    if (!wanted[model.soup_vertex[v.idx()]]) continue;
    if (model.mesh.is_boundary(v))
      at_boundary.insert(model.soup_vertex[v.idx()]);
    else
      free[v.idx()] = 1;
  }
  held = static_cast<int>(at_boundary.size());
  return free;
}

/// Rings 0, 1, ... around the free vertices; patch_rings + 1 where further away.
std::vector<int> rings_around(const TriMesh& mesh, const std::vector<char>& free, std::vector<int>& order) {
  std::vector<int> ring(mesh.n_vertices(), patch_rings + 1);
  for (std::size_t i = 0; i < free.size(); ++i)
    if (free[i]) {
      ring[i] = 0;
      order.push_back(static_cast<int>(i));
    }
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (ring[order[k]] >= patch_rings) break;
    for (const auto w : mesh.vv_range(VertexHandle(order[k])))
      if (ring[w.idx()] > patch_rings) {
        ring[w.idx()] = ring[order[k]] + 1;
        order.push_back(w.idx());
      }
  }
  return ring;
}

void check_held(const TriMesh& mesh, const std::vector<char>& free) {
  std::vector<char> seen(free.size(), 0);
  for (const auto seed : mesh.vertices()) {
    if (!free[seed.idx()] || seen[seed.idx()]) continue;
    std::vector<VertexHandle> queue{seed};
    std::set<int> fixed;
    seen[seed.idx()] = 1;
    for (std::size_t q = 0; q < queue.size(); ++q)
      for (const auto w : mesh.vv_range(queue[q])) {
        if (!free[w.idx()]) fixed.insert(w.idx());
        if (!free[w.idx()] || seen[w.idx()]) continue;
        seen[w.idx()] = 1;
        queue.push_back(w);
      }
    if (fixed.size() < 3)
      throw InvalidArgument(say("the region takes in a whole piece of the surface: nothing around it would hold it"));
  }
}

/// Closed chains of the directed edges that only one of the patch's own triangles has.
std::vector<std::vector<int>> boundaries_of(const Patch& patch) {
  std::map<std::pair<int, int>, char> open;
  for (int f = 0; f < patch.patch_triangles; ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = patch.triangles[f][k], b = patch.triangles[f][(k + 1) % 3];
      if (!open.erase({b, a})) open[{a, b}] = 1;
    }
  std::multimap<int, int> next;
  for (const auto& [edge, unused] : open) next.emplace(edge.first, edge.second);
  std::vector<std::vector<int>> boundaries;
  while (!next.empty()) {
    std::vector<int> boundary;
    for (auto at = next.begin(); at != next.end(); at = next.find(boundary.back())) {
      if (boundary.empty()) boundary.push_back(at->first);
      const int to = at->second;
      next.erase(at);
      if (to == boundary.front()) break;
      boundary.push_back(to);
    }
    boundaries.push_back(std::move(boundary));
  }
  return boundaries;
}

bool same_triangle(const Triangle& a, const Triangle& b) {
  for (int k = 0; k < 3; ++k)
    if (a[0] == b[k] && a[1] == b[(k + 1) % 3] && a[2] == b[(k + 2) % 3]) return true;
  return false;
}

/// Point of the soup that a patch vertex is; free ones by the region's list.
int soup_point(const SurfaceModel& model, const Region& region, int v) {
  return v < region.patch.free_count ? region.free_vertex[v] : model.soup_vertex[region.patch.view_vertex[v]];
}

}  // namespace

Region make_region(const SurfaceModel& model, const std::vector<int>& vertices) {
  Region region;
  Patch& patch = region.patch;
  const std::vector<char> free = movable(model, vertices, region.held_at_boundary);
  std::vector<int> order;
  const std::vector<int> ring = rings_around(model.mesh, free, order);
  patch.free_count = static_cast<int>(std::count(free.begin(), free.end(), 1));
  if (patch.free_count == 0)
    throw InvalidArgument(
        say("the region has no vertex that could move: it is empty, or lies on the surface's boundary"));
  check_held(model.mesh, free);

  Eigen::AlignedBox3d box;
  for (int v : order)
    if (ring[v] <= 1) box.extend(model.mesh.point(VertexHandle(v)));
  patch.center = box.center();
  patch.scale = box.diagonal().norm();
  std::vector<int> number(model.mesh.n_vertices(), -1);
  for (int v : order) {
    number[v] = patch.vertex_count();
    patch.positions.push_back(patch.to_frame(model.mesh.point(VertexHandle(v))));
    patch.ring.push_back(ring[v]);
    patch.view_vertex.push_back(ring[v] == 0 ? -1 : v);
    if (ring[v] == 0) region.free_vertex.push_back(model.soup_vertex[v]);
  }
  Triangles around;
  for (const auto face : model.mesh.faces()) {
    Triangle t;
    int k = 0, nearest = patch_rings + 1;
    for (const auto v : model.mesh.fv_range(face)) {
      nearest = std::min(nearest, ring[v.idx()]);
      t[k++] = number[v.idx()];
    }
    if (std::min({t[0], t[1], t[2]}) < 0) continue;
    if (nearest == 0) {
      patch.triangles.push_back(t);
      region.own_triangle.push_back(model.soup_face[face.idx()]);
    } else {
      around.push_back(t);
    }
  }
  patch.patch_triangles = static_cast<int>(patch.triangles.size());
  patch.triangles.insert(patch.triangles.end(), around.begin(), around.end());
  patch.loops = boundaries_of(patch);
  for (std::size_t k = 0; k < patch.loops.size(); ++k) patch.loop_numbers.push_back(static_cast<int>(k) + 1);
  return region;
}

TriangleSoup with_region(const SurfaceModel& model, const Region& region, const Patch& evolved) {
  const TriangleSoup& soup = model.soup;
  TriangleSoup result = soup;
  const auto place = [&](int i) { return evolved.to_mesh(evolved.positions[i]); };
  if (evolved.free_count == region.patch.free_count && evolved.patch_triangles == region.patch.patch_triangles) {
    for (int i = 0; i < evolved.free_count; ++i) result.points[region.free_vertex[i]] = place(i);
    for (int f = 0; f < evolved.patch_triangles; ++f) {
      Triangle t = evolved.triangles[f];
      for (int& v : t) v = soup_point(model, region, v);
      Triangle& old = result.triangles[region.own_triangle[f]];
      if (!same_triangle(t, old)) old = t;
    }
    return result;
  }
  std::vector<char> gone_point(soup.points.size(), 0), gone_triangle(soup.triangles.size(), 0);
  for (int v : region.free_vertex) gone_point[v] = 1;
  for (int f : region.own_triangle) gone_triangle[f] = 1;
  std::vector<int> number(soup.points.size(), -1), points, triangles;
  result = {};
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    if (gone_point[v]) continue;
    number[v] = static_cast<int>(result.points.size());
    result.points.push_back(soup.points[v]);
    points.push_back(static_cast<int>(v));
    if (!soup.colors.empty()) result.colors.push_back(soup.colors[v]);
  }
  const int first_new = static_cast<int>(result.points.size());
  for (int i = 0; i < evolved.free_count; ++i) result.points.push_back(place(i));
  if (!soup.colors.empty()) result.colors.resize(result.points.size(), Color{255, 255, 255, 255});
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    if (!gone_triangle[f]) {
      const Triangle& t = soup.triangles[f];
      result.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
      triangles.push_back(static_cast<int>(f));
    }
  copy_rows(soup, points, triangles, result);
  for (int f = 0; f < evolved.patch_triangles; ++f) {
    Triangle t = evolved.triangles[f];
    for (int& v : t) v = v < evolved.free_count ? first_new + v : number[model.soup_vertex[evolved.view_vertex[v]]];
    result.triangles.push_back(t);
  }
  return result;
}

}  // namespace loopmend
