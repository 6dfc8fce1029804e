// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/wall_bridge.h"

#include "core/quantile.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

constexpr double alike = 0.5;        ///< cosine of the angle between the directions in which both surfaces end
constexpr double square = 0.5;       ///< cosine of the angle between such a direction and the way to the other loop
constexpr double of_a_tube = 0.6;    ///< norm of BridgeEnd::onward from which a loop is the end of a tube
constexpr double other_share = 0.1;  ///< of a loop where it may lie otherwise
constexpr std::size_t most_places = 128;  ///< of a loop that are looked at
constexpr int most_rows_of_a_wall = 1000;

struct NearestPlace {
  Vec3 point = Vec3::Zero(), conormal = Vec3::Zero();
};

NearestPlace nearest_place(const BridgeEnd& end, const Vec3& p) {
  NearestPlace nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < end.points.size(); ++k) {
    const std::size_t next = (k + 1) % end.points.size();
    const Vec3 &q = end.points[k], along = end.points[next] - q;
    const double length2 = along.squaredNorm();
    const double t = length2 > 0 ? std::clamp((p - q).dot(along) / length2, 0.0, 1.0) : 0;
    const Vec3 place = q + t * along;
    if (!((place - p).squaredNorm() < least)) continue;
    least = (place - p).squaredNorm();
    nearest = {place, (1 - t) * end.conormals[k] + t * end.conormals[next]};
  }
  return nearest;
}

bool runs_beside(const BridgeEnd& end, const BridgeEnd& other) {
  const std::size_t stride = std::max<std::size_t>(1, end.points.size() / most_places);
  std::size_t places = 0, others = 0;
  for (std::size_t k = 0; k < end.points.size(); k += stride, ++places) {
    const NearestPlace nearest = nearest_place(other, end.points[k]);
    const Vec3 way = nearest.point - end.points[k];
    const double length = way.norm();
    const bool is_beside = length > 0 && end.conormals[k].dot(nearest.conormal.normalized()) > alike &&
                           std::abs(way.dot(end.conormals[k])) < square * length;
    others += !is_beside;
  }
  return static_cast<double>(others) <= other_share * static_cast<double>(places);
}

/// Of the strip's triangles: the vertices of the cross edges in rows, made when they are asked for.
class Rows {
 public:
  Rows(const BridgeEnd& a, const BridgeEnd& b, int count)
      : first_of_b_(static_cast<int>(a.points.size())),
        count_(count) {
    points = a.points;
    points.insert(points.end(), b.points.begin(), b.points.end());
  }

  /// On the cross edge from `foot` to `apex`, `row` rows from the foot.
  int at(int foot, int apex, int row) {
    if (row == 0) return foot;
    if (row == count_) return apex;
    const bool from_a = foot < first_of_b_;
    const auto [found, is_new] =
        first_.try_emplace(from_a ? std::pair(foot, apex) : std::pair(apex, foot), static_cast<int>(points.size()));
    const auto [first, last] = found->first;
    for (int r = 1; is_new && r < count_; ++r) {
      const double way = static_cast<double>(r) / count_;
      points.push_back((1 - way) * points[static_cast<std::size_t>(first)] +
                       way * points[static_cast<std::size_t>(last)]);
    }
    return found->second + (from_a ? row : count_ - row) - 1;
  }

  bool is_of_a(int vertex) const { return vertex < first_of_b_; }

  Points points;

 private:
  int first_of_b_, count_;
  std::map<std::pair<int, int>, int> first_;
};

}  // namespace

bool are_sides_of_a_plate(const BridgeEnd& a, const BridgeEnd& b) {
  if (a.onward.norm() > of_a_tube || b.onward.norm() > of_a_tube) return false;
  return std::abs(a.axis.dot(b.axis)) > alike && runs_beside(a, b) && runs_beside(b, a);
}

bool are_outlines_of_a_plate(const BoundaryLoop& a, const BoundaryLoop& b, const BridgeEnd& end_a,
                             const BridgeEnd& end_b) {
  return a.kind == LoopKind::outer_rim && b.kind == LoopKind::outer_rim && are_sides_of_a_plate(end_a, end_b);
}

namespace {

/// Whether hole loops are the rims of a bore through a plate: they lie on each other, not far apart, and both surfaces look away from
/// the other.
bool are_rims_of_a_bore(const BoundaryLoop& a, const BoundaryLoop& b, const BridgeEnd& end_a, const BridgeEnd& end_b) {
  constexpr double longest = 0.5;  // in diameters; longer ones may be two holes
  const Vec3 way = b.center - a.center;
  return a.kind == LoopKind::hole && b.kind == LoopKind::hole &&
         way.norm() < longest * std::min(a.diameter, b.diameter) && end_a.axis.dot(way) < 0 &&
         end_b.axis.dot(way) > 0 && are_sides_of_a_plate(end_a, end_b);
}

}  // namespace

bool have_a_wall_between(const BoundaryLoop& a, const BoundaryLoop& b, const BridgeEnd& end_a, const BridgeEnd& end_b) {
  return are_outlines_of_a_plate(a, b, end_a, end_b) || are_rims_of_a_bore(a, b, end_a, end_b);
}

SweptBridge bridge_by_wall(const BridgeEnd& a, const BridgeEnd& b, double step) {
  const Triangles strip = bridge_by_strip(a.points, b.points);
  if (strip.empty()) return {};
  std::vector<double> widths;
  for (const Vec3& p : a.points) widths.push_back((nearest_place(b, p).point - p).norm());
  const int count = static_cast<int>(std::clamp(std::round(median(widths) / step), 1.0, double{most_rows_of_a_wall}));
  Rows rows(a, b, count);
  SweptBridge wall;
  for (Triangle t : strip) {
    // Turned so that its apex, alone on its loop, comes last.
    while (rows.is_of_a(t[0]) != rows.is_of_a(t[1])) std::rotate(t.begin(), t.begin() + 1, t.end());
    for (int r = 0; r + 1 < count; ++r) {
      const int p = rows.at(t[0], t[2], r), q = rows.at(t[1], t[2], r);
      const int p_next = rows.at(t[0], t[2], r + 1), q_next = rows.at(t[1], t[2], r + 1);
      wall.triangles.push_back({p, q, q_next});
      wall.triangles.push_back({p, q_next, p_next});
    }
    wall.triangles.push_back({rows.at(t[0], t[2], count - 1), rows.at(t[1], t[2], count - 1), t[2]});
  }
  wall.points = std::move(rows.points);
  return wall;
}

}  // namespace loopmend
