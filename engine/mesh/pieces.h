// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of a surface that do not hang together, and which of them lie as islands in a hole of another.
#pragma once

#include "mesh/boundary_loops.h"

#include <vector>

namespace loopmend {

/// For each view face the lowest face of its piece of surface. Pieces that have a vertex in common are one.
std::vector<int> pieces_of(const TriMesh& mesh);

/// The piece that a loop bounds, by the numbers of `piece` (of pieces_of).
int piece_beside(const TriMesh& mesh, const std::vector<int>& piece, const BoundaryLoop& loop);

struct HoleWithIslands {
  int hole = 0;              ///< index into the loops
  std::vector<int> islands;  ///< rims of other pieces that lie within it, ascending
};

/// Holes in which other pieces lie: seen square to the hole's best plane, the piece's outer rim is inside the hole, and no
/// further from that plane than half the hole's diameter. An island belongs to the smallest hole around it.
/// @param loops  all of the model. @returns by rising hole; holes without islands are left out.
std::vector<HoleWithIslands> find_islands(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops);

}  // namespace loopmend
