// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/rim_groups.h"

#include "core/quantile.h"
#include "filling/bridge_loops.h"
#include "filling/find_rings.h"
#include "mesh/loop_facing.h"
#include "repair/stitch_boundaries.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

namespace loopmend {

namespace {

constexpr double end_of_a_tube = 0.25;  ///< norm of LoopFacing::onward; 1 where the rim is even
constexpr double end_of_a_wall = 0.5;   ///< the same; outlines of plates have less
constexpr double looks_at = 0.7;        ///< cosine of the angle between the way the surface goes on and the other loop
constexpr double most_apart_of_tubes = 2;  ///< in diameters of the wider one
constexpr double alike = 0.6;              ///< shorter perimeter, in longer ones
constexpr int fewest_edges_of_a_tube = 8, most_edges_tried = 2000, most_tubes_tried = 4;
constexpr double least_extent = 0.08;  ///< of a tube's end in its piece of surface: small holes of a scan are none
constexpr int few_edges = 400;
constexpr double coarse = 0.25;  ///< density that is tried first: enough for even rims

constexpr double longest_gap_edge = 0.5;  ///< width of a gap in its length
constexpr double shortest_gap = 0.5;      ///< its length in diameters of the smaller outline
constexpr double narrowest_gap = 0.09;    ///< in edges
constexpr double widest_gap = 0.2;        ///< in diameters of the smaller outline
constexpr std::size_t fewest_edges = 5, most_edges_between = 2;
constexpr double most_edge_pairs = 5e7;  ///< that are looked at in all

double two_digits(double x) {
  const double unit = std::pow(10.0, std::floor(std::log10(x)) - 1);
  return std::round(x / unit) * unit;
}

bool touches(const BoundaryLoop& loop) {
  return std::any_of(loop.shared.begin(), loop.shared.end(), [](char other) { return other != 0; });
}

bool may_be_joined(const BoundaryLoop& loop) {
  return (loop.kind == LoopKind::hole || loop.kind == LoopKind::outer_rim) && loop.diameter > 0 && !touches(loop);
}

bool is_across(const LoopFacing& from, const Vec3& to) {
  const Vec3 way = to - from.center;
  return from.onward.dot(way) > looks_at * from.onward.norm() * way.norm();
}

/// Of loops of about one size, so near that --stitch joins them.
bool are_sides_of_a_crack(const BoundaryLoop& loop, double apart) {
  return apart < narrowest_gap * loop.perimeter / loop.edges();
}

/// Ends of tubes, the nearest first.
void add_tubes(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, const CancelToken& cancel,
               std::set<int>& taken, std::vector<RimGroup>& groups) {
  std::vector<std::optional<LoopFacing>> ends;
  for (const BoundaryLoop& loop : loops) {
    ends.emplace_back();
    if (!may_be_joined(loop) || loop.edges() < fewest_edges_of_a_tube || loop.extent < least_extent) continue;
    ends.back() = loop_facing(model, loop);
    if (ends.back()->onward.norm() < end_of_a_tube) ends.back().reset();
  }
  std::vector<std::tuple<double, int, int>> near;
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (std::size_t j = i + 1; ends[i] && j < loops.size(); ++j) {  // by falling perimeter
      if (loops[j].perimeter < alike * loops[i].perimeter) break;
      const double apart = (loops[i].center - loops[j].center).norm();
      if (ends[j] && apart < most_apart_of_tubes * std::max(loops[i].diameter, loops[j].diameter) &&
          (are_sides_of_a_crack(loops[i], apart) ||
           (is_across(*ends[i], loops[j].center) && is_across(*ends[j], loops[i].center))))
        near.emplace_back(apart, static_cast<int>(i), static_cast<int>(j));
    }
  if (near.empty()) return;
  std::sort(near.begin(), near.end());
  int tried = 0;
  std::set<int> seen = taken;
  const NearBoundaries sides = near_boundaries(model);  // a rim that --stitch closes along half of it is no end
  for (std::size_t k = 0; k < loops.size(); ++k)
    if (ends[k] && 2 * closing_edges(model, loops[k], sides) > loops[k].edges()) seen.insert(static_cast<int>(k));
  for (const auto& [apart, i, j] : near) {
    if (seen.contains(i) || seen.contains(j)) continue;
    if (are_sides_of_a_crack(loops[static_cast<std::size_t>(i)], apart)) {
      seen.insert({i, j});
      continue;
    }
    const std::vector<BoundaryLoop> both{loops[static_cast<std::size_t>(i)], loops[static_cast<std::size_t>(j)]};
    if (both[0].edges() + both[1].edges() > most_edges_tried || ++tried > most_tubes_tried) continue;
    seen.insert({i, j});
    const auto joins = [&](double density) {
      InitialPatchOptions options;
      options.density = density;
      const BridgeOutcome tube = bridge_loops(model, both, options, cancel);
      return tube.bridge && tube.bridge->quality.is_clean();
    };
    if (!joins(coarse) && !(both[0].edges() + both[1].edges() <= few_edges && joins(1))) continue;
    taken.insert({i, j});
    groups.push_back({{i, j}, RimGroup::Kind::tube});
  }
}

/// The boundary edges of a loop as they lie.
struct Outline {
  Outline(const SurfaceModel& model, const BoundaryLoop& loop) : facing(loop_facing(model, loop)) {
    for (const int v : loop.vertices) {
      points.push_back(model.mesh.point(TriMesh::VertexHandle(v)));
      soup.push_back(model.soup_vertex[static_cast<std::size_t>(v)]);
    }
  }
  std::size_t size() const { return points.size(); }
  std::size_t next(std::size_t k) const { return (k + 1) % size(); }
  Vec3 middle(std::size_t k) const { return (points[k] + points[next(k)]) / 2; }
  Vec3 out(std::size_t k) const { return (facing.conormals[k] + facing.conormals[next(k)]).normalized(); }
  /// From p to the nearest place of edge k.
  Vec3 way_to(std::size_t k, const Vec3& p) const {
    const Vec3 along = points[next(k)] - points[k];
    const double length2 = along.squaredNorm();
    const double t = length2 > 0 ? std::clamp((p - points[k]).dot(along) / length2, 0.0, 1.0) : 0;
    return points[k] + t * along - p;
  }

