// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/plane_cut.h"

#include "core/error.h"
#include "mesh/select_triangles.h"
#include "mesh/triangulate_polygon.h"
#include "repair/divided_faces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

using CutEdge = std::pair<int, int>;  ///< directed
using Curve = std::vector<int>;       ///< closed, of points of the section

std::string in_six_digits(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", x);
  return text.data();
}

/// The soup without what lies before the plane, and the edges at which it was cut.
class Halves {
 public:
  Halves(const TriangleSoup& soup, const CutPlane& plane) : soup_(soup), plane_(plane) {
    made_.points = soup.points;
    measure();
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) add(static_cast<int>(f));
    made_.triangles.insert(made_.triangles.end(), parts_.begin(), parts_.end());
    copy_divided_rows(soup, divided_, made_);
  }

  TriangleSoup take_soup() { return std::move(made_); }
  const PlaneCutCounts& counts() const { return counts_; }

  /// Directed as the new faces have them: those that a kept face has lost its neighbor at.
  std::vector<CutEdge> edges() const {
    std::vector<CutEdge> edges;
    for (const auto& [edge, count] : kept_edges_) {
      const CutEdge back{edge.second, edge.first};
      const int open = count - count_of(kept_edges_, back);
      for (int k = std::min(open, count_of(removed_edges_, back)); k > 0; --k) edges.push_back(back);
    }
    std::sort(edges.begin(), edges.end());
    return edges;
  }

 private:
  using Counts = std::map<CutEdge, int>;
  static int count_of(const Counts& counts, const CutEdge& edge) {
    const auto found = counts.find(edge);
    return found == counts.end() ? 0 : found->second;
  }

  double height(int v) const { return (soup_.points[v] - plane_.point).dot(plane_.normal); }

  /// @throws InvalidArgument where nothing would be cut.
  void measure() {
    constexpr double share_in_plane = 1e-7;
    Eigen::AlignedBox3d box;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Triangle& t : soup_.triangles)
      for (int v : t) {
        box.extend(soup_.points[v]);
        low = std::min(low, height(v));
        high = std::max(high, height(v));
      }
    const double in_plane = box.isEmpty() ? 0 : share_in_plane * box.diagonal().norm();
    const auto message = [&](const Message& what) {
      return say("%1: along its normal, the surface lies from %2 to %3 of the plane: choose a point between", what,
                 in_six_digits(low), in_six_digits(high));
    };
    if (!(high > in_plane)) throw InvalidArgument(message(say("the cutting plane misses the surface")));
    if (!(low < -in_plane)) throw InvalidArgument(message(say("the cutting plane would remove the whole surface")));
    side_.reserve(soup_.points.size());
    for (std::size_t v = 0; v < soup_.points.size(); ++v) {
      const double h = height(static_cast<int>(v));
      side_.push_back(static_cast<signed char>((h > in_plane) - (h < -in_plane)));
    }
  }

  void add(int face) {
    const Triangle& t = soup_.triangles[face];
    const auto count = [&](int side) {
      return std::count_if(t.begin(), t.end(), [&](int v) { return side_[v] == side; });
    };
    const auto before = count(1), behind = count(-1);
    if (before > 0 && behind > 0) return divide(face);
    const Vec3 &a = soup_.points[t[0]], &b = soup_.points[t[1]], &c = soup_.points[t[2]];
    // A face in the plane that looks along the normal bounds what lies behind the plane.
    const bool is_kept = before == 0 && (behind > 0 || (b - a).cross(c - a).dot(plane_.normal) > 0);
    for (std::size_t k = 0; k < 3; ++k)
      if (const CutEdge edge{t[k], t[(k + 1) % 3]}; side_[edge.first] == 0 && side_[edge.second] == 0)
        ++(is_kept ? kept_edges_ : removed_edges_)[edge];
    if (!is_kept) {
      ++counts_.removed_faces;
      return;
    }
    made_.triangles.push_back(t);
    divided_.kept.push_back(face);
  }

  void divide(int face) {
    const Triangle& t = soup_.triangles[face];
    std::vector<int> polygon, in_plane;
    for (std::size_t k = 0; k < 3; ++k) {
      const int v = t[k], next = t[(k + 1) % 3];
      if (side_[v] <= 0) polygon.push_back(v);
      if (side_[v] == 0) in_plane.push_back(v);
      if (side_[v] * side_[next] >= 0) continue;
      polygon.push_back(point_on(v, next, face));
      in_plane.push_back(polygon.back());
    }
    if (polygon.size() == 4) {  // by the shorter diagonal
      const auto length = [&](std::size_t i, std::size_t k) {
        return (made_.points[polygon[i]] - made_.points[polygon[k]]).squaredNorm();
      };
      if (length(1, 3) < length(0, 2)) std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
    }
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      parts_.push_back({polygon[0], polygon[k - 1], polygon[k]});
      divided_.part_of.push_back(face);
    }
    ++counts_.divided_faces;
    // Along the polygon, the edge in the plane leads from one of the two to the other.
    const auto place = std::find(polygon.begin(), polygon.end(), in_plane[0]) - polygon.begin();
    const bool is_next = polygon[(static_cast<std::size_t>(place) + 1) % polygon.size()] == in_plane[1];
    const CutEdge edge = is_next ? CutEdge{in_plane[0], in_plane[1]} : CutEdge{in_plane[1], in_plane[0]};
    ++kept_edges_[edge];
    ++removed_edges_[{edge.second, edge.first}];
  }

  /// The point of an edge in the plane, the same for all faces at it.
  int point_on(int v, int w, int face) {
    const auto [a, b] = std::minmax(v, w);
    const auto [entry, is_new] = point_of_edge_.try_emplace({a, b}, static_cast<int>(made_.points.size()));
    if (!is_new) return entry->second;
    const double from = height(a), to = height(b);
    Vec3 p = soup_.points[a] + from / (from - to) * (soup_.points[b] - soup_.points[a]);
    p -= (p - plane_.point).dot(plane_.normal) * plane_.normal;
    made_.points.push_back(p);
    divided_.beneath.push_back(face);
    return entry->second;
  }

  const TriangleSoup& soup_;
  const CutPlane& plane_;
  TriangleSoup made_;
  Triangles parts_;
  DividedFaces divided_;
  PlaneCutCounts counts_;
  std::vector<signed char> side_;  ///< of each point: 1 before the plane, -1 behind it, 0 in it
  std::map<CutEdge, int> point_of_edge_;
  Counts kept_edges_, removed_edges_;  ///< in the plane
};

