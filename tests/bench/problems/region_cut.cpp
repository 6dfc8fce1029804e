// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_cut.h"

#include "mesh/boundary_loops.h"
#include "mesh/quality.h"
#include "mesh/self_intersections.h"
#include "operators/topology.h"
#include "samples/analytic_surfaces.h"
#include "truth_mesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace loopmend::bench {

namespace {

/// Which triangles stay, as trim_boundaries of the engine's samples decides it round by round, but looking again only where the
/// last round changed something: large scans unravel slowly.
class BoundaryTrimmer {
 public:
  BoundaryTrimmer(const TriangleSoup& soup, const Topology& topology, std::vector<char>& keep)
      : soup_(soup),
        topology_(topology),
        keep_(keep),
        boundary_from_(soup.points.size(), 0) {
    for (std::size_t f = 0; f < keep.size(); ++f)
      for (int k = 0; keep[f] && k < 3; ++k) edges_.insert(edge(soup.triangles[f][k], soup.triangles[f][(k + 1) % 3]));
    for (std::size_t v = 0; v < soup.points.size(); ++v) count_boundary_edges(static_cast<int>(v));
  }
  void trim() {
    std::vector<int> candidates(keep_.size());
    std::iota(candidates.begin(), candidates.end(), 0);
    while (!candidates.empty()) candidates = drop_hanging(candidates);
  }

 private:
  static std::uint64_t edge(int from, int to) {
    return static_cast<std::uint64_t>(from) << 32U | static_cast<std::uint32_t>(to);
  }
  bool is_boundary(int from, int to) const { return !edges_.contains(edge(to, from)); }
  void count_boundary_edges(int v) {
    boundary_from_[v] = 0;
    for (int f : topology_.faces(v))
      for (int k = 0; keep_[f] && k < 3; ++k)
        if (soup_.triangles[f][k] == v && is_boundary(v, soup_.triangles[f][(k + 1) % 3])) ++boundary_from_[v];
  }
  bool hangs(int f) const {
    int boundary_sides = 0;
    bool touching = false;
    for (int k = 0; k < 3; ++k) {
      boundary_sides += is_boundary(soup_.triangles[f][k], soup_.triangles[f][(k + 1) % 3]) ? 1 : 0;
      touching = touching || boundary_from_[soup_.triangles[f][k]] > 1;
    }
    return boundary_sides >= 2 || touching;
  }
  /// @returns the triangles whose neighborhood changed.
  std::vector<int> drop_hanging(const std::vector<int>& candidates) {
    std::vector<int> dropped, changed;
    for (int f : candidates)
      if (keep_[f] && hangs(f)) dropped.push_back(f);
    for (int f : dropped) {
      keep_[f] = 0;
      for (int k = 0; k < 3; ++k) edges_.erase(edge(soup_.triangles[f][k], soup_.triangles[f][(k + 1) % 3]));
    }
    for (int f : dropped)
      for (int v : soup_.triangles[f]) {
        count_boundary_edges(v);
        changed.insert(changed.end(), topology_.faces(v).begin(), topology_.faces(v).end());
      }
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    return changed;
  }

