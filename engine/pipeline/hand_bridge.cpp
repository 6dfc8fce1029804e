// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/hand_bridge.h"

#include "core/error.h"
#include "filling/tangent_cubic.h"
#include "mesh/boundary_loops.h"
#include "mesh/loop_facing.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

constexpr int averaged_edges = 3;  ///< to both sides of an end, for its tangent plane
constexpr int most_shifts = 2;     ///< boundary edges by which an end may move aside
constexpr int seen_edges = 8;      ///< to both sides of an end, in which teeth of the boundary are looked for
constexpr double narrowed = 0.7;   ///< width of a strip in that of its ends

/// A vertex of a loop that runs with the hole to its left, and the vertices on both sides of it.
struct BridgeEnd {
  int before = 0, at = 0, after = 0;  ///< soup points
  Vec3 normal;                        ///< unit, of the surface
  Vec3 onward;                        ///< unit, tangent to the surface, out of it and half towards the other end
};

Vec3 unit_or_zero(const Vec3& v) { return v.norm() > 0 ? Vec3(v.normalized()) : Vec3::Zero(); }

Vec3 without(const Vec3& v, const Vec3& unit) { return v - unit.dot(v) * unit; }

/// A loop, and what a strip finds at its vertices.
class BridgeLoop {
 public:
  BridgeLoop(const SurfaceModel& model, const BoundaryLoop& loop)
      : model_(model),
        loop_(loop),
        facing_(loop_facing(model, loop)) {}

  /// @param towards  from the end to the strip's other one
  BridgeEnd end_at(int vertex, const Vec3& towards) const {
    Vec3 normal = Vec3::Zero(), onward = Vec3::Zero();
    for (int k = vertex - averaged_edges; k <= vertex + averaged_edges; ++k) {
      for (const auto f : model_.mesh.vf_range(TriMesh::VertexHandle(loop_.vertices[wrapped(k)])))
        normal += model_.mesh.calc_normal(f);
      onward += facing_.conormals[wrapped(k)];
    }
    normal = unit_or_zero(normal);
    onward = unit_or_zero(without(onward, normal));
    const Vec3 both = onward + unit_or_zero(without(towards, normal));
    if (both.norm() > 1e-3) onward = both.normalized();
    return {soup_point(vertex - 1), soup_point(vertex), soup_point(vertex + 1), normal, onward};
  }

  /// The end at this vertex, or at the nearest one that has no tooth of the boundary before it.
  BridgeEnd free_end_at(int vertex, const Vec3& towards) const {
    BridgeEnd best = end_at(vertex, towards);
    double least = tooth_before(vertex, best);
    for (int shift = 1; shift <= most_shifts && least > 0; ++shift)
      for (const int to : {vertex + shift, vertex - shift}) {
        const BridgeEnd end = end_at(to, towards);
        const double tooth = tooth_before(to, end);
        if (tooth >= least) continue;
        least = tooth;
        best = end;
      }
    return best;
  }

 private:
  std::size_t wrapped(int vertex) const {
    const int n = loop_.edges();
    return static_cast<std::size_t>((vertex % n + n) % n);
  }
  int soup_point(int vertex) const { return model_.soup_vertex[loop_.vertices[wrapped(vertex)]]; }
  Vec3 point(int vertex) const { return model_.mesh.point(TriMesh::VertexHandle(loop_.vertices[wrapped(vertex)])); }

  /// How far the boundary stands out before the strip that begins here, in widths of it; 0 below a quarter.
  double tooth_before(int vertex, const BridgeEnd& end) const {
    const Vec3 p = point(vertex), aside = end.normal.cross(end.onward);
    const double width = ((point(vertex - 1) - p).norm() + (point(vertex + 1) - p).norm()) / 2;
    double farthest = 0;
    const int reach = std::min(seen_edges, loop_.edges() / 4);
    for (int k = -reach; k <= reach; ++k) {
      if (std::abs(k) < 2) continue;
      const Vec3 d = point(vertex + k) - p;
      if (std::abs(aside.dot(d)) < 1.2 * width) farthest = std::max(farthest, end.onward.dot(d));
    }
    return farthest > width / 4 ? farthest / width : 0;
  }

  const SurfaceModel& model_;
  const BoundaryLoop& loop_;
  LoopFacing facing_;
};

/// What is known of the surface between the ends of a strip: two spheres, each through one end with its normal, that pass into each
/// other. Both have the curvature by which the normal turns from end to end. On a sphere it is that sphere.
class BetweenEnds {
 public:
  BetweenEnds(const Vec3& p, const Vec3& normal_p, const Vec3& q, const Vec3& normal_q)
      : p_(p),
        q_(q),
        normal_p_(normal_p),
        normal_q_(normal_q),
        curvature_((normal_q - normal_p).dot(q - p) / std::max((q - p).squaredNorm(), 1e-300)) {}

  /// Near x. @param share  of the way from p to q
  Vec3 normal(const Vec3& x, double share) const {
    const double of_q = weight(share);
    return unit_or_zero((1 - of_q) * (normal_p_ + curvature_ * (x - p_)) + of_q * (normal_q_ + curvature_ * (x - q_)));
  }
  /// Where x comes to lie on the surface.
  Vec3 laid(const Vec3& x, double share) const {
    const double of_q = weight(share);
    const double height = (1 - of_q) * (normal_p_.dot(x - p_) + curvature_ / 2 * (x - p_).squaredNorm()) +
                          of_q * (normal_q_.dot(x - q_) + curvature_ / 2 * (x - q_).squaredNorm());
    return x - height * normal(x, share);
  }

 private:
  /// Of q: its slope is 0 at both ends, so that a curve that is tangent there stays so.
  static double weight(double share) { return share * share * (3 - 2 * share); }

