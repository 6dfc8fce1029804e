// SPDX-License-Identifier: GPL-3.0-or-later
// From a boundary loop to the G0 filler: triangulate, refine to the density of the surroundings, remesh, relax.
#pragma once

#include "core/cancel.h"
#include "mesh/patch.h"

#include <optional>
#include <string>

namespace loopmend {

enum class FillerShape {
  minimal,       ///< relaxed to a minimal surface
  triangulated,  ///< as the loop's triangulation lies in space, with its creases: nearer to bulging surroundings
};

struct FillerOptions {
  double density = 1;  ///< edges per length relative to the surroundings, 0.1..10: 2 halves the edge length
  FillerShape shape = FillerShape::minimal;
};

/// @throws InvalidArgument if an option is out of range.
void check(const FillerOptions& options);

/// What a filler is like, told before anybody builds on it.
struct FillerQuality {
  int folds = 0;               ///< edges inside the patch or on the rim with a dihedral over 90°
  int self_intersections = 0;  ///< pairs of triangles, patch with patch or patch with surroundings
  double min_angle_deg = 0;    ///< smallest angle of a patch triangle
};

struct FillerOutcome {
  std::optional<LoopFiller> filler;  ///< empty when there is no valid triangulation, or when cancelled
  std::string message;               ///< why there is none, or what is left to wish; empty when all is well
  FillerQuality quality;
};

/// Reads the model, never changes it. No new vertex lies on the loop.
/// @throws InvalidArgument if the density is out of range.
FillerOutcome fill_loop(const SurfaceModel& model, const BoundaryLoop& loop, const FillerOptions& options,
                        const CancelToken& cancel);

}  // namespace loopmend
