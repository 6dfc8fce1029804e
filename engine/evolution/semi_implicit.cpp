// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/semi_implicit.h"

#include "evolution/stopwatch.h"
#include "flows/decay_rate.h"
#include "flows/symmetric_part.h"
#include "mesh/quality.h"
#include "solvers/diagonal.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace loopmend {

namespace {

constexpr double steady_sigma = 1e4;     ///< a step that jumps to the steady state of the linear part
constexpr double fair_angle = 25;        ///< degrees: triangles no worse than this are left as they are
constexpr double flow_tolerance = 1.05;  ///< docs/math/energy_to_matrix.md, "Semi-implicit step"
/// Of the linear system. A step is off by a tenth of itself, being of first order in time.
constexpr double linear_tolerance = 1e-4;
constexpr double smallest_step = 1e-6;   ///< relative to the step that was asked for: below, the flow has stalled
constexpr int semi_implicit_trials = 2;  ///< of a step, before Gauss-Newton takes it
constexpr const char* collapsed_text =
    text_to_say("stopped early: only vanishing time steps keep the flow stable here");

bool has_energy(FlowKind flow) { return flow == FlowKind::mmcvf || flow == FlowKind::wf; }

}  // namespace

SemiImplicit::SemiImplicit(const EvolvingPatch& patch)
    : wanted_sigma_(patch.options.mode == EvolutionMode::steady ? steady_sigma : patch.options.sigma),
      sigma_(wanted_sigma_),
      lowest_measure_(patch.state.measure),
      improved_edge_length_(patch.edge_length()),
      solver_(make_general_solver(patch.options.solver, linear_tolerance)) {}

/// 1 where there is none, or when cancelled.
double SemiImplicit::decay_rate(const EvolvingPatch& patch, const CancelToken& cancel) {
  if (decay_rate_ > 0) return decay_rate_;
  const double rate = slowest_decay_rate(patch.options.flow, patch.state.patch, cancel);
  if (cancel.cancelled()) return 1;
  return decay_rate_ = rate > 0 ? rate : 1;
}

/// M(I/τ − V') s = M V, which is nearly symmetric.
SolveReport SemiImplicit::solve(const EvolvingPatch& patch, const FlowSystem& system, Eigen::VectorXd& s,
                                const CancelToken& cancel) {
  const Patch& surface = patch.state.patch;
  const Eigen::VectorXd mass = barycentric_areas(surface.positions, surface.triangles).head(surface.free_count);
  const double inverse_tau = decay_rate(patch, cancel) / sigma_;
  GeneralSystem linear;
  linear.times = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    return mass.cwiseProduct(inverse_tau * x - system.times_jacobian(x));
  };
  linear.matrix = [&]() -> SparseMatrix {
    const SparseMatrix M(mass.asDiagonal());
    return inverse_tau * M - M * system.jacobian();
  };
  linear.preconditioner = [&]() -> SparseMatrix {
    SparseMatrix K = symmetric_part(patch.options.flow, surface, patch.state.ops);
    store_diagonal(K);  // a vertex that no fit sees has no entry
    K.diagonal() += inverse_tau * mass;
    return K;
  };
  return solver_->solve(linear, mass.cwiseProduct(system.velocity()), s, cancel);
}

/// One trial with the present sigma.
StepTrial SemiImplicit::attempt(EvolvingPatch& patch, const FlowSystem& system, StepRecord& record,
                                const CancelToken& cancel) {
  Stopwatch watch;
  StepTrial trial;
  Eigen::VectorXd s;
  const SolveReport report = solve(patch, system, s, cancel);
  record.solve_seconds += watch.lap();
  record.iterations += report.iterations;
  record.factorizations += report.factored ? 1 : 0;
  if (!report.solved) return trial;
  EvolutionState next = displaced(patch.state, patch.objective, patch.stencil, s);
  trial.accepted = trial.whole = patch.acceptable(next, flow_tolerance * lowest_measure_);
  record.assemble_seconds += watch.lap();
  if (!trial.accepted) return trial;
  patch.accept(std::move(next), record, s, sigma_, decay_rate(patch, cancel));
  trial.move = patch.history.back().max_move;
  return trial;
}

/// Whether motion along the normals has worn the mesh since it was last improved. Moved vertices make the factors of the
/// steps before worth nothing, so they are not moved for their own sake.
bool SemiImplicit::mesh_is_worn(const EvolvingPatch& patch) {
  const Patch& surface = patch.state.patch;
  const double length = patch.edge_length();
  const double angle = min_angle_deg(surface.positions, surface.triangles, surface.patch_triangles);
  const bool stretched = std::abs(length - improved_edge_length_) > 0.05 * improved_edge_length_;
  const bool sharpened = angle < fair_angle && std::abs(angle - worn_angle_) > 0.1 * worn_angle_;
  if (patch.state.folds == 0 && !stretched && !sharpened) return false;
  improved_edge_length_ = length;
  worn_angle_ = angle;
  return true;
}

void SemiImplicit::finish(EvolvingPatch& patch, bool converged) {
  lowest_measure_ = std::min(lowest_measure_, patch.state.measure);
  if (converged) return patch.stop(PatchStatus::converged);
  if (sigma_ < smallest_step * wanted_sigma_) return patch.stop(PatchStatus::stalled, say(collapsed_text));
  sigma_ = std::min(wanted_sigma_, sigma_ * 3);
  if (mesh_is_worn(patch)) patch.improve_mesh(flow_tolerance * lowest_measure_);
}

void SemiImplicit::step(EvolvingPatch& patch, const CancelToken& cancel) {
  if (!patch.require_fits()) return;
  Stopwatch watch;
  add_weights(patch.state, patch.objective, patch.stencil);
  const FlowSystem system(patch.options.flow, FlowState(patch.state.ops, patch.state.patch.free_count));
  StepRecord record;
  record.assemble_seconds = watch.lap();
  std::optional<DampedStep> descent;
  for (int k = 0; k < most_trials; ++k) {
    if (patch.stop_if(cancel)) return;
    if (k == semi_implicit_trials && has_energy(patch.options.flow)) {
      descent.emplace(patch, spd_);
      sigma_ = wanted_sigma_;
    }
    const double rate = decay_rate(patch, cancel);
    if (patch.stop_if(cancel)) return;
    const StepTrial trial = descent
                                ? descent->attempt(patch, rate / (2 * sigma_), rate, Fits::operators, record, cancel)
                                : attempt(patch, system, record, cancel);
    // Smaller steps move less: that is no convergence. What counts is a step of the size that was asked for.
    const bool stands_still = trial.move < small_move * std::min(1.0, sigma_) && sigma_ >= 0.1 * wanted_sigma_;
    if (trial.accepted) return finish(patch, trial.whole && stands_still);
    if (descent && trial.solved && stands_still) return patch.stop(PatchStatus::converged);
    ++record.rejections;
    sigma_ /= 10;
  }
  if (!patch.stop_if(cancel)) patch.stop(PatchStatus::stalled, say(collapsed_text));
}

}  // namespace loopmend
