// SPDX-License-Identifier: GPL-3.0-or-later
// Several surfaces in one model, so that a patch can join loops of different files.
#pragma once

#include "mesh/boundary_loops.h"
#include "mesh/surface_model.h"

#include <vector>

namespace loopmend {

struct JoinedParts {
  SurfaceModel model;                    ///< all points and triangles, part after part, in their order
  std::vector<std::size_t> first_point;  ///< #parts + 1: where each part's points begin in model.soup
  /// Per part its loops in the joined model, in the order in which `info` numbers those of the part alone.
  std::vector<std::vector<BoundaryLoop>> loops;
};

/// @throws InvalidArgument where parts cut each other, or a part has no usable face.
JoinedParts join_parts(const std::vector<TriangleSoup>& parts);

/// Turns round the pieces of the surface that some of these loops bound. The model and the loops are made again; `loops`
/// keeps its order. @param opposed indices into `loops`.
/// @returns how many faces were turned.
/// @throws InvalidArgument if a piece is bounded by opposed loops and by others: no two-sided surface joins them.
std::size_t turn_opposed_pieces(SurfaceModel& model, std::vector<BoundaryLoop>& loops, const std::vector<int>& opposed);

}  // namespace loopmend
