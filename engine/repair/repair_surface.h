// SPDX-License-Identifier: GPL-3.0-or-later
// From a soup of triangles to an oriented manifold, at the price of some vertices that become two.
#pragma once

#include "mesh/triangle_soup.h"

#include <cstddef>

namespace loopmend {

/// What was done. All 0 for a sound mesh.
struct RepairCounts {
  std::size_t degenerate_faces = 0;  ///< with a vertex twice: removed
  std::size_t duplicate_faces = 0;   ///< over the vertices of an earlier one: removed
  std::size_t separated_edges = 0;   ///< had more than two faces; each now has two or one
  /// Fans that lie side by side, as where two holes touch, keep their vertex in common.
  std::size_t separated_vertices = 0;  ///< became several at one place: ends of such edges, and where sheets touch
  std::size_t turned_faces = 0;        ///< to agree with their neighbors
  std::size_t removed_pieces = 0;      ///< of surface, tiny
  std::size_t removed_faces = 0;       ///< of these pieces

  bool any() const {
    return degenerate_faces + duplicate_faces + separated_edges + separated_vertices + turned_faces + removed_pieces >
           0;
  }
};

struct RepairedSurface {
  TriangleSoup soup;  ///< the points given, in their order and bit by bit, then the copies of those that were separated
  RepairCounts counts;
};

/// Faces keep their order. No point moves. @throws InvalidArgument if no usable face is left.
RepairedSurface repair_surface(const TriangleSoup& soup);

}  // namespace loopmend
