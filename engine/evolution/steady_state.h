// SPDX-License-Identifier: GPL-3.0-or-later
// MMCVF straight to its steady state: linear fairings while they pay, then damped Gauss-Newton steps.
#pragma once

#include "evolution/damped_step.h"

#include <deque>
#include <optional>

namespace loopmend {

/// What the neighborhood allows near convergence.
enum class NearConvergence {
  quadratic_fits,
  cubic_fits  ///< the neighborhood is smooth: H from cubic fits is more accurate by an order
};

class SteadyState : public Stepper {
 public:
  SteadyState(const EvolvingPatch& patch, NearConvergence fits);
  void step(EvolvingPatch& patch, const CancelToken& cancel) override;

  /// The next undamped step would move a hundredth of what the last one did, and that was little.
  bool near_convergence() const;
  double damping_unit() const { return unit_; }
  /// A good start is known: no fairings. @param unit  damping_unit() of the run that it comes from.
  void skip_fairings(double unit);

 private:
  bool fairing_step(EvolvingPatch& patch, const CancelToken& cancel);
  bool use_cubic_fits(EvolvingPatch& patch);
  bool rests_by_cubic_fits(EvolvingPatch& patch, const CancelToken& cancel);
  bool find_unit(EvolvingPatch& patch, const CancelToken& cancel);
  void gauss_newton_step(EvolvingPatch& patch, const CancelToken& cancel);
  void after_step(EvolvingPatch& patch, int rejections, double energy_before, const CancelToken& cancel);
  bool stagnates(const EvolvingPatch& patch, double move, double energy_before);
  bool at_rest(EvolvingPatch& patch, bool undamped, const CancelToken& cancel);
  bool stands_still(EvolvingPatch patch, const CancelToken& cancel);
  bool is_undamped() const { return mu_ <= unit_; }

  NearConvergence fits_;
  std::optional<EvolutionState> cubic_start_;  ///< the start by cubic fits, once it is known; without weights
  int fairings_left_;
  bool may_rest_;  ///< the start may be a steady state by cubic fits, from an evolution before
  double start_measure_;
  double unit_ = 0;                 ///< of mu_: about the slowest decay rate; 0 before the first Gauss-Newton step
  double mu_ = 0;                   ///< damping of the next step
  double last_undamped_move_ = 0;   ///< of the last step, in mean edge lengths, if it was undamped and taken at once
  std::deque<double> small_steps_;  ///< energies before the last steps, all of which hardly moved
  int tiny_steps_ = 0;              ///< in a row, which moved nothing to speak of
  bool undamped_left_ = true;       ///< damped steps that stand still may once be followed by an undamped one
  std::unique_ptr<SpdSolver> solver_ = make_spd_solver();
};

}  // namespace loopmend
