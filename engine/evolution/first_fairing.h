// SPDX-License-Identifier: GPL-3.0-or-later
// The first linear fairing on the way to the steady state of a hole, made beside the filler instead of after it.
#pragma once

#include "core/cancel.h"
#include "core/threads.h"
#include "evolution/linear_start.h"
#include "mesh/boundary_loops.h"
#include "mesh/surface_model.h"

#include <optional>

namespace loopmend {

/// Of a filler whose last coarse mesh is known: see fair_from_coarse. Empty where there is none.
struct FirstFairing {
  explicit FirstFairing(std::function<std::optional<FairedPatch>()> work) : task(std::move(work)) {}
  SharedTask<std::optional<FairedPatch>> task;
};

/// Whether MMCVF begins so: on its way to the steady state, from linear fairings, free to make a mesh of its own.
bool begins_with_fairing(const EvolutionOptions& options);

/// Whether there is such a thing: for one loop and a patch that is not large. @param density  of FillerOptions.
bool has_first_fairing(const std::vector<BoundaryLoop>& loops, double density, const EvolutionOptions& options);

/// The coarse mesh faired, brought to the size of the rim's edges, and faired again, for ∫‖∇H‖²:
/// what fairing, remeshing and fairing the filler comes to.
/// @param coarse  of this loop's filler (OnCoarseFiller). @param density  of FillerOptions.
FairedPatch fair_from_coarse(const SurfaceModel& model, const BoundaryLoop& loop, const LoopFiller& coarse,
                             double density, const CancelToken& cancel);

/// The same where nobody has kept the coarse mesh: the filler is made once more. Nothing is done before it is asked for;
/// the model lives until then.
std::shared_ptr<FirstFairing> first_fairing_of(const SurfaceModel& model, const BoundaryLoop& loop, double density,
                                               const CancelToken& cancel);

}  // namespace loopmend
