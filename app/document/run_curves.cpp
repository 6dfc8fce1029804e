// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/run_curves.h"

namespace loopmend {

Lowered lowered_by_last_step(const PatchState& state) {
  if (state.last_step.split.total() > 0) return Lowered::J;
  const bool flows = state.method == Method::flow || state.method == Method::mixed_order;
  return state.steps > 0 && flows ? Lowered::energy : Lowered::nothing;
}

RunCurves::RunCurves(const OpenPatch& patch) {
  const std::size_t run = patch.state->recipe.runs.size();
  const PatchState* before = nullptr;
  for (const PatchStatePtr& state : *patch.timeline) {
    if (state->recipe.runs.size() == run && state->steps > 0) add(*state, before);
    before = state.get();
  }
  fairing = step.empty() && !residual.empty();
}

void RunCurves::add(const PatchState& state, const PatchState* before) {
  if (state.last_step.max_move > 0) {
    residual_step << state.steps;
    residual << state.last_step.max_move;
  }
  const Lowered what = lowered_by_last_step(state);
  if (what == Lowered::nothing) return;
  if (what == Lowered::J) {
    const SplitEnergy& J = state.last_step.split;
    split = true;
    smooth << J.smooth;
    relief << J.relief + J.noise;
  } else if (step.empty() && before) {
    step << before->steps;
    lowered << state.energy.initial;
  }
  step << state.steps;
  lowered << (split ? state.last_step.split.total() : state.energy.final);
}

}  // namespace loopmend
