// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface_model.h"

#include "core/error.h"
#include "mesh/directed_edges.h"
#include "mesh/orient_soup.h"
#include "mesh/vertex_fans.h"
#include "mesh/vertex_survey.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace loopmend {

namespace {

using VertexHandle = TriMesh::VertexHandle;

std::uint64_t directed_key(int a, int b) {
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32) | static_cast<std::uint32_t>(b);
}
std::uint64_t edge_key(int a, int b) { return a < b ? directed_key(a, b) : directed_key(b, a); }

void check_indices(const TriangleSoup& soup) {
  const int n = static_cast<int>(soup.points.size());
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    for (int v : soup.triangles[f])
      if (v < 0 || v >= n)
        throw InvalidArgument("face " + std::to_string(f) + " names vertex " + std::to_string(v) + ", but there are " +
                              std::to_string(n) + " vertices");
}

/// Soup triangles that can be part of a surface: three different corners, not seen before. Fills the two counts.
std::vector<int> usable_faces(const TriangleSoup& soup, ModelRepairs& repairs) {
  const std::vector<char> repeated = repeated_triangles(soup.triangles, soup.points.size());
  std::vector<int> faces;
  faces.reserve(soup.triangles.size());
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const Triangle& t = soup.triangles[f];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      ++repairs.degenerate_faces;
    else if (repeated[f])
      ++repairs.duplicate_faces;
    else
      faces.push_back(static_cast<int>(f));
  }
  return faces;
}

bool runs_along(const Triangle& t, int a, int b) {
  for (int k = 0; k < 3; ++k)
    if (t[k] == a && t[(k + 1) % 3] == b) return true;
  return false;
}

/// Number of the connected component of each triangle.
std::vector<int> components(const Triangles& triangles, std::size_t vertex_count) {
  std::vector<int> parent(vertex_count);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Triangle& t : triangles)
    for (int k = 1; k < 3; ++k) parent[root(t[k])] = root(t[0]);
  std::vector<int> component;
  component.reserve(triangles.size());
  for (const Triangle& t : triangles) component.push_back(root(t[0]));
  return component;
}

/// Turns whole components back where CGAL, which follows the first face of each, turned more than half of the faces.
/// @returns for each face whether it is turned in the end.
std::vector<char> keep_the_majority(const Triangles& given, OrientedSoup& oriented) {
  std::vector<char> turned(given.size());
  std::vector<int> votes(oriented.origin.size(), 0);
  const std::vector<int> component = components(oriented.triangles, oriented.origin.size());
  for (std::size_t k = 0; k < given.size(); ++k) {
    const Triangle& t = oriented.triangles[k];
    turned[k] = !runs_along(given[k], oriented.origin[t[0]], oriented.origin[t[1]]);
    votes[component[k]] += turned[k] ? 1 : -1;
  }
  for (std::size_t k = 0; k < given.size(); ++k)
    if (votes[component[k]] > 0) {
      std::swap(oriented.triangles[k][1], oriented.triangles[k][2]);
      turned[k] = !turned[k];
    }
  return turned;
}

