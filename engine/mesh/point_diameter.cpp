// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/point_diameter.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

constexpr int leaf_size = 16;

/// Points in a tree of boxes, halved along the longest side.
class FarthestPair {
 public:
  explicit FarthestPair(const Points& points) : points_(points) {
    nodes_.reserve(4 * points_.size() / leaf_size + 1);
    build(0, static_cast<int>(points_.size()));
  }

  double squared() {
    search(0, 0);
    return best_;
  }

 private:
  struct Node {
    int begin = 0, end = 0;
    int left = -1, right = -1;  ///< nodes; none in a leaf
    Eigen::AlignedBox3d box;
  };

  int build(int begin, int end) {
    const int k = static_cast<int>(nodes_.size());
    Node node{begin, end, -1, -1, {}};
    for (int i = begin; i < end; ++i) node.box.extend(points_[i]);
    nodes_.push_back(node);
    if (end - begin <= leaf_size) return k;
    int axis = 0;
    node.box.sizes().maxCoeff(&axis);
    const int middle = begin + (end - begin) / 2;
    std::nth_element(points_.begin() + begin, points_.begin() + middle, points_.begin() + end,
                     [axis](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
    const int left = build(begin, middle), right = build(middle, end);
    nodes_[k].left = left;
    nodes_[k].right = right;
    return k;
  }

  /// No two points of these boxes are farther apart, also as they are rounded: rounding keeps the order of numbers, and this
  /// takes the steps that a distance takes.
  static double bound(const Node& a, const Node& b) {
    const Vec3 reach = (a.box.max() - b.box.min()).cwiseMax(b.box.max() - a.box.min());
    return reach.squaredNorm();
  }

  void search(int a, int b) {
    const Node& first = nodes_[a];
    const Node& second = nodes_[b];
    if (bound(first, second) <= best_) return;
    if (first.left < 0 && second.left < 0) {
      for (int i = first.begin; i < first.end; ++i)
        for (int j = second.begin; j < second.end; ++j)
          best_ = std::max(best_, (points_[i] - points_[j]).squaredNorm());
      return;
    }
    std::vector<std::pair<int, int>> pairs;
    if (a == b) {
      pairs = {{first.left, first.right}, {first.left, first.left}, {first.right, first.right}};
    } else if (second.left < 0 || (first.left >= 0 && first.end - first.begin >= second.end - second.begin)) {
      pairs = {{first.left, b}, {first.right, b}};
    } else {
      pairs = {{a, second.left}, {a, second.right}};
    }
    std::stable_sort(pairs.begin(), pairs.end(), [this](const auto& p, const auto& q) {
      return bound(nodes_[p.first], nodes_[p.second]) > bound(nodes_[q.first], nodes_[q.second]);
    });
    for (const auto& [x, y] : pairs) search(x, y);
  }

  Points points_;
  std::vector<Node> nodes_;
  double best_ = 0;
};

}  // namespace

double diameter_of(const Points& points) { return points.size() < 2 ? 0 : std::sqrt(FarthestPair(points).squared()); }

}  // namespace loopmend
