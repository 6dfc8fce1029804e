// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/flat_view.h"

#include "core/error.h"
#include "mesh/orient_soup.h"
#include "mesh/vertex_fans.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace loopmend {

namespace {

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
  if (survey.non_manifold_edges > 0) separate_at_edges(soup.points, own, view.origin);
  if (survey_vertices(own, view.origin.size()).any(VertexState::disordered)) {
    const std::vector<char> is_turned = orient_soup(own, view.origin);
    for (std::size_t k = 0; k < own.size(); ++k)
      if (is_turned[k]) {
        std::swap(soup.triangles[own_faces[k]][1], soup.triangles[own_faces[k]][2]);
        view.turned_faces.push_back(own_faces[k]);
      }
  }
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
