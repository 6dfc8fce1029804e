// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/join_tiles.h"

#include "core/error.h"
#include "mesh/boundary_loops.h"
#include "mesh/flat_view.h"
#include "mesh/pieces.h"
#include "mesh/self_intersections.h"
#include "mesh/surface_tree.h"
#include "pipeline/hand_bridge.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

constexpr double looks_alike = 0.7;         ///< cosine of the angle between the normals
constexpr double beside = 0.5;              ///< from the outline of the larger part, in edges of the smaller one
constexpr std::size_t fewest_faces = 8;     ///< of a tile; less is a scrap
constexpr double small_fragment = 0.01;     ///< of the faces of a part
constexpr double fragment_distance = 4;     ///< in those of the faces
constexpr std::size_t fewest_in_a_row = 8;  ///< vertices, for a strip at either end
constexpr std::size_t most_tries = 8;       ///< of each strip
constexpr std::ptrdiff_t from_corner = 2;   ///< vertices from the end of a row to the middle of its strip

std::size_t at(int v) { return static_cast<std::size_t>(v); }

Vec3 doubled_area(const Points& points, const Triangle& t) {
  return (points[at(t[1])] - points[at(t[0])]).cross(points[at(t[2])] - points[at(t[0])]);
}

struct Part {
  std::vector<int> faces;
  double area = 0;
  Eigen::AlignedBox3d box;
  bool is_open = false;
};

Eigen::AlignedBox3d box_of(const Points& points, const Triangle& t) {
  Eigen::AlignedBox3d box(points[at(t[0])]);
  return box.extend(points[at(t[1])]).extend(points[at(t[2])]);
}

class Overlap {
 public:
  Overlap(const SurfaceModel& model, double distance)
      : points_(model.soup.points),
        triangles_(model.soup.triangles),
        distance_(distance),
        kept_(triangles_.size(), 1),
        normals_(points_.size(), Vec3::Zero()),
        edges_(points_.size(), 0),
        at_boundary_(points_.size(), 0),
        over_(points_.size(), -1),
        rank_(triangles_.size(), 0),
        index_(points_, triangles_, triangles_outside(model)) {
    int count = 0;
    const std::vector<int> part_of = parts_of_points(model, count);
    parts_.resize(at(count));
    const auto part_at = [&](int v) -> Part& { return parts_[at(part_of[at(v)])]; };
    for_each_soup_triangle(model, [&](int f) { add(f, part_at(triangles_[at(f)][0])); });
    for (const BoundaryLoop& loop : find_boundary_loops(model))
      for (const int w : loop.vertices) {
        const int v = model.soup_vertex[at(w)];
        at_boundary_[at(v)] = 1;
        part_at(v).is_open = true;
      }
    std::ranges::stable_sort(parts_, std::ranges::greater(), &Part::area);
    for (std::size_t k = 0; k < parts_.size(); ++k)
      for (const int f : parts_[k].faces) rank_[at(f)] = k;
  }

  /// One for each triangle: 0 where it has to go.
  std::vector<char> kept() {
    for (std::size_t k = 1; k < parts_.size(); ++k)
      if (parts_[k].is_open && parts_[k].faces.size() >= fewest_faces) cut_back(k);
    return kept_;
  }
  /// After kept(): of which no face is kept.
  std::size_t removed_parts() const {
    return static_cast<std::size_t>(std::ranges::count_if(parts_, [&](const Part& part) {
      return std::ranges::none_of(part.faces, [&](int f) { return kept_[at(f)] != 0; });
    }));
  }

