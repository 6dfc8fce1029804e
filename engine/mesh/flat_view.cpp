// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/flat_view.h"

#include "core/error.h"
#include "mesh/orient_soup.h"
#include "mesh/vertex_fans.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace loopmend {

namespace {

std::uint64_t edge_key(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(low)) << 32) | static_cast<std::uint32_t>(high);
}

bool runs_along(const Triangle& t, int a, int b) {
  for (int k = 0; k < 3; ++k)
    if (t[k] == a && t[(k + 1) % 3] == b) return true;
  return false;
}

/// Turns whole components back where CGAL, which follows the first face of each, turned more than half of the faces.
/// @returns for each face whether it is turned in the end.
std::vector<char> keep_the_majority(const Triangles& given, OrientedSoup& oriented) {
  std::vector<char> turned(given.size());
  std::vector<int> votes(oriented.origin.size(), 0);
  const std::vector<int> component = components(oriented.triangles, oriented.origin.size());
  const auto component_of = [&](std::size_t k) { return component[oriented.triangles[k][0]]; };
  for (std::size_t k = 0; k < given.size(); ++k) {
    const Triangle& t = oriented.triangles[k];
    turned[k] = !runs_along(given[k], oriented.origin[t[0]], oriented.origin[t[1]]);
    votes[component_of(k)] += turned[k] ? 1 : -1;
  }
  for (std::size_t k = 0; k < given.size(); ++k)
    if (votes[component_of(k)] > 0) {
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
                 std::vector<int>& turned_faces) {
  Points points = soup.points;
  for (std::size_t v = points.size(); v < origin.size(); ++v) points.push_back(soup.points[origin[v]]);
  OrientedSoup oriented = orient_soup(points, view_triangles);
  const std::vector<char> turned = keep_the_majority(view_triangles, oriented);
  for (std::size_t k = 0; k < faces.size(); ++k)
    if (turned[k]) {
      std::swap(soup.triangles[faces[k]][1], soup.triangles[faces[k]][2]);
      turned_faces.push_back(faces[k]);
    }
  for (std::size_t v = origin.size(); v < oriented.origin.size(); ++v) origin.push_back(origin[oriented.origin[v]]);
  view_triangles = std::move(oriented.triangles);
}

/// Cuts and turns the pieces of surface with a disordered vertex; keeps the order of triangles.
void put_in_order(TriangleSoup& soup, const VertexSurvey& survey, FlatView& view) {
  Triangles& triangles = view.triangles;
  const std::vector<int> piece = components(triangles, view.origin.size());
  std::vector<char> is_disordered(view.origin.size(), 0);
  for (std::size_t v = 0; v < survey.state.size(); ++v)
    if (survey.state[v] == VertexState::disordered) is_disordered[piece[v]] = 1;
  std::vector<int> places, own_faces;
  Triangles own;
  for (std::size_t k = 0; k < triangles.size(); ++k)
    if (is_disordered[piece[triangles[k][0]]]) {
      places.push_back(static_cast<int>(k));
      own_faces.push_back(view.face(k));
      own.push_back(triangles[k]);
    }
  if (survey.non_manifold_edges > 0) own = EdgePairing(soup.points, own).separated(view.origin);
  if (survey_vertices(own, view.origin.size()).any(VertexState::disordered))
    orient_view(soup, own_faces, own, view.origin, view.turned_faces);
  for (std::size_t k = 0; k < places.size(); ++k) triangles[places[k]] = own[k];
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

/// The triangles at vertices that were split, ascending. @param is_split  #origin
std::vector<std::size_t> triangles_at(const std::vector<char>& is_split, const Triangles& triangles) {
  std::vector<std::size_t> result;
  for (std::size_t f = 0; f < triangles.size(); ++f)
    if (const Triangle& t = triangles[f]; is_split[t[0]] || is_split[t[1]] || is_split[t[2]]) result.push_back(f);
  return result;
}

/// Where fans that share nothing but a vertex lie side by side around it, as where two holes touch, that vertex is one again:
/// its copies take the number of the first. Fans that share an edge of the file with another stay apart.
void rejoin_fans(const Points& points, const std::vector<int>& origin, Triangles& triangles) {
  std::map<int, std::map<int, std::map<int, int>>> fans_at;  // split point → copy → next corner → previous corner
  std::vector<char> is_split(origin.size(), 0);
  for (std::size_t copy = points.size(); copy < origin.size(); ++copy) is_split[copy] = is_split[origin[copy]] = 1;
  const std::vector<std::size_t> at_split = triangles_at(is_split, triangles);
  for (std::size_t f : at_split)
    for (int k = 0; k < 3; ++k)
      if (const Triangle& t = triangles[f]; is_split[t[k]])
        fans_at[origin[t[k]]][t[k]][t[(k + 1) % 3]] = t[(k + 2) % 3];
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
  for (std::size_t f : at_split)
    for (int& v : triangles[f])
      if (const auto found = joined.find(v); found != joined.end()) v = found->second;
}

/// Keeps the triangles that `goes` does not name. @returns how many went.
template <class Goes>
std::size_t leave_out(const TriangleSoup& soup, FlatView& view, const Goes& goes) {
  const Triangles& given = view.all(soup);
  std::vector<int> faces;
  Triangles kept;
  for (std::size_t k = 0; k < given.size(); ++k) {
    if (goes(k)) continue;
    faces.push_back(view.face(k));
    kept.push_back(given[k]);
  }
  const std::size_t gone = given.size() - kept.size();
  view.faces = std::move(faces);
  view.triangles = std::move(kept);
  view.is_own = true;
  return gone;
}

/// Leaves out what can be no part of a surface: triangles with a corner twice, and those over the corners of another.
VertexSurvey leave_out_unusable(const TriangleSoup& soup, std::optional<VertexSurvey> known, FlatView& view,
                                ModelRepairs& repairs) {
  VertexSurvey survey = known ? std::move(*known) : survey_vertices(soup.triangles, soup.points.size());
  if (survey.collapsed_triangles > 0)
    repairs.degenerate_faces =
        leave_out(soup, view, [&](std::size_t k) { return !has_three_corners(soup.triangles[k]); });
  if (!survey.may_repeat) return survey;
  const std::vector<char> repeated = repeated_triangles(view.all(soup), soup.points.size());
  if (std::find(repeated.begin(), repeated.end(), 1) == repeated.end()) return survey;
  repairs.duplicate_faces = leave_out(soup, view, [&](std::size_t k) { return repeated[k] == 1; });
  return survey_vertices(view.all(soup), soup.points.size());
}

/// Cuts and turns what is not an oriented manifold, and leaves the pieces alone that are.
void repair(TriangleSoup& soup, VertexSurvey& survey, FlatView& view, ModelRepairs& repairs) {
  view.is_split = true;
  if (!view.is_own) view.triangles = soup.triangles;
  view.is_own = true;
  const bool disordered = survey.any(VertexState::disordered);
  if (disordered) {
    put_in_order(soup, survey, view);
    survey = survey_vertices(view.triangles, view.origin.size());
  }
  separate_fans(survey, view.triangles, view.origin);
  std::set<int> split;
  for (std::size_t v = soup.points.size(); v < view.origin.size(); ++v) split.insert(view.origin[v]);
  repairs.non_manifold_vertices = split.size();
  repairs.reoriented_faces = view.turned_faces.size();
  rejoin_fans(soup.points, view.origin, view.triangles);
}

/// Where a vertex was split, all its fans count: the file has edges that several of them share.
void mark_copies(const VertexSurvey& survey, FlatView& view) {
  view.at_boundary.resize(view.origin.size(), 1);
  for (std::size_t v = 0; v < survey.state.size(); ++v)
    if (survey.state[v] != VertexState::clean) view.at_boundary[view.origin[v]] = 1;
  for (std::size_t v = survey.state.size(); v < view.origin.size(); ++v) view.at_boundary[view.origin[v]] = 1;
  for (std::size_t v = 0; v < view.origin.size(); ++v)
    if (view.at_boundary[v]) view.at_boundary[view.origin[v]] = 1;
  for (std::size_t v = 0; v < view.origin.size(); ++v) view.at_boundary[v] = view.at_boundary[view.origin[v]];
}

}  // namespace

std::vector<int> components(const Triangles& triangles, std::size_t point_count) {
  std::vector<int> parent(point_count);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Triangle& t : triangles)
    for (int k = 1; k < 3; ++k) parent[root(t[k])] = root(t[0]);
  for (int v = 0; v < static_cast<int>(point_count); ++v) parent[v] = root(v);
  return parent;
}

FlatView flat_view(TriangleSoup& soup, std::optional<VertexSurvey> known, ModelRepairs& repairs) {
  FlatView view;
  VertexSurvey survey = leave_out_unusable(soup, std::move(known), view, repairs);
  if (view.all(soup).empty()) throw InvalidArgument(say("no usable face: every face is degenerate"));
  view.origin.resize(soup.points.size());
  std::iota(view.origin.begin(), view.origin.end(), 0);
  repairs.non_manifold_edges = survey.non_manifold_edges;
  if (survey.any(VertexState::several) || survey.any(VertexState::disordered)) {
    repair(soup, survey, view, repairs);
    view.at_boundary = std::move(survey.at_boundary);
    mark_copies(survey, view);
  } else {
    view.at_boundary = std::move(survey.at_boundary);
  }
  return view;
}

}  // namespace loopmend