/// Sorts edges into closed curves, none of which passes a point twice.
class Curves {
 public:
  explicit Curves(const std::vector<CutEdge>& edges) {
    for (const CutEdge& edge : edges) {
      join(edge.first, edge.second);
      next_[edge.first].push_back(edge.second);
      ++balance_[edge.first];
      --balance_[edge.second];
    }
    std::set<int> open_parts, parts;
    for (const auto& [v, balance] : balance_) {
      parts.insert(root(v));
      if (balance != 0) open_parts.insert(root(v));
    }
    open = open_parts.size();
    for (auto& [v, next] : next_)
      while (!next.empty() && !open_parts.contains(root(v))) walk(v);
  }

  std::vector<Curve> closed;
  std::size_t open = 0;

 private:
  int root(int v) {
    const auto [entry, is_new] = root_.try_emplace(v, v);
    return entry->second == v ? v : entry->second = root(entry->second);
  }
  void join(int v, int w) { root_[root(v)] = root(w); }

  void walk(int start) {
    Curve path{start};
    for (;;) {
      std::vector<int>& next = next_[path.back()];
      if (next.empty()) return;
      const int v = next.back();
      next.pop_back();
      const auto before = std::find(path.begin(), path.end(), v);
      if (before == path.end()) {
        path.push_back(v);
        continue;
      }
      closed.emplace_back(before, path.end());
      path.erase(before + 1, path.end());
      if (path.size() == 1 && next_[v].empty()) return;
    }
  }

  std::map<int, std::vector<int>> next_;
  std::map<int, int> balance_, root_;
};

