// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/steady_state.h"

#include "core/threads.h"
#include "evolution/mesh_improvement.h"
#include "evolution/stopwatch.h"
#include "filling/fairing.h"
#include "flows/decay_rate.h"
#include "mesh/quality.h"

#include <algorithm>
#include <utility>

namespace loopmend {

namespace {

constexpr int most_fairings = 6;
constexpr double near_move = 1;  ///< in mean edge lengths: a smooth neighborhood is worth cubic fits from here
constexpr double near_convergence_move = 0.05;              ///< in mean edge lengths
constexpr double first_sigma = 500;                         ///< of the first Gauss-Newton step
constexpr double no_damping = 1e-8, little_damping = 1e-3;  ///< of the slowest decay rate
constexpr double converged_move =
    5e-5;                       ///< in patch radii: what such an undamped step leaves is a few hundredths of it
constexpr double still = 4e-3;  ///< in patch radii: a step that no restart need make
constexpr double stagnation_move = 1e-2;               ///< in mean edge lengths, with next to no fall of the energy:
constexpr double stagnation_fall = 1e-4;               ///< relative, on average; the frozen fits lead no further down
constexpr std::size_t most_stagnating_steps = 8;       ///< in a row
constexpr double smooth_start = 0.02;                  ///< its energy by cubic fits, in that by quadratics
constexpr double worn_growth = 1.05, worn_angle = 30;  ///< of the edges; smallest, degrees: a mesh beyond is remeshed
constexpr const char* damped_text =
    text_to_say("stopped early: the flow has not converged, but only ever smaller steps lower the energy");
constexpr const char* stalled_text =
    text_to_say("stopped early: no further step lowers the energy without folding the patch");

EvolutionState start_by_cubic_fits(const EvolvingPatch& patch) {
  return make_state(patch.start, patch.objective, Stencil::two_ring_cubic, nullptr, Fits::curvatures);
}

bool mesh_is_worn(const EvolvingPatch& patch) {
  const Patch &start = patch.start, &now = patch.state.patch;
  const double first_edge = mean_edge_length(start.positions, start.triangles, start.patch_triangles);
  return patch.state.folds > 0 || patch.edge_length() > worn_growth * first_edge ||
         min_angle_deg(now.positions, now.triangles, now.patch_triangles) < worn_angle;
}

struct FairedPatch {
  Patch patch;
  std::shared_ptr<const Topology> topology;
  double move = 0;  ///< largest, patch frame
  double assemble_seconds = 0, solve_seconds = 0;
};

/// One linear fairing of ∫‖∇H‖² + bending ∫H², of the patch on a fresh mesh where its own is worn. Where that folds it: the
/// same with even weights, then on the mesh that remeshing makes of what came out.
FairedPatch linearly_faired(const EvolvingPatch& from, const CancelToken& cancel) {
  Stopwatch watch;
  FairedPatch result;
  Patch patch = from.state.patch;
  result.topology = from.state.topology;
  const auto remesh = [&](const Patch& shape) {
    patch = remeshed(shape);
    result.topology = std::make_shared<Topology>(patch.vertex_count(), patch.triangles);
  };
  const bool may_remesh = from.options.triangles == PatchTriangles::free;
  if (may_remesh && !from.history.empty() && mesh_is_worn(from)) remesh(patch);
  for (int attempt = 0; attempt < (may_remesh ? 3 : 2); ++attempt) {
    if (attempt == 2) remesh(result.patch);
    result.assemble_seconds += watch.lap();
    const bool evenly = from.options.start == SteadyStart::evenly_faired || attempt > 0;
    result.patch = patch;
    result.patch.positions =
        linear_fairing(patch, *result.topology, from.objective.bending, evenly ? even_clamp : robust_clamp, cancel);
    result.solve_seconds += watch.lap();
    result.move = 0;
    for (int i = 0; i < patch.free_count; ++i)
      result.move = std::max(result.move, (result.patch.positions[i] - patch.positions[i]).norm());
    const int folds = count_folds(result.patch.positions, patch.triangles, patch.patch_triangles);
    result.assemble_seconds += watch.lap();
    if (folds == 0 || cancel.cancelled()) break;
  }
  return result;
}

}  // namespace

SteadyState::SteadyState(const EvolvingPatch& patch, NearConvergence fits)
    : fits_(fits),
      fairings_left_(patch.history.empty() && patch.options.start != SteadyStart::as_given ? most_fairings : 0),
      may_rest_(fairings_left_ == 0 && fits == NearConvergence::cubic_fits),
      start_measure_(patch.state.measure) {}

bool SteadyState::near_convergence() const {
  return last_undamped_move_ > 0 && last_undamped_move_ < near_convergence_move;
}

void SteadyState::skip_fairings(double unit) {
  unit_ = unit;
  fairings_left_ = 0;
}

void SteadyState::step(EvolvingPatch& patch, const CancelToken& cancel) {
  // Before the fairings: what they alone have shaped must not pass for the flow's work.
  if (!patch.require_fits()) return;
  if (fairings_left_ > 0) {
    --fairings_left_;
    if (fairing_step(patch, cancel) || patch.stop_if(cancel)) return;
    fairings_left_ = 0;
  }
  if (std::exchange(may_rest_, false) && (rests_by_cubic_fits(patch, cancel) || patch.stop_if(cancel))) return;
  gauss_newton_step(patch, cancel);
}

/// A restart from where an evolution converged by cubic fits: quadratic ones have another steady state. @returns false if
/// an undamped step by cubic fits moves something; then the state is as it was.
bool SteadyState::rests_by_cubic_fits(EvolvingPatch& patch, const CancelToken& cancel) {
  if (!find_unit(patch, cancel)) return false;
  EvolvingPatch cubic = patch;
  cubic.stencil = Stencil::two_ring_cubic;
  cubic.state = make_state(patch.state.patch, patch.objective, cubic.stencil, patch.state.topology, Fits::curvatures);
  if (!stands_still(cubic, cancel) || cancel.cancelled()) return false;
  patch = std::move(cubic);
  if (patch.history.empty()) patch.initial_energy = patch.energy();
  patch.stop(PatchStatus::converged);
  return true;
}

/// A linear fairing instead of a Gauss-Newton step, while it pays: from its result large openings are reached too.
/// @returns false if that does not lower the energy any more; then the state is as it was.
bool SteadyState::fairing_step(EvolvingPatch& patch, const CancelToken& cancel) {
  const EvolutionState& now = patch.state;
  FairedPatch faired;
  EvolutionState next;
  const auto fair = [&] {
    faired = linearly_faired(patch, cancel);
    if (cancel.cancelled()) return;
    Stopwatch watch;
    next = make_state(std::move(faired.patch), patch.objective, patch.stencil, faired.topology, Fits::curvatures);
    faired.assemble_seconds += watch.lap();
  };
  // Fairings leave the other core half idle, and what comes after them will need the start by cubic fits.
  if (fits_ == NearConvergence::cubic_fits && !cubic_start_ && thread_budget() > 1)
    parallel_invoke(fair, [&] { cubic_start_ = start_by_cubic_fits(patch); });
  else
    fair();
  if (cancel.cancelled() || !patch.acceptable(next, now.measure)) return false;
  if (next.measure > 0.5 * now.measure && next.folds == 0) fairings_left_ = 0;
  StepRecord record;
  record.assemble_seconds = faired.assemble_seconds;
  record.solve_seconds = faired.solve_seconds;
  patch.accept_start(std::move(next), record, faired.move);
  // As after a Gauss-Newton step: so near, those steps had better be of the fits that they will end with.
  if (fairings_left_ == 0 && patch.history.back().max_move < near_move) use_cubic_fits(patch);
  return true;
}

/// The same energy from fits whose H is more accurate by an order. Where these find the start better than what came of it,
/// the mesh is too coarse for them; except where they find the start far better than quadratics do, as they find any smooth
/// surface: then they go on from there. @returns whether the state is now of cubic fits, and was not before.
bool SteadyState::use_cubic_fits(EvolvingPatch& patch) {
  if (patch.stencil == Stencil::two_ring_cubic || fits_ == NearConvergence::quadratic_fits ||
      patch.state.folds > patch.start_folds)
    return false;
  EvolutionState cubic;
  const auto fit_here = [&] {
    cubic = make_state(patch.state.patch, patch.objective, Stencil::two_ring_cubic, patch.state.topology);
  };
  if (cubic_start_)
    fit_here();
  else
    parallel_invoke(fit_here, [&] { cubic_start_ = start_by_cubic_fits(patch); });
  if (!(cubic.measure < cubic_start_->measure)) {
    if (!(cubic_start_->measure < smooth_start * start_measure_) || cubic_start_->folds > patch.start_folds) {
      fits_ = NearConvergence::quadratic_fits;
      return false;
    }
    cubic = *cubic_start_;  // it lay on a smooth surface, from which the quadratics only led away
  }
  patch.stencil = Stencil::two_ring_cubic;
  patch.state = std::move(cubic);
  patch.initial_energy = shown_energy(patch.options.flow, *cubic_start_);
  if (!patch.history.empty()) patch.history.back().energy = patch.energy();  // no step may have been accepted
  tiny_steps_ = 0;
  small_steps_.clear();
  cubic_start_.reset();
  return true;
}

/// Whether the whole step of Gauss-Newton, which a restart would begin with, goes nowhere.
bool SteadyState::stands_still(EvolvingPatch patch, const CancelToken& cancel) {
  add_weights(patch.state, patch.objective, patch.stencil);
  const double move = DampedStep(patch, solver_).move(patch, no_damping * unit_, cancel);
  return move < std::max(stagnation_move, still * patch_radius(patch.state.patch) / patch.edge_length());
}

/// Steps move nothing any more. Undamped ones say by that that this is the minimum, which only more accurate fits can still
/// refine; damped ones only that the damping holds them: then an undamped one is tried, once.
/// @returns false if that is to come.
bool SteadyState::at_rest(EvolvingPatch& patch, bool undamped, const CancelToken& cancel) {
  if (!undamped && std::exchange(undamped_left_, false)) {
    mu_ = unit_ / 2;
    tiny_steps_ = 0;
    small_steps_.clear();
    return false;
  }
  if (undamped && use_cubic_fits(patch)) return true;
  const bool converged = undamped && (mu_ <= little_damping * unit_ || stands_still(patch, cancel));
  if (patch.stop_if(cancel)) return true;
  if (converged)
    patch.stop(PatchStatus::converged);
  else
    patch.stop(PatchStatus::stalled, say(damped_text));
  return true;
}

/// Every so many steps one gains a little more than the others: the fall of several together counts.
bool SteadyState::stagnates(const EvolvingPatch& patch, double move, double energy_before) {
  if (!(move < stagnation_move)) {
    small_steps_.clear();
    return false;
  }
  small_steps_.push_back(energy_before);
  if (small_steps_.size() < most_stagnating_steps) return false;
  const double fall = 1 - patch.state.measure / small_steps_.front();
  small_steps_.pop_front();
  return fall < stagnation_fall * static_cast<double>(most_stagnating_steps);
}

/// Outcome of an accepted step of Gauss-Newton: converged, stagnating, or the next one follows.
void SteadyState::after_step(EvolvingPatch& patch, int rejections, double energy_before, const CancelToken& cancel) {
  const double move = patch.history.back().max_move;
  const bool undamped = is_undamped(), at_once = undamped && rejections == 0;
  // Gauss-Newton steps shrink ever faster: two undamped ones tell how far the next would go.
  const bool next_tiny =
      at_once && move < 0.1 * last_undamped_move_ && move * move / last_undamped_move_ < 0.1 * small_move;
  last_undamped_move_ = at_once ? move : 0;
  const double settled =
      std::max(0.1 * small_move, converged_move * patch_radius(patch.state.patch) / patch.edge_length());
  const bool tiny = move < settled || next_tiny;
  tiny_steps_ = tiny ? tiny_steps_ + 1 : 0;
  mu_ = std::max(0.2 * mu_, no_damping * unit_);
  if ((tiny && (undamped || tiny_steps_ >= 3)) || stagnates(patch, move, energy_before)) {
    at_rest(patch, undamped, cancel);
    return;
  }
  if (move < near_move && use_cubic_fits(patch)) return;
  patch.improve_mesh(std::min(1.2 * patch.state.measure, energy_before));
}

namespace {

/// Large patches do with about the slowest decay rate: that itself takes as long as a step.
double damping_unit_of(const EvolvingPatch& patch, const CancelToken& cancel) {
  constexpr int most_for_exact = 20'000;  // free vertices
  const Patch& present = patch.state.patch;
  const double rate = present.free_count > most_for_exact ? rough_decay_rate(patch.options.flow, present)
                                                          : slowest_decay_rate(patch.options.flow, present, cancel);
  return rate > 0 ? rate : 1;
}

}  // namespace

/// @returns false if cancelled.
bool SteadyState::find_unit(EvolvingPatch& patch, const CancelToken& cancel) {
  if (unit_ != 0) return true;
  const double unit = damping_unit_of(patch, cancel);
  if (patch.stop_if(cancel)) return false;
  unit_ = unit;
  return true;
}

void SteadyState::gauss_newton_step(EvolvingPatch& patch, const CancelToken& cancel) {
  Stopwatch watch;
  if (!find_unit(patch, cancel)) return;
  if (!(mu_ > 0)) mu_ = unit_ / (2 * first_sigma);
  add_weights(patch.state, patch.objective, patch.stencil);
  std::optional<DampedStep> damped(std::in_place, patch, solver_);
  // Else the next state takes from them what has not changed.
  if (patch.state.patch.free_count > largest_kept) drop_weights(patch.state);
  StepRecord record;
  record.assemble_seconds = watch.lap();
  const double energy_before = patch.state.measure;
  bool undamped = is_undamped(), first = true;
  double predicted = 0;  // by the first trial, which is damped least
  for (int k = 0; k < most_trials; ++k) {
    if (patch.stop_if(cancel)) return;
    // Near convergence the next step is probably the last.
    const Fits fits = near_convergence() ? Fits::curvatures : Fits::operators;
    const StepTrial trial = damped->attempt(patch, mu_, unit_, fits, record, cancel);
    if (trial.accepted) return after_step(patch, record.rejections, energy_before, cancel);
    if (first) predicted = trial.predicted_reduction;
    ++record.rejections;
    if (trial.move > 0 && trial.move < small_move) {
      // The gradient is that of frozen fits, exact to a few percent: close to the minimum it cannot lead further down.
      const bool at_minimum = first || predicted < 1e-2 * energy_before || predicted < 1e-6 * start_measure_;
      if (!at_minimum) return patch.stop(PatchStatus::stalled, say(stalled_text));
      if (undamped) damped.reset();  // at_rest() makes one of its own
      if (at_rest(patch, undamped, cancel)) return;
      undamped = first = true;
      continue;
    }
    first = false;
    mu_ *= 10;
  }
  if (!patch.stop_if(cancel)) patch.stop(PatchStatus::stalled, say(stalled_text));
}

}  // namespace loopmend
