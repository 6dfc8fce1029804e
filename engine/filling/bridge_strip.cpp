// SPDX-License-Identifier: GPL-3.0-or-later
// Strips between two loops.
#include "filling/bridge_topology.h"
#include "filling/tangent_cubic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace loopmend {

namespace {

constexpr int most_rows = 400;

/// The cross edges of a strip from a₀–b_start on, b taken backwards: for each the step that led to it.
struct StripPath {
  double cost = std::numeric_limits<double>::max();
  std::vector<char> along_a;  ///< (m + 1)·(n + 1): 1 if the cross edge (i, j) was reached along a
};

StripPath best_path(const Points& a, const Points& b, int start) {
  const int m = static_cast<int>(a.size()), n = static_cast<int>(b.size());
  const auto at = [&](int i, int j) { return static_cast<std::size_t>(i) * (n + 1) + j; };
  constexpr double none = std::numeric_limits<double>::max();
  StripPath path;
  path.along_a.assign(at(m, n) + 1, 0);
  std::vector<double> above(n + 1, none), here(n + 1, none);
  const double band = std::max(0.3, 2.0 / std::min(m, n));  // docs/dev/filling.md, "Bridges between loops"
  for (int i = 0; i <= m; ++i) {
    std::fill(here.begin(), here.end(), none);
    for (int j = 0; j <= n; ++j) {
      if (std::abs(static_cast<double>(i) / m - static_cast<double>(j) / n) > band) continue;
      const double length2 = (a[i % m] - b[((start - j) % n + n) % n]).squaredNorm();
      const double by_a = above[j], by_b = j > 0 ? here[j - 1] : none;
      if (i == 0 && j == 0) here[0] = length2;
      if (by_a == none && by_b == none) continue;
      path.along_a[at(i, j)] = by_a <= by_b;
      here[j] = std::min(by_a, by_b) + length2;
    }
    std::swap(above, here);
  }
  path.cost = above[n];
  return path;
}

using CrossEdges = std::vector<std::pair<int, int>>;

/// Fractions of the perimeter at each vertex and once round, from vertex `start` on, forwards (+1) or backwards (−1).
std::vector<double> fractions(const Points& points, int start, int sense) {
  const int n = static_cast<int>(points.size());
  std::vector<double> at{0};
  for (int k = 0; k < n; ++k) {
    const Vec3 &p = points[((start + sense * k) % n + n) % n], &q = points[((start + sense * (k + 1)) % n + n) % n];
    at.push_back(at.back() + (q - p).norm());
  }
  for (double& x : at) x /= at.back();
  return at;
}

/// The strip that moves evenly along both loops, b backwards from b_start: no fans, which would pinch a neck.
/// @param together  steps on both loops at once where they are so near to each other, in perimeters: quads in place of pairs of triangles
CrossEdges even_path(const Points& a, const Points& b, int start, double together) {
  const int m = static_cast<int>(a.size()), n = static_cast<int>(b.size());
  const std::vector<double> at_a = fractions(a, 0, 1), at_b = fractions(b, start, -1);
  CrossEdges cross;
  for (int i = 0, j = 0; i < m || j < n;) {
    cross.emplace_back(i % m, ((start - j) % n + n) % n);
    const bool both = i < m && j < n && std::abs(at_a[i + 1] - at_b[j + 1]) < together;
    const bool along_a = j == n || (i < m && at_a[i + 1] <= at_b[j + 1]);
    if (both || along_a) ++i;
    if (both || !along_a) ++j;
  }
  return cross;
}

CrossEdges best_even_path(const Points& a, const Points& b, double together) {
  CrossEdges best;
  double least = std::numeric_limits<double>::max();
  for (int start = 0; start < static_cast<int>(b.size()); ++start) {
    CrossEdges path = even_path(a, b, start, together);
    double cost = 0;
    for (const auto& [i, j] : path) cost += (a[i] - b[j]).squaredNorm();
    if (cost >= least) continue;
    least = cost;
    best = std::move(path);
  }
  return best;
}

/// Averaged with their neighbours, so that a ragged boundary does not tangle what leaves it.
Points smoothed(Points directions) {
  const std::size_t n = directions.size();
  for (int round = 0; round < 3; ++round) {
    const Points before = directions;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 sum = before[(i + n - 1) % n] + 2 * before[i] + before[(i + 1) % n];
      if (sum.norm() > 0) directions[i] = sum.normalized();
    }
  }
  return directions;
}

