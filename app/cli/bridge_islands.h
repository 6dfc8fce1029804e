// SPDX-License-Identifier: GPL-3.0-or-later
// Holes with pieces of surface inside: `fill --bridge-islands`.
#pragma once

#include "evolution/fill_loops.h"
#include "mesh/pieces.h"

#include <vector>

namespace loopmend {

/// A vertex of the soup on each loop: the soup's numbers stay while bridges renumber the view.
std::vector<int> anchors_of(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops);

/// Joins a hole to the islands within it by one patch. Where that cannot be done the model is as it was.
/// @param anchors  of `loops`, from before anything was filled.
/// @returns one result for the hole, then one for each island.
std::vector<LoopResult> bridge_islands(SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                       const std::vector<int>& anchors, const HoleWithIslands& place,
                                       const FillOptions& options);

}  // namespace loopmend
