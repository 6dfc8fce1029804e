// SPDX-License-Identifier: GPL-3.0-or-later
// The first triangulation of a loop: no new vertices, n − 2 triangles.
#pragma once

#include "core/cancel.h"
#include "core/types.h"

#include <set>
#include <utility>
#include <vector>

namespace loopmend {

/// Cubic search is right more often, Delaunay-guided search scales (docs/dev/filling.md, "Triangulation").
enum class TriangulationMethod {
  cubic,          ///< the least folded of all triangulations by dynamic programming, O(n³): up to a few hundred edges
  delaunay,       ///< guided by a 3D Delaunay triangulation, with the cubic search where that fails
  delaunay_only,  ///< the same without the cubic search: for long loops
  planar,         ///< constrained Delaunay in the loop's plane, where its projection is simple
};

/// Pairs (i, k), i < k, of places of a loop that are not next to each other.
using Chords = std::set<std::pair<int, int>>;

/// Chords that edges of the neighborhood join, and those between two places of one vertex.
/// @param neighborhood, loop  as triangulate_loop() has them
Chords present_chords(const Triangles& neighborhood, const std::vector<int>& loop);

/// Chords along straight runs of a loop, up to 1e-5 at each vertex: rounding would decide on which side of the surface beside the run
/// they pass.
Chords straight_chords(const Points& points, const std::vector<int>& loop);

/// @param points       the loop's neighbourhood, #P
/// @param neighborhood triangles of the mesh around the loop, over `points`
/// @param loop         n ≥ 3 indices into `points`, in the order of the boundary halfedges; one that the loop passes twice is
/// there twice
/// @param avoided      chords that no triangle may have
/// @returns n − 2 triangles over places 0..n−1 of the loop, oriented like the neighborhood; empty when there is no such
/// triangulation.
Triangles triangulate_loop(const Points& points, const Triangles& neighborhood, const std::vector<int>& loop,
                           const Chords& avoided, TriangulationMethod method);

/// The least folded of those triangulations whose triangles cut neither the neighborhood nor one another.
/// @param neighborhood  all triangles that a triangulation might cut
/// @returns as triangulate_loop(); empty as well where none was found, when cancelled, for loops of more than 200 edges, and among very many triangles.
Triangles triangulate_loop_uncut(const Points& points, const Triangles& neighborhood, const std::vector<int>& loop,
                                 const Chords& avoided, const CancelToken& cancel);

}  // namespace loopmend
