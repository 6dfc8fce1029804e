// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface_model.h"

#include "core/error.h"
#include "core/threads.h"
#include "mesh/directed_edges.h"
#include "mesh/flat_view.h"
#include "mesh/loops_at_copies.h"
#include "mesh/vertex_fans.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <stdexcept>
#include <utility>

namespace loopmend {

namespace {

using VertexHandle = TriMesh::VertexHandle;

void check_indices(const TriangleSoup& soup) {
  const int n = static_cast<int>(soup.points.size());
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    for (int v : soup.triangles[f])
      if (v < 0 || v >= n) throw InvalidArgument(say("face %1 names vertex %2, but there are %3 vertices", f, v, n));
}

/// Some boundary vertices have several fans: the boundary goes on from each to the next.
void link_all_fans(TriMesh& mesh) {
  for (const auto v : mesh.vertices())
    if (mesh.is_boundary(v) && fan_count(mesh, v) > 1) link_fans(mesh, v);
}

/// The points that triangles use. @returns of each whether; fills the count of the others.
std::vector<char> used_points(const TriangleSoup& soup, const FlatView& view, ModelRepairs& repairs) {
  std::vector<char> used(view.origin.size(), 0), named(soup.points.size(), 0);
  for (const Triangle& t : view.all(soup))
    for (int v : t) used[v] = 1;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v]) named[view.origin[v]] = 1;
  repairs.unreferenced_vertices = std::count(named.begin(), named.end(), 0);
  return used;
}

/// Adds the points that are wanted and the triangles between them. @param point  that stands for a point of the view
/// @returns their view vertices; −1: none
template <class Point, class Wanted>
std::vector<int> add_faces(const TriangleSoup& soup, const FlatView& view, const std::vector<char>& points,
                           const Point& point, const Wanted& is_wanted, SurfaceModel& model) {
  std::vector<int> view_of(view.origin.size(), -1);
  for (std::size_t v = 0; v < view.origin.size(); ++v) {
    if (!points[v]) continue;
    view_of[v] = model.mesh.add_vertex(soup.points[view.origin[v]]).idx();
    model.soup_vertex.push_back(view.origin[v]);
  }
  const Triangles& triangles = view.all(soup);
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const Triangle t{point(triangles[k][0]), point(triangles[k][1]), point(triangles[k][2])};
    if (!is_wanted(t)) continue;
    const auto face =
        model.mesh.add_face(VertexHandle(view_of[t[0]]), VertexHandle(view_of[t[1]]), VertexHandle(view_of[t[2]]));
    if (!face.is_valid()) throw InvalidArgument(say("face %1 cannot be joined to its neighbours", view.face(k)));
    model.soup_face.push_back(view.face(k));
  }
  if (view.is_split) link_all_fans(model.mesh);
  return view_of;
}

/// The same, and joins copies of points where that makes simpler loops.
template <class Wanted>
std::vector<int> add_surface(const TriangleSoup& soup, const FlatView& view, std::vector<char> points,
                             const Wanted& is_wanted, SurfaceModel& model) {
  std::vector<int> view_of = add_faces(soup, view, points, std::identity(), is_wanted, model);
  if (!view.is_split) return view_of;
  std::vector<int> point_of(model.mesh.n_vertices());
  for (std::size_t v = 0; v < view_of.size(); ++v)
    if (view_of[v] >= 0) point_of[view_of[v]] = static_cast<int>(v);
  const JoinedCopies parted = join_copies_on_loops(model, point_of);
  if (parted.links.empty()) return view_of;
  const auto point = [&](int v) {
    const auto found = parted.joined.find(v);
    return found == parted.joined.end() ? v : found->second;
  };
  for (const auto& [copy, first] : parted.joined) points[copy] = 0;
  model.mesh.clear();
  model.soup_vertex.clear();
  model.soup_face.clear();
  view_of = add_faces(soup, view, points, point, is_wanted, model);
  const auto edge = [&](int from, int to) {
    return model.mesh.find_halfedge(VertexHandle(view_of[point(from)]), VertexHandle(view_of[point(to)]));
  };
  std::vector<std::pair<TriMesh::HalfedgeHandle, TriMesh::HalfedgeHandle>> next;  // found while all links are whole
  for (const BoundaryLink& link : parted.links) {
    next.emplace_back(edge(link.from, link.at), edge(link.at, link.to));
    if (!next.back().first.is_valid() || !next.back().second.is_valid())
      throw std::logic_error("make_surface_model: joined copies lost an edge");
  }
  for (const auto& [in, out] : next) model.mesh.set_next_halfedge_handle(in, out);
  return view_of;
}

