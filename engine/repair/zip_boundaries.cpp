// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/zip_boundaries.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace loopmend {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t most_vertices_zipped = 3000, most_on_edge = 8;

double squared_from_edge(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double length2 = (b - a).squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(b - a) / length2, 0.0, 1.0) : 0.0;
  return (a + t * (b - a) - p).squaredNorm();
}

std::vector<Vec3> places(const Points& points, const std::vector<int>& boundary) {
  std::vector<Vec3> result;
  for (const int v : boundary) result.push_back(points[static_cast<std::size_t>(v)]);
  return result;
}

double farthest(const std::vector<Vec3>& of, const std::vector<Vec3>& from) {
  double largest = 0;
  for (const Vec3& p : of) {
    double nearest = infinite;
    for (std::size_t k = 0; k < from.size(); ++k)
      nearest = std::min(nearest, squared_from_edge(p, from[k], from[(k + 1) % from.size()]));
    largest = std::max(largest, nearest);
  }
  return std::sqrt(largest);
}

/// How a match came from the one before it: so many steps along either boundary, one of them 1.
struct Step {
  std::uint8_t along_a = 0, along_b = 0;
};

}  // namespace

double distance_all_along(const Points& points, const std::vector<int>& a, const std::vector<int>& b) {
  const std::vector<Vec3> p = places(points, a), q = places(points, b);
  return std::max(farthest(p, q), farthest(q, p));
}

std::optional<ZippedBoundaries> zip_boundaries(const Points& points, const std::vector<int>& a,
                                               const std::vector<int>& b) {
  const std::size_t n = a.size(), m = b.size();
  if (n < 3 || m < 3 || n > most_vertices_zipped || m > most_vertices_zipped) return std::nullopt;
  std::vector<int> first = a, second(b.rbegin(), b.rend());
  std::pair<std::size_t, std::size_t> start;
  double nearest = infinite;
  std::vector<Vec3> p = places(points, first), q = places(points, second);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j)
      if (const double d = (p[i] - q[j]).squaredNorm(); d < nearest) {
        nearest = d;
        start = {i, j};
      }
  std::rotate(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(start.first), first.end());
  std::rotate(second.begin(), second.begin() + static_cast<std::ptrdiff_t>(start.second), second.end());
  first.push_back(first.front());
  second.push_back(second.front());
  p = places(points, first);
  q = places(points, second);
  const auto at = [&](std::size_t i, std::size_t j) { return i * (m + 1) + j; };
  std::vector<double> cost((n + 1) * (m + 1), infinite);
  std::vector<Step> step(cost.size());
  cost[0] = 0;
  for (std::size_t i = 1; i <= n; ++i)
    for (std::size_t j = 1; j <= m; ++j) {
      const double pair = (p[i] - q[j]).squaredNorm();
      const auto take = [&](std::size_t along_a, std::size_t along_b, double on_edge) {
        const double sum = cost[at(i - along_a, j - along_b)] + on_edge + pair;
        if (!(sum < cost[at(i, j)])) return;
        cost[at(i, j)] = sum;
        step[at(i, j)] = {static_cast<std::uint8_t>(along_a), static_cast<std::uint8_t>(along_b)};
      };
      take(1, 1, 0);
      double on_edge = 0;
      for (std::size_t k = 2; k <= std::min(i, most_on_edge); ++k)
        take(k, 1, on_edge += squared_from_edge(p[i - k + 1], q[j - 1], q[j]));
      on_edge = 0;
      for (std::size_t k = 2; k <= std::min(j, most_on_edge); ++k)
        take(1, k, on_edge += squared_from_edge(q[j - k + 1], p[i - 1], p[i]));
    }
  if (!std::isfinite(cost[at(n, m)])) return std::nullopt;
  ZippedBoundaries zipped;
  for (std::size_t i = n, j = m; i > 0;) {
    const auto [along_a, along_b] = step[at(i, j)];
    zipped.pairs.emplace_back(first[i], second[j]);
    // The second boundary runs the other way.
    for (std::size_t k = along_a - 1U; k >= 1; --k)
      zipped.on_edges[{second[j], second[j - 1]}].push_back(first[i - along_a + k]);
    for (std::size_t k = 1; k < along_b; ++k)
      zipped.on_edges[{first[i - 1], first[i]}].push_back(second[j - along_b + k]);
    i -= along_a;
    j -= along_b;
  }
  return zipped;
}

}  // namespace loopmend
