// SPDX-License-Identifier: GPL-3.0-or-later
#include "mirror/cut_image.h"

#include "core/threads.h"
#include "mesh/directed_edges.h"
#include "mesh/quality.h"
#include "mesh/surface_tree.h"
#include "mirror/loop_strip.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <unordered_map>

namespace loopmend {

namespace {

/// A part within the loop with fewer triangles is refined, each triangle into four, up to twice: small holes hold hardly any.
constexpr std::size_t fewest_triangles = 24;
constexpr int most_refinements = 2;
constexpr std::size_t most_to_refine = 20000;
/// From so many triangles on, those that hang on the rest by one edge are dropped, which smooths the boundary.
constexpr std::size_t worth_smoothing = 40;
/// Least depth of the triangles that are kept, in edges of the loop: a wider strip lets a ragged cut do less harm.
constexpr double strip_margins[] = {0.45, 0.7, 1, 1.4};
constexpr double free_bend_deg = 40, width_cost = 30;
/// In edges of the loop. In a narrow slit what lies within the loop may be in several parts, of which one is kept. Of 17 copies (seed
/// 23 of loopmend_cut_models) the three worst, at 4 to 10 times the distance of the ordinary patch, have 13 to 15, the others up to 6.5.
constexpr double widest_strip = 8;

/// On which side of a loop a point lies: beyond the surface outside, where the loop's edges are nearest to it.
class LoopSide {
 public:
  explicit LoopSide(const Patch& patch)
      : patch_(patch),
        outside_(patch.triangles.begin() + patch.patch_triangles, patch.triangles.end()),
        tree_(patch.positions, outside_) {
    const std::vector<int>& loop = patch.loops[0];
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const int a = loop[k], b = loop[(k + 1) % loop.size()];
      edges_.push_back(std::minmax(a, b));
      edge_at_[a] = (patch.positions[b] - patch.positions[a]).norm();
    }
    std::sort(edges_.begin(), edges_.end());
  }

  /// In edges of the loop; negative outside.
  double depth_of(const Vec3& p) const {
    const SurfacePoint found = tree_.closest(p);
    if (found.triangle < 0) return -1;
    const Triangle& t = outside_[found.triangle];
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      const Vec3 &from = patch_.positions[a], edge = patch_.positions[b] - from;
      const double length = edge.norm();
      if (patch_.ring[a] == 1 && (found.place - from).norm() <= rounding * length)
        return (p - found.place).norm() / edge_at_.at(a);
      if (!std::binary_search(edges_.begin(), edges_.end(), std::pair<int, int>(std::minmax(a, b)))) continue;
      if ((found.place - from).cross(edge).norm() <= rounding * length * length)
        return (p - found.place).norm() / length;
    }
    return -1;
  }

 private:
  static constexpr double rounding = 1e-9;
  const Patch& patch_;
  Triangles outside_;
  SurfaceTree tree_;
  std::vector<std::pair<int, int>> edges_;
  std::unordered_map<int, double> edge_at_;
};

struct Sheet {
  Points points;
  Triangles triangles;
};

/// Each triangle into four plane ones.
Sheet refined(const Sheet& sheet) {
  Sheet fine{sheet.points, {}};
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [entry, added] = middles.try_emplace(std::minmax(a, b), static_cast<int>(fine.points.size()));
    if (added) fine.points.emplace_back((sheet.points[a] + sheet.points[b]) / 2);
    return entry->second;
  };
  for (const auto& [a, b, c] : sheet.triangles) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const Triangle& t : {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c}, Triangle{ab, bc, ca}})
      fine.triangles.push_back(t);
  }
  return fine;
}

/// Number of the part of each triangle: parts hang together by edges.
std::vector<int> parts_of(const Triangles& triangles, int& count) {
  std::map<std::pair<int, int>, int> first;
  std::vector<int> parent(triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int f) {
    while (parent[f] != f) f = parent[f] = parent[parent[f]];
    return f;
  };
  for (int f = 0; f < static_cast<int>(triangles.size()); ++f)
    for (int k = 0; k < 3; ++k) {
      const auto [entry, added] = first.try_emplace(std::minmax(triangles[f][k], triangles[f][(k + 1) % 3]), f);
      if (!added) parent[root(f)] = root(entry->second);
    }
  std::map<int, int> number;
  std::vector<int> part(triangles.size());
  for (int f = 0; f < static_cast<int>(triangles.size()); ++f)
    part[f] = number.try_emplace(root(f), static_cast<int>(number.size())).first->second;
  count = static_cast<int>(number.size());
  return part;
}

