// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/hand_bridge.h"

#include "core/error.h"
#include "mesh/boundary_loops.h"
#include "mesh/loop_facing.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace loopmend {

namespace {

/// A boundary edge as it runs along its loop, the hole to its left.
struct BridgeSeat {
  int loop = 0;
  int from = 0, to = 0;           ///< soup points
  Vec3 leaving_from, leaving_to;  ///< unit, tangent to the surface, out of it
};

std::vector<BridgeSeat> seats_at(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, int point) {
  std::vector<BridgeSeat> seats;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    std::optional<LoopFacing> facing;
    const std::vector<int>& vertices = loops[l].vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (model.soup_vertex[vertices[i]] != point) continue;
      if (!facing) facing = loop_facing(model, loops[l]);
      const std::size_t next = (i + 1) % vertices.size();
      seats.push_back({static_cast<int>(l), point, model.soup_vertex[vertices[next]], facing->conormals[i],
                       facing->conormals[next]});
    }
  }
  if (seats.empty()) throw InvalidArgument(say("vertex %1 lies on no boundary loop", point));
  return seats;
}

/// From p, which it leaves along `leaving`, to q, which it reaches against `arriving` (cubic Hermite).
Vec3 cubic(const Vec3& p, const Vec3& leaving, const Vec3& q, const Vec3& arriving, double t) {
  const double length = (q - p).norm(), s = 1 - t;
  return s * s * (1 + 2 * t) * p + t * t * (1 + 2 * s) * q + length * (s * s * t * leaving + s * t * t * arriving);
}

}  // namespace

TriangleSoup with_bridge(const SurfaceModel& model, int a, int b) {
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  const std::vector<BridgeSeat> seats_a = seats_at(model, loops, a), seats_b = seats_at(model, loops, b);
  BridgeSeat s = seats_a.front(), t = seats_b.front();
  for (const BridgeSeat& first : seats_a)  // where loops touch, both ends on one loop if that can be
    for (const BridgeSeat& second : seats_b)
      if (first.loop == second.loop) s = first, t = second;
  if (s.from == t.from || s.from == t.to || s.to == t.from || s.to == t.to)
    throw InvalidArgument(
        say("the boundary edges that begin at vertices %1 and %2 have a vertex in common: a bridge needs two that lie "
            "apart",
            a, b));
  TriangleSoup soup = model.soup;
  const auto at = [&](int v) { return Vec3(model.soup.points[v]); };
  const double edge = ((at(s.to) - at(s.from)).norm() + (at(t.to) - at(t.from)).norm()) / 2;
  const double span = ((at(t.from) - at(s.to)).norm() + (at(t.to) - at(s.from)).norm()) / 2;
  const int rows = std::clamp(static_cast<int>(std::lround(span / std::max(edge, 1e-300))), 2, 10000);
  // Two rails: from the end of the first edge to the begin of the second, and from its begin to the other's end.
  std::vector<int> right{s.to}, left{s.from};
  /// Between two points of the soup, at the share `way` from the first.
  const auto add = [&](const Vec3& p, int first, int second, double way) {
    soup.points.push_back(p);
    if (!soup.colors.empty()) {
      Color mixed;
      for (std::size_t k = 0; k < mixed.size(); ++k)
        mixed[k] =
            static_cast<unsigned char>(std::lround((1 - way) * soup.colors[first][k] + way * soup.colors[second][k]));
      soup.colors.push_back(mixed);
    }
    return static_cast<int>(soup.points.size()) - 1;
  };
  for (int r = 1; r < rows; ++r) {
    const double way = static_cast<double>(r) / rows;
    right.push_back(add(cubic(at(s.to), s.leaving_to, at(t.from), t.leaving_from, way), s.to, t.from, way));
    left.push_back(add(cubic(at(s.from), s.leaving_from, at(t.to), t.leaving_to, way), s.from, t.to, way));
  }
  right.push_back(t.from);
  left.push_back(t.to);
  for (int r = 0; r < rows; ++r) {
    soup.triangles.push_back({left[r], right[r], right[r + 1]});
    soup.triangles.push_back({left[r], right[r + 1], left[r + 1]});
  }
  return soup;
}

}  // namespace loopmend
