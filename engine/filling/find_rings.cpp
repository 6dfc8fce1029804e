// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/find_rings.h"

#include "filling/bridge_loops.h"
#include "filling/ring_bridge.h"
#include "filling/wall_bridge.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace loopmend {

namespace {

/// Two loops that a ring or a wall may join.
struct RingSides {
  double width;
  int i, j;
  std::optional<std::size_t> outline;  ///< of a ring: 0 for i, 1 for j

  int outer() const { return *outline == 0 ? i : j; }
  int inner() const { return *outline == 0 ? j : i; }
};

/// The outline of a block and the rims of two bores or more, all of one missing face: the loops beside each other within each outline.
std::vector<std::vector<int>> groups_with_bores(const std::vector<BridgeEnd>& ends,
                                                const std::vector<RingSides>& pairs) {
  std::map<int, std::set<int>> within;
  for (const RingSides& pair : pairs)
    if (pair.outline && ends[pair.outer()].axis.dot(ends[pair.inner()].axis) < 0)
      within[pair.outer()].insert(pair.inner());
  std::vector<std::vector<int>> groups;
  for (const auto& [outer, inner] : within) {
    std::vector<int> group{outer};
    for (const int k : inner)
      if (std::ranges::none_of(pairs, [&](const RingSides& pair) {
            return pair.outline && pair.inner() == k && inner.contains(pair.outer());
          }))
        group.push_back(k);
    std::ranges::sort(group);
    std::vector<BridgeEnd> members;
    for (const int k : group) members.push_back(ends[static_cast<std::size_t>(k)]);
    if (group.size() > 2 && lie_in_one_plane(members)) groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace

std::vector<std::vector<int>> find_rings(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                         const CancelToken& cancel) {
  constexpr int fewest_edges_of_a_bore = 8;
  constexpr double shortest_onward = 0.5;  // of walls that are steep along most of the loop
  constexpr double coarse = 0.25;          // density; it matters at noisy loops around many bores alone
  constexpr int few_edges = 1000;          // of a group: at full density a ring takes less than a second
  const std::vector<BridgeEnd> ends = ends_of(model, loops);
  std::vector<std::size_t> may_end;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const bool touches = std::any_of(loops[k].shared.begin(), loops[k].shared.end(), [](char other) { return other; });
    if ((loops[k].kind == LoopKind::hole || loops[k].kind == LoopKind::outer_rim) && !touches &&
        (ends[k].onward.norm() > shortest_onward || loops[k].kind == LoopKind::outer_rim ||
         loops[k].edges() >= fewest_edges_of_a_bore))
      may_end.push_back(k);
  }
  std::vector<RingSides> pairs;
  for (std::size_t a = 0; a < may_end.size() && !cancel.cancelled(); ++a)
    for (std::size_t b = a + 1; b < may_end.size(); ++b) {
      const std::size_t i = may_end[a], j = may_end[b];
      const double apart = (loops[i].center - loops[j].center).norm();
      if (apart >= std::max(loops[i].diameter, loops[j].diameter)) continue;
      std::optional<std::size_t> outline;
      if (ends[i].onward.norm() > shortest_onward && ends[j].onward.norm() > shortest_onward)
        outline = outline_of_a_ring({ends[i], ends[j]});
      if (outline || have_a_wall_between(loops[i], loops[j], ends[i], ends[j]))
        pairs.push_back({apart + std::abs(loops[i].diameter - loops[j].diameter) / 2, static_cast<int>(i),
                         static_cast<int>(j), outline});
    }
  std::ranges::sort(pairs, {}, [](const RingSides& pair) { return std::tuple(pair.width, pair.i, pair.j); });
  const auto are_joined = [&](const std::vector<int>& ring) {
    std::vector<BoundaryLoop> members;
    int edges = 0;
    for (const int k : ring) {
      members.push_back(loops[static_cast<std::size_t>(k)]);
      edges += members.back().edges();
    }
    return ring_between(model, members, coarse, cancel) ||
           (ring.size() > 2 && edges <= few_edges && ring_between(model, members, 1, cancel));
  };
  std::vector<std::vector<int>> rings;
  std::set<int> seen;
  for (const std::vector<int>& group : groups_with_bores(ends, pairs)) {
    if (std::ranges::any_of(group, [&](int k) { return seen.contains(k); }) || !are_joined(group)) continue;
    seen.insert(group.begin(), group.end());
    rings.push_back(group);
  }
  for (const RingSides& pair : pairs) {
    const bool first_of_i = seen.insert(pair.i).second, first_of_j = seen.insert(pair.j).second;
    if (first_of_i && first_of_j && are_joined({pair.i, pair.j})) rings.push_back({pair.i, pair.j});
  }
  return rings;
}

std::vector<std::vector<int>> find_missing_faces(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                                 const CancelToken& cancel) {
  std::vector<std::vector<int>> faces;
  for (std::vector<int>& ring : find_rings(model, loops, cancel)) {
    std::vector<BoundaryLoop> members;
    for (const int k : ring) members.push_back(loops[static_cast<std::size_t>(k)]);
    const std::vector<BridgeEnd> ends = ends_of(model, members);
    const std::optional<std::size_t> outline = outline_of_a_ring(ends);
    if (!outline || !lie_in_one_plane(ends) || !find_opposed_loops(model, members).empty()) continue;
    std::swap(ring.front(), ring[*outline]);
    faces.push_back(std::move(ring));
  }
  return faces;
}

}  // namespace loopmend
