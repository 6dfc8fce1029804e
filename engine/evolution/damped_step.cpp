// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/damped_step.h"

#include "core/release.h"
#include "evolution/stopwatch.h"
#include "solvers/diagonal.h"

#include <algorithm>
#include <limits>

namespace loopmend {

namespace {

constexpr int most_dampings = 6;      ///< of the trials of a step, because it would go too far
constexpr double longest_move = 0.3;  ///< of a step, in patch radii: further off the fits mean nothing
constexpr double energy_tolerance = 1 + 1e-9;
constexpr int largest_factored = 300000;  ///< free vertices: beyond, the matrix's factors take many gigabytes
/// Of steps that are iterated: each iteration lowers the quadratic model, and its minimum is not the energy's. (Nocedal,
/// Wright, Numerical Optimization, 2nd ed., §7.1: truncated Newton.) On a hundred thousand free vertices 0.05 takes 67.
constexpr IterationLimits truncated{0.05, 100};

/// The curvature energy of a flow that has one.
EnergyWeights energy_of(const Objective& objective) {
  return objective.flow == FlowKind::wf ? EnergyWeights{0, 1} : EnergyWeights{1, objective.bending};
}

}  // namespace

DampedStep::DampedStep(const EvolvingPatch& patch, std::unique_ptr<SpdSolver>& solver)
    : solver_(solver),
      system_(assemble_gauss_newton(patch.state.patch, patch.state.ops, energy_of(patch.objective))) {
  const int free_count = patch.state.patch.free_count;
  if (free_count <= largest_kept || free_count > largest_factored) return;
  curvature_ = system_.curvature();  // needed for certain, and its parts make room for the factors
  release(system_.B);
  release(system_.Q);
}

bool DampedStep::solve_iteratively(const EvolvingPatch& patch, double mu, StepRecord& record, Eigen::VectorXd& s,
                                   const CancelToken& cancel) {
  GeneralSystem linear;
  linear.times = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    return system_.curvature_times(x) + mu * system_.mass.cwiseProduct(x);
  };
  linear.preconditioner = [&]() { return near_gauss_newton(patch.state.patch, energy_of(patch.objective), mu); };
  const SolveReport report = conjugate_gradients(linear, *solver_, truncated, -system_.half_gradient, s, cancel);
  record.iterations += report.iterations;
  return report.solved;
}

bool DampedStep::solve(const EvolvingPatch& patch, double mu, StepRecord& record, Eigen::VectorXd& s,
                       const CancelToken& cancel) {
  ++record.factorizations;
  if (patch.state.patch.free_count > largest_factored) return solve_iteratively(patch, mu, record, s, cancel);
  if (curvature_.rows() == 0) curvature_ = system_.curvature();
  store_diagonal(curvature_);  // a vertex that no fit sees has no entry
  Eigen::MatrixXd solution;
  // The damping comes and goes in place: a copy of the matrix would be of the size of all else but its factors.
  const Eigen::VectorXd undamped = curvature_.diagonal();
  curvature_.diagonal() += mu * system_.mass;
  const bool solved = solver_->factorize(curvature_, cancel) && solver_->solve(-system_.half_gradient, solution);
  curvature_.diagonal() = undamped;
  if (solved) s = solution;
  return solved;
}

double DampedStep::move(const EvolvingPatch& patch, double mu, const CancelToken& cancel) {
  StepRecord record;
  Eigen::VectorXd s;
  if (!solve(patch, mu, record, s, cancel)) return std::numeric_limits<double>::infinity();
  return s.cwiseAbs().maxCoeff() / patch.edge_length();
}

StepTrial DampedStep::attempt(EvolvingPatch& patch, double mu, double unit, Fits fits, StepRecord& record,
                              const CancelToken& cancel) {
  Stopwatch watch;
  StepTrial trial;
  Eigen::VectorXd s;
  trial.solved = solve(patch, mu, record, s, cancel);
  if (patch.state.patch.free_count > largest_kept) solver_ = make_spd_solver();
  record.solve_seconds += watch.lap();
  if (!trial.solved) return trial;
  trial.move = s.cwiseAbs().maxCoeff() / patch.edge_length();
  trial.predicted_reduction = -system_.half_gradient.dot(s);
  // So far the linear model is worth nothing: more damping first, which smooths what is rough; then a part of the way.
  const double reach = longest_move * patch_radius(patch.state.patch) / (trial.move * patch.edge_length());
  if (reach < 1 && record.rejections < most_dampings) return trial;
  for (double share : {1.0, 0.5, 0.25}) {
    if (cancel.cancelled()) return trial;
    const Eigen::VectorXd move = std::min(1.0, reach) * share * s;
    EvolutionState next = displaced(patch.state, patch.objective, patch.stencil, move, fits);
    const bool good = patch.acceptable(next, energy_tolerance * patch.state.measure);
    record.assemble_seconds += watch.lap();
    if (!good) continue;
    patch.accept(std::move(next), record, move, unit / (2 * mu), unit);
    trial.accepted = true;
    trial.whole = share == 1 && reach >= 1;
    return trial;
  }
  return trial;
}

}  // namespace loopmend
