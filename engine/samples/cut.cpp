// SPDX-License-Identifier: GPL-3.0-or-later
// Cutting pieces out of a mesh, and tidying what the cut leaves.
#include "samples/analytic_surfaces.h"

#include <cstdint>
#include <unordered_set>

namespace loopmend {
namespace {

/// The triangles for which `keep` holds, and the points that they use, both in their old order.
TriangleSoup keep_triangles(const TriangleSoup& soup, const std::vector<char>& keep) {
  TriangleSoup kept;
  std::vector<int> new_index(soup.points.size(), -1), points, triangles;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    if (!keep[f]) continue;
    for (int v : soup.triangles[f]) new_index[v] = 0;
    kept.triangles.push_back(soup.triangles[f]);
    triangles.push_back(static_cast<int>(f));
  }
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    if (new_index[v] < 0) continue;
    new_index[v] = static_cast<int>(kept.points.size());
    kept.points.push_back(soup.points[v]);
    points.push_back(static_cast<int>(v));
    if (!soup.colors.empty()) kept.colors.push_back(soup.colors[v]);
  }
  for (Triangle& triangle : kept.triangles) {
    for (int& v : triangle) v = new_index[v];
  }
  copy_rows(soup, points, triangles, kept);
  return kept;
}

std::uint64_t directed_edge(int from, int to) {
  return static_cast<std::uint64_t>(from) << 32U | static_cast<std::uint32_t>(to);
}

/// Marks the triangles that hang on by one edge or less, or that touch a vertex where more than one loop passes.
/// @returns how many were newly marked.
int drop_hanging(const TriangleSoup& soup, std::vector<char>& keep) {
  std::unordered_set<std::uint64_t> edges;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const Triangle& t = soup.triangles[f];
    for (int k = 0; keep[f] && k < 3; ++k) edges.insert(directed_edge(t[k], t[(k + 1) % 3]));
  }
  const auto is_boundary = [&](int from, int to) { return !edges.contains(directed_edge(to, from)); };
  std::vector<int> boundary_edges_from(soup.points.size(), 0);
  for (const std::uint64_t edge : edges) {
    const int from = static_cast<int>(edge >> 32U);
    if (is_boundary(from, static_cast<int>(edge & 0xffffffffU))) ++boundary_edges_from[from];
  }
  int dropped = 0;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    if (!keep[f]) continue;
    const Triangle& t = soup.triangles[f];
    int boundary_sides = 0;
    bool touching = false;
    for (int k = 0; k < 3; ++k) {
      boundary_sides += is_boundary(t[k], t[(k + 1) % 3]) ? 1 : 0;
      touching = touching || boundary_edges_from[t[k]] > 1;
    }
    if (boundary_sides < 2 && !touching) continue;
    keep[f] = 0;
    ++dropped;
  }
  return dropped;
}

}  // namespace

TriangleSoup cut(const TriangleSoup& soup, const std::function<bool(const Vec3&)>& inside) {
  std::vector<char> is_inside(soup.points.size());
  for (std::size_t v = 0; v < soup.points.size(); ++v) is_inside[v] = inside(soup.points[v]) ? 1 : 0;
  std::vector<char> keep(soup.triangles.size());
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const auto& [a, b, c] = soup.triangles[f];
    keep[f] = !is_inside[a] && !is_inside[b] && !is_inside[c];
  }
  return keep_triangles(soup, keep);
}

TriangleSoup trim_boundaries(const TriangleSoup& soup) {
  std::vector<char> keep(soup.triangles.size(), 1);
  while (drop_hanging(soup, keep) > 0) {
  }
  return keep_triangles(soup, keep);
}

}  // namespace loopmend
