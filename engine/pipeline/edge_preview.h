// SPDX-License-Identifier: GPL-3.0-or-later
// The sharp edges that would run on across a hole, before it is filled, and what a person says of them.
#pragma once

#include "core/cancel.h"
#include "edges/sharp_patch.h"
#include "evolution/edge_edits.h"
#include "mesh/surface_model.h"

#include <vector>

namespace loopmend {

struct ContinuedEdge {
  Points line;               ///< mesh units, from one end to the other
  int begin = -1, end = -1;  ///< soup points on the boundary; −1: it ends within the hole
};

/// As solve_patch() would continue them by default, from the initial patch of the loop. @param edits  of the scan. @param density
/// as InitialPatchOptions. @returns nothing where none runs on, or when cancelled.
std::vector<ContinuedEdge> continued_edges(const SurfaceModel& model, const BoundaryLoop& loop, const EdgeEdits& edits,
                                           double density, const CancelToken& cancel);

/// Of the edits of a scan those at points of these loops.
EdgeEdits edits_at(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, const EdgeEdits& edits);

/// Those of a patch with one loop, by places on it.
LoopEdits edits_of(const SurfaceModel& model, const Patch& patch, const EdgeEdits& edits);

/// @throws InvalidArgument unless each point is on one of the loops, and both ends of a drawn edge are on the same one, with
/// other points of it between them on either hand.
void check(const EdgeEdits& edits, const SurfaceModel& model, const std::vector<BoundaryLoop>& loops);

}  // namespace loopmend