/// Edges without a triangle on their other side, as they run in their triangle: from each its end. A vertex that several such edges leave
/// is in `crossed`.
struct Border {
  std::map<int, int> next;
  std::vector<int> crossed;

  explicit Border(const Triangles& triangles) {
    const DirectedEdges edges(triangles, static_cast<int>(triangles.size()));
    for (const auto& edge : edges.all())
      if (!edges.contains({edge.second, edge.first}) && !next.try_emplace(edge.first, edge.second).second)
        crossed.push_back(edge.first);
  }

  /// From its least vertex on.
  std::vector<int> first_loop() const {
    std::vector<int> loop;
    if (next.empty()) return loop;
    int v = next.begin()->first;
    do {
      loop.push_back(v);
      const auto found = next.find(v);
      if (found == next.end()) return {};
      v = found->second;
    } while (v != loop.front() && loop.size() <= next.size());
    return loop;
  }
};

void erase_at(const std::vector<int>& vertices, Triangles& triangles) {
  std::erase_if(triangles, [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(),
                       [&](int v) { return std::find(vertices.begin(), vertices.end(), v) != vertices.end(); });
  });
}

void drop_hanging(Triangles& triangles) {
  const DirectedEdges edges(triangles, static_cast<int>(triangles.size()));
  std::erase_if(triangles, [&](const Triangle& t) {
    int open = 0;
    for (int k = 0; k < 3; ++k) open += !edges.contains({t[(k + 1) % 3], t[k]});
    return open > 1;
  });
}

/// Of each vertex of the loop from the border of the triangles.
std::vector<double> distances_from_border(const Patch& patch, const Points& points, const Triangles& triangles) {
  std::vector<double> distances;
  const Border border(triangles);
  for (int v : patch.loops[0]) {
    double least = std::numeric_limits<double>::max();
    for (const auto& [a, b] : border.next) least = std::min(least, (points[a] - patch.positions[v]).squaredNorm());
    distances.push_back(std::sqrt(least));
  }
  return distances;
}

/// The largest of these distances, in mean edges of the loop.
double strip_width(const Patch& patch, const Points& points, const Triangles& triangles) {
  const std::vector<int>& loop = patch.loops[0];
  double perimeter = 0;
  for (std::size_t k = 0; k < loop.size(); ++k)
    perimeter += (patch.positions[loop[(k + 1) % loop.size()]] - patch.positions[loop[k]]).norm();
  const std::vector<double> distances = distances_from_border(patch, points, triangles);
  return *std::max_element(distances.begin(), distances.end()) * static_cast<double>(loop.size()) / perimeter;
}

/// The part whose border follows the loop.
Triangles nearest_part(const Patch& patch, const Points& points, const Triangles& triangles) {
  int count = 0;
  const std::vector<int> part = parts_of(triangles, count);
  std::vector<Triangles> parts(count);
  for (std::size_t f = 0; f < triangles.size(); ++f) parts[part[f]].push_back(triangles[f]);
  if (count < 2) return triangles;
  std::vector<double> distances;
  for (const Triangles& own : parts) {
    const std::vector<double> of_loop = distances_from_border(patch, points, own);
    distances.push_back(std::accumulate(of_loop.begin(), of_loop.end(), 0.0));
  }
  return parts[std::min_element(distances.begin(), distances.end()) - distances.begin()];
}

/// Triangles deep enough within the loop, in one part without pinched vertices.
Triangles inner_triangles(const Patch& patch, const Sheet& sheet, const std::vector<double>& depth, double margin) {
  Triangles inner;
  for (const Triangle& t : sheet.triangles)
    if (depth[t[0]] > margin && depth[t[1]] > margin && depth[t[2]] > margin) inner.push_back(t);
  inner = nearest_part(patch, sheet.points, inner);
  if (inner.size() >= worth_smoothing) drop_hanging(inner);
  for (;;) {
    const Border border(inner);
    if (border.crossed.empty()) return nearest_part(patch, sheet.points, inner);
    erase_at(border.crossed, inner);
    inner = nearest_part(patch, sheet.points, inner);
  }
}