  Vec3 p_, q_, normal_p_, normal_q_;
  double curvature_;
};

bool lie_apart(const BridgeEnd& s, const BridgeEnd& t) {
  for (const int end : {s.before, s.at, s.after})
    if (end == t.before || end == t.at || end == t.after) return false;
  return true;
}

}  // namespace

BridgeMaker::BridgeMaker(const SurfaceModel& model) : model_(model), loops_(find_boundary_loops(model)) {
  for (std::size_t l = 0; l < loops_.size(); ++l)
    for (int k = 0; k < loops_[l].edges(); ++k)
      places_.emplace(model.soup_vertex[static_cast<std::size_t>(loops_[l].vertices[static_cast<std::size_t>(k)])],
                      Place{l, k});
}

std::vector<BridgeMaker::Place> BridgeMaker::places_of(int point) const {
  std::vector<Place> places;
  for (auto [it, end] = places_.equal_range(point); it != end; ++it) places.push_back(it->second);
  if (places.empty()) throw InvalidArgument(say("vertex %1 lies on no boundary loop", point));
  return places;
}

BridgeStrip BridgeMaker::strip(int a, int b) const {
  const std::vector<Place> places_a = places_of(a), places_b = places_of(b);
  Place from = places_a.front(), to = places_b.front();
  for (const Place& first : places_a)  // where loops touch, both ends on one loop if that can be
    for (const Place& second : places_b)
      if (first.loop == second.loop) from = first, to = second;
  const auto at = [&](int v) { return Vec3(model_.soup.points[v]); };
  const Vec3 across = at(b) - at(a);
  const BridgeLoop loop_a(model_, loops_[from.loop]), loop_b(model_, loops_[to.loop]);
  BridgeEnd s = loop_a.free_end_at(from.vertex, across), t = loop_b.free_end_at(to.vertex, -across);
  if (!lie_apart(s, t)) s = loop_a.end_at(from.vertex, across), t = loop_b.end_at(to.vertex, -across);
  if (!lie_apart(s, t))
    throw InvalidArgument(
        say("the boundary edges at vertices %1 and %2 have a vertex in common: a bridge needs two ends that lie apart",
            a, b));
  BridgeStrip made;
  made.from = s.at;
  made.to = t.at;
  const TangentCubic course(at(s.at), s.onward, at(t.at), -t.onward);
  const BetweenEnds surface(at(s.at), s.normal, at(t.at), t.normal);
  // Towards the left rail, from the middle: at both ends, and of the strip between.
  const Vec3 left_of_s = at(s.before) - at(s.at), left_of_t = at(t.after) - at(t.at);
  const Vec3 right_of_s = at(s.after) - at(s.at), right_of_t = at(t.before) - at(t.at);
  const double width = narrowed * (left_of_s.norm() + left_of_t.norm() + right_of_s.norm() + right_of_t.norm()) / 4;
  const int rows = std::clamp(static_cast<int>(std::lround(course.length() / std::max(width, 1e-300))), 2, 10000);
  /// Between two points of the soup, at the share `share` from the first.
  const auto add = [&](const Vec3& p, int first, int second, double share) {
    made.points.push_back(p);
    if (const std::vector<Color>& colors = model_.soup.colors; !colors.empty()) {
      Color mixed;
      for (std::size_t k = 0; k < mixed.size(); ++k)
        mixed[k] = static_cast<unsigned char>(std::lround((1 - share) * colors[first][k] + share * colors[second][k]));
      made.colors.push_back(mixed);
    }
    return static_cast<int>(model_.soup.points.size() + made.points.size()) - 1;
  };
  made.rows.push_back({s.before, s.at, s.after});
  for (int r = 1; r < rows; ++r) {
    const double share = static_cast<double>(r) / rows;
    // The boundary's own edges count in the first and the last row only.
    const double of_s = std::max(0.0, 1 - r / 2.0), of_t = std::max(0.0, 1 - (rows - r) / 2.0);
    const Vec3 p = surface.laid(course.at(share), share);
    const Vec3 side =
        (1 - of_s - of_t) * width * unit_or_zero(surface.normal(p, share).cross(course.derivative(share)));
    made.rows.push_back({add(p + side + of_s * left_of_s + of_t * left_of_t, s.before, t.after, share),
                         add(p, s.at, t.at, share),
                         add(p - side + of_s * right_of_s + of_t * right_of_t, s.after, t.before, share)});
  }
  made.rows.push_back({t.after, t.at, t.before});
  for (std::size_t r = 0; r + 1 < made.rows.size(); ++r) {
    const auto [left, middle, right] = made.rows[r];
    const auto [next_left, next_middle, next_right] = made.rows[r + 1];
    made.triangles.push_back({left, middle, next_middle});
    made.triangles.push_back({left, next_middle, next_left});
    made.triangles.push_back({middle, right, next_middle});
    made.triangles.push_back({right, next_right, next_middle});
  }
  return made;
}

void append(TriangleSoup& soup, const BridgeStrip& strip, std::size_t surface_points) {
  const auto shift = static_cast<int>(soup.points.size() - surface_points);
  soup.points.insert(soup.points.end(), strip.points.begin(), strip.points.end());
  soup.colors.insert(soup.colors.end(), strip.colors.begin(), strip.colors.end());
  for (Triangle t : strip.triangles) {
    for (int& v : t)
      if (v >= static_cast<int>(surface_points)) v += shift;
    soup.triangles.push_back(t);
  }
}

TriangleSoup with_bridge(const SurfaceModel& model, int a, int b) {
  TriangleSoup soup = model.soup;
  append(soup, BridgeMaker(model).strip(a, b), soup.points.size());
  return soup;
}

}  // namespace loopmend
