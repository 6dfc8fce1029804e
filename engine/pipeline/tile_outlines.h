// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets that lie on each other along a part, as tiles of one scan do.
#pragma once

#include "mesh/boundary_loops.h"

#include <cstddef>
#include <vector>

namespace loopmend {

/// Outlines that run over another part of the surface.
struct OverlappingOutlines {
  std::size_t count = 0;
  double distance =
      0;  ///< half as far again as the farthest vertex lies over the other part, mesh units: enough for join_tiles()
  /// By part of parts_of_points(): whether its outline runs over another, or that of another over it. Empty if there is none.
  std::vector<char> is_tile;
};

/// How many outlines of sheets lie beside other boundaries, near enough for --stitch, and over other sheets.
struct TileOutlines {
  std::size_t abutting = 0;
  OverlappingOutlines overlapping;
};

/// Outlines, and boundaries of holes, that run over another part that looks the same way, for a twentieth of their length or more and within an edge's length
/// of it. Outlines that only lie beside another boundary are none of these.
/// @param loops  all of the model. @param distance  mesh units: so far over another part counts as well
OverlappingOutlines find_overlapping_outlines(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                              double distance = 0);

}  // namespace loopmend