/// How many edges away the nearest point is that the view is made around: exact up to `rings`, else more.
std::vector<unsigned char> rings_around(const TriangleSoup& soup, const FlatView& view, const AroundLoops& around) {
  constexpr unsigned char far = 255;
  std::vector<unsigned char> ring(view.origin.size(), far);
  for (std::size_t v = 0; v < ring.size(); ++v) {
    const Vec3& p = soup.points[view.origin[v]];
    const bool inside =
        std::any_of(around.boxes.begin(), around.boxes.end(), [&](const auto& box) { return box.contains(p); });
    if (view.at_boundary[v] || inside) ring[v] = 0;
  }
  for (int reached = 0; reached < around.rings; ++reached)
    for (const Triangle& t : view.all(soup)) {
      if (ring[t[0]] != reached && ring[t[1]] != reached && ring[t[2]] != reached) continue;
      for (int v : t) ring[v] = std::min(ring[v], static_cast<unsigned char>(reached + 1));
    }
  return ring;
}

/// What is known of the whole surface; what depends on the view comes later. Numbers the pieces.
void describe_beyond(const TriangleSoup& soup, const FlatView& view, const std::vector<char>& used,
                     SurfaceBeyond& beyond) {
  std::vector<int> number(view.origin.size(), -1);
  for (std::size_t v = 0; v < view.origin.size(); ++v) {
    int& piece = beyond.piece_of_point[v];
    if (!used[v]) {
      piece = -1;
      continue;
    }
    int& mine = number[piece];
    if (mine < 0) {
      mine = static_cast<int>(beyond.boxes.size());
      beyond.boxes.emplace_back();
    }
    piece = mine;
    beyond.boxes[piece].extend(soup.points[view.origin[v]]);
  }
  if (!view.faces.empty()) {
    auto next = view.faces.begin();
    for (int f = 0; f < static_cast<int>(soup.triangles.size()); ++f)
      if (next != view.faces.end() && *next == f)
        ++next;
      else
        beyond.unusable.push_back(f);
  }
  beyond.copy_of.assign(view.origin.begin() + static_cast<std::ptrdiff_t>(soup.points.size()), view.origin.end());
}

/// @param model  with its repairs
SurfaceModel view_around(TriangleSoup soup, std::shared_ptr<const FlatView> flat, const AroundLoops& around,
                         SurfaceModel model) {
  const FlatView& view = *flat;
  SurfaceBeyond beyond;
  if (view.is_split) beyond.flat = flat;
  model.turned_faces = view.turned_faces;
  std::vector<char> points;
  std::vector<unsigned char> ring;
  parallel_invoke([&] { beyond.piece_of_point = components(view.all(soup), view.origin.size()); },
                  [&] {
                    points = used_points(soup, view, model.repairs);
                    ring = rings_around(soup, view, around);
                  });
  describe_beyond(soup, view, points, beyond);
  const auto is_complete = [&](int v) { return ring[v] <= around.rings; };
  const auto is_wanted = [&](const Triangle& t) { return std::any_of(t.begin(), t.end(), is_complete); };
  std::fill(points.begin(), points.end(), 0);
  for (const Triangle& t : view.all(soup))
    if (is_wanted(t))
      for (int v : t) points[v] = 1;
  const std::vector<int> view_of = add_surface(soup, view, points, is_wanted, model);
  beyond.rings = around.rings;
  beyond.is_cut_off.resize(model.mesh.n_vertices());
  beyond.piece_of_vertex.resize(model.mesh.n_vertices());
  for (std::size_t v = 0; v < view_of.size(); ++v) {
    if (view_of[v] < 0) continue;
    beyond.is_cut_off[view_of[v]] = !is_complete(static_cast<int>(v));
    beyond.piece_of_vertex[view_of[v]] = beyond.piece_of_point[v];
  }
  model.beyond = std::move(beyond);
  model.soup = std::move(soup);
  return model;
}

}  // namespace

SurfaceModel make_surface_model(TriangleSoup soup, std::optional<VertexSurvey> survey) {
  if (!survey) check_indices(soup);
  SurfaceModel model;
  FlatView view = flat_view(soup, std::move(survey), model.repairs);
  model.turned_faces = std::move(view.turned_faces);
  const std::size_t count = view.all(soup).size();
  // Each triangle has three edges, of which two share one but at boundaries; these have about as many edges as points. Were one
  // edge too little reserved, half a gigabyte would be copied for ten million triangles, and as much left unused.
  const auto boundary = static_cast<std::size_t>(std::count(view.at_boundary.begin(), view.at_boundary.end(), 1));
  model.mesh.reserve(view.origin.size(), (3 * count + boundary) / 2 + count / 500 + 16, count);
  model.soup_face.reserve(count);
  add_surface(
      soup, view, used_points(soup, view, model.repairs), [](const Triangle&) { return true; }, model);
  model.soup = std::move(soup);
  return model;
}

std::shared_ptr<const SurfaceModel> make_shared_surface_model(TriangleSoup soup, std::optional<VertexSurvey> survey) {
  return std::shared_ptr<const SurfaceModel>(new SurfaceModel(make_surface_model(std::move(soup), std::move(survey))));
}

