// SPDX-License-Identifier: GPL-3.0-or-later
#include "ringed_cap.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace loopmend::bench {

namespace {

constexpr double pi = std::numbers::pi;

/// Vertices on each ring about the pole, rings `step` apart, triangles about equilateral; ring 0 is the pole.
std::vector<int> ring_sizes(int rings, double step) {
  std::vector<int> sizes{1};
  for (int k = 1; k < rings; ++k)
    sizes.push_back(std::max(6, static_cast<int>(std::lround(2 * pi * std::sin(k * step) / (1.1547 * step)))));
  return sizes;
}

/// Rings 0..inner of the hole hold exactly `free` vertices.
std::vector<int> sizes_for(int free, double angle, int outer, int& inner) {
  int best = 1;
  for (int k = 1; k < free; ++k) {
    const std::vector<int> sizes = ring_sizes(k + 1, angle / (k + 1));
    if (std::accumulate(sizes.begin(), sizes.end(), 0) > free) break;
    best = k;
  }
  inner = best;
  std::vector<int> sizes = ring_sizes(inner + 1 + outer, angle / (inner + 1));
  int missing = free - std::accumulate(sizes.begin(), sizes.begin() + inner + 1, 0);
  // Spread over the rings in proportion to their sizes, the rest on the outermost.
  const double share = static_cast<double>(missing) / (free - 1);
  for (int k = 1; k <= inner; ++k) {
    const int more = std::min(missing, static_cast<int>(share * sizes[k]));
    sizes[k] += more;
    missing -= more;
  }
  for (int k = inner; missing > 0; k = k > 1 ? k - 1 : inner, --missing) ++sizes[k];
  return sizes;
}

/// Triangles between two rings, each step on the side that lags behind.
void zip(int first, int count, int next_first, int next_count, Triangles& triangles) {
  int i = 0, j = 0;
  while (i < count || j < next_count) {
    const int a = first + i % count, b = next_first + j % next_count;
    const bool outer = i >= count || (j < next_count && 1.0 * (j + 1) / next_count <= 1.0 * (i + 1) / count);
    if (outer)
      triangles.push_back({a, b, next_first + ++j % next_count});
    else
      triangles.push_back({a, b, first + ++i % count});
  }
}

Vec3 on_sphere(double polar, double turn) {
  return {std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)};
}

TriangleSoup whole_cap(const std::vector<int>& sizes, double step) {
  TriangleSoup soup;
  for (std::size_t k = 0; k < sizes.size(); ++k)
    for (int i = 0; i < sizes[k]; ++i)
      soup.points.push_back(on_sphere(static_cast<double>(k) * step, 2 * pi * i / sizes[k]));
  for (int i = 0; i < sizes[1]; ++i) soup.triangles.push_back({0, 1 + i, 1 + (i + 1) % sizes[1]});
  int first = 1;
  for (std::size_t k = 1; k + 1 < sizes.size(); ++k) {
    zip(first, sizes[k], first + sizes[k], sizes[k + 1], soup.triangles);
    first += sizes[k];
  }
  return soup;
}

}  // namespace

RingedCap make_ringed_cap(int free, double angle, int rings) {
  int inner = 0;
  const std::vector<int> sizes = sizes_for(free, angle, rings, inner);
  const TriangleSoup whole = whole_cap(sizes, angle / (inner + 1));
  TriangleSoup open;
  open.points.assign(whole.points.begin() + free, whole.points.end());
  for (Triangle t : whole.triangles) {
    if (*std::min_element(t.begin(), t.end()) < free) continue;
    for (int& v : t) v -= free;
    open.triangles.push_back(t);
  }
  RingedCap cap;
  const int loop_size = sizes[inner + 1];
  cap.problem = open_problem(
      "ringed cap", std::move(open), [&](const Vec3& p) { return p.z() > std::cos(angle * (1 + 1e-6)); },
      [](const Vec3& p) { return std::abs(p.norm() - 1); });
  cap.problem.removed = free;
  // The view keeps the soup's order: loop vertex v is point free + v of the whole.
  std::vector<int> index(free + loop_size, -1);
  for (int v : cap.problem.loops.at(0).vertices) {
    index[free + v] = static_cast<int>(cap.initial_patch.points.size());
    cap.initial_patch.points.push_back(whole.points[free + v]);
  }
  for (int v = 0; v < free; ++v) {
    const double x = std::acos(std::clamp(whole.points[v].z(), -1.0, 1.0)) / angle;
    index[v] = static_cast<int>(cap.initial_patch.points.size());
    cap.initial_patch.points.push_back(whole.points[v] * (1 + 0.05 * std::pow(1 - x * x, 2)));
  }
  for (const Triangle& t : whole.triangles)
    if (*std::min_element(t.begin(), t.end()) < free)
      cap.initial_patch.triangles.push_back({index[t[0]], index[t[1]], index[t[2]]});
  return cap;
}

}  // namespace loopmend::bench
