// SPDX-License-Identifier: GPL-3.0-or-later
// One damped Gauss-Newton step on the curvature energy: (μM + BᵀQB) s = −½∇E, then a line search.
#pragma once

#include "evolution/evolving_patch.h"
#include "flows/gauss_newton.h"
#include "solvers/linear_solver.h"

namespace loopmend {

/// What came of one trial of a step.
struct StepTrial {
  bool solved = false;
  bool accepted = false;
  bool whole = false;              ///< accepted as it was solved for, not a part of it
  double move = 0;                 ///< largest displacement before the line search, in mean edge lengths; 0 if unsolved
  double predicted_reduction = 0;  ///< of the energy, by the quadratic model; Gauss-Newton only
};

/// Patches with more free vertices keep neither weights nor factors longer than they must.
inline constexpr int largest_kept = 100000;

/// The linear system at the state that the patch has when this is made, for trials with different damping.
class DampedStep {
 public:
  /// @param patch   with weights. @param solver  keeps its symbolic analysis from step to step.
  DampedStep(const EvolvingPatch& patch, std::unique_ptr<SpdSolver>& solver);
  /// The whole step, a half, a quarter: the first that is acceptable is taken.
  /// @param mu    damping. @param unit  of mu: about the slowest decay rate of the flow.
  /// @param fits  that the next state needs.
  StepTrial attempt(EvolvingPatch& patch, double mu, double unit, Fits fits, StepRecord& record,
                    const CancelToken& cancel);
  /// Largest displacement of the whole step, in mean edge lengths; nothing is moved. Infinite where the matrix is singular.
  double move(const EvolvingPatch& patch, double mu, const CancelToken& cancel);

 private:
  bool solve(const EvolvingPatch& patch, double mu, StepRecord& record, Eigen::VectorXd& s, const CancelToken& cancel);
  bool solve_iteratively(const EvolvingPatch& patch, double mu, StepRecord& record, Eigen::VectorXd& s,
                         const CancelToken& cancel);

  std::unique_ptr<SpdSolver>& solver_;
  GaussNewtonSystem system_;
  SparseMatrix curvature_;  ///< BᵀQB; empty until it has to be factored
};

}  // namespace loopmend
