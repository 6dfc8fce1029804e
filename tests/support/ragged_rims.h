// SPDX-License-Identifier: GPL-3.0-or-later
// A sphere with a hole whose rim a scanner has left ragged: which faces are bad, and why, is known.
#pragma once

#include "mesh/boundary_loops.h"
#include "mesh/quality.h"
#include "rim/trim_rim.h"
#include "samples/analytic_surfaces.h"

#include <algorithm>
#include <vector>

namespace loopmend::test {

struct RaggedRim {
  TriangleSoup clean;           ///< without the bad faces
  TriangleSoup ragged;          ///< the same triangles first, then the bad ones
  std::vector<BadRimFace> bad;  ///< in the order of the faces; `ring` is the round in which trimming can reach them
};

namespace ragged_detail {

inline Vec3 normal_of(const TriangleSoup& soup, const Triangle& t) {
  return unit_normal(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
}

/// The hole's rim as soup points; the hole lies to the left.
inline std::vector<int> rim_of(const TriangleSoup& soup) {
  const SurfaceModel model = make_surface_model(soup);
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  std::vector<int> rim;
  for (int v : loops.front().vertices) rim.push_back(model.soup_vertex[v]);
  return rim;
}

inline void add(RaggedRim& rim, const Triangle& t, RimFault fault, int ring) {
  rim.bad.push_back({static_cast<int>(rim.ragged.triangles.size()), fault, ring});
  rim.ragged.triangles.push_back(t);
}

}  // namespace ragged_detail

/// Every sixth vertex of the rim gets a face over the two rim edges that meet there. In turns the vertex stands a little back
/// (the face is a sliver), sticks out (it is folded back over the surface), or there is a sliver that a sliver leads to, or
/// a flipped triangle that stands on one edge.
inline RaggedRim ragged_rim() {
  using namespace ragged_detail;
  TriangleSoup soup = trim_rims(cut(make_icosphere(5), [](const Vec3& p) { return p.z() > 0.7; }));
  const std::vector<int> rim = rim_of(soup);
  const int n = static_cast<int>(rim.size());
  const auto at = [&](int k) { return rim[(k + n) % n]; };
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
  RaggedRim result{soup, soup, {}};
  for (std::size_t p = 0; p < places.size(); ++p) {
    const int k = places[p];
    const Triangle corner{at(k - 1), at(k), at(k + 1)};
    switch (p % 4) {
      case 0: add(result, corner, RimFault::sliver, 1); break;
      case 1: add(result, corner, RimFault::flipped, 1); break;
      case 2:
        add(result, corner, RimFault::sliver, 2);
        add(result, {at(k - 1), at(k + 1), at(k + 2)}, RimFault::sliver, 1);
        break;
      default: {  // over the rim edge, back onto the surface
        const Vec3 middle = (soup.points[at(k)] + soup.points[at(k + 1)]) / 2;
        result.ragged.points.push_back(middle + 0.02 * outwards(k) + Vec3(0, 0, -0.01));
        add(result, {at(k), at(k + 1), static_cast<int>(result.ragged.points.size()) - 1}, RimFault::dangling, 1);
      }
    }
  }
  return result;
}

}  // namespace loopmend::test
