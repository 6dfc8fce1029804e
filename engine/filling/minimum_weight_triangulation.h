// SPDX-License-Identifier: GPL-3.0-or-later
// The triangulation of a closed polyline that is folded least: Barequet and Sharir 1995, with the weights of Liepa 2003.
#pragma once

#include "core/types.h"

#include <set>
#include <utility>

namespace loopmend {

/// A closed polyline, and what its triangulation will be joined to.
struct OpenLoop {
  Points points;                          ///< n ≥ 3, in the order of the boundary halfedges
  Points across;                          ///< n: third corner of the triangle outside at the edge from i to i + 1
  std::set<std::pair<int, int>> present;  ///< chords (i, j), i < j, that are edges outside: they are not made again
};

/// Built up from shorter stretches of the loop, each with the smallest worst dihedral (those with the triangles outside
/// count too), of equals with the smallest area: what CGAL's triangulate_hole finds without Delaunay triangulation, to the
/// last bit. All O(n³) triangles are considered, but few of them measured exactly.
/// @returns n − 2 triangles over the points; empty if all triangulations have a degenerate one or a chord that is present.
Triangles minimum_weight_triangulation(const OpenLoop& loop);

/// The same among those triangulations that are made of the given triangles alone.
/// @param allowed  corners in ascending order
Triangles minimum_weight_triangulation(const OpenLoop& loop, Triangles allowed);

}  // namespace loopmend
