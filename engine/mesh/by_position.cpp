// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/by_position.h"

#include <bit>
#include <cstdint>

namespace loopmend {

namespace {

constexpr int filter_bits = 18;

/// Of equal positions equal, of −0 and 0 too.
std::size_t filter_slot(const Vec3& p) {
  std::uint64_t hash = 0;
  for (int k = 0; k < 3; ++k) hash = (hash ^ std::bit_cast<std::uint64_t>(p[k] + 0.0)) * 0x9e3779b97f4a7c15ULL;
  return hash >> (64 - filter_bits);
}

}  // namespace

Triangles sorted_by_position(const Points& points, Triangles triangles) {
  const auto before = [&](int v, int w) { return points[v] != points[w] ? precedes(points[v], points[w]) : v < w; };
  for (Triangle& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end(), before), t.end());
  std::sort(triangles.begin(), triangles.end(), [&](const Triangle& s, const Triangle& t) {
    return std::lexicographical_compare(s.begin(), s.end(), t.begin(), t.end(), before);
  });
  return triangles;
}

std::vector<int> position_numbers(const Points& points, const Points& places) {
  Points distinct = places;
  std::sort(distinct.begin(), distinct.end(), precedes);
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  std::vector<char> may_be(std::size_t{1} << filter_bits, 0);
  for (const Vec3& p : distinct) may_be[filter_slot(p)] = 1;
  std::vector<int> number(points.size(), -1);
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (!may_be[filter_slot(points[v])]) continue;
    const auto found = std::lower_bound(distinct.begin(), distinct.end(), points[v], precedes);
    if (found != distinct.end() && *found == points[v]) number[v] = static_cast<int>(found - distinct.begin());
  }
  return number;
}

}  // namespace loopmend
