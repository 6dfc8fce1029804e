// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/watertight.h"

#include "mesh/orient_soup.h"
#include "mesh/self_intersections.h"
#include "repair/inverted_shells.h"

#include <Eigen/Geometry>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <numeric>
#include <span>

namespace loopmend {
namespace {

/// Sets of vertices, or of edges, that hang together.
class ConnectedSets {
 public:
  explicit ConnectedSets(std::size_t count) : rank_(count, 0), parent_(count), sets_(rank_.data(), parent_.data()) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  void join(int a, int b) { sets_.union_set(a, b); }
  /// Of those that hold one of these.
  std::size_t count(std::vector<int> members) {
    for (int& member : members) member = sets_.find_set(member);
    std::sort(members.begin(), members.end());
    return static_cast<std::size_t>(std::unique(members.begin(), members.end()) - members.begin());
  }

 private:
  std::vector<unsigned char> rank_;
  std::vector<int> parent_;
  boost::disjoint_sets<unsigned char*, int*> sets_;
};

struct Edge {
  int low, high;
  int triangle;
  bool forward;  ///< whether its triangle runs from low to high
  bool operator<(const Edge& other) const { return low != other.low ? low < other.low : high < other.high; }
};

std::vector<Edge> sorted_edges(const Triangles& triangles) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = triangles[f][k], b = triangles[f][(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), static_cast<int>(f), a < b});
    }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// The vertex of the triangle after v.
int after(const Triangle& t, int v) { return t[(std::find(t.begin(), t.end(), v) - t.begin() + 1) % 3]; }

int start_of(const Edge& edge) { return edge.forward ? edge.low : edge.high; }
int end_of(const Edge& edge) { return edge.forward ? edge.high : edge.low; }

/// The open edge at the other side of the fan of triangles at whose one side this one ends; null where it is no fan of a surface.
const Edge* across_fan(const Edge& edge, const std::vector<Edge>& edges, const Triangles& triangles) {
  const int pivot = end_of(edge);
  int triangle = edge.triangle;
  for (std::size_t steps = 0; steps < triangles.size(); ++steps) {
    const int next = after(triangles[triangle], pivot);
    const Edge wanted{std::min(pivot, next), std::max(pivot, next), 0, false};
    const auto [first, last] = std::equal_range(edges.begin(), edges.end(), wanted);
    if (last - first == 1) return &*first;
    if (last - first != 2 || first->forward == std::next(first)->forward) return nullptr;
    triangle = first->triangle == triangle ? std::next(first)->triangle : first->triangle;
  }
  return nullptr;
}

/// Two loops that touch at a vertex are two. Where more of them meet, or the triangles are no fans, they are taken for one.
std::size_t count_loops(const std::vector<Edge>& open, const std::vector<Edge>& edges, const Triangles& triangles,
                        std::size_t vertex_count) {
  const auto count = static_cast<int>(open.size());
  ConnectedSets loops(open.size() + vertex_count);  // the vertices stand for the edges at them where these are one set
  std::vector<int> numbers(open.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  std::vector<char> meet(vertex_count, 0);
  std::vector<int> arriving(vertex_count, 0), leaving(vertex_count, 0), sum_leaving(vertex_count, 0);
  for (int i : numbers) {
    ++arriving[end_of(open[i])];
    ++leaving[start_of(open[i])];
    sum_leaving[start_of(open[i])] += i;
  }
  for (int i : numbers) {
    const int v = end_of(open[i]);
    const bool two = arriving[v] == 2 && leaving[v] == 2;
    if (const Edge* across = two ? across_fan(open[i], edges, triangles) : nullptr) {
      const auto far_side = std::lower_bound(open.begin(), open.end(), *across) - open.begin();
      loops.join(i, sum_leaving[v] - static_cast<int>(far_side));  // goes on at the near side of the other fan
      continue;
    }
    loops.join(i, count + v);
    meet[v] = 1;
  }
  for (int i : numbers)
    if (const int v = start_of(open[i]); meet[v] || arriving[v] == 0) loops.join(i, count + v);
  return loops.count(std::move(numbers));
}

void count_edges(const Triangles& triangles, std::size_t vertex_count, Watertightness& result) {
  const std::vector<Edge> edges = sorted_edges(triangles);
  std::vector<Edge> open;
  for (auto first = edges.begin(); first != edges.end();) {
    const auto last = std::upper_bound(first, edges.end(), *first);
    if (const std::span same(first, last); same.size() == 1) {
      open.push_back(*first);
    } else {
      const auto forward = std::count_if(same.begin(), same.end(), [](const Edge& edge) { return edge.forward; });
      const bool in_pairs = 2 * static_cast<std::size_t>(forward) == same.size();
      if (same.size() == 2)
        result.reversed_edges += !in_pairs;
      else
        (in_pairs ? result.touching_edges : result.non_manifold_edges) += 1;
    }
    first = last;
  }
  result.open_edges = open.size();
  result.open_boundaries = count_loops(open, edges, triangles, vertex_count);
}

/// The triangles over the first point in each place, without those that are left with two corners or fewer.
Triangles welded_by_place(const TriangleSoup& soup) {
  const std::vector<int> merged = merged_by_place(soup.points);
  Triangles triangles;
  triangles.reserve(soup.triangles.size());
  for (const Triangle& t : soup.triangles) {
    const Triangle welded{merged[t[0]], merged[t[1]], merged[t[2]]};
    if (welded[0] != welded[1] && welded[1] != welded[2] && welded[2] != welded[0]) triangles.push_back(welded);
  }
  return triangles;
}

std::size_t count_pieces(const Triangles& triangles, std::size_t vertex_count) {
  ConnectedSets pieces(vertex_count);
  std::vector<int> used;
  used.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    pieces.join(t[0], t[1]);
    pieces.join(t[0], t[2]);
    used.push_back(t[0]);
  }
  return pieces.count(std::move(used));
}