int rows_for(const std::vector<TangentCubic>& cubics, double step) {
  double length = 0;
  for (const TangentCubic& c : cubics) length += c.length();
  return std::clamp(static_cast<int>(std::lround(length / static_cast<double>(cubics.size()) / step)), 1, most_rows);
}

/// The cross edges of the shortest strip: (vertex of a, vertex of b), in the order of a.
CrossEdges strip_between(const Points& a, const Points& b) {
  const int m = static_cast<int>(a.size()), n = static_cast<int>(b.size());
  std::vector<int> starts(n);
  std::iota(starts.begin(), starts.end(), 0);
  const int tries = std::min(n, 8);
  std::partial_sort(starts.begin(), starts.begin() + tries, starts.end(),
                    [&](int i, int j) { return (b[i] - a[0]).squaredNorm() < (b[j] - a[0]).squaredNorm(); });
  StripPath best;
  int start = 0;
  for (int k = 0; k < tries; ++k) {
    StripPath path = best_path(a, b, starts[k]);
    if (path.cost >= best.cost) continue;
    best = std::move(path);
    start = starts[k];
  }
  CrossEdges cross;
  if (best.cost == std::numeric_limits<double>::max()) return cross;
  for (int i = m, j = n; i > 0 || j > 0;) {
    best.along_a[static_cast<std::size_t>(i) * (n + 1) + j] ? --i : --j;
    cross.emplace_back(i % m, ((start - j) % n + n) % n);
  }
  std::reverse(cross.begin(), cross.end());
  return cross;
}

}  // namespace

Triangles bridge_by_strip(const Points& a, const Points& b) {
  const int m = static_cast<int>(a.size());
  const auto cross = strip_between(a, b);
  Triangles triangles;
  for (std::size_t k = 0; k < cross.size(); ++k) {
    const auto [i, j] = cross[k];
    const auto [next_i, next_j] = cross[(k + 1) % cross.size()];
    triangles.push_back({i, next_i != i ? next_i : m + next_j, m + j});
  }
  return triangles;
}

SweptBridge bridge_by_sweep(const BridgeEnd& a, const BridgeEnd& b, double step, SweepShape shape) {
  constexpr double never = 0, at_once = 1e-6;
  const CrossEdges cross = best_even_path(a.points, b.points, shape == SweepShape::straight ? at_once : never);
  const Points leaving = smoothed(a.conormals), arriving = smoothed(b.conormals);
  std::vector<TangentCubic> cubics;
  for (const auto& [i, j] : cross) {
    const Vec3 across = (b.points[j] - a.points[i]).normalized();
    const bool is_straight = shape == SweepShape::straight;
    cubics.emplace_back(a.points[i], is_straight ? across : leaving[i], b.points[j],
                        is_straight ? across : Vec3(-arriving[j]));
  }
  const int rows = rows_for(cubics, step), m = static_cast<int>(a.points.size()), n = static_cast<int>(b.points.size());
  SweptBridge bridge;
  bridge.points = a.points;
  bridge.points.insert(bridge.points.end(), b.points.begin(), b.points.end());
  for (const TangentCubic& c : cubics)
    for (int r = 1; r < rows; ++r) bridge.points.push_back(c.at(static_cast<double>(r) / rows));
  const int columns = static_cast<int>(cross.size());
  const auto number = [&](int column, int row) {
    column %= columns;
    if (row == 0) return cross[column].first;
    if (row == rows) return m + cross[column].second;
    return m + n + column * (rows - 1) + row - 1;
  };
  for (int k = 0; k < columns; ++k)
    for (int r = 0; r < rows; ++r) {
      const int p = number(k, r), q = number(k + 1, r), s = number(k + 1, r + 1), t = number(k, r + 1);
      if (p != q) bridge.triangles.push_back({p, q, t});
      if (s != t) bridge.triangles.push_back({q, s, t});
    }
  return bridge;
}

}  // namespace loopmend
