// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/threads.h"
#include "evolution/evolution_impl.h"
#include "evolution/stopwatch.h"
#include "flows/decay_rate.h"
#include "solvers/diagonal.h"

#include <algorithm>
#include <cmath>

namespace loopmend {

namespace {

constexpr double first_gauss_newton_sigma = 500;
constexpr int most_dampings = 6;      ///< of the trials of a step, because it would go too far
constexpr double longest_move = 0.3;  ///< of a Gauss-Newton step, in patch radii: further off the fits mean nothing
constexpr double newton_tolerance = 1 + 1e-9;
constexpr double settled_move = 5e-5;   ///< in patch radii: what such a bold step leaves is a few hundredths of it
constexpr double creeping_move = 1e-2;  ///< in mean edge lengths, with next to no fall of the energy:
constexpr double creeping_fall = 1e-4;  ///< relative, on average; the frozen fits lead no further down
constexpr std::size_t most_creeping_steps = 8;  ///< in a row
constexpr double smooth_start = 0.02;           ///< its energy by cubic fits, in that by quadratics
constexpr int largest_factored = 300000;        ///< free vertices: beyond, the matrix's factors take many gigabytes
constexpr int largest_kept = 100000;            ///< free vertices: beyond, factors make room for the next state
/// Of steps that are iterated: each iteration lowers the quadratic model, and its minimum is not the energy's. (Nocedal,
/// Wright, Numerical Optimization, 2nd ed., §7.1: truncated Newton.) On a hundred thousand free vertices 0.05 takes 67.
constexpr IterationLimits truncated{0.05, 100};
constexpr const char* damped_words =
    "stopped early: the flow has not converged, but only ever smaller steps lower the energy";
constexpr const char* stalled_words = "stopped early: no further step lowers the energy without folding the patch";

}  // namespace

EvolutionState Evolution::Impl::state_of_start_by_cubic_fits() const {
  return make_state(start, objective, Stencil::two_ring_cubic, nullptr, Fits::curvatures);
}

/// Near the steady state of smooth surroundings: the same energy from fits whose H is more accurate by an order. Where
/// these find the start better than what came of it, the mesh is too coarse for them; but for a start that they find far
/// better than quadratics do, as they find any smooth surface: then they go on from there.
bool Evolution::Impl::go_over_to_cubic_fits() {
  if (stencil == Stencil::two_ring_cubic || !smooth_surroundings || state.folds > start_folds) return false;
  EvolutionState cubic;
  const auto fit_here = [&] { cubic = make_state(state.patch, objective, Stencil::two_ring_cubic, state.topology); };
  if (cubic_start)
    fit_here();
  else
    parallel_invoke(fit_here, [&] { cubic_start = state_of_start_by_cubic_fits(); });
  if (!(cubic.measure < cubic_start->measure)) {
    if (!(cubic_start->measure < smooth_start * start_measure) || cubic_start->folds > start_folds) {
      smooth_surroundings = false;
      return false;
    }
    cubic = *cubic_start;  // it lay on a smooth surface, from which the quadratics only led away
  }
  stencil = Stencil::two_ring_cubic;
  state = std::move(cubic);
  small_moves = 0;
  creeping_from.clear();
  initial_energy = shown_energy(options.flow, *cubic_start);
  cubic_start.reset();
  history.back().energy = shown_energy(options.flow, state);
  return true;
}

/// At the minimum: done, unless more accurate fits can still refine it.
void Evolution::Impl::finish() {
  if (!go_over_to_cubic_fits()) stop(PatchStatus::converged, "");
}

/// Steps move nothing any more. Undamped ones say by that that this is the minimum; damped ones only that the damping holds
/// them: then an undamped one is tried, once. @returns false if that is to come.
bool Evolution::Impl::stand_still(bool undamped) {
  if (!undamped && std::exchange(undamped_left, false)) {
    mu = damping_unit / 2;
    small_moves = 0;
    creeping_from.clear();
    return false;
  }
  undamped ? finish() : stop(PatchStatus::stalled, damped_words);
  return true;
}

/// (μM + BᵀQB) s = −½∇E. @param curvature  BᵀQB, empty until it has to be factored.
bool Evolution::Impl::solve_gauss_newton(const GaussNewtonSystem& system, SparseMatrix& curvature, StepRecord& record,
                                         Eigen::VectorXd& s) {
  Stopwatch watch;
  if (state.patch.free_count > largest_factored) {
    GeneralSystem linear;
    linear.times = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
      return system.curvature_times(x) + mu * system.mass.cwiseProduct(x);
    };
    linear.nearby = [&]() { return near_gauss_newton(state.patch, energy_of(objective), mu); };
    const SolveReport report = conjugate_gradients(linear, *spd, truncated, -system.half_gradient, s);
    record.solve_seconds += watch.lap();
    record.iterations += report.iterations;
    ++record.factorizations;
    return report.solved;
  }
  if (curvature.rows() == 0) curvature = system.curvature();
  store_diagonal(curvature);  // a vertex that no fit sees has no entry
  record.assemble_seconds += watch.lap();
  ++record.factorizations;
  Eigen::MatrixXd solution;
  // The damping comes and goes in place: a copy of the matrix would be of the size of all else but its factors.
  const Eigen::VectorXd undamped = curvature.diagonal();
  curvature.diagonal() += mu * system.mass;
  const bool solved = spd->factorize(curvature) && spd->solve(-system.half_gradient, solution);
  curvature.diagonal() = undamped;
  record.solve_seconds += watch.lap();
  if (solved) s = solution;
  return solved;
}