  const TriangleSoup& soup_;
  const Topology& topology_;
  std::vector<char>& keep_;
  std::vector<int> boundary_from_;
  std::unordered_set<std::uint64_t> edges_;
};

/// Triangles without a masked corner, trimmed.
std::vector<char> kept_triangles(const TriangleSoup& soup, const Topology& topology, const std::vector<char>& mask) {
  std::vector<char> keep(soup.triangles.size());
  for (std::size_t f = 0; f < keep.size(); ++f) {
    const auto& [a, b, c] = soup.triangles[f];
    keep[f] = !mask[a] && !mask[b] && !mask[c];
  }
  BoundaryTrimmer(soup, topology, keep).trim();
  return keep;
}

/// The kept triangles and their points, in their old order.
TriangleSoup kept_part(const TriangleSoup& soup, const std::vector<char>& keep) {
  TriangleSoup part;
  std::vector<int> index(soup.points.size(), -1);
  for (std::size_t f = 0; f < keep.size(); ++f)
    if (keep[f]) part.triangles.push_back(soup.triangles[f]);
  for (const Triangle& t : part.triangles)
    for (int v : t) index[v] = 0;
  for (std::size_t v = 0; v < index.size(); ++v) {
    if (index[v] < 0) continue;
    index[v] = static_cast<int>(part.points.size());
    part.points.push_back(soup.points[v]);
  }
  for (Triangle& t : part.triangles)
    for (int& v : t) v = index[v];
  return part;
}

/// Component of each vertex, by its lowest vertex; −1 for vertices without a triangle.
std::vector<int> components(std::size_t vertices, const Triangles& triangles) {
  std::vector<int> parent(vertices);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::vector<char> used(vertices, 0);
  for (const Triangle& t : triangles) {
    for (int v : t) used[v] = 1;
    for (int k : {1, 2}) {
      const int a = root(t[0]), b = root(t[k]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<int> component(vertices, -1);
  for (std::size_t v = 0; v < vertices; ++v)
    if (used[v]) component[v] = root(static_cast<int>(v));
  return component;
}

int most_used(const std::vector<int>& component, const Triangles& triangles) {
  std::unordered_map<int, int> count;
  for (const Triangle& t : triangles) ++count[component[t[0]]];
  int best = -1;
  for (const auto& [c, n] : count)
    if (best < 0 || n > count[best] || (n == count[best] && c < best)) best = c;
  return best;
}

/// The shape's own coordinates over a surface.
class ShapeFrame {
 public:
  ShapeFrame(const TriangleSoup& soup, const RegionPlan& plan) : plan_(plan), origin_(soup.points[plan.center]) {
    // The mean normal of the neighbourhood, since that of one vertex of a scan is noise.
    Vec3 normal = Vec3::Zero();
    for (const auto& [a, b, c] : soup.triangles)
      if ((soup.points[a] - origin_).norm() < 0.3 * plan.radius || a == plan.center)
        normal += (soup.points[b] - soup.points[a]).cross(soup.points[c] - soup.points[a]);
    normal.normalize();
    const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
    u_ = std::cos(plan.turn) * u + std::sin(plan.turn) * v;
    v_ = normal.cross(u_);
  }
  bool contains(const Vec3& p) const {
    const Vec3 d = p - origin_;
    const double flat = std::hypot(d.dot(u_), d.dot(v_));
    const double stretch = flat > 0 ? d.norm() / (flat * plan_.radius) : 0;
    return plan_.shape.contains(stretch * d.dot(u_), stretch * d.dot(v_));
  }

 private:
  const RegionPlan& plan_;
  Vec3 origin_, u_, v_;
};

std::vector<char> grow(const TriangleSoup& soup, const Topology& topology, const RegionPlan& plan) {
  const ShapeFrame frame(soup, plan);
  std::vector<char> mask(soup.points.size(), 0);
  std::vector<int> queue{plan.center};
  mask[plan.center] = 1;
  for (std::size_t q = 0; q < queue.size(); ++q)
    for (int w : topology.neighbors(queue[q]))
      if (!mask[w] && frame.contains(soup.points[w])) {
        mask[w] = 1;
        queue.push_back(w);
      }
  return mask;
}

/// Adds what the region encloses. @returns false when that is more than the region itself: it severs a part.
bool add_islands(const TriangleSoup& soup, std::vector<char>& mask) {
  Triangles kept;
  for (const Triangle& t : soup.triangles)
    if (!mask[t[0]] && !mask[t[1]] && !mask[t[2]]) kept.push_back(t);
  if (kept.empty()) return false;
  const std::vector<int> component = components(soup.points.size(), kept);
  const int main = most_used(component, kept);
  const auto before = std::count(mask.begin(), mask.end(), 1);
  for (std::size_t v = 0; v < mask.size(); ++v)
    if (component[v] >= 0 && component[v] != main) mask[v] = 1;
  return std::count(mask.begin(), mask.end(), 1) < 2 * before + 10;
}

/// True if a vertex within `rings` edges of the region lies on a boundary.
bool near_boundary(const Topology& topology, const std::vector<char>& mask, int rings) {
  std::vector<char> reached = mask;
  std::vector<int> front;
  for (int v = 0; v < topology.vertex_count(); ++v)
    if (mask[v]) front.push_back(v);
  for (int ring = 0; ring <= rings; ++ring) {
    std::vector<int> next;
    for (int v : front) {
      if (topology.is_boundary(v)) return true;
      for (int w : topology.neighbors(v))
        if (!reached[w]) {
          reached[w] = 1;
          next.push_back(w);
        }
    }
    front = std::move(next);
  }
  return false;
}

TriangleSoup compacted(const Points& points, const Triangles& triangles) {
  TriangleSoup soup;
  std::unordered_map<int, int> index;
  for (Triangle t : triangles) {
    for (int& v : t) {
      const auto [entry, added] = index.try_emplace(v, static_cast<int>(soup.points.size()));
      if (added) soup.points.push_back(points[v]);
      v = entry->second;
    }
    soup.triangles.push_back(t);
  }
  return soup;
}

/// What a trimmed cut took away round the centre. At the far boundaries of a neighbourhood trimming takes something, too.
TriangleSoup removed_part(const TriangleSoup& whole, const std::vector<char>& keep, int center) {
  Triangles removed, joined;
  for (std::size_t f = 0; f < keep.size(); ++f)
    if (!keep[f]) removed.push_back(whole.triangles[f]);
  const std::vector<int> component = components(whole.points.size(), removed);
  for (const Triangle& t : removed)
    if (component[t[0]] == component[center]) joined.push_back(t);
  return compacted(whole.points, joined);
}

/// The masked vertices with their triangles: what a cut takes away before it is trimmed.
TriangleSoup masked_part(const TriangleSoup& whole, const std::vector<char>& mask) {
  Triangles removed;
  for (const Triangle& t : whole.triangles)
    if (mask[t[0]] || mask[t[1]] || mask[t[2]]) removed.push_back(t);
  return compacted(whole.points, removed);
}

int count_missing(const TriangleSoup& removed, const TriangleSoup& open) {
  const PlaceSet left(open.points);
  return static_cast<int>(
      std::count_if(removed.points.begin(), removed.points.end(), [&](const Vec3& p) { return !left.contains(p); }));
}

double mean_edge_at(const TriangleSoup& soup, int v) {
  double sum = 0;
  int count = 0;
  for (const Triangle& t : soup.triangles)
    for (int k = 0; k < 3; ++k)
      if (t[k] == v) {
        sum += (soup.points[t[(k + 1) % 3]] - soup.points[v]).norm();
        ++count;
      }
  return count > 0 ? sum / count : 0;
}

/// A small mesh as it is; of a large one what lies near the planned cut. The centre is renumbered.
TriangleSoup neighborhood(const TriangleSoup& whole, RegionPlan& plan) {
  if (whole.points.size() <= most_kept_whole) return whole;
  const Vec3 center = whole.points[plan.center];
  const double reach = 2 * plan.radius + 30 * mean_edge_at(whole, plan.center);
  const TriangleSoup near = cut(whole, [&](const Vec3& p) { return (p - center).norm() > reach; });
  const std::vector<int> component = components(near.points.size(), near.triangles);
  const auto at_center = std::find(near.points.begin(), near.points.end(), center);
  if (at_center == near.points.end()) return whole;
  Triangles kept;
  for (const Triangle& t : near.triangles)
    if (component[t[0]] == component[at_center - near.points.begin()]) kept.push_back(t);
  TriangleSoup result = compacted(near.points, kept);
  plan.center = static_cast<int>(std::find(result.points.begin(), result.points.end(), center) - result.points.begin());
  return result;
}

/// One component, one boundary loop, no handle: V − E + F = 1.
bool is_disc(const TriangleSoup& soup) {
  const std::vector<int> component = components(soup.points.size(), soup.triangles);
  if (std::any_of(component.begin(), component.end(), [](int c) { return c != 0; })) return false;
  std::set<std::pair<int, int>> edges;
  for (const Triangle& t : soup.triangles)
    for (int k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  return soup.points.size() + soup.triangles.size() == edges.size() + 1;
}

}  // namespace

std::optional<RegionCut> cut_region(const TriangleSoup& given, const RegionPlan& planned) {
  RegionPlan plan = planned;
  const TriangleSoup whole = neighborhood(given, plan);
  const Topology topology(static_cast<int>(whole.points.size()), whole.triangles);
  std::vector<char> mask = grow(whole, topology, plan);
  if (near_boundary(topology, mask, plan.clearance) || !add_islands(whole, mask)) return std::nullopt;
  if (!is_disc(masked_part(whole, mask))) return std::nullopt;
  RegionCut result;
  const std::vector<char> keep = kept_triangles(whole, topology, mask);
  result.open = kept_part(whole, keep);
  if (result.open.triangles.empty()) return std::nullopt;
  result.removed = removed_part(whole, keep, plan.center);
  result.removed_vertices = count_missing(result.removed, result.open);
  if (!is_disc(result.removed)) return std::nullopt;
  const std::vector<int> parts = components(result.open.points.size(), result.open.triangles);
  if (std::any_of(parts.begin(), parts.end(), [&](int c) { return c != parts.front(); })) return std::nullopt;
  return result;
}

double expected_vertices(const TriangleSoup& whole, const RegionPlan& plan) {
  const Vec3 center = whole.points[plan.center];
  const auto near = std::count_if(whole.points.begin(), whole.points.end(),
                                  [&](const Vec3& p) { return (p - center).norm() < plan.radius; });
  return static_cast<double>(near) * plan.shape.area() / std::numbers::pi;
}

HoleProblem problem_of(std::string name, RegionCut cut, std::function<double(const Vec3&)> distance) {
  const PlaceSet removed(cut.removed.points);
  if (!distance) distance = [truth = TruthMesh(cut.removed)](const Vec3& p) { return truth.distance(p); };
  HoleProblem problem = open_problem(
      std::move(name), std::move(cut.open), [&](const Vec3& p) { return removed.contains(p); }, std::move(distance));
  problem.removed = cut.removed_vertices;
  return problem;
}

OriginalFaults faults_of_original(const TriangleSoup& removed, const TriangleSoup& open) {
  TriangleSoup both = removed;
  std::map<std::array<double, 3>, int> index;
  for (std::size_t v = 0; v < removed.points.size(); ++v) {
    const Vec3& p = removed.points[v];
    index.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(v));
  }
  std::vector<int> number(open.points.size());
  for (std::size_t v = 0; v < open.points.size(); ++v) {
    const Vec3& p = open.points[v];
    const auto found = index.find({p.x(), p.y(), p.z()});
    number[v] = found != index.end() ? found->second : static_cast<int>(both.points.size());
    if (found == index.end()) both.points.push_back(p);
  }
  for (const auto& [a, b, c] : open.triangles) both.triangles.push_back({number[a], number[b], number[c]});
  const int own = static_cast<int>(removed.triangles.size());
  return {static_cast<int>(self_intersections(both.points, both.triangles, own).size()),
          count_folds(both.points, both.triangles, own)};
}

void crop_around_cut(RegionCut& cut, int rings) {
  const PlaceSet boundary(cut.removed.points);
  const TriangleSoup& open = cut.open;
  const Topology topology(static_cast<int>(open.points.size()), open.triangles);
  std::vector<char> far(open.points.size(), 1);
  std::vector<int> front;
  for (std::size_t v = 0; v < open.points.size(); ++v) {
    if (!boundary.contains(open.points[v])) continue;
    far[v] = 0;
    front.push_back(static_cast<int>(v));
  }
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<int> next;
    for (int v : front)
      for (int w : topology.neighbors(v))
        if (far[w]) {
          far[w] = 0;
          next.push_back(w);
        }
    front = std::move(next);
  }
  cut.open = kept_part(open, kept_triangles(open, topology, far));
}

TriangleSoup largest_component(const TriangleSoup& soup) {
  const std::vector<int> component = components(soup.points.size(), soup.triangles);
  const int main = most_used(component, soup.triangles);
  Triangles kept;
  for (const Triangle& t : soup.triangles)
    if (component[t[0]] == main) kept.push_back(t);
  return compacted(soup.points, kept);
}

}  // namespace loopmend::bench
