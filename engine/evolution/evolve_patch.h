// SPDX-License-Identifier: GPL-3.0-or-later
// One patch from start to steady state, for problems without a hole: points to interpolate, regions of a surface.
#pragma once

#include "evolution/evolution.h"
#include "filling/loop_filler.h"

#include <string>

namespace loopmend {

struct EvolvedPatch {
  Patch patch;
  EvolutionStatus status = EvolutionStatus::ready;
  std::string message;  ///< why it stopped early; empty when converged
  FlowKind flow = FlowKind::mmcvf;
  Method method = Method::flow;
  std::string reason;     ///< why it is not the flow itself, and how to get that; empty if it is, or if nobody judged
  FillerQuality quality;  ///< folds and cuts within the patch and the rings around it
  int steps = 0;
  double bending = 0;  ///< EvolutionOptions::bending that was used
  struct {
    double assemble = 0, solve = 0;
  } seconds;  ///< sums over the steps
  struct {
    double initial = 0, final = 0;
  } energy;
  std::vector<StepRecord> history;

  bool is_valid() const { return quality.folds == 0 && quality.self_intersections == 0; }
};

/// Runs the flow from the patch as it is, once.
/// @throws InvalidArgument as Evolution.
EvolvedPatch run_flow(const Patch& start, const EvolutionOptions& options, const Evolution::OnStep& on_step,
                      const CancelToken& cancel);

/// The same from the best of several starts (best_start.h); where that ends folded, cut or stalled, again from the
/// third-order linear fairing, and the better end is taken.
EvolvedPatch evolve_patch(const Patch& start, const EvolutionOptions& options, const Evolution::OnStep& on_step,
                          const CancelToken& cancel);

}  // namespace loopmend
