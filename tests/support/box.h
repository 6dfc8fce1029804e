// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/triangle_soup.h"

#include <array>

namespace loopmend::test {

/// Twelve faces that look outward.
inline TriangleSoup box(const Vec3& low, const Vec3& high) {
  TriangleSoup soup;
  for (int k = 0; k < 8; ++k)
    soup.points.emplace_back((k & 1 ? high : low).x(), (k & 2 ? high : low).y(), (k & 4 ? high : low).z());
  for (const std::array<int, 4>& q : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
                                      std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
    soup.triangles.push_back({q[0], q[1], q[2]});
    soup.triangles.push_back({q[0], q[2], q[3]});
  }
  return soup;
}

}  // namespace loopmend::test
