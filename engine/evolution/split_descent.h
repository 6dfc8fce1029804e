// SPDX-License-Identifier: GPL-3.0-or-later
// MMCVF on a scan with relief or noise: down to the least of the split energy (split/split_problem.h).
#pragma once

#include "evolution/evolving_patch.h"
#include "split/split_problem.h"

#include <memory>
#include <optional>
#include <utility>

namespace loopmend {

/// Sets out from the robust fairings, or, where there is little relief and noise, from the steady state of the flow itself:
/// their steps come first. Or as given. Then the mesh of the patch stays as it is.
class SplitDescent : public Stepper {
 public:
  SplitDescent(const EvolvingPatch& patch, const SplitEstimate& estimate, double radius);
  void step(EvolvingPatch& patch, const CancelToken& cancel) override;

 private:
  void approach(EvolvingPatch& patch, const CancelToken& cancel);
  void end(EvolvingPatch& patch, SplitProblem::Outcome outcome) const;
  void take(EvolvingPatch& patch, const Points& moved, double solve_seconds);

  SplitEstimate estimate_;
  double radius_;                               ///< R of the neighborhood, patch frame
  bool by_flow_ = false;                        ///< the approach is the flow
  std::unique_ptr<Stepper> approach_;           ///< until it has ended
  std::optional<SplitProblem> problem_;         ///< from then on
  std::pair<PatchStatus, Message> approached_;  ///< how the approach ended
  bool pays_ = true;                            ///< the last step lowered the energy by more than next to nothing
  int steps_ = 0;                               ///< of the descent
};

}  // namespace loopmend