  LoopFacing facing;
  Points points;
  std::vector<int> soup;
};

/// For each edge of an outline how far the other one lies before it; infinite where it does not.
std::vector<double> widths_before(const Outline& own, const Outline& other) {
  std::vector<double> widths(own.size(), std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < own.size(); ++k) {
    const Vec3 p = own.middle(k);
    std::size_t nearest = 0;
    Vec3 way = other.way_to(0, p);
    for (std::size_t l = 1; l < other.size(); ++l)
      if (const Vec3 w = other.way_to(l, p); w.squaredNorm() < way.squaredNorm()) {
        way = w;
        nearest = l;
      }
    const double length = way.norm();
    if (length > 0 && own.out(k).dot(way) > looks_at * length && -other.out(nearest).dot(way) > looks_at * length)
      widths[k] = length;
  }
  return widths;
}

/// The longest run of edges with a finite width, few others among them: its first edge and how many; none where all are finite.
std::pair<std::size_t, std::size_t> longest_run(const std::vector<double>& widths) {
  const std::size_t n = widths.size();
  std::pair<std::size_t, std::size_t> best{0, 0};
  std::size_t first = 0, last = 0;
  bool is_in_run = false;
  for (std::size_t k = 0; k < 2 * n; ++k) {
    if (!std::isfinite(widths[k % n])) continue;
    if (!is_in_run || k - last > most_edges_between + 1) first = k;
    is_in_run = true;
    last = k;
    if (last - first + 1 > best.second) best = {first % n, last - first + 1};
  }
  return best.second < n ? best : std::pair<std::size_t, std::size_t>{0, 0};
}

/// The edge that a strip from edge k meets straight.
std::size_t edge_across(const Outline& own, std::size_t k, const Outline& other) {
  const auto distance = [&](std::size_t l) {
    return (other.points[l] - own.points[own.next(k)]).squaredNorm() +
           (other.points[other.next(l)] - own.points[k]).squaredNorm();
  };
  std::size_t best = 0;
  for (std::size_t l = 1; l < other.size(); ++l)
    if (distance(l) < distance(best)) best = l;
  return best;
}

void add_gaps(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, const std::set<int>& taken,
              std::vector<RimGroup>& groups) {
  std::vector<int> outlines;
  for (std::size_t k = 0; k < loops.size(); ++k)
    if (loops[k].kind == LoopKind::outer_rim && may_be_joined(loops[k]) && !taken.contains(static_cast<int>(k)))
      outlines.push_back(static_cast<int>(k));
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const int k : outlines) {
    boxes.emplace_back();
    for (const int v : loops[static_cast<std::size_t>(k)].vertices)
      boxes.back().extend(model.mesh.point(TriMesh::VertexHandle(v)));
  }
  double left = most_edge_pairs;
  for (std::size_t i = 0; i < outlines.size(); ++i)
    for (std::size_t j = i + 1; j < outlines.size(); ++j) {
      const BoundaryLoop &a = loops[static_cast<std::size_t>(outlines[i])],
                         &b = loops[static_cast<std::size_t>(outlines[j])];
      if (boxes[i].exteriorDistance(boxes[j]) > widest_gap * std::min(a.diameter, b.diameter)) continue;
      left -= static_cast<double>(a.edges()) * b.edges();
      if (left < 0) break;
      std::optional<RimGroup> gap = find_gap(model, a, b);
      if (!gap) continue;
      gap->loops = {outlines[i], outlines[j]};
      groups.push_back(*gap);
    }
}

double distance_to(const SurfaceModel& model, const BoundaryLoop& loop, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const int v : loop.vertices)
    least = std::min(least, (model.mesh.point(TriMesh::VertexHandle(v)) - p).squaredNorm());
  return least;
}