/// By the divergence theorem, about a point of the surface so that one far from the origin loses no digits.
double enclosed_volume(const Points& points, const Triangles& triangles) {
  double six_times = 0;
  for (const Triangle& t : triangles) {
    const Vec3& origin = points[triangles.front()[0]];
    six_times += (points[t[0]] - origin).dot((points[t[1]] - origin).cross(points[t[2]] - origin));
  }
  return six_times / 6;
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// Bodies that touch at points or edges are parted before.
std::size_t count_inverted_shells(const Points& points, const Triangles& triangles) {
  TriangleSoup apart{points, triangles};
  std::vector<int> origin(points.size());
  std::iota(origin.begin(), origin.end(), 0);
  separate_at_edges(points, apart.triangles, origin);
  for (std::size_t v = points.size(); v < origin.size(); ++v) apart.points.push_back(points[origin[v]]);
  if (count_pieces(apart.triangles, apart.points.size()) < 2) return 0;
  const SurfaceModel model = make_surface_model(apart);
  return find_inverted_shells(model, find_boundary_loops(model)).closed;
}

}  // namespace

Watertightness watertightness(const TriangleSoup& soup, const CancelToken& cancel) {
  Watertightness result;
  const Triangles triangles = welded_by_place(soup);
  if (cancel.cancelled()) return result;
  count_edges(triangles, soup.points.size(), result);
  if (cancel.cancelled()) return result;
  result.pieces = count_pieces(triangles, soup.points.size());
  result.volume = enclosed_volume(soup.points, triangles);
  result.intersections = count_self_intersections(soup.points, triangles, most_intersections, cancel);
  if (result.encloses()) {
    Watertightness as_given;  // closed bodies in the same place are still several
    count_edges(soup.triangles, soup.points.size(), as_given);
    result.inverted_shells = count_inverted_shells(soup.points, as_given.encloses() ? soup.triangles : triangles);
  }
  return result;
}

std::vector<std::string> faults(const Watertightness& surface) {
  std::vector<std::string> result;
  const auto add = [&](std::size_t count, const char* one, const char* many) {
    if (count > 0) result.push_back(counted(count, one, many));
  };
  add(surface.open_boundaries, "open boundary", "open boundaries");
  add(surface.non_manifold_edges, "edge of more than two triangles", "edges of more than two triangles");
  add(surface.reversed_edges, "edge whose triangles face opposite sides", "edges whose triangles face opposite sides");
  add(surface.intersections, "pair of triangles that intersect", "pairs of triangles that intersect");
  if (surface.encloses() && !(surface.volume > 0))
    result.push_back("inside out");
  else
    add(surface.inverted_shells, "body or cavity that is inside out", "bodies or cavities that are inside out");
  return result;
}

}  // namespace loopmend
