// SPDX-License-Identifier: GPL-3.0-or-later
#include "rim/trim_rim.h"

#include "core/error.h"
#include "mesh/mesh_arrays.h"
#include "mesh/quality.h"
#include "mesh/self_intersections.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>

namespace loopmend {

namespace {

constexpr double sliver_angle = 5 * std::numbers::pi / 180;
constexpr double spike_cosine = 0.5, flipped_cosine = -0.5;
/// What crosses is followed inward further than what is merely bad: no patch is valid beside it.
constexpr int rounds_for_crossings = 10;

Vec3 normal_of(const SurfaceModel& model, int view_face) {
  const auto& [a, b, c] = model.soup.triangles[model.soup_face[view_face]];
  return unit_normal(model.soup.points[a], model.soup.points[b], model.soup.points[c]);
}

std::optional<RimFault> fault_of(const SurfaceModel& model, int view_face) {
  const auto& [a, b, c] = model.soup.triangles[model.soup_face[view_face]];
  const Points& p = model.soup.points;
  std::vector<Vec3> beside;
  for (const auto f : model.mesh.ff_range(TriMesh::FaceHandle(view_face))) beside.push_back(normal_of(model, f.idx()));
  if (beside.size() <= 1) return RimFault::dangling;
  if (min_angle(p[a], p[b], p[c]) < sliver_angle) return RimFault::sliver;
  // Where the neighbours disagree among themselves, it is the surface that folds there, not the triangle.
  const Vec3 own = normal_of(model, view_face);
  const bool turned =
      std::any_of(beside.begin(), beside.end(), [&](const Vec3& n) { return own.dot(n) < flipped_cosine; });
  if (turned && beside[0].dot(beside[1]) > spike_cosine) return RimFault::flipped;
  return std::nullopt;
}

/// The triangles at a rim vertex that stands up out of what lies round about; else none.
std::vector<int> spike_at(const SurfaceModel& model, int view_vertex) {
  std::vector<int> fan;
  std::set<int> around;
  for (const auto f : model.mesh.vf_range(TriMesh::VertexHandle(view_vertex))) fan.push_back(f.idx());
  for (int f : fan)
    for (const auto v : model.mesh.fv_range(TriMesh::FaceHandle(f)))
      if (v.idx() != view_vertex)
        for (const auto g : model.mesh.vf_range(v)) around.insert(g.idx());
  for (int f : fan) around.erase(f);
  if (around.empty()) return {};
  Vec3 ground = Vec3::Zero();
  for (int f : around) ground += normal_of(model, f);
  ground.normalize();
  const bool stands =
      std::all_of(fan.begin(), fan.end(), [&](int f) { return normal_of(model, f).dot(ground) < spike_cosine; });
  return stands ? fan : std::vector<int>{};
}

/// View faces with an edge on one of the loops that are holes.
std::set<int> rim_faces(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::set<int> faces;
  for (const BoundaryLoop& loop : loops) {
    if (loop.kind != LoopKind::hole) continue;
    for (std::size_t k = 0; k < loop.vertices.size(); ++k) {
      const TriMesh::VertexHandle from(loop.vertices[k]), to(loop.vertices[(k + 1) % loop.vertices.size()]);
      const auto edge = model.mesh.find_halfedge(from, to);
      if (!edge.is_valid()) continue;
      for (const auto half : {edge, model.mesh.opposite_halfedge_handle(edge)}) {
        const auto face = model.mesh.face_handle(half);
        if (face.is_valid()) faces.insert(face.idx());
      }
    }
  }
  return faces;
}

/// Which of the view faces cut others of the surface.
std::vector<int> crossing_faces(const SurfaceModel& model, const std::set<int>& faces) {
  std::vector<int> crossing;
  if (faces.empty()) return crossing;
  const Points points = points_of(model.mesh);
  const Triangles triangles = triangles_of(model.mesh);
  const TriangleIndex index(points, triangles);
  for (int f : faces) {
    const auto& [a, b, c] = triangles[f];
    const Vec3 low = points[a].cwiseMin(points[b]).cwiseMin(points[c]);
    const Vec3 high = points[a].cwiseMax(points[b]).cwiseMax(points[c]);
    Points corners;
    Triangles local;
    const auto add = [&](int face) {
      const int first = static_cast<int>(corners.size());
      for (int v : triangles[face]) corners.push_back(points[v]);
      local.push_back({first, first + 1, first + 2});
    };
    add(f);
    for (int g : index.near(low, high))
      if (g != f) add(g);
    if (!self_intersections(corners, local, 1).empty()) crossing.push_back(f);
  }
  return crossing;
}

std::set<int> soup_vertices(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::set<int> vertices;
  for (const BoundaryLoop& loop : loops)
    for (int v : loop.vertices) vertices.insert(model.soup_vertex[v]);
  return vertices;
}

}  // namespace

const char* to_string(RimFault fault) {
  switch (fault) {
    case RimFault::dangling: return "dangling";
    case RimFault::sliver: return "sliver";
    case RimFault::spike: return "spike";
    case RimFault::flipped: return "flipped";
    case RimFault::crossing: return "crossing";
  }
  return "";
}

std::vector<BadRimFace> bad_rim_faces(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::map<int, RimFault> faults;  // by soup triangle
  for (int f : rim_faces(model, loops))
    if (const auto fault = fault_of(model, f)) faults.emplace(model.soup_face[f], *fault);
  for (const BoundaryLoop& loop : loops)
    if (loop.kind == LoopKind::hole)
      for (int v : loop.vertices)
        for (int f : spike_at(model, v)) faults.emplace(model.soup_face[f], RimFault::spike);
  std::vector<BadRimFace> bad;
  for (const auto& [face, fault] : faults) bad.push_back({face, fault, 1});
  return bad;
}

namespace {

/// To the other bad faces, by rising number.
void add_crossing_faces(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                        std::vector<BadRimFace>& bad) {
  for (int f : crossing_faces(model, rim_faces(model, loops))) {
    const BadRimFace face{model.soup_face[f], RimFault::crossing, 1};
    const auto at = std::lower_bound(bad.begin(), bad.end(), face,
                                     [](const BadRimFace& a, const BadRimFace& b) { return a.face < b.face; });
    if (at == bad.end() || at->face != face.face) bad.insert(at, face);
  }
}

}  // namespace

TrimmedModel trim_rim(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, int rounds) {
  if (rounds < 0 || rounds > 100)
    throw InvalidArgument("between 0 and 100 rings of a boundary can be trimmed, not " + std::to_string(rounds));
  TrimmedModel result{model, {}, loops};
  std::vector<int> original(model.soup.triangles.size());
  std::iota(original.begin(), original.end(), 0);
  std::set<int> touched = soup_vertices(model, loops);
  for (int round = 1; round <= (rounds > 0 ? std::max(rounds, rounds_for_crossings) : 0); ++round) {
    std::vector<BadRimFace> bad;
    if (round <= rounds) bad = bad_rim_faces(result.model, result.loops);
    add_crossing_faces(result.model, result.loops, bad);
    if (bad.empty()) break;
    TriangleSoup left = result.model.soup;
    left.triangles.clear();
    std::vector<int> points(left.points.size()), stay, numbers;
    std::iota(points.begin(), points.end(), 0);
    auto next = bad.begin();
    for (int f = 0; f < static_cast<int>(original.size()); ++f) {
      const Triangle& t = result.model.soup.triangles[f];
      if (next == bad.end() || next->face != f) {
        left.triangles.push_back(t);
        stay.push_back(f);
        numbers.push_back(original[f]);
        continue;
      }
      result.removed.push_back({original[f], next->fault, round});
      touched.insert(t.begin(), t.end());
      ++next;
    }
    if (left.triangles.empty()) throw InvalidArgument("trimming the boundary would leave no triangle");
    copy_rows(result.model.soup, points, stay, left);
    original = std::move(numbers);
    result.model = make_surface_model(std::move(left));
    result.loops.clear();
    for (BoundaryLoop& loop : find_boundary_loops(result.model))
      if (std::any_of(loop.vertices.begin(), loop.vertices.end(),
                      [&](int v) { return touched.count(result.model.soup_vertex[v]) > 0; }))
        result.loops.push_back(std::move(loop));
  }
  return result;
}

}  // namespace loopmend