SurfaceModel make_view_around_loops(TriangleSoup soup, const AroundLoops& around, std::optional<VertexSurvey> survey) {
  if (!survey) check_indices(soup);
  SurfaceModel model;
  auto flat = std::make_shared<const FlatView>(flat_view(soup, std::move(survey), model.repairs));
  return view_around(std::move(soup), std::move(flat), around, std::move(model));
}

SurfaceModel with_view_around(SurfaceModel model, const AroundLoops& around) {
  if (!model.beyond || !model.beyond->flat) return make_view_around_loops(as_read(std::move(model)), around);
  SurfaceModel other;
  other.repairs = model.repairs;
  return view_around(std::move(model.soup), std::move(model.beyond->flat), around, std::move(other));
}

TriangleSoup as_read(SurfaceModel model) {
  for (int f : model.turned_faces) std::swap(model.soup.triangles[f][1], model.soup.triangles[f][2]);
  return std::move(model.soup);
}

bool is_cut_off(const SurfaceModel& model, int view_vertex) {
  const auto v = static_cast<std::size_t>(view_vertex);
  return model.beyond && v < model.beyond->is_cut_off.size() && model.beyond->is_cut_off[v];
}

namespace {

void check_patch_fits(const SurfaceModel& model, const PatchGeometry& patch) {
  const int boundary_size = static_cast<int>(patch.boundary.size());
  const int vertex_count = boundary_size + static_cast<int>(patch.points.size());
  const DirectedEdges directed(patch.triangles, static_cast<int>(patch.triangles.size()));
  for (const auto& [a, b] : directed.all())
    if (a < 0 || a >= vertex_count || a == b)
      throw InvalidArgument(say("a patch triangle names a vertex that is not there"));
  if (directed.any_twice()) throw InvalidArgument(say("the patch is not an oriented manifold"));
  for (const auto& [a, b] : directed.all()) {
    const bool open = !directed.contains({b, a});
    const bool on_boundary = a < boundary_size && b < boundary_size;
    if (open && !on_boundary) throw InvalidArgument(say("the patch has an open edge away from its boundary"));
    if (!on_boundary) continue;
    const auto h = model.mesh.find_halfedge(VertexHandle(patch.boundary[a]), VertexHandle(patch.boundary[b]));
    if (open && (!h.is_valid() || !model.mesh.is_boundary(h)))
      throw InvalidArgument(say("a boundary edge of the patch is not a boundary edge of the surface"));
    if (!open && h.is_valid()) throw InvalidArgument(say("a chord of the patch is an edge of the surface already"));
  }
}

}  // namespace

void reserve_patches(SurfaceModel& model, std::size_t points, std::size_t triangles) {
  const TriMesh& mesh = model.mesh;
  model.soup.points.reserve(model.soup.points.size() + points);
  if (!model.soup.colors.empty()) model.soup.colors.reserve(model.soup.colors.size() + points);
  model.soup.triangles.reserve(model.soup.triangles.size() + triangles);
  model.soup_vertex.reserve(model.soup_vertex.size() + points);
  model.soup_face.reserve(model.soup_face.size() + triangles);
  // A triangle has at most three edges of its own.
  model.mesh.reserve(mesh.n_vertices() + points, mesh.n_edges() + 3 * triangles, mesh.n_faces() + triangles);
}

void append_patch(SurfaceModel& model, const PatchGeometry& patch) {
  check_patch_fits(model, patch);
  std::vector<VertexHandle> view;
  view.reserve(patch.boundary.size() + patch.points.size());
  for (int v : patch.boundary) view.emplace_back(v);
  for (const Vec3& p : patch.points) {
    view.push_back(model.mesh.add_vertex(p));
    model.soup_vertex.push_back(static_cast<int>(model.soup.points.size()));
    model.soup.points.push_back(p);
    if (!model.soup.colors.empty()) model.soup.colors.push_back({200, 200, 200, 255});
  }
  for (const Triangle& t : patch.triangles) {
    const auto face = model.mesh.add_face(view[t[0]], view[t[1]], view[t[2]]);
    if (!face.is_valid()) throw std::logic_error("append_patch: a checked patch did not fit");
    model.soup_face.push_back(static_cast<int>(model.soup.triangles.size()));
    model.soup.triangles.push_back({model.soup_vertex[view[t[0]].idx()], model.soup_vertex[view[t[1]].idx()],
                                    model.soup_vertex[view[t[2]].idx()]});
  }
  for (int v : patch.boundary)
    if (fan_count(model.mesh, VertexHandle(v)) > 1) link_fans(model.mesh, VertexHandle(v));
}

std::vector<int> triangles_outside(const SurfaceModel& model) {
  std::vector<char> is_inside(model.soup.triangles.size(), 0);
  for_each_soup_triangle(model, [&](int f) { is_inside[f] = 1; });
  std::vector<int> outside;
  for (std::size_t f = 0; f < is_inside.size(); ++f)
    if (!is_inside[f]) outside.push_back(static_cast<int>(f));
  return outside;
}

}  // namespace loopmend
