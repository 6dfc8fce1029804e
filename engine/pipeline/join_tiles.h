// SPDX-License-Identifier: GPL-3.0-or-later
// Tiles of one scan that overlap are cut back to each other's outline and joined, so that the gap between them is a hole.
#pragma once

#include "mesh/surface_model.h"

#include <cstddef>
#include <functional>

namespace loopmend {

struct JoinedTiles {
  std::size_t removed_faces = 0;  ///< of a smaller tile, where a larger one lies
  std::size_t removed_parts = 0;  ///< that lay on a larger one altogether
  std::size_t bridges = 0;        ///< strips between the outlines; their points and faces come last
  std::size_t open_gaps = 0;      ///< that no strip crosses, since each would cut the surface
};

/// The larger of two parts that overlap (pipeline/tile_outlines.h) keeps its faces. The other one, if it is open and has eight faces or more, loses those with a vertex over it: within `distance` of it
/// along its normal, within half an edge of its outline beside it, and looking the same way. Of each row of edges that come free
/// both ends are joined to the larger part by a strip, which makes a hole of the gap; of a closed row one vertex is. Where a strip
/// would have its ends at one place, there is none, and the gap stays part of the outline.
/// @param distance  above 0, mesh units
/// @param replace   makes `model` of another soup
JoinedTiles join_tiles(const SurfaceModel& model, double distance, const std::function<void(TriangleSoup)>& replace);

}  // namespace loopmend
