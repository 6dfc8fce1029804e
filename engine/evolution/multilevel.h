// SPDX-License-Identifier: GPL-3.0-or-later
// The steady state of a large patch by a coarse copy of it: most of the path costs little on few vertices.
#pragma once

#include "evolution/steady_state.h"

namespace loopmend {

/// Begins with the steady state of a coarse copy in place of the linear fairings, near enough for one or two Gauss-Newton
/// steps. On small patches, and where that does not lower the energy, it is SteadyState.
class Multilevel : public Stepper {
 public:
  Multilevel(const EvolvingPatch& patch, NearConvergence fits);
  void step(EvolvingPatch& patch, const CancelToken& cancel) override;

 private:
  bool coarse_step(EvolvingPatch& patch, const CancelToken& cancel);

  NearConvergence fits_;
  SteadyState steady_;
  bool coarse_start_left_;
};

}  // namespace loopmend
