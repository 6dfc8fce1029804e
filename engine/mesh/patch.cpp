// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/patch.h"

#include "core/error.h"
#include "mesh/by_position.h"
#include "mesh/point_diameter.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <unordered_map>

namespace loopmend {

namespace {

using VertexHandle = TriMesh::VertexHandle;

/// The fixed vertices in rings around the loops: those on the loops as these run, those of each other ring by their positions, so
/// that the patch does not depend on how the file numbers them.
struct Neighborhood {
  std::vector<int> view_vertex;
  std::vector<int> ring;
  std::unordered_map<int, int> index;  // view vertex → place in the two vectors
};

void sort_rings(const TriMesh& mesh, Neighborhood& around) {
  const auto first = std::find_if(around.ring.begin(), around.ring.end(), [](int ring) { return ring > 1; });
  std::vector<std::pair<int, int>> others;  // ring, vertex
  for (auto k = first - around.ring.begin(); k < static_cast<long>(around.ring.size()); ++k)
    others.emplace_back(around.ring[k], around.view_vertex[k]);
  std::sort(others.begin(), others.end(), [&](const auto& a, const auto& b) {
    const Vec3 &p = mesh.point(VertexHandle(a.second)), &q = mesh.point(VertexHandle(b.second));
    if (a.first != b.first) return a.first < b.first;
    return p != q ? precedes(p, q) : a.second < b.second;
  });
  auto place = first - around.ring.begin();
  for (const auto& [ring, v] : others) {
    around.ring[place] = ring;
    around.view_vertex[place] = v;
    around.index[v] = static_cast<int>(place++);
  }
}

Neighborhood collect_rings(const TriMesh& mesh, const std::vector<BoundaryLoop>& loops, int rings) {
  Neighborhood s;
  const auto add = [&](int v, int ring) {
    if (!s.index.emplace(v, static_cast<int>(s.view_vertex.size())).second) return;
    s.view_vertex.push_back(v);
    s.ring.push_back(ring);
  };
  for (const BoundaryLoop& loop : loops)
    for (int v : loop.vertices) add(v, 1);
  for (std::size_t k = 0; k < s.view_vertex.size(); ++k) {
    if (s.ring[k] >= rings) break;
    for (const auto next : mesh.vv_range(VertexHandle(s.view_vertex[k]))) add(next.idx(), s.ring[k] + 1);
  }
  sort_rings(mesh, s);
  return s;
}

/// The triangles among the neighborhood's vertices, over their places, each from its least corner on, in ascending order.
Triangles collect_triangles(const TriMesh& mesh, const Neighborhood& around) {
  std::vector<int> faces;
  for (int v : around.view_vertex)
    for (const auto face : mesh.vf_range(VertexHandle(v))) faces.push_back(face.idx());
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  Triangles triangles;
  for (int f : faces) {
    Triangle t;
    int k = 0;
    for (const auto v : mesh.fv_range(TriMesh::FaceHandle(f))) {
      const auto found = around.index.find(v.idx());
      if (found != around.index.end()) t[k++] = found->second;
    }
    if (k < 3) continue;
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    triangles.push_back(t);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

void check_sizes(const std::vector<BoundaryLoop>& loops, const std::vector<LoopPatch>& initial_patches) {
  if (loops.size() != initial_patches.size() || loops.empty())
    throw InvalidArgument(say("a patch needs one initial patch for each loop, and at least one loop"));
  for (std::size_t k = 0; k < loops.size(); ++k)
    if (initial_patches[k].points.size() < loops[k].vertices.size())
      throw InvalidArgument(say("an initial patch has fewer points than its loop"));
}

}  // namespace

Patch make_patch(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                 const std::vector<LoopPatch>& initial_patches) {
  return make_narrow_patch(model, loops, initial_patches, patch_rings);
}

Patch make_narrow_patch(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                        const std::vector<LoopPatch>& initial_patches, int rings) {
  check_sizes(loops, initial_patches);
  Patch patch;
  Eigen::AlignedBox3d box;
  for (const BoundaryLoop& loop : loops)
    for (int v : loop.vertices) box.extend(model.mesh.point(VertexHandle(v)));
  patch.center = box.center();
  patch.scale = box.diagonal().norm();
  if (!(patch.scale > 0)) throw InvalidArgument(say("a loop has no extent: all its vertices are in one place"));

  for (std::size_t k = 0; k < loops.size(); ++k)
    patch.free_count += static_cast<int>(initial_patches[k].points.size() - loops[k].vertices.size());
  const Neighborhood around = collect_rings(model.mesh, loops, rings);

  int next_free = 0;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const int boundary = loops[k].edges();
    std::vector<int> number(initial_patches[k].points.size());
    for (int i = 0; i < boundary; ++i) number[i] = patch.free_count + around.index.at(loops[k].vertices[i]);
    for (std::size_t i = boundary; i < number.size(); ++i) {
      number[i] = next_free++;
      patch.positions.push_back(patch.to_frame(initial_patches[k].points[i]));
    }
    for (const Triangle& t : initial_patches[k].triangles)
      patch.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
    patch.loops.emplace_back(number.begin(), number.begin() + boundary);
    patch.loop_numbers.push_back(loops[k].number);
  }
  patch.patch_triangles = static_cast<int>(patch.triangles.size());

  patch.ring.assign(patch.free_count, 0);
  patch.view_vertex.assign(patch.free_count, -1);
  for (std::size_t i = 0; i < around.view_vertex.size(); ++i) {
    patch.ring.push_back(around.ring[i]);
    patch.view_vertex.push_back(around.view_vertex[i]);
    patch.positions.push_back(patch.to_frame(model.mesh.point(VertexHandle(around.view_vertex[i]))));
  }
  for (const Triangle& t : collect_triangles(model.mesh, around))
    patch.triangles.push_back({t[0] + patch.free_count, t[1] + patch.free_count, t[2] + patch.free_count});
  return patch;
}

double loop_diameter(const Patch& patch, std::size_t loop) {
  Points boundary;
  for (int v : patch.loops[loop]) boundary.push_back(patch.positions[v]);
  return diameter_of(boundary);
}

PatchGeometry patch_geometry(const Patch& patch) {
  PatchGeometry geometry;
  int boundary = 0;
  while (patch.free_count + boundary < patch.vertex_count() && patch.ring[patch.free_count + boundary] == 1) ++boundary;
  geometry.boundary.assign(patch.view_vertex.begin() + patch.free_count,
                           patch.view_vertex.begin() + patch.free_count + boundary);
  for (int i = 0; i < patch.free_count; ++i) geometry.points.push_back(patch.to_mesh(patch.positions[i]));
  for (int f = 0; f < patch.patch_triangles; ++f) {
    Triangle t = patch.triangles[f];
    for (int& v : t) v = v < patch.free_count ? v + boundary : v - patch.free_count;
    geometry.triangles.push_back(t);
  }
  return geometry;
}

}  // namespace loopmend
