// SPDX-License-Identifier: GPL-3.0-or-later
// One patch to its steady state by the engine's solve_group(), every accepted state shown on the way.
#pragma once

#include "jobs/evolve_patches.h"
#include "pipeline/solve_group.h"

#include <chrono>
#include <map>
#include <vector>

namespace loopmend {

/// What was done in place of the flow, and why; then what is to be said of the result.
Message message_of(const PatchResult& result);

/// What solve_group() is asked for.
InitialPatch initial_of(const EvolveTask::Item& item);
inline GroupOptions group_options(const EvolveTask::Item& item, const EvolutionOptions& evolution) {
  return {InitialPatchOptions{item.patch.state->recipe.density}, evolution};
}

class SteadyRun {
 public:
  SteadyRun(const EvolveTask& task, const EvolveTask::Item& item, RunRecorder& recorder, const Job& job);

  /// @returns several patches in place of the item's, where its holes were solved apart from each other; else nothing.
  /// @throws InvalidArgument with the engine's words where no patch came of it.
  std::vector<OpenPatch> run();

 private:
  std::vector<OpenPatch> run_bridge();
  void show(const Evolution& evolution, const StepRecord& record);
  /// The patch after this step of a run that set out from `start`.
  std::shared_ptr<PatchState> after_step(const PatchState& start, const Evolution& evolution, const StepRecord& record);
  PatchStatePtr state_of(const PatchResult& result, const PatchState& from);
  void finish(const PatchResult& result);
  /// Some of the loops as a patch of their own. @param result  null: the initial patch, and `why_not`.
  OpenPatch part(const std::vector<int>& numbers, const PatchResult* result, const Message& why_not);
  /// A part's initial patch.
  PatchStatePtr first_of(const std::vector<int>& numbers, const PatchResult* result);
  std::vector<BoundaryLoop> loops_of(const std::vector<int>& numbers) const;

  const EvolveTask& task_;
  const EvolveTask::Item& item_;
  RunRecorder& recorder_;
  const Job& job_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  PatchStatePtr last_;
  struct Part {
    PatchStatePtr first;
    std::vector<PatchStatePtr> steps;  ///< of the last attempt
    int attempts = 0;
  };
  std::map<std::vector<int>, Part> parts_;  ///< by numbers of loops: what is solved apart from the rest of the patch
  double initial_energy_ = 0;
  int attempts_ = 0;
};

}  // namespace loopmend