 private:
  void add(int f, Part& part) {
    const Triangle& t = triangles_[at(f)];
    const Vec3 area = doubled_area(points_, t);
    part.faces.push_back(f);
    part.area += area.norm();
    part.box.extend(box_of(points_, t));
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t v = at(t[c]), w = at(t[(c + 1) % 3]);
      normals_[v] += area;
      const double length = (points_[w] - points_[v]).norm();
      edges_[v] = std::max(edges_[v], length);
      edges_[w] = std::max(edges_[w], length);
    }
  }

  /// Whether the vertex lies over these triangles, no further than that, or so far beside them.
  bool lies_over(int v, const SurfaceTree& tree, const Triangles& below, double distance, double beside_length,
                 int* triangle = nullptr) const {
    const SurfacePoint foot = tree.closest(points_[at(v)]);
    if (foot.triangle < 0) return false;
    if (triangle) *triangle = foot.triangle;
    const Vec3 normal = doubled_area(points_, below[at(foot.triangle)]).normalized();
    const Vec3 apart = points_[at(v)] - foot.place;
    const double along = normal.dot(apart);
    return std::abs(along) <= distance && (apart - along * normal).norm() <= beside_length &&
           normal.dot(normals_[at(v)].normalized()) >= looks_alike;
  }

  /// What is left of a part is its largest fragment, and others that are not tiny and lie further off.
  /// @param faces  of the whole part. @returns one for each triangle: not 0 where it goes
  std::vector<char> fragments_to_remove(const Triangles& left, std::size_t faces, const SurfaceTree& lower,
                                        const Triangles& below) const {
    std::vector<char> falls(left.size(), 0);
    if (left.size() == faces) return falls;
    std::map<int, int> number;  // of the points
    Triangles renumbered;
    for (const Triangle& t : left) {
      Triangle& own = renumbered.emplace_back();
      for (std::size_t c = 0; c < 3; ++c)
        own[c] = number.try_emplace(t[c], static_cast<int>(number.size())).first->second;
    }
    const std::vector<int> fragment = components(renumbered, number.size());
    std::map<int, std::vector<std::size_t>> members;
    for (std::size_t f = 0; f < left.size(); ++f) members[fragment[at(renumbered[f][0])]].push_back(f);
    std::size_t largest = 0;
    for (const auto& [root, own] : members) largest = std::max(largest, own.size());
    for (const auto& [root, own] : members) {
      if (own.size() == largest) continue;
      const bool is_small = static_cast<double>(own.size()) < small_fragment * static_cast<double>(faces);
      if (is_small || std::ranges::all_of(own, [&](std::size_t f) {
            return std::ranges::all_of(left[f], [&](int v) {
              return lies_over(v, lower, below, fragment_distance * distance_, beside * edges_[at(v)]);
            });
          }))
        for (const std::size_t f : own) falls[f] = 1;
    }
    return falls;
  }

  void cut_back(std::size_t k) {
    const Part& part = parts_[k];
    const Vec3 margin = Vec3::Constant(distance_);
    const Eigen::AlignedBox3d reach(part.box.min() - margin, part.box.max() + margin);
    Triangles below;
    std::set<int> outline;  // of the larger parts, near this one
    for (const int f : index_.near_box(reach.min(), reach.max())) {
      if (rank_[at(f)] >= k || !kept_[at(f)]) continue;
      below.push_back(triangles_[at(f)]);
      for (const int v : below.back())
        if (at_boundary_[at(v)] && reach.contains(points_[at(v)])) outline.insert(v);
    }
    if (below.empty()) return;
    const SurfaceTree lower(points_, below);
    for (const int f : part.faces)
      for (const int v : triangles_[at(f)]) {
        signed char& over = over_[at(v)];
        if (over < 0) over = lies_over(v, lower, below, distance_, beside * edges_[at(v)]) ? 1 : 0;
        if (over > 0) kept_[at(f)] = 0;
      }
    Triangles left;  // some are so large that none of their vertices is over
    std::vector<int> number;
    for (const int f : part.faces)
      if (kept_[at(f)]) {
        left.push_back(triangles_[at(f)]);
        number.push_back(f);
      }
    const auto falls = fragments_to_remove(left, part.faces.size(), lower, below);
    for (std::size_t f = 0; f < left.size(); ++f)
      if (falls[f]) kept_[at(number[f])] = 0;
    const SurfaceTree upper(points_, left);
    for (const int v : outline)
      if (int f = -1; lies_over(v, upper, left, distance_, 1e-6 * edges_[at(v)], &f)) kept_[at(number[at(f)])] = 0;
  }

  const Points& points_;
  const Triangles& triangles_;
  double distance_;
  std::vector<char> kept_;
  Points normals_;             ///< as long as the areas
  std::vector<double> edges_;  ///< the longest at each point
  std::vector<char> at_boundary_;
  std::vector<signed char> over_;  ///< whether a point lies over a larger part; −1: not asked yet
  std::vector<Part> parts_;        ///< by falling area
  std::vector<std::size_t> rank_;  ///< of each triangle's part among them
  TriangleIndex index_;
};

/// A row of boundary vertices that came free, in the order of its loop.
struct FreeRow {
  std::vector<int> points;
  bool is_closed = false;
};

