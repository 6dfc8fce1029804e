// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/join_tiles.h"

#include "core/error.h"
#include "mesh/boundary_loops.h"
#include "mesh/flat_view.h"
#include "mesh/pieces.h"
#include "mesh/point_tree.h"
#include "mesh/self_intersections.h"
#include "mesh/surface_tree.h"
#include "pipeline/hand_bridge.h"
#include "pipeline/tile_outlines.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

namespace bg = boost::geometry;

constexpr double looks_alike = 0.7;         ///< cosine of the angle between the normals
constexpr double beside = 0.5;              ///< from the outline of the larger part, in edges of the smaller one
constexpr std::size_t fewest_faces = 8;     ///< of a tile; less is a scrap
constexpr double small_fragment = 0.01;     ///< of the faces of a part
constexpr double fragment_distance = 4;     ///< in those of the faces
constexpr std::size_t fewest_in_a_row = 8;  ///< vertices, for a strip at either end; also of a loop that strips lead to
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
  bool is_open = false, is_tile = false;
};

Eigen::AlignedBox3d box_of(const Points& points, const Triangle& t) {
  Eigen::AlignedBox3d box(points[at(t[0])]);
  return box.extend(points[at(t[1])]).extend(points[at(t[2])]);
}

/// These triangles and the points that they use, renumbered.
TriangleSoup used_alone(const Points& points, const Triangles& triangles) {
  TriangleSoup alone;
  std::unordered_map<int, int> number;
  for (const Triangle& t : triangles) {
    Triangle& own = alone.triangles.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [found, is_new] = number.try_emplace(t[c], static_cast<int>(alone.points.size()));
      if (is_new) alone.points.push_back(points[at(t[c])]);
      own[c] = found->second;
    }
  }
  return alone;
}

class Overlap {
 public:
  /// @param is_tile  by part, as OverlappingOutlines has it
  Overlap(const SurfaceModel& model, double distance, const std::vector<char>& is_tile)
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
    for (std::size_t k = 0; k < parts_.size(); ++k) parts_[k].is_tile = is_tile[k] != 0;
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
      if (parts_[k].is_tile && parts_[k].is_open && parts_[k].faces.size() >= fewest_faces) cut_back(k);
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

  struct Left {
    Triangles triangles;
    std::vector<int> number;  ///< of each among all
  };
  Left left_of(const std::vector<int>& faces) const {
    Left left;
    for (const int f : faces)
      if (kept_[at(f)]) {
        left.triangles.push_back(triangles_[at(f)]);
        left.number.push_back(f);
      }
    return left;
  }

  /// Keeps the largest fragment of the triangles that stay, and others that are not tiny and lie further off.
  void remove_fragments(const std::vector<int>& faces, const SurfaceTree& lower, const Triangles& below) {
    const Left left = left_of(faces);
    if (left.triangles.size() == faces.size()) return;
    const TriangleSoup alone = used_alone(points_, left.triangles);
    const std::vector<int> fragment = components(alone.triangles, alone.points.size());
    std::map<int, std::vector<std::size_t>> members;
    for (std::size_t f = 0; f < left.number.size(); ++f) members[fragment[at(alone.triangles[f][0])]].push_back(f);
    std::size_t largest = 0;
    for (const auto& [root, own] : members) largest = std::max(largest, own.size());
    for (const auto& [root, own] : members) {
      if (own.size() == largest) continue;
      const bool is_small = static_cast<double>(own.size()) < small_fragment * static_cast<double>(faces.size());
      if (is_small || std::ranges::all_of(own, [&](std::size_t f) {
            return std::ranges::all_of(left.triangles[f], [&](int v) {
              return lies_over(v, lower, below, fragment_distance * distance_, beside * edges_[at(v)]);
            });
          }))
        for (const std::size_t f : own) kept_[at(left.number[f])] = 0;
    }
  }

