// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary vertices that are two only because each face of a file rounded its corners for itself.
#pragma once

#include "mesh/triangle_soup.h"
#include "mesh/vertex_survey.h"

#include <cstddef>
#include <vector>

namespace loopmend {

/// How near boundary vertices must be, as a part of the size of the mesh (of its box's diagonal, or of its largest coordinate
/// where that is more): 8 units in the last place of single precision.
inline constexpr double rounding_of_floats = 0x1p-20;

struct JoinedCracks {
  std::vector<int> first;    ///< per point: the one that its faces name now, itself if nothing changed; empty: no crack
  std::size_t vertices = 0;  ///< joined to another
  double largest = 0;        ///< distance from the farthest of them to the one that its faces name now; mesh units
};

/// Closes cracks whose sides lie within rounding of each other: boundary vertices become one where that closes an edge, unless
/// a face would lose a corner, two faces would have the same corners, or an edge more than two faces. Vertices stay apart, too,
/// where an edge at one of them is not a hundred times as long, or four times where the coordinates are of single precision and only
/// their last two units differ. Points and the order of faces stay.
/// @param survey  of the soup as it is before
JoinedCracks join_rounding_cracks(TriangleSoup& soup, const VertexSurvey& survey);

}  // namespace loopmend
