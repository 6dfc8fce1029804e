// SPDX-License-Identifier: GPL-3.0-or-later
// A part of a soup as a soup of its own.
#pragma once

#include "mesh/triangle_soup.h"

#include <vector>

namespace loopmend {

struct TriangleSelection {
  TriangleSoup soup;              ///< the chosen triangles and the points that they use, both in their order
  std::vector<int> point_number;  ///< per point of the whole: its number in the selection; -1 where it is not there
};

/// Colours and the rows of attributes come along. @param chosen  one for each triangle: not 0 where it is wanted.
TriangleSelection select_triangles(const TriangleSoup& whole, const std::vector<char>& chosen);

}  // namespace loopmend