/// The curves of a section, seen against the normal of the plane.
class Section {
 public:
  Section(const Points& points, const Vec3& normal, std::vector<Curve> curves)
      : points_(points),
        first_(normal.unitOrthogonal()),
        second_(normal.cross(first_)),
        curves_(std::move(curves)) {
    for (const Curve& curve : curves_) areas_.push_back(area(curve));
    // Where the surface looks inward, its outlines run the other way round.
    if (std::accumulate(areas_.begin(), areas_.end(), 0.0) < 0)
      for (double& a : areas_) a = -a;
  }

  /// Outlines, each with the curves within it.
  std::vector<std::vector<Curve>> groups() const {
    std::map<std::size_t, std::vector<Curve>> of_outline;
    for (std::size_t k = 0; k < curves_.size(); ++k) of_outline[outline_of(k)];
    for (std::size_t k = 0; k < curves_.size(); ++k) {
      std::vector<Curve>& group = of_outline[outline_of(k)];
      group.insert(outline_of(k) == k ? group.begin() : group.end(), curves_[k]);
    }
    std::vector<std::vector<Curve>> all;
    for (auto& [outline, group] : of_outline) all.push_back(std::move(group));
    return all;
  }

 private:
  Eigen::Vector2d flat(int v) const {
    const Vec3 p = points_[v] - points_[curves_.front().front()];
    return {p.dot(first_), p.dot(second_)};
  }

  double area(const Curve& curve) const {
    double sum = 0;
    for (std::size_t k = 0; k < curve.size(); ++k) {
      const Eigen::Vector2d a = flat(curve[k]), b = flat(curve[(k + 1) % curve.size()]);
      sum += (a.x() * b.y() - a.y() * b.x()) / 2;
    }
    return sum;
  }

  bool holds(const Curve& curve, const Curve& other) const {
    const auto apart = std::find_if(other.begin(), other.end(),
                                    [&](int v) { return std::find(curve.begin(), curve.end(), v) == curve.end(); });
    if (apart == other.end()) return false;
    const Eigen::Vector2d p = flat(*apart);
    bool is_within = false;
    for (std::size_t k = 0; k < curve.size(); ++k) {
      const Eigen::Vector2d a = flat(curve[k]), b = flat(curve[(k + 1) % curve.size()]);
      if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
        is_within = !is_within;
    }
    return is_within;
  }

  /// The smallest outline around a curve that runs the other way round; else itself.
  std::size_t outline_of(std::size_t k) const {
    std::size_t outline = k;
    if (areas_[k] >= 0) return k;
    for (std::size_t other = 0; other < curves_.size(); ++other)
      if (areas_[other] > -areas_[k] && (outline == k || areas_[other] < areas_[outline]) &&
          holds(curves_[other], curves_[k]))
        outline = other;
    return outline;
  }

  const Points& points_;
  Vec3 first_, second_;
  std::vector<Curve> curves_;
  std::vector<double> areas_;  ///< above 0 for outlines
};

}  // namespace

CutPlane make_cut_plane(const Vec3& point, const Vec3& normal) {
  const double length = normal.norm();
  if (!point.allFinite() || !std::isfinite(length) || !(length > 0))
    throw InvalidArgument(say("a cutting plane needs a point and a normal that is not 0"));
  return {point, normal / length};
}

CutSurface cut_by_plane(const TriangleSoup& soup, const CutPlane& plane) {
  Halves halves(soup, plane);
  Curves curves(halves.edges());
  CutSurface result;
  result.counts = halves.counts();
  result.counts.left_open = curves.open;
  const TriangleSoup whole = halves.take_soup();
  TriangleSelection kept = select_triangles(whole, std::vector<char>(whole.triangles.size(), 1));
  result.soup = std::move(kept.soup);
  if (curves.closed.empty()) return result;
  for (Curve& curve : curves.closed)
    for (int& v : curve) v = kept.point_number[v];
  for (const std::vector<Curve>& group : Section(result.soup.points, plane.normal, curves.closed).groups()) {
    const Triangles faces = triangulate_seen_flat(result.soup.points, group);
    (faces.empty() ? result.counts.left_open : result.counts.closed) += group.size();
    result.counts.new_faces += faces.size();
    result.soup.triangles.insert(result.soup.triangles.end(), faces.begin(), faces.end());
  }
  return result;
}

}  // namespace loopmend
