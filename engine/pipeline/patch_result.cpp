// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/patch_result.h"

namespace loopmend {

void take_figures(const Evolution& evolution, PatchResult& result) {
  result.history = evolution.history();
  result.steps = static_cast<int>(result.history.size());
  result.seconds.assemble = result.seconds.solve = 0;
  for (const StepRecord& step : result.history) {
    result.seconds.assemble += step.assemble_seconds;
    result.seconds.solve += step.solve_seconds;
  }
  result.energy = {evolution.initial_energy(), evolution.energy()};
  result.bending = evolution.bending();
}

void add_message(PatchResult& result, Message message) {
  result.message = joined(std::move(result.message), "; ", std::move(message));
}

std::string method_name(const PatchResult& result) {
  return is_filled(result.status) ? method_name(result.method, result.flow) : std::string();
}

StartRating rating_of(const PatchResult& result, bool usable) {
  const bool faired = !result.history.empty() && result.history.front().sigma == 0;
  return {usable, is_at_end(result.status), faired, result.steps, result.energy.final};
}

}  // namespace loopmend
