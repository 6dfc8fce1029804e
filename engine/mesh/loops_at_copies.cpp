// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/loops_at_copies.h"

#include "mesh/vertex_fans.h"

#include <algorithm>
#include <cstddef>
#include <set>

namespace loopmend {

namespace {

/// The points of which a loop passes several copies that can be one.
std::set<int> joinable_points(const SurfaceModel& model, const std::vector<int>& loop) {
  std::vector<std::pair<int, int>> copies;  // point, copy
  for (int v : loop) copies.emplace_back(model.soup_vertex[v], v);
  std::sort(copies.begin(), copies.end());
  std::set<int> points;
  for (std::size_t i = 0, j = 0; i < copies.size(); i = j) {
    while (j < copies.size() && copies[j].first == copies[i].first) ++j;
    if (j - i < 2) continue;
    std::set<int> neighbors;
    bool fit = true;
    for (std::size_t k = i; k < j && fit; ++k) {
      const TriMesh::VertexHandle v(copies[k].second);
      fit = fan_count(model.mesh, v) == 1;
      for (const auto w : model.mesh.vv_range(v)) fit = fit && neighbors.insert(model.soup_vertex[w.idx()]).second;
    }
    if (fit) points.insert(copies[i].first);
  }
  return points;
}

/// A vertex of a loop on the way round, and the loop's own neighbors of it; once joined, `to` is that of the last copy.
struct Visit {
  int first, from, to;
  bool is_joined = false;
};

void part(const SurfaceModel& model, const std::vector<int>& number, const std::vector<int>& loop,
          JoinedCopies& result) {
  const std::set<int> joinable = joinable_points(model, loop);
  if (joinable.empty()) return;
  const std::size_t n = loop.size();
  std::vector<Visit> open;           // since the last closed part
  std::vector<int> point_of;         // of each of these
  std::map<int, std::size_t> place;  // of joinable points among them
  for (std::size_t i = 0; i < n; ++i) {
    const int point = model.soup_vertex[loop[i]];
    const Visit here{number[loop[i]], number[loop[(i + n - 1) % n]], number[loop[(i + 1) % n]]};
    const auto met = place.find(point);
    if (met == place.end()) {
      if (joinable.contains(point)) place.emplace(point, open.size());
      open.push_back(here);
      point_of.push_back(point);
      continue;
    }
    Visit& before = open[met->second];
    result.joined.emplace(here.first, before.first);
    result.links.push_back({here.from, before.first, before.to});
    before.to = here.to;
    before.is_joined = true;
    while (open.size() > met->second + 1) {  // the part that is closed now
      const Visit& closed = open.back();
      if (closed.is_joined) result.links.push_back({closed.from, closed.first, closed.to});
      place.erase(point_of.back());
      open.pop_back();
      point_of.pop_back();
    }
  }
  for (const Visit& visit : open)
    if (visit.is_joined) result.links.push_back({visit.from, visit.first, visit.to});
}

}  // namespace

JoinedCopies join_copies_on_loops(const SurfaceModel& model, const std::vector<int>& number) {
  JoinedCopies result;
  std::vector<char> seen(model.mesh.n_halfedges(), 0);
  for (const auto start : model.mesh.halfedges()) {
    if (!model.mesh.is_boundary(start) || seen[start.idx()]) continue;
    std::vector<int> loop;
    for (auto h = start; !seen[h.idx()]; h = model.mesh.next_halfedge_handle(h)) {
      seen[h.idx()] = 1;
      loop.push_back(model.mesh.from_vertex_handle(h).idx());
    }
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    part(model, number, loop, result);
  }
  return result;
}

}  // namespace loopmend