  void cut_back(std::size_t k) {
    const Part& part = parts_[k];
    const Vec3 margin = Vec3::Constant(distance_);
    const Eigen::AlignedBox3d reach(part.box.min() - margin, part.box.max() + margin);
    Triangles below;
    std::set<int> outline;  // of the larger parts, near this one
    for (const int f : index_.near_box(reach.min(), reach.max())) {
      if (rank_[at(f)] >= k || !kept_[at(f)] || !parts_[rank_[at(f)]].is_tile) continue;
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
    remove_crossing(part.faces, below);
    remove_below(outline, part.faces);
    remove_teeth(part.faces);
    remove_fragments(part.faces, lower, below);
  }

  /// Triangles that cut a larger part and are joined to some that went, by others that do.
  void remove_crossing(const std::vector<int>& faces, const Triangles& below) {
    Left left = left_of(faces);
    const std::size_t count = left.triangles.size();
    if (count == faces.size()) return;
    left.triangles.insert(left.triangles.end(), below.begin(), below.end());
    const TriangleSoup alone = used_alone(points_, left.triangles);
    const std::vector<char> cuts = triangles_that_cut(alone.points, alone.triangles, static_cast<int>(count));
    std::set<int> free;
    for (const int f : faces)
      if (!kept_[at(f)]) free.insert(triangles_[at(f)].begin(), triangles_[at(f)].end());
    for (bool any = true; std::exchange(any, false);)
      for (std::size_t k = 0; k < cuts.size(); ++k) {
        const Triangle& t = left.triangles[k];
        if (!cuts[k] || !kept_[at(left.number[k])] || std::ranges::none_of(t, [&](int v) { return free.contains(v); }))
          continue;
        kept_[at(left.number[k])] = 0;
        free.insert(t.begin(), t.end());
        any = true;
      }
  }

  /// Triangles that the outline of a larger part runs below: some are so large that none of their vertices lies over it.
  void remove_below(const std::set<int>& outline, const std::vector<int>& faces) {
    const Left left = left_of(faces);
    const SurfaceTree upper(points_, left.triangles);
    for (const int v : outline)
      if (int f = -1; lies_over(v, upper, left.triangles, distance_, 1e-6 * edges_[at(v)], &f))
        kept_[at(left.number[at(f)])] = 0;
  }

  /// Triangles with two edges that came free, and those that are so then.
  void remove_teeth(const std::vector<int>& faces) {
    const auto edge = [&](int f, std::size_t c) -> std::pair<int, int> {
      return std::minmax({triangles_[at(f)][c], triangles_[at(f)][(c + 1) % 3]});
    };
    for (bool any = true; std::exchange(any, false);) {
      std::set<std::pair<int, int>> free;
      for (const int f : faces)
        for (std::size_t c = 0; c < 3 && !kept_[at(f)]; ++c) free.insert(edge(f, c));
      for (const int f : faces) {
        if (!kept_[at(f)] || free.contains(edge(f, 0)) + free.contains(edge(f, 1)) + free.contains(edge(f, 2)) < 2)
          continue;
        kept_[at(f)] = 0;
        any = true;
      }
    }
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

enum class Outcome {
  laid,
  later,       ///< only beside strips that were laid
  impossible,  ///< each cuts the surface
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

/// Strips from rows that came free to the nearest other part, each of which leaves what stands untouched.
class Joiner {
 public:
  /// @param part_of  of each point before any strip was laid
  Joiner(const SurfaceModel& model, const std::vector<int>& part_of)
      : model_(model),
        part_of_(part_of),
        maker_(model),
        index_(model.soup.points, model.soup.triangles),
        soup_(model.soup),
        is_taken_(model.soup.points.size(), 0) {
    std::vector<std::pair<TreePoint, int>> entries;
    for (const BoundaryLoop& loop : maker_.loops())
      for (const int v : loop.vertices)
        if (const int point = model.soup_vertex[at(v)];
            loop.vertices.size() >= fewest_in_a_row && at(point) < part_of.size())
          entries.emplace_back(tree_point(model.soup.points[at(point)]), point);
    boundary_ = PointTree(entries);
  }

  /// From the first of these points from which a strip cuts nothing.
  Outcome bridge(const std::vector<int>& from) {
    Outcome outcome = Outcome::impossible;
    for (std::size_t k = 0; k < std::min(most_tries, from.size()); ++k) {
      const int to = nearest_of_another(from[k]);
      if (to < 0) return outcome;
      try {
        const BridgeStrip strip = maker_.strip(from[k], to);
        if (meets_another(strip)) {
          outcome = Outcome::later;
          continue;
        }
        const std::size_t points = soup_.points.size(), triangles = soup_.triangles.size();
        append(soup_, strip, model_.soup.points.size());
        if (cuts_surface(triangles)) {
          soup_.points.resize(points);
          soup_.colors.resize(soup_.colors.empty() ? 0 : points);
          soup_.triangles.resize(triangles);
          continue;
        }
        for (const Triangle& t : strip.triangles)
          for (const int v : t)
            if (at(v) < is_taken_.size()) is_taken_[at(v)] = 1;
        return Outcome::laid;
      } catch (const InvalidArgument&) {  // both ends have a vertex in common
      }
    }
    return outcome;
  }

  /// With the strips; their points and triangles come last.
  TriangleSoup take_soup() { return std::move(soup_); }

 private:
  /// The boundary vertex of another part that is nearest; −1 where there is none.
  int nearest_of_another(int from) const {
    const auto is_of_another = [&](const std::pair<TreePoint, int>& entry) {
      return part_of_[at(entry.second)] != part_of_[at(from)];
    };
    const auto query =
        bg::index::nearest(tree_point(model_.soup.points[at(from)]), 1) && bg::index::satisfies(is_of_another);
    const auto found = boundary_.qbegin(query);
    return found == boundary_.qend() ? -1 : found->second;
  }

  /// Whether it has a vertex in common with a strip that was laid.
  bool meets_another(const BridgeStrip& strip) const {
    return std::ranges::any_of(strip.triangles, [&](const Triangle& t) {
      return std::ranges::any_of(t, [&](int v) { return at(v) < is_taken_.size() && is_taken_[at(v)]; });
    });
  }

  /// Whether the soup's triangles from this one on cut others or themselves.
  bool cuts_surface(std::size_t first) const {
    Triangles triangles(soup_.triangles.begin() + static_cast<std::ptrdiff_t>(first), soup_.triangles.end());
    const auto count = static_cast<int>(triangles.size());
    Eigen::AlignedBox3d strip;
    for (const Triangle& t : triangles) strip.extend(box_of(soup_.points, t));
    for (const int f : index_.near_box(strip.min(), strip.max())) triangles.push_back(soup_.triangles[at(f)]);
    for (std::size_t f = model_.soup.triangles.size(); f < first; ++f) triangles.push_back(soup_.triangles[f]);
    const TriangleSoup compact = used_alone(soup_.points, triangles);
    return !self_intersections(compact.points, compact.triangles, count).empty();
  }

  const SurfaceModel& model_;
  const std::vector<int>& part_of_;
  BridgeMaker maker_;
  TriangleIndex index_;
  TriangleSoup soup_;           ///< with the strips
  std::vector<char> is_taken_;  ///< points at which a strip ends
  PointTree boundary_;
};

/// Where the strips of a row may begin, the best place first: of a closed row there is one, else one at either end.
std::vector<std::vector<int>> strip_starts(FreeRow row) {
  if (row.is_closed) return {std::move(row.points)};
  if (row.points.size() < fewest_in_a_row) return {};
  const auto half = static_cast<std::ptrdiff_t>(row.points.size() / 2);
  return {{row.points.begin() + from_corner, row.points.begin() + half},
          {row.points.rbegin() + from_corner, row.points.rbegin() + half}};
}

}  // namespace

JoinedTiles join_tiles(const SurfaceModel& model, double distance, const std::function<void(TriangleSoup)>& replace) {
  JoinedTiles joined;
  const OverlappingOutlines outlines = find_overlapping_outlines(model, find_boundary_loops(model), distance);
  if (outlines.count == 0) return joined;
  Overlap overlap(model, distance, outlines.is_tile);
  const std::vector<char> kept = overlap.kept();
  joined.removed_parts = overlap.removed_parts();
  joined.removed_faces = static_cast<std::size_t>(std::ranges::count(kept, 0));
  if (joined.removed_faces == 0) return joined;
  std::vector<char> is_free(model.soup.points.size(), 0);
  for (std::size_t f = 0; f < kept.size(); ++f)
    if (!kept[f])
      for (const int v : model.soup.triangles[f]) is_free[at(v)] = 1;
  replace(with_faces(model.soup, kept));
  int count = 0;
  const std::vector<int> part_of = parts_of_points(model, count);
  struct Start {
    std::vector<int> points;
    std::size_t row;
  };
  std::vector<Start> open;
  std::set<std::size_t> apart;  // rows without a strip
  std::vector<FreeRow> rows = free_rows(model, is_free);
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::vector<int>& points : strip_starts(std::move(rows[row]))) {
      open.push_back({std::move(points), row});
      apart.insert(row);
    }
  for (std::size_t laid = 1; laid > 0 && !open.empty(); joined.bridges += laid) {
    laid = 0;
    Joiner joiner(model, part_of);
    std::vector<Start> later;  // beside strips that were laid
    for (Start& start : open) {
      const Outcome outcome = joiner.bridge(start.points);
      if (outcome == Outcome::laid) ++laid, apart.erase(start.row);
      if (outcome == Outcome::later) later.push_back(std::move(start));
    }
    if (laid > 0) replace(joiner.take_soup());
    open = std::move(later);
  }
  joined.open_gaps = apart.size();
  return joined;
}

}  // namespace loopmend
