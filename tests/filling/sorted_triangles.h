// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles in an order of their own, to compare two lists of them.
#pragma once

#include "mesh/triangle_soup.h"

#include <algorithm>

namespace loopmend {

/// Each triangle's corners ascending, the triangles in order.
inline Triangles sorted(Triangles triangles) {
  for (Triangle& t : triangles) std::sort(t.begin(), t.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

}  // namespace loopmend