/// Where more than two faces meet at an edge, pairs of them that run on into each other with the least angle stay together,
/// as where two sheets touch along the edge or a fin stands on a sheet; the rest are cut off there.
class EdgePairing {
 public:
  EdgePairing(const Points& points, const Triangles& triangles) : points_(points), triangles_(triangles) {
    parent_.resize(3 * triangles.size());
    std::iota(parent_.begin(), parent_.end(), 0);
    std::vector<std::pair<std::uint64_t, int>> sides;  // edge, 3 · face + place of its first corner
    for (int f = 0; f < static_cast<int>(triangles.size()); ++f)
      for (int k = 0; k < 3; ++k) sides.emplace_back(edge_key(triangles[f][k], triangles[f][(k + 1) % 3]), 3 * f + k);
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0; i < sides.size();) {
      std::size_t j = i;
      std::vector<int> at;
      for (; j < sides.size() && sides[j].first == sides[i].first; ++j) at.push_back(sides[j].second);
      if (at.size() == 2) join(at[0], at[1]);
      if (at.size() > 2) join_the_flattest(at);
      i = j;
    }
  }

  /// The faces with a vertex of its own for each fan; the first keeps its number. @param origin  extended by the new ones.
  Triangles separated(std::vector<int>& origin) {
    Triangles result = triangles_;
    std::vector<int> number(parent_.size(), -1);  // by root corner
    std::vector<char> used(origin.size(), 0);
    for (std::size_t f = 0; f < result.size(); ++f)
      for (int k = 0; k < 3; ++k) {
        const int v = triangles_[f][k];
        int& mine = number[root(static_cast<int>(3 * f) + k)];
        if (mine < 0 && used[v]) {
          mine = static_cast<int>(origin.size());
          origin.push_back(v);
        } else if (mine < 0) {
          mine = v;
          used[v] = 1;
        }
        result[f][k] = mine;
      }
    return result;
  }

 private:
  int root(int corner) {
    while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
    return corner;
  }
  int vertex(int side, int k) const { return triangles_[side / 3][(side % 3 + k) % 3]; }
  static int corner(int side, int k) { return side / 3 * 3 + (side % 3 + k) % 3; }
  bool same_way(int s, int t) const { return vertex(s, 0) == vertex(t, 0); }

  void join(int s, int t) {
    const int turn = same_way(s, t) ? 0 : 1;
    for (int k : {0, 1}) {
      const int a = root(corner(s, k)), b = root(corner(t, (k + turn) % 2));
      parent_[std::max(a, b)] = std::min(a, b);
    }
  }

  /// From the edge into the face, square to the edge.
  Vec3 wing(int side) const {
    const Vec3 &a = points_[vertex(side, 0)], &b = points_[vertex(side, 1)], &apex = points_[vertex(side, 2)];
    const Vec3 along = (b - a).normalized(), out = apex - a;
    return (out - along.dot(out) * along).normalized();
  }

  void join_the_flattest(std::vector<int> at) {
    std::vector<std::tuple<double, int, int>> pairs;  // cosine between the wings: −1 is flat
    for (std::size_t i = 0; i < at.size(); ++i)
      for (std::size_t j = i + 1; j < at.size(); ++j)
        if (!same_way(at[i], at[j])) pairs.emplace_back(wing(at[i]).dot(wing(at[j])), at[i], at[j]);
    std::sort(pairs.begin(), pairs.end());
    std::set<int> joined;
    for (const auto& [cosine, s, t] : pairs) {
      if (joined.contains(s) || joined.contains(t)) continue;
      join(s, t);
      joined.insert({s, t});
    }
  }

  const Points& points_;
  const Triangles& triangles_;
  std::vector<int> parent_;  // of corners: 3 · face + place
};

/// Turns faces that disagree, and cuts where that does not help. @param faces  soup faces of the triangles
void orient_view(TriangleSoup& soup, const std::vector<int>& faces, Triangles& view_triangles, std::vector<int>& origin,
                 ModelRepairs& repairs) {
  Points points = soup.points;
  for (std::size_t v = points.size(); v < origin.size(); ++v) points.push_back(soup.points[origin[v]]);
  OrientedSoup oriented = orient_soup(points, view_triangles);
  const std::vector<char> turned = keep_the_majority(view_triangles, oriented);
  for (std::size_t k = 0; k < faces.size(); ++k)
    if (turned[k]) {
      std::swap(soup.triangles[faces[k]][1], soup.triangles[faces[k]][2]);
      ++repairs.reoriented_faces;
    }
  for (std::size_t v = origin.size(); v < oriented.origin.size(); ++v) origin.push_back(origin[oriented.origin[v]]);
  view_triangles = std::move(oriented.triangles);
}

