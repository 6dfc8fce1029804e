// SPDX-License-Identifier: GPL-3.0-or-later
// One patch to its steady state, as `loopmend fill` does it: same tests, same fallbacks, same result.
#pragma once

#include "evolution/evolve_filler.h"
#include "jobs/evolve_patches.h"

#include <chrono>
#include <optional>
#include <vector>

namespace loopmend {

class SteadyRun {
 public:
  SteadyRun(const EvolveTask& task, const EvolveTask::Item& item, RunRecorder& recorder, const Job& job);

  /// @returns several patches in place of the item's, where its holes ask for different treatment, or a joint solution
  /// would spoil one of them; else nothing.
  std::vector<OpenPatch> run();

 private:
  Evolved evolve(const PatchState& start);
  void show(const Evolution& evolution, const StepRecord& record);
  PatchStatePtr state_of(const Evolved& evolved, const PatchState& from);
  std::vector<std::vector<int>> one_by_one() const;
  std::vector<std::vector<int>> parts_alike() const;
  std::vector<OpenPatch> in_parts(const std::vector<std::vector<int>>& parts);
  std::optional<OpenPatch> solved(const std::vector<int>& members);

  const EvolveTask& task_;
  const EvolveTask::Item& item_;
  RunRecorder& recorder_;
  const Job& job_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
  PatchStatePtr last_;
  double initial_energy_ = 0;
  int attempts_ = 0;
};

}  // namespace loopmend
