// SPDX-License-Identifier: GPL-3.0-or-later
// A sphere with a hole whose boundary a scanner has left ragged: which faces are bad, and why, is known.
#pragma once

#include "mesh/boundary_loops.h"
#include "mesh/quality.h"
#include "neighborhood/trim_boundary.h"
#include "samples/analytic_surfaces.h"

#include <algorithm>
#include <vector>

namespace loopmend::test {

struct RaggedBoundary {
  TriangleSoup clean;   ///< without the bad faces
  TriangleSoup ragged;  ///< the same triangles first, then the bad ones
  std::vector<BadBoundaryFace>
      bad;  ///< in the order of the faces; `ring` is the round in which trimming can reach them
};

namespace ragged_detail {

inline Vec3 normal_of(const TriangleSoup& soup, const Triangle& t) {
  return unit_normal(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
}

/// The hole's boundary as soup points, from the lowest on; the hole lies to the left. Other starts put faults on corners that
/// are slivers already.
inline std::vector<int> boundary_of(const TriangleSoup& soup) {
  const SurfaceModel model = make_surface_model(soup);
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  std::vector<int> boundary;
  for (int v : loops.front().vertices) boundary.push_back(model.soup_vertex[v]);
  std::rotate(boundary.begin(), std::min_element(boundary.begin(), boundary.end()), boundary.end());
  return boundary;
}

inline void add(RaggedBoundary& boundary, const Triangle& t, BoundaryFault fault, int ring) {
  boundary.bad.push_back({static_cast<int>(boundary.ragged.triangles.size()), fault, ring});
  boundary.ragged.triangles.push_back(t);
}

}  // namespace ragged_detail

/// Every sixth vertex of the boundary gets a face over the two boundary edges that meet there. In turns the vertex stands a little back
/// (the face is a sliver), sticks out (it is folded back over the surface), or there is a sliver that a sliver leads to, or
/// a flipped triangle that stands on one edge.
inline RaggedBoundary ragged_boundary() {
  using namespace ragged_detail;
  TriangleSoup soup = trim_boundaries(cut(make_icosphere(5), [](const Vec3& p) { return p.z() > 0.7; }));
  const std::vector<int> boundary = boundary_of(soup);
  const int n = static_cast<int>(boundary.size());
  const auto at = [&](int k) { return boundary[(k + n) % n]; };
  const auto outwards = [&](int k) { return Vec3(soup.points[at(k)].x(), soup.points[at(k)].y(), 0).normalized(); };
  std::vector<int> places;
  for (int k = 3; k + 3 < n; k += 6) places.push_back(k);
  // How far a vertex stands back from the chord of its neighbours, in chords; less than nothing where it sticks out.
  constexpr double back[] = {0.02, -0.25, 0.02, 0.3};
  for (std::size_t p = 0; p < places.size(); ++p) {
    const int k = places[p];
    const auto put = [&](int j, double depth) {
      const Vec3 a = soup.points[at(j - 1)], b = soup.points[at(j + 1)];
      soup.points[at(j)] = ((a + b) / 2 + depth * (b - a).norm() * outwards(j)).normalized();
    };
    put(k, back[p % 4]);
    if (p % 4 == 2) {  // the next one stands back from the chord that the first face leaves
      const Vec3 a = soup.points[at(k - 1)], b = soup.points[at(k + 2)];
      soup.points[at(k + 1)] = (a + 2 * b) / 3 + 0.03 * (b - a).norm() * outwards(k + 1);
      put(k, 0.02);
    }
  }
  RaggedBoundary result{soup, soup, {}};
  for (std::size_t p = 0; p < places.size(); ++p) {
    const int k = places[p];
    const Triangle corner{at(k - 1), at(k), at(k + 1)};
    switch (p % 4) {
      case 0: add(result, corner, BoundaryFault::sliver, 1); break;
      case 1: add(result, corner, BoundaryFault::flipped, 1); break;
      case 2:
        add(result, corner, BoundaryFault::sliver, 2);
        add(result, {at(k - 1), at(k + 1), at(k + 2)}, BoundaryFault::sliver, 1);
        break;
      default: {  // over the boundary edge, back onto the surface
        const Vec3 middle = (soup.points[at(k)] + soup.points[at(k + 1)]) / 2;
        result.ragged.points.push_back(middle + 0.02 * outwards(k) + Vec3(0, 0, -0.01));
        add(result, {at(k), at(k + 1), static_cast<int>(result.ragged.points.size()) - 1}, BoundaryFault::dangling, 1);
      }
    }
  }
  return result;
}

}  // namespace loopmend::test