/// Cuts and turns what is not an oriented manifold, and leaves the pieces alone that are; keeps the order of triangles.
void repair_view(TriangleSoup& soup, const std::vector<int>& faces, Triangles& view_triangles, std::vector<int>& origin,
                 VertexSurvey survey, ModelRepairs& repairs) {
  if (survey.any(VertexState::disordered)) {
    // Only the pieces of surface with such a vertex.
    const std::vector<int> piece = components(view_triangles, origin.size());
    std::vector<char> is_disordered(origin.size(), 0);
    for (std::size_t k = 0; k < view_triangles.size(); ++k)
      for (int v : view_triangles[k])
        if (survey.state[v] == VertexState::disordered) is_disordered[piece[k]] = 1;
    std::vector<int> places, own_faces;
    Triangles own;
    for (std::size_t k = 0; k < view_triangles.size(); ++k)
      if (is_disordered[piece[k]]) {
        places.push_back(static_cast<int>(k));
        own_faces.push_back(faces[k]);
        own.push_back(view_triangles[k]);
      }
    if (survey.non_manifold_edges > 0) own = EdgePairing(soup.points, own).separated(origin);
    if (survey_vertices(own, origin.size()).any(VertexState::disordered))
      orient_view(soup, own_faces, own, origin, repairs);
    for (std::size_t k = 0; k < places.size(); ++k) view_triangles[places[k]] = own[k];
    survey = survey_vertices(view_triangles, origin.size());
  }
  separate_fans(survey, view_triangles, origin);
  std::set<int> split;
  for (std::size_t v = soup.points.size(); v < origin.size(); ++v) split.insert(origin[v]);
  repairs.non_manifold_vertices = split.size();
}

/// The link of an open fan from its faces' (next, previous) corners, in order; empty for a closed one.
std::vector<int> link_of(const std::map<int, int>& next) {
  std::set<int> ends;
  for (const auto& [from, to] : next) ends.insert(to);
  for (const auto& [from, to] : next) {
    if (ends.contains(from)) continue;
    std::vector<int> link{from};
    for (auto at = next.find(from); at != next.end(); at = next.find(at->second)) link.push_back(at->second);
    return link;
  }
  return {};
}

/// Where fans that share nothing but a vertex lie side by side around it, as where two holes touch, that vertex is one again:
/// its copies take the number of the first. Fans that share an edge of the file with another stay apart.
void rejoin_fans(const Points& points, const std::vector<int>& origin, Triangles& triangles) {
  std::map<int, std::map<int, std::map<int, int>>> fans_at;  // split point → copy → next corner → previous corner
  for (std::size_t copy = points.size(); copy < origin.size(); ++copy) fans_at[origin[copy]];
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k)
      if (const auto split = fans_at.find(origin[t[k]]); split != fans_at.end())
        split->second[t[k]][t[(k + 1) % 3]] = t[(k + 2) % 3];
  std::map<int, int> joined;  // copy → the one whose number it takes
  for (const auto& [point, fans] : fans_at) {
    std::map<int, std::vector<int>> link_at;  // copy → neighbors in the file
    std::map<int, int> uses;
    for (const auto& [copy, next] : fans)
      for (int v : link_of(next)) {
        link_at[copy].push_back(origin[v]);
        ++uses[origin[v]];
      }
    std::vector<FanLink> links;
    std::vector<int> copies;
    for (const auto& [copy, neighbors] : link_at) {
      if (std::any_of(neighbors.begin(), neighbors.end(), [&](int v) { return uses.at(v) > 1; })) continue;
      copies.push_back(copy);
      FanLink& link = links.emplace_back();
      for (int v : neighbors) link.push_back(points[v]);
    }
    if (links.size() < 2 || !arrange_fans(points[point], links)) continue;
    for (int copy : copies) joined[copy] = copies.front();
  }
  for (Triangle& t : triangles)
    for (int& v : t)
      if (const auto found = joined.find(v); found != joined.end()) v = found->second;
}

