// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/self_intersections.h"

#include "core/release.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <Eigen/Geometry>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>

namespace loopmend {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;

Kernel::Point_3 to_cgal(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// Relative to the sizes at hand: far beyond rounding, far below what matters.
constexpr double clearly = 1e-10;

/// The pair test by the number of shared vertices.
class PairTest {
 public:
  PairTest(const Points& points, const Triangles& triangles)
      : points_(points),
        triangles_(triangles),
        merged_(merged_by_place(points)) {}

  bool cut(int f, int g) const {
    const Triangle &a = triangles_[f], &b = triangles_[g];
    if (is_collapsed(a) || is_collapsed(b)) return false;
    const auto [shared, in_a, in_b] = corners_in_common(a, b);
    if (plainly_uncut(a, in_a, b, in_b, shared)) return false;
    const Kernel::Triangle_3 s = triangle(a), t = triangle(b);
    if (s.is_degenerate() || t.is_degenerate()) return false;
    if (shared == 3) return true;  // one triangle on top of the other
    if (shared == 0) return CGAL::do_intersect(s, t);
    if (shared == 1) {
      return CGAL::do_intersect(opposite_edge(a, in_a[0]), t) || CGAL::do_intersect(opposite_edge(b, in_b[0]), s);
    }
    const Kernel::Point_3 p = point(a[in_a[0]]), q = point(a[in_a[1]]);
    const Kernel::Point_3 r = point(a[3 - in_a[0] - in_a[1]]), u = point(b[3 - in_b[0] - in_b[1]]);
    return CGAL::coplanar(p, q, r, u) && CGAL::coplanar_orientation(p, q, r, u) == CGAL::POSITIVE;
  }

 private:
  struct Common {
    int count = 0;
    std::array<int, 3> in_a{}, in_b{};  ///< which corners; of these the first `count`
  };
  Common corners_in_common(const Triangle& a, const Triangle& b) const {
    Common common;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (merged_[a[i]] == merged_[b[j]]) {
          common.in_a[common.count] = i;
          common.in_b[common.count] = j;
          ++common.count;
        }
    return common;
  }
  /// Without exact arithmetic, which most pairs do not need.
  bool plainly_uncut(const Triangle& a, const std::array<int, 3>& in_a, const Triangle& b,
                     const std::array<int, 3>& in_b, int shared) const {
    // Neighbours at less than a right angle: the common case.
    if (shared == 2) return plain_normal(a).dot(plain_normal(b)) > 0;
    if (shared == 3) return false;
    // One triangle on one side of the other's plane, up to what they share and far beyond rounding: common too.
    if (aside(a, b, in_b, shared) || aside(b, a, in_a, shared)) return true;
    return shared == 1 ? apart_around(a, in_a[0], b, in_b[0]) : apart(a, b);
  }
  /// Two of its corners lie in one place.
  bool is_collapsed(const Triangle& t) const {
    return merged_[t[0]] == merged_[t[1]] || merged_[t[1]] == merged_[t[2]] || merged_[t[2]] == merged_[t[0]];
  }
  Kernel::Point_3 point(int v) const { return to_cgal(points_[v]); }
  Vec3 plain_normal(const Triangle& t) const {
    return (points_[t[1]] - points_[t[0]]).cross(points_[t[2]] - points_[t[0]]);
  }
  /// True if the corners of t, but for the shared one, lie clearly on one side of the plane of `of`.
  bool aside(const Triangle& of, const Triangle& t, const std::array<int, 3>& shared_corner, int shared) const {
    const Vec3 normal = plain_normal(of);
    double low = std::numeric_limits<double>::max(), high = -low, size = 0;
    for (int k = 0; k < 3; ++k) {
      if (shared == 1 && k == shared_corner[0]) continue;
      const Vec3 d = points_[t[k]] - points_[of[0]];
      const double height = normal.dot(d);
      low = std::min(low, height);
      high = std::max(high, height);
      size = std::max(size, d.norm());
    }
    const double margin = clearly * normal.norm() * size;
    return low > margin || high < -margin;
  }
  /// True if a plane through the shared corner, across the way from one triangle to the other, clearly parts them.
  bool apart_around(const Triangle& a, int in_a, const Triangle& b, int in_b) const {
    const Vec3& p = points_[a[in_a]];
    const std::array<Vec3, 2> from_p_to_a{points_[a[(in_a + 1) % 3]] - p, points_[a[(in_a + 2) % 3]] - p};
    const std::array<Vec3, 2> from_p_to_b{points_[b[(in_b + 1) % 3]] - p, points_[b[(in_b + 2) % 3]] - p};
    const auto bisector = [](const std::array<Vec3, 2>& sides) {
      return (sides[0].normalized() + sides[1].normalized()).normalized();
    };
    const Vec3 axis = bisector(from_p_to_a) - bisector(from_p_to_b);
    const auto beyond = [&](const Vec3& side, double sign) { return sign * axis.dot(side) > clearly * side.norm(); };
    return beyond(from_p_to_a[0], 1) && beyond(from_p_to_a[1], 1) && beyond(from_p_to_b[0], -1) &&
           beyond(from_p_to_b[1], -1);
  }
  /// True if a plane clearly parts them: one across the line of the centroids, or one that stands on an edge.
  bool apart(const Triangle& a, const Triangle& b) const {
    const auto centroid = [&](const Triangle& t) { return Vec3((points_[t[0]] + points_[t[1]] + points_[t[2]]) / 3); };
    if (parted_along(centroid(a) - centroid(b), a, b)) return true;
    for (const Triangle* t : {&a, &b}) {
      const Vec3 normal = plain_normal(*t);
      for (int k = 0; k < 3; ++k)
        if (parted_along(normal.cross(points_[(*t)[(k + 1) % 3]] - points_[(*t)[k]]), a, b)) return true;
    }
    return false;
  }
  bool parted_along(const Vec3& axis, const Triangle& a, const Triangle& b) const {
    const Vec3& origin = points_[a[0]];
    std::array<double, 2> low, high;
    double size = 0;
    for (int side : {0, 1}) {
      low[side] = std::numeric_limits<double>::max();
      high[side] = -low[side];
      for (int v : side == 0 ? a : b) {
        const Vec3 d = points_[v] - origin;
        const double along = axis.dot(d);
        low[side] = std::min(low[side], along);
        high[side] = std::max(high[side], along);
        size = std::max(size, d.norm());
      }
    }
    const double margin = clearly * axis.norm() * size;
    return low[0] > high[1] + margin || low[1] > high[0] + margin;
  }
  Kernel::Triangle_3 triangle(const Triangle& t) const { return {point(t[0]), point(t[1]), point(t[2])}; }
  Kernel::Segment_3 opposite_edge(const Triangle& t, int corner) const {
    return {point(t[(corner + 1) % 3]), point(t[(corner + 2) % 3])};
  }
  const Points& points_;
  const Triangles& triangles_;
  std::vector<int> merged_;
};

/// Up to here a sweep is faster than trees, and cannot take long however the triangles lie.
constexpr std::size_t most_for_sweep = 20000;

constexpr std::size_t most_pairs = 20'000'000;

using Boxes = std::vector<Eigen::AlignedBox3d>;

/// visit(f, g) for all pairs of boxes that touch and of which one at least is among the first `count`; f < g. Along the
/// axis they are passed in order; each is compared with those that begin before it ends.
template <class Visit>
void sweep(const Boxes& boxes, int axis, int count, const Visit& visit) {
  struct Entry {
    double begin, end;  ///< along the axis
    Eigen::Array2d low, high;
    int number;
  };
  const int second = (axis + 1) % 3, third = (axis + 2) % 3;
  std::vector<Entry> entries;
  Eigen::AlignedBox3d own;
  for (int f = 0; f < count; ++f) own.extend(boxes[f]);
  for (std::size_t f = 0; f < boxes.size(); ++f) {
    if (!own.intersects(boxes[f])) continue;
    const Vec3 &low = boxes[f].min(), &high = boxes[f].max();
    entries.push_back(
        {low[axis], high[axis], {low[second], low[third]}, {high[second], high[third]}, static_cast<int>(f)});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.begin < b.begin; });
  for (auto a = entries.begin(); a != entries.end(); ++a)
    for (auto b = a + 1; b != entries.end() && b->begin <= a->end; ++b) {
      // No branches: none of these can be foretold. A sum, since clang warns of & between bools.
      const int met = (a->low[0] <= b->high[0]) + (b->low[0] <= a->high[0]) + (a->low[1] <= b->high[1]) +
                      (b->low[1] <= a->high[1]) + (std::min(a->number, b->number) < count);
      if (met == 5) visit(std::min(a->number, b->number), std::max(a->number, b->number));
    }
}

/// The same by CGAL, which scans along the first axis and builds trees over the others.
template <class Visit>
void search_trees(const Boxes& boxes, const std::array<int, 3>& axis, int count, const Visit& visit) {
  std::vector<Box> first, others;
  for (std::size_t f = 0; f < boxes.size(); ++f) {
    const Vec3 &low = boxes[f].min(), &high = boxes[f].max();
    const CGAL::Bbox_3 box(low[axis[0]], low[axis[1]], low[axis[2]], high[axis[0]], high[axis[1]], high[axis[2]]);
    (static_cast<int>(f) < count ? first : others).emplace_back(box, static_cast<int>(f));
  }
  const auto look = [&](const Box& a, const Box& b) {
    visit(std::min(a.info(), b.info()), std::max(a.info(), b.info()));
  };
  CGAL::box_self_intersection_d(first.begin(), first.end(), look);
  CGAL::box_intersection_d(first.begin(), first.end(), others.begin(), others.end(), look);
}

}  // namespace

