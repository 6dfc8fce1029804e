// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's semi-implicit scheme (§4): (I/τ − V') s = V with τ = σ/λ₁, one step after another.
#pragma once

#include "evolution/damped_step.h"
#include "flows/flow_terms.h"

namespace loopmend {

/// Takes steps of EvolutionOptions::sigma, or very large ones to the steady state. Where the scheme fails twice, Gauss-Newton
/// takes the implicit step of the same size: it descends the same energy, and is stable where the scheme is not.
class SemiImplicit : public Stepper {
 public:
  explicit SemiImplicit(const EvolvingPatch& patch);
  void step(EvolvingPatch& patch, const CancelToken& cancel) override;

 private:
  double decay_rate(const EvolvingPatch& patch, const CancelToken& cancel);
  SolveReport solve(const EvolvingPatch& patch, const FlowSystem& system, Eigen::VectorXd& s,
                    const CancelToken& cancel);
  StepTrial attempt(EvolvingPatch& patch, const FlowSystem& system, StepRecord& record, const CancelToken& cancel);
  void finish(EvolvingPatch& patch, bool converged);
  bool mesh_is_worn(const EvolvingPatch& patch);

  double wanted_sigma_, sigma_;  ///< sigma_: of the next step; falls on rejection, recovers
  double decay_rate_ = 0;        ///< slowest, patch frame; 0 until it is first asked for
  double lowest_measure_;        ///< so far
  double improved_edge_length_;  ///< mean, at the last mesh improvement
  double worn_angle_ = 0;        ///< smallest, degrees, before it
  std::unique_ptr<GeneralSolver> solver_;
  std::unique_ptr<SpdSolver> spd_ = make_spd_solver();  ///< of Gauss-Newton
};

}  // namespace loopmend
