// SPDX-License-Identifier: GPL-3.0-or-later
// Zips boundaries that lie on each other, or nearly: cracks, seams between tiles, T-junctions.
#pragma once

#include "mesh/surface_model.h"

#include <cstddef>

namespace loopmend {

struct StitchedSurface {
  /// Points as they were, in their order: those that were joined to another are still there, without a face. Faces in their
  /// order; where a vertex of the other side lay on an edge, a face became two, the second at the end.
  TriangleSoup soup;
  std::size_t joined_vertices = 0;  ///< that faces gave up for one close by
  std::size_t split_faces = 0;      ///< at T-junctions
  std::size_t removed_faces = 0;    ///< that would have had a vertex twice
};

/// How near vertices must be to be joined, in lengths of the boundary edges there.
inline constexpr double stitch_tolerance = 0.1;

/// @param tolerance  0..0.4, in lengths of the boundary edges there. @throws InvalidArgument if it is not.
StitchedSurface stitch_boundaries(const SurfaceModel& model, double tolerance = stitch_tolerance);

}  // namespace loopmend