// Along a crack the two sides touch without sharing a vertex.
std::vector<int> merged_by_place(const Points& points) {
  std::vector<int> order(points.size()), merged(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto less = [&](int a, int b) {
    const Vec3 &p = points[a], &q = points[b];
    return std::tie(p.x(), p.y(), p.z(), a) < std::tie(q.x(), q.y(), q.z(), b);
  };
  std::sort(order.begin(), order.end(), less);
  for (std::size_t k = 0; k < order.size(); ++k)
    merged[order[k]] = k > 0 && points[order[k]] == points[order[k - 1]] ? merged[order[k - 1]] : order[k];
  return merged;
}

namespace {

/// visit(f, g) for the pairs that self_intersections() returns, in no particular order.
template <class Visit>
void for_each_intersection(const Points& points, const Triangles& triangles, int count, const CancelToken& cancel,
                           const Visit& visit) {
  Eigen::AlignedBox3d extent;
  for (const Vec3& p : points) extent.extend(p);
  std::array<int, 3> axis{0, 1, 2};
  std::sort(axis.begin(), axis.end(), [&](int a, int b) { return extent.sizes()[a] < extent.sizes()[b]; });
  Boxes boxes(triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (int v : triangles[f]) boxes[f].extend(points[v]);
  const PairTest test(points, triangles);
  const auto look = [&](int f, int g) {
    if (!cancel.cancelled() && test.cut(f, g)) visit(f, g);
  };
  // On a nearly flat patch the trees have the least to search over the long axes, and a sweep along the longest.
  if (triangles.size() <= most_for_sweep)
    sweep(boxes, axis[2], count, look);
  else
    search_trees(boxes, axis, count, look);
}

}  // namespace

std::vector<std::pair<int, int>> self_intersections(const Points& points, const Triangles& triangles, int count,
                                                    const CancelToken& cancel) {
  std::vector<std::pair<int, int>> pairs;
  for_each_intersection(points, triangles, count, cancel, [&](int f, int g) { pairs.emplace_back(f, g); });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::size_t count_self_intersections(const Points& points, const Triangles& triangles, std::size_t most,
                                     const CancelToken& cancel) {
  struct Enough {};
  std::size_t pairs = 0;
  try {
    for_each_intersection(points, triangles, static_cast<int>(triangles.size()), cancel, [&](int, int) {
      if (++pairs >= most) throw Enough();
    });
  } catch (const Enough&) {
  }
  return pairs;
}

std::vector<char> triangles_that_cut(const Points& points, const Triangles& triangles, int count,
                                     const CancelToken& cancel) {
  std::vector<Box> first, others;
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    Eigen::AlignedBox3d box;
    for (int v : triangles[f]) box.extend(points[v]);
    const Vec3 &low = box.min(), &high = box.max();
    (static_cast<int>(f) < count ? first : others)
        .emplace_back(CGAL::Bbox_3(low.x(), low.y(), low.z(), high.x(), high.y(), high.z()), static_cast<int>(f));
  }
  const PairTest test(points, triangles);
  std::vector<char> cuts(count, 0);
  struct TooMuch {};
  std::size_t pairs = 0;
  try {
    CGAL::box_intersection_d(first.begin(), first.end(), others.begin(), others.end(), [&](const Box& a, const Box& b) {
      if (++pairs > most_pairs || cancel.cancelled()) throw TooMuch();
      if (!cuts[a.info()] && test.cut(a.info(), b.info())) cuts[a.info()] = 1;
    });
  } catch (const TooMuch&) {
    cuts.clear();
  }
  return cuts;
}

namespace bg = boost::geometry;
using TreePoint = bg::model::point<double, 3, bg::cs::cartesian>;
using TreeBox = bg::model::box<TreePoint>;

namespace {

/// So many triangles that lie together have one box in the tree.
constexpr std::size_t block_size = 16;

/// The three numbers' bits in turn: what has nearly the same lies together.
std::uint32_t interleaved(const std::array<std::uint32_t, 3>& cell) {
  std::uint32_t key = 0;
  for (int bit = 9; bit >= 0; --bit)
    for (int axis = 0; axis < 3; ++axis) key = (key << 1) | ((cell[axis] >> bit) & 1U);
  return key;
}

Eigen::AlignedBox3d box_of(const Points& points, const Triangle& t) {
  Eigen::AlignedBox3d box;
  for (int v : t) box.extend(points[v]);
  return box;
}

}  // namespace

struct TriangleIndex::Impl {
  Impl(const Points& p, const Triangles& t) : points(p), triangles(t) {}
  const Points& points;
  const Triangles& triangles;
  std::vector<int> order;  ///< triangles, those of a block one after the other
  bg::index::rtree<std::pair<TreeBox, int>, bg::index::quadratic<16>>
      tree;  ///< of blocks: their first place in `order`
};

TriangleIndex::TriangleIndex(const Points& points, const Triangles& triangles, const std::vector<int>& left_out)
    : impl_(std::make_unique<Impl>(points, triangles)) {
  Eigen::AlignedBox3d extent;
  for (const Vec3& p : points) extent.extend(p);
  const Vec3 sizes = extent.sizes().cwiseMax(std::numeric_limits<double>::min());
  std::vector<std::pair<std::uint32_t, int>> keys;
  keys.reserve(triangles.size());
  auto next = left_out.begin();
  for (int f = 0; f < static_cast<int>(triangles.size()); ++f) {
    if (next != left_out.end() && *next == f) {
      ++next;
      continue;
    }
    const Vec3 place = ((points[triangles[f][0]] - extent.min()).array() / sizes.array()) * 1023;
    keys.emplace_back(interleaved({static_cast<std::uint32_t>(place.x()), static_cast<std::uint32_t>(place.y()),
                                   static_cast<std::uint32_t>(place.z())}),
                      f);
  }
  std::sort(keys.begin(), keys.end());
  impl_->order.reserve(keys.size());
  for (const auto& [key, f] : keys) impl_->order.push_back(f);
  release(keys);
  std::vector<std::pair<TreeBox, int>> blocks;
  for (std::size_t first = 0; first < impl_->order.size(); first += block_size) {
    Eigen::AlignedBox3d box;
    for (std::size_t k = first; k < std::min(first + block_size, impl_->order.size()); ++k)
      box.extend(box_of(points, triangles[impl_->order[k]]));
    blocks.emplace_back(
        TreeBox({box.min().x(), box.min().y(), box.min().z()}, {box.max().x(), box.max().y(), box.max().z()}),
        static_cast<int>(first));
  }
  impl_->tree = decltype(impl_->tree)(blocks);  // packed: O(n log n)
}

TriangleIndex::~TriangleIndex() = default;
TriangleIndex::TriangleIndex(TriangleIndex&&) noexcept = default;
TriangleIndex& TriangleIndex::operator=(TriangleIndex&&) noexcept = default;

std::vector<int> TriangleIndex::near_box(const Vec3& low, const Vec3& high) const {
  const Eigen::AlignedBox3d asked(low, high);
  const TreeBox box({low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()});
  std::vector<int> found;
  for (auto it = impl_->tree.qbegin(bg::index::intersects(box)); it != impl_->tree.qend(); ++it) {
    const auto first = static_cast<std::size_t>(it->second);
    for (std::size_t k = first; k < std::min(first + block_size, impl_->order.size()); ++k)
      if (box_of(impl_->points, impl_->triangles[impl_->order[k]]).intersects(asked)) found.push_back(impl_->order[k]);
  }
  std::sort(found.begin(), found.end());
  return found;
}

bool runs_through(const Points& points, const Triangles& triangles, const TriangleIndex& index, const Vec3& p,
                  const Vec3& q) {
  if (p == q) return false;
  const auto exact = [](const Vec3& v) { return Kernel::Point_3(v.x(), v.y(), v.z()); };
  const Kernel::Segment_3 edge(exact(p), exact(q));
  const std::vector<int> near = index.near_box(p.cwiseMin(q), p.cwiseMax(q));
  return std::any_of(near.begin(), near.end(), [&](int f) {
    const Triangle& t = triangles[f];
    // A corner in the same place, as along a seam, is a common one.
    if (std::any_of(t.begin(), t.end(), [&](int v) { return points[v] == p || points[v] == q; })) return false;
    const Kernel::Triangle_3 face(exact(points[t[0]]), exact(points[t[1]]), exact(points[t[2]]));
    return !face.is_degenerate() && CGAL::do_intersect(edge, face);
  });
}

}  // namespace loopmend