/// Whether most of a loop lies nearer to one of the group's other loops than to any loop beside these.
bool is_nearest(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, int loop, const RimGroup& group) {
  constexpr std::size_t most_places = 16;
  const std::vector<int>& vertices = loops[static_cast<std::size_t>(loop)].vertices;
  const std::size_t stride = std::max<std::size_t>(1, vertices.size() / most_places);
  std::size_t places = 0, nearest = 0;
  for (std::size_t i = 0; i < vertices.size(); i += stride, ++places) {
    const Vec3 p = model.mesh.point(TriMesh::VertexHandle(vertices[i]));
    double own = std::numeric_limits<double>::infinity();
    for (const int k : group.loops)
      if (k != loop) own = std::min(own, distance_to(model, loops[static_cast<std::size_t>(k)], p));
    nearest += std::none_of(loops.begin(), loops.end(), [&](const BoundaryLoop& other) {
      const bool is_other = !std::ranges::binary_search(group.loops, static_cast<int>(&other - loops.data()));
      return is_other && (other.center - p).norm() < other.diameter + std::sqrt(own) &&
             distance_to(model, other, p) < own;
    });
  }
  return 2 * nearest > places;
}

}  // namespace

std::vector<RimGroup> find_walls(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                 const CancelToken& cancel) {
  std::vector<RimGroup> groups;
  for (std::vector<int>& ring : find_rings(model, loops, cancel)) {
    const bool is_plate = loop_facing(model, loops[static_cast<std::size_t>(ring[0])]).onward.norm() < end_of_a_wall;
    groups.push_back({std::move(ring), is_plate ? RimGroup::Kind::plate : RimGroup::Kind::ring});
  }
  return groups;
}

std::vector<char> are_at_walls(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                               const std::vector<RimGroup>& groups) {
  std::vector<char> result(loops.size(), 0);
  for (const RimGroup& group : groups) {
    if (group.kind != RimGroup::Kind::ring && group.kind != RimGroup::Kind::plate) continue;
    for (const int k : group.loops) result[static_cast<std::size_t>(k)] = is_nearest(model, loops, k, group);
  }
  return result;
}