/// Every so many steps one gains a little more than the others: the fall of several together counts.
bool Evolution::Impl::only_creeps(double move, double energy_before) {
  if (!(move < creeping_move)) {
    creeping_from.clear();
    return false;
  }
  creeping_from.push_back(energy_before);
  if (creeping_from.size() < most_creeping_steps) return false;
  const double fall = 1 - state.measure / creeping_from.front();
  creeping_from.pop_front();
  return fall < creeping_fall * static_cast<double>(most_creeping_steps);
}

/// One trial with the present mu: the whole step, a half, a quarter.
FlowTrial Evolution::Impl::try_gauss_newton(const GaussNewtonSystem& system, SparseMatrix& curvature,
                                            StepRecord& record, const CancelToken& cancel) {
  FlowTrial trial;
  Eigen::VectorXd s;
  trial.solved = solve_gauss_newton(system, curvature, record, s);
  if (state.patch.free_count > largest_kept) spd = make_spd_solver();
  if (!trial.solved) return trial;
  Stopwatch watch;
  trial.move = s.cwiseAbs().maxCoeff() / edge_length();
  trial.promised = -system.half_gradient.dot(s);
  // So far the linear model is worth nothing: more damping first, which smooths what is rough; then a part of the way.
  const double reach = longest_move * radius() / (trial.move * edge_length());
  if (reach < 1 && record.rejections < most_dampings) return trial;
  for (double share : {1.0, 0.5, 0.25}) {
    if (cancel.cancelled()) return trial;
    const Eigen::VectorXd move = std::min(1.0, reach) * share * s;
    // Near the end the next step is probably the last.
    EvolutionState next =
        displaced(state, objective, stencil, move, near_the_end() ? Fits::curvatures : Fits::operators);
    const bool good = acceptable(next, newton_tolerance * state.measure);
    record.assemble_seconds += watch.lap();
    if (!good) continue;
    accept(std::move(next), record, move, damping_unit / (2 * mu), damping_unit);
    trial.accepted = true;
    trial.whole = share == 1 && reach >= 1;
    return trial;
  }
  return trial;
}

void Evolution::Impl::gauss_newton_step(const CancelToken& cancel) {
  Stopwatch watch;
  if (damping_unit == 0) damping_unit = rough_decay_rate(options.flow, state.patch);
  add_weights(state, objective, stencil);
  GaussNewtonSystem system = assemble_gauss_newton(state.patch, state.ops, energy_of(objective));
  if (state.patch.free_count > largest_kept)
    drop_weights(state);  // else the next state takes from them what has not changed
  if (!(mu > 0)) mu = damping_unit / (2 * first_gauss_newton_sigma);
  SparseMatrix curvature;
  if (state.patch.free_count > largest_kept && state.patch.free_count <= largest_factored) {
    curvature = system.curvature();  // here for certain, and its parts make room for the factors
    system.B = {};
    system.Q = {};
  }
  StepRecord record;
  record.assemble_seconds = watch.lap();
  bool undamped = mu <= damping_unit, first = true;
  double promised = 0;  // by the first, boldest trial
  for (int k = 0; k < most_trials; ++k) {
    if (cancel.cancelled()) return stop(PatchStatus::cancelled, "cancelled");
    const double energy_before = state.measure;
    const FlowTrial trial = try_gauss_newton(system, curvature, record, cancel);
    if (trial.accepted) {
      const double move = history.back().max_move;
      // Gauss-Newton steps shrink ever faster: two bold ones tell how far the next would go.
      const bool next_small = mu <= damping_unit && record.rejections == 0 && move < 0.1 * last_bold_move &&
                              move * move / last_bold_move < 0.1 * small_move;
      last_bold_move = mu <= damping_unit && record.rejections == 0 ? move : 0;
      const double settled = std::max(0.1 * small_move, settled_move * radius() / edge_length());
      const bool small = move < settled || next_small;
      small_moves = small ? small_moves + 1 : 0;
      const bool bold = mu <= damping_unit;
      mu = std::max(0.2 * mu, 1e-8 * damping_unit);
      if ((small && (bold || small_moves >= 3)) || only_creeps(move, energy_before)) {
        stand_still(bold);
        return;
      }
      if (history.back().max_move < near_move && go_over_to_cubic_fits()) return;
      return care_for_mesh(std::min(1.2 * state.measure, energy_before));
    }
    if (first) promised = trial.promised;
    ++record.rejections;
    if (trial.move > 0 && trial.move < small_move) {
      // The gradient is that of frozen fits, exact to a few percent: close to the minimum it cannot lead further down.
      const bool at_minimum = first || promised < 1e-2 * energy_before || promised < 1e-6 * start_measure;
      if (!at_minimum) return stop(PatchStatus::stalled, stalled_words);
      if (stand_still(undamped)) return;
      undamped = first = true;
      continue;
    }
    first = false;
    mu *= 10;
  }
  if (cancel.cancelled()) return stop(PatchStatus::cancelled, "cancelled");
  stop(PatchStatus::stalled, stalled_words);
}

}  // namespace loopmend
