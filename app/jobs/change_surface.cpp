// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/change_surface.h"

#include "core/error.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace loopmend {
namespace {

using Edge = std::pair<int, int>;

/// Directed boundary edges over soup points, of these loops.
std::set<Edge> edges_of(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                        const NewPoints& new_points) {
  std::set<Edge> edges;
  const auto point = [&](int v) {
    const int p = model.soup_vertex[v];
    return new_points.empty() ? p : new_points[p];
  };
  for (const BoundaryLoop& loop : loops)
    for (std::size_t i = 0; i < loop.vertices.size(); ++i)
      edges.emplace(point(loop.vertices[i]), point(loop.vertices[(i + 1) % loop.vertices.size()]));
  return edges;
}

/// The faces at a point, in groups that hang together by edges at it; the largest first.
std::vector<std::vector<int>> fans_at(const TriangleSoup& soup, int point, const std::vector<int>& faces) {
  std::vector<std::vector<int>> fans;
  std::vector<int> left = faces;
  while (!left.empty()) {
    std::vector<int> fan{left.back()};
    left.pop_back();
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const Triangle& mine = soup.triangles[fan[i]];
      const auto shares_edge = [&](int f) {
        const Triangle& other = soup.triangles[f];
        return std::any_of(mine.begin(), mine.end(), [&](int v) {
          return v != point && std::find(other.begin(), other.end(), v) != other.end();
        });
      };
      const auto gone = std::stable_partition(left.begin(), left.end(), [&](int f) { return !shares_edge(f); });
      fan.insert(fan.end(), gone, left.end());
      left.erase(gone, left.end());
    }
    fans.push_back(std::move(fan));
  }
  std::stable_sort(fans.begin(), fans.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return fans;
}

}  // namespace

ChangedSurface without_faces_at(const TriangleSoup& soup, const std::vector<int>& points) {
  std::vector<char> chosen(soup.points.size(), 0), used(soup.points.size(), 0), orphan(soup.points.size(), 0);
  for (int p : points) chosen[p] = 1;
  ChangedSurface result;
  std::vector<int> kept_points, kept_faces;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const Triangle& t = soup.triangles[f];
    const bool gone = std::any_of(t.begin(), t.end(), [&](int v) { return chosen[v]; });
    for (int v : t) (gone ? orphan : used)[v] = 1;
    result.changes += gone;
    if (!gone) kept_faces.push_back(static_cast<int>(f));
  }
  if (kept_faces.empty()) throw InvalidArgument(say("this would leave no triangle of the surface"));
  result.new_points.assign(soup.points.size(), -1);
  for (std::size_t p = 0; p < soup.points.size(); ++p) {
    if (orphan[p] && !used[p]) continue;
    result.new_points[p] = static_cast<int>(result.soup.points.size());
    result.soup.points.push_back(soup.points[p]);
    if (!soup.colors.empty()) result.soup.colors.push_back(soup.colors[p]);
    kept_points.push_back(static_cast<int>(p));
  }
  for (int f : kept_faces) {
    Triangle t = soup.triangles[f];
    for (int& v : t) v = result.new_points[v];
    result.soup.triangles.push_back(t);
  }
  copy_rows(soup, kept_points, kept_faces, result.soup);
  return result;
}

std::vector<int> loops_opened(const SurfaceModel& before, const OpenedScan& after, const NewPoints& new_points) {
  const std::set<Edge> known = edges_of(before, find_boundary_loops(before), new_points);
  std::vector<int> opened;
  for (std::size_t l = 0; l < after.loops.size(); ++l) {
    if (after.loops[l].kind != LoopKind::hole) continue;
    const std::set<Edge> edges = edges_of(*after.model, {after.loops[l]}, {});
    if (!std::includes(known.begin(), known.end(), edges.begin(), edges.end())) opened.push_back(static_cast<int>(l));
  }
  return opened;
}

bool touches_itself(const BoundaryLoop& loop) {
  std::vector<int> vertices = loop.vertices;
  std::sort(vertices.begin(), vertices.end());
  return std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
}

ChangedSurface parted_at_touches(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::map<int, std::vector<int>> faces_at;  // by the points at which a loop touches itself
  for (const BoundaryLoop& loop : loops) {
    std::vector<int> vertices = loop.vertices;
    std::sort(vertices.begin(), vertices.end());
    for (std::size_t i = 1; i < vertices.size(); ++i)
      if (vertices[i] == vertices[i - 1]) faces_at[model.soup_vertex[vertices[i]]];
  }
  for (std::size_t f = 0; f < model.soup.triangles.size(); ++f)
    for (int v : model.soup.triangles[f])
      if (const auto at = faces_at.find(v); at != faces_at.end()) at->second.push_back(static_cast<int>(f));
  ChangedSurface result{model.soup, {}, 0};
  std::vector<int> point_of(model.soup.points.size());
  std::iota(point_of.begin(), point_of.end(), 0);
  for (const auto& [point, faces] : faces_at) {
    const std::vector<std::vector<int>> fans = fans_at(model.soup, point, faces);
    result.changes += fans.size() > 1;
    for (std::size_t k = 1; k < fans.size(); ++k) {
      const int twin = static_cast<int>(result.soup.points.size());
      result.soup.points.push_back(model.soup.points[point]);
      if (!model.soup.colors.empty()) result.soup.colors.push_back(model.soup.colors[point]);
      point_of.push_back(point);
      for (int f : fans[k])
        for (int& v : result.soup.triangles[f])
          if (v == point) v = twin;
    }
  }
  std::vector<int> faces(model.soup.triangles.size());
  std::iota(faces.begin(), faces.end(), 0);
  copy_rows(model.soup, point_of, faces, result.soup);
  return result;
}

}  // namespace loopmend