std::vector<RimGroup> find_rim_groups(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                      const CancelToken& cancel) {
  constexpr std::size_t most_outlines = 200;  // of more every pair would take long to look at
  std::vector<RimGroup> groups = find_walls(model, loops, cancel);
  std::set<int> taken;
  for (const RimGroup& group : groups) taken.insert(group.loops.begin(), group.loops.end());
  add_tubes(model, loops, cancel, taken, groups);
  const auto outlines = static_cast<std::size_t>(
      std::ranges::count_if(loops, [](const BoundaryLoop& loop) { return loop.kind == LoopKind::outer_rim; }));
  if (outlines <= most_outlines) add_gaps(model, loops, taken, groups);
  return groups;
}

std::optional<RimGroup> find_gap(const SurfaceModel& model, const BoundaryLoop& a, const BoundaryLoop& b) {
  if (!may_be_joined(a) || !may_be_joined(b)) return std::nullopt;
  if (a.onward > end_of_a_wall || b.onward > end_of_a_wall) return std::nullopt;  // no sheets
  const Outline own(model, a), other(model, b);
  const std::vector<double> widths = widths_before(own, other);
  const auto [first, count] = longest_run(widths);
  if (count < fewest_edges) return std::nullopt;
  std::vector<double> in_run;
  double length = 0;
  for (std::size_t k = first; k < first + count; ++k) {
    const std::size_t edge = k % own.size();
    if (std::isfinite(widths[edge])) in_run.push_back(widths[edge]);
    length += (own.points[own.next(edge)] - own.points[edge]).norm();
  }
  RimGroup gap{{0, 1}, RimGroup::Kind::gap, median(in_run)};
  // --stitch joins narrower ones.
  if (gap.width < narrowest_gap * length / static_cast<double>(count)) return std::nullopt;
  if (length < shortest_gap * std::min(a.diameter, b.diameter)) return std::nullopt;
  if (gap.width > longest_gap_edge * length || gap.width > widest_gap * std::min(a.diameter, b.diameter))
    return std::nullopt;
  // A strip takes the edges on both sides of its ends: these lie one edge within the run.
  const std::size_t begin = first % own.size(), end = (first + count - 1) % own.size();
  const std::size_t across_begin = edge_across(own, begin, other),
                    across_end = other.next(edge_across(own, end, other));
  gap.bridges = {std::pair{own.soup[own.next(begin)], other.soup[across_begin]},
                 std::pair{own.soup[end], other.soup[across_end]}};
  const std::size_t apart = (across_begin + other.size() - across_end) % other.size();
  if (apart < 3) return std::nullopt;  // the strips would share a vertex
  return gap;
}

Message gap_cure(const RimGroup& gap) {
  const auto& [first, second] = gap.bridges;
  return say("'loopmend fill --bridge %1,%2 --bridge %3,%4' closes the gap", first.first, first.second, second.first,
             second.second);
}

Message advice(const RimGroup& group, int own) {
  std::string all, others, named;  // as commands take them
  for (const int k : group.loops) {
    const std::string number = std::to_string(k + 1);
    named += (named.empty() ? "1:" : ",1:") + number;
    all += (all.empty() ? "" : ", ") + number;
    if (k != own) others += number;
  }
  switch (group.kind) {
    case RimGroup::Kind::ring:
      if (group.loops.size() > 2)
        return say("walls end at loops %1: 'loopmend blend --loops %2' joins them by a face with holes", all, named);
      return say("a wall ends at this loop and at loop %1: 'loopmend blend --loops %2' joins them by a ring", others,
                 named);
    case RimGroup::Kind::plate:
      return say("loop %1 bounds the other side of a plate: 'loopmend blend --loops %2' joins them by a straight wall",
                 others, named);
    case RimGroup::Kind::tube:
      return say("the end at loop %1 looks at this one: 'loopmend blend --loops %2' joins them by a smooth tube",
                 others, named);
    case RimGroup::Kind::gap:
      return joined(say("a gap of about %1 parts this outline from that of loop %2", two_digits(group.width), others),
                    ": ", gap_cure(group));
  }
  return {};
}

}  // namespace loopmend
