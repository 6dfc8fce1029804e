// SPDX-License-Identifier: GPL-3.0-or-later
// Which chords of a boundary loop a patch must not make an edge of.
#pragma once

#include "mesh/boundary_loops.h"

#include <vector>

namespace loopmend {

/// Fills BoundaryLoop::joined and BoundaryLoop::shared of all loops of a model.
void find_taken_chords(const SurfaceModel& model, std::vector<BoundaryLoop>& loops);

}  // namespace loopmend
