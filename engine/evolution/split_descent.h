// SPDX-License-Identifier: GPL-3.0-or-later
// MMCVF on a scan with relief or noise: down to the least of the split energy (split/split_problem.h).
#pragma once

#include "evolution/robust_fairing.h"
#include "split/split_problem.h"

#include <optional>

namespace loopmend {

/// Sets out from the robust fairings, whose steps come first, or as given; then the mesh of the patch stays as it is.
class SplitDescent : public Stepper {
 public:
  SplitDescent(const EvolvingPatch& patch, const SplitEstimate& estimate, double radius);
  void step(EvolvingPatch& patch, const CancelToken& cancel) override;

 private:
  void fair(EvolvingPatch& patch, const CancelToken& cancel);
  void end(EvolvingPatch& patch, SplitProblem::Outcome outcome) const;
  void take(EvolvingPatch& patch, const Points& moved, double solve_seconds);

  SplitEstimate estimate_;
  std::optional<RobustFairing> fairing_;  ///< until its passes are done
  std::optional<SplitProblem> problem_;   ///< from then on
  bool pays_ = true;                      ///< the last step lowered the energy by more than next to nothing
  int steps_ = 0;                         ///< of the descent
};

}  // namespace loopmend