std::vector<FreeRow> free_rows(const SurfaceModel& model, const std::vector<char>& is_free) {
  std::vector<FreeRow> rows;
  for (const BoundaryLoop& loop : find_boundary_loops(model)) {
    std::vector<int> points;
    for (const int v : loop.vertices) points.push_back(model.soup_vertex[at(v)]);
    const auto bound = std::ranges::find_if(points, [&](int v) { return !is_free[at(v)]; });
    if (bound == points.end()) {
      rows.push_back({std::move(points), true});
      continue;
    }
    std::rotate(points.begin(), bound, points.end());
    points.push_back(points.front());
    FreeRow row;
    for (const int v : points)
      if (is_free[at(v)])
        row.points.push_back(v);
      else if (!row.points.empty())
        rows.push_back(std::exchange(row, {}));
  }
  return rows;
}

/// Joins parts of the surface along rows that came free.
class Joiner {
 public:
  Joiner(const SurfaceModel& model, const std::function<void(TriangleSoup)>& replace)
      : model_(model),
        replace_(replace) {
    int count = 0;
    part_of_ = parts_of_points(model, count);
  }

  /// @returns how many strips were laid.
  std::size_t join(const FreeRow& row) {
    if (row.is_closed) return bridge(row.points);
    if (row.points.size() < fewest_in_a_row) return 0;
    const auto half = static_cast<std::ptrdiff_t>(row.points.size() / 2);
    return bridge({row.points.begin() + from_corner, row.points.begin() + half}) +
           bridge({row.points.rbegin() + from_corner, row.points.rbegin() + half});
  }

 private:
  /// The boundary vertex of another part that is nearest; −1 where there is none.
  int nearest_of_another(int from) const {
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    const Points& points = model_.soup.points;
    for (const BoundaryLoop& loop : find_boundary_loops(model_))
      for (const int v : loop.vertices) {
        const int point = model_.soup_vertex[at(v)];
        if (at(point) >= part_of_.size() || part_of_[at(point)] == part_of_[at(from)]) continue;
        const double apart = (points[at(point)] - points[at(from)]).squaredNorm();
        if (apart < least) least = apart, nearest = point;
      }
    return nearest;
  }

  /// From the first of these points from which a strip cuts nothing. @returns how many were laid: 0 or 1
  std::size_t bridge(const std::vector<int>& from) {
    for (std::size_t k = 0; k < std::min(most_tries, from.size()); ++k) {
      const int to = nearest_of_another(from[k]);
      if (to < 0) return 0;
      try {
        HandBridge bridge = with_bridge(model_, from[k], to);
        if (cuts_surface(bridge.soup)) continue;
        replace_(std::move(bridge.soup));
        return 1;
      } catch (const InvalidArgument&) {  // both ends have a vertex in common
      }
    }
    return 0;
  }

  /// Whether the triangles beyond those of the model do, or cut each other.
  bool cuts_surface(const TriangleSoup& soup) const {
    const auto first_new = soup.triangles.begin() + static_cast<std::ptrdiff_t>(model_.soup.triangles.size());
    Triangles triangles(first_new, soup.triangles.end());
    const auto count = static_cast<int>(triangles.size());
    Eigen::AlignedBox3d strip;
    for (const Triangle& t : triangles) strip.extend(box_of(soup.points, t));
    std::copy_if(soup.triangles.begin(), first_new, std::back_inserter(triangles),
                 [&](const Triangle& t) { return box_of(soup.points, t).intersects(strip); });
    return !self_intersections(soup.points, triangles, count).empty();
  }

  const SurfaceModel& model_;
  const std::function<void(TriangleSoup)>& replace_;
  std::vector<int> part_of_;  ///< of each point before any strip was laid
};

}  // namespace

JoinedTiles join_tiles(const SurfaceModel& model, double distance, const std::function<void(TriangleSoup)>& replace) {
  JoinedTiles joined;
  Overlap overlap(model, distance);
  const std::vector<char> kept = overlap.kept();
  joined.removed_parts = overlap.removed_parts();
  joined.removed_faces = static_cast<std::size_t>(std::ranges::count(kept, 0));
  if (joined.removed_faces == 0) return joined;
  std::vector<char> is_free(model.soup.points.size(), 0);
  for (std::size_t f = 0; f < kept.size(); ++f)
    if (!kept[f])
      for (const int v : model.soup.triangles[f]) is_free[at(v)] = 1;
  replace(with_faces(model.soup, kept));
  Joiner joiner(model, replace);
  for (const FreeRow& row : free_rows(model, is_free)) joined.bridges += joiner.join(row);
  return joined;
}

}  // namespace loopmend
