// SPDX-License-Identifier: GPL-3.0-or-later
// Zips boundaries that lie on each other, or nearly: cracks, seams between tiles, T-junctions.
#pragma once

#include "mesh/boundary_loops.h"
#include "mesh/surface_model.h"

#include <cstddef>
#include <optional>
#include <set>
#include <utility>

namespace loopmend {

struct StitchedSurface {
  /// Points as they were, in their order: those that were joined to another are still there, without a face. Faces in their
  /// order; where vertices of the other side lay on its edges, a face became several, all but the first at the end.
  TriangleSoup soup;
  std::size_t joined_vertices = 0;  ///< that faces gave up for one close by
  std::size_t split_faces = 0;      ///< at T-junctions
  std::size_t removed_faces = 0;    ///< that would have had a vertex twice

  bool any() const { return joined_vertices + split_faces + removed_faces > 0; }
};

/// How near vertices must be to be joined. Edges of different boundaries whose faces would form a crevice narrower than 30 degrees are not,
/// unless they lie on each other: bodies touch there. With a length, or a larger share than the default, boundaries of two parts that
/// lie within it of each other all along are zipped from end to end.
struct StitchTolerance {
  double edges = 0.1;            ///< 0..0.4, in lengths of the boundary edges there, but at most ten medians of all
  std::optional<double> length;  ///< at least 0, in mesh units, in place of that
};

/// @throws InvalidArgument if the tolerance is out of its range.
StitchedSurface stitch_boundaries(const SurfaceModel& model, const StitchTolerance& tolerance = {});

/// Whether it zips boundaries of two parts from end to end. @throws InvalidArgument if the tolerance is out of its range.
bool zips_whole_boundaries(const SurfaceModel& model, const StitchTolerance& tolerance);

/// What stitching would do.
struct NearBoundaries {
  std::size_t vertices = 0;  ///< would be joined; without those that lie at exactly the same place
  std::size_t faces = 0;     ///< would be split
  /// Boundary edges that would have a face on both sides, as they run in theirs; soup points.
  std::set<std::pair<int, int>> closing;
};

/// Serves any view that holds the boundary loops. @throws InvalidArgument if the tolerance is out of its range.
NearBoundaries near_boundaries(const SurfaceModel& model, const StitchTolerance& tolerance = {});

/// How many edges of the loop are among those.
int closing_edges(const SurfaceModel& model, const BoundaryLoop& loop, const NearBoundaries& near);

}  // namespace loopmend