/// Some boundary vertices have several fans: the boundary goes on from each to the next.
void link_all_fans(TriMesh& mesh) {
  for (const auto v : mesh.vertices())
    if (mesh.is_boundary(v) && fan_count(mesh, v) > 1) link_fans(mesh, v);
}

}  // namespace

SurfaceModel make_surface_model(TriangleSoup soup) {
  check_indices(soup);
  SurfaceModel model;
  const std::vector<int> faces = usable_faces(soup, model.repairs);
  if (faces.empty()) throw InvalidArgument("no usable face: every face is degenerate");
  Triangles triangles;
  triangles.reserve(faces.size());
  for (int f : faces) triangles.push_back(soup.triangles[f]);
  std::vector<int> origin(soup.points.size());
  std::iota(origin.begin(), origin.end(), 0);
  VertexSurvey survey = survey_vertices(triangles, soup.points.size());
  model.repairs.non_manifold_edges = survey.non_manifold_edges;
  const bool was_split = survey.any(VertexState::several) || survey.any(VertexState::disordered);
  if (was_split) {
    repair_view(soup, faces, triangles, origin, std::move(survey), model.repairs);
    rejoin_fans(soup.points, origin, triangles);
  }

  std::vector<int> view_of(origin.size(), -1);
  for (const Triangle& t : triangles)
    for (int v : t) view_of[v] = 0;
  std::vector<char> used(soup.points.size(), 0);
  model.mesh.reserve(origin.size(), triangles.size() * 3 / 2 + 16, triangles.size());
  for (std::size_t v = 0; v < origin.size(); ++v) {
    if (view_of[v] < 0) continue;
    used[origin[v]] = 1;
    view_of[v] = model.mesh.add_vertex(soup.points[origin[v]]).idx();
    model.soup_vertex.push_back(origin[v]);
  }
  model.repairs.unreferenced_vertices = std::count(used.begin(), used.end(), 0);
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const Triangle& t = triangles[k];
    const auto face =
        model.mesh.add_face(VertexHandle(view_of[t[0]]), VertexHandle(view_of[t[1]]), VertexHandle(view_of[t[2]]));
    if (!face.is_valid())
      throw InvalidArgument("face " + std::to_string(faces[k]) + " cannot be joined to its neighbours");
    model.soup_face.push_back(faces[k]);
  }
  if (was_split) link_all_fans(model.mesh);
  model.soup = std::move(soup);
  return model;
}

namespace {

void check_patch_fits(const SurfaceModel& model, const PatchGeometry& patch) {
  const int rim_size = static_cast<int>(patch.rim.size());
  const int vertex_count = rim_size + static_cast<int>(patch.points.size());
  const DirectedEdges directed(patch.triangles, static_cast<int>(patch.triangles.size()));
  for (const auto& [a, b] : directed.all())
    if (a < 0 || a >= vertex_count || a == b)
      throw InvalidArgument("a patch triangle names a vertex that is not there");
  if (directed.any_twice()) throw InvalidArgument("the patch is not an oriented manifold");
  for (const auto& [a, b] : directed.all()) {
    const bool open = !directed.contains({b, a});
    const bool on_rim = a < rim_size && b < rim_size;
    if (open && !on_rim) throw InvalidArgument("the patch has an open edge away from its boundary");
    if (!on_rim) continue;
    const auto h = model.mesh.find_halfedge(VertexHandle(patch.rim[a]), VertexHandle(patch.rim[b]));
    if (open && (!h.is_valid() || !model.mesh.is_boundary(h)))
      throw InvalidArgument("a boundary edge of the patch is not a boundary edge of the surface");
    if (!open && h.is_valid()) throw InvalidArgument("a chord of the patch is an edge of the surface already");
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
  view.reserve(patch.rim.size() + patch.points.size());
  for (int v : patch.rim) view.emplace_back(v);
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
  for (int v : patch.rim)
    if (fan_count(model.mesh, VertexHandle(v)) > 1) link_fans(model.mesh, VertexHandle(v));
}

}  // namespace loopmend