int euler_number(const Triangles& triangles) {
  std::vector<int> vertices;
  for (const Triangle& t : triangles) vertices.insert(vertices.end(), t.begin(), t.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const int open = static_cast<int>(Border(triangles).next.size()), faces = static_cast<int>(triangles.size());
  return static_cast<int>(vertices.size()) - (3 * faces + open) / 2 + faces;
}

CutFault fault_of(const Sheet& sheet, const Triangles& inner) {
  if (inner.empty()) return CutFault::open_there;
  const DirectedEdges own(inner, static_cast<int>(inner.size()));
  if (own.any_twice()) return CutFault::no_disc;
  const DirectedEdges all(sheet.triangles, static_cast<int>(sheet.triangles.size()));
  for (const auto& [a, b] : own.all())
    if (!all.contains({b, a})) return CutFault::open_there;
  const Border border(inner);
  if (border.first_loop().size() != border.next.size() || euler_number(inner) != 1) return CutFault::no_disc;
  return CutFault::none;
}

/// Beside the strip, which comes first in the triangles of the joined patch.
double bend_cost(const Patch& patch, const LoopPatch& joined, int strip_triangles) {
  const int boundary = static_cast<int>(patch.loops[0].size()), shift = patch.vertex_count() - boundary;
  Points points = patch.positions;
  points.insert(points.end(), joined.points.begin() + boundary, joined.points.end());
  Triangles triangles;
  for (Triangle t : joined.triangles) {
    for (int& v : t) v = v < boundary ? patch.loops[0][v] : v + shift;
    triangles.push_back(t);
  }
  triangles.insert(triangles.end(), patch.triangles.begin() + patch.patch_triangles, patch.triangles.end());
  double cost = 0;
  for (const Bend& bend : bends(points, triangles, strip_triangles))
    cost += std::max(0.0, std::acos(std::clamp(bend.cosine, -1.0, 1.0)) * 180 / std::numbers::pi - free_bend_deg);
  return cost;
}

CutImage joined_to_loop(const Patch& patch, const Sheet& sheet, const Triangles& inner, double margin) {
  CutImage cut;
  LoopPatch& joined = cut.patch;
  for (int v : patch.loops[0]) joined.points.push_back(patch.positions[v]);
  std::vector<int> border = Border(inner).first_loop();
  std::reverse(border.begin(), border.end());  // as the halfedges run that the strip has to close
  joined.triangles = strip_to_loop(patch, {sheet.points, inner, border});
  if (joined.triangles.empty()) return {{}, CutFault::no_disc};
  const int strip_triangles = static_cast<int>(joined.triangles.size());
  std::unordered_map<int, int> number;
  const auto add = [&](int v) {
    const auto [entry, added] = number.try_emplace(v, static_cast<int>(joined.points.size()));
    if (added) joined.points.push_back(sheet.points[v]);
    return entry->second;
  };
  for (int v : border) add(v);
  for (const auto& [a, b, c] : inner) {
    const int own_a = add(a), own_b = add(b);
    joined.triangles.push_back({own_a, own_b, add(c)});
  }
  cut.cost = bend_cost(patch, joined, strip_triangles) + width_cost * margin;
  return cut;
}

std::vector<double> depths(const LoopSide& side, const Points& points) {
  std::vector<double> depth(points.size());
  parallel_for(0, static_cast<int>(depth.size()), 64, [&](int v) { depth[v] = side.depth_of(points[v]); });
  return depth;
}

}  // namespace

std::vector<CutImage> cut_image(const Patch& patch, const MirrorImage& image, const CancelToken& cancel) {
  const LoopSide side(patch);
  Sheet sheet{image.points, image.triangles};
  std::vector<double> depth = depths(side, sheet.points);
  for (int k = 0; k < most_refinements && sheet.triangles.size() < most_to_refine; ++k) {
    if (inner_triangles(patch, sheet, depth, strip_margins[0]).size() >= fewest_triangles) break;
    sheet = refined(sheet);
    depth = depths(side, sheet.points);
  }
  std::vector<CutImage> cuts;
  for (const double margin : strip_margins) {
    if (cancel.cancelled()) return {};
    const Triangles inner = inner_triangles(patch, sheet, depth, margin);
    CutFault fault = fault_of(sheet, inner);
    if (fault == CutFault::none && strip_width(patch, sheet.points, inner) > widest_strip) fault = CutFault::no_disc;
    cuts.push_back(fault == CutFault::none ? joined_to_loop(patch, sheet, inner, margin) : CutImage{{}, fault});
  }
  std::stable_sort(cuts.begin(), cuts.end(), [](const CutImage& a, const CutImage& b) {
    const bool a_fails = a.fault != CutFault::none, b_fails = b.fault != CutFault::none;
    return a_fails != b_fails ? b_fails : a.cost < b.cost;
  });
  return cuts;
}

}  // namespace loopmend
