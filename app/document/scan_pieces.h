// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of a scan that do not hang together, the largest first.
#pragma once

#include "mesh/surface_model.h"

#include <cstddef>
#include <vector>

namespace loopmend {

struct ScanPieces {
  struct Piece {
    std::size_t triangles = 0;
    double diameter = 0;   ///< of its box, mesh units
    int first_vertex = 0;  ///< its lowest, of the view
  };
  std::vector<Piece> list;     ///< by falling number of triangles, then by lowest vertex
  std::vector<int> of_vertex;  ///< #V of the view: index into `list`; empty where there is but one

  /// @param vertex  of the view
  int piece_of(int vertex) const { return of_vertex.empty() ? 0 : of_vertex[vertex]; }
};

/// Pieces that have a vertex in common are one, as in mesh/pieces.h.
ScanPieces scan_pieces(const TriMesh& mesh);

}  // namespace loopmend
