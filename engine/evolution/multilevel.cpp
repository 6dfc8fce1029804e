// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/multilevel.h"

#include "evolution/coarse_patch.h"
#include "evolution/stopwatch.h"

#include <utility>

namespace loopmend {

namespace {

constexpr double least_coarsening = 0.7;       ///< of the free vertices
constexpr std::size_t most_coarse_steps = 12;  ///< straight ways take fewer; a longer one may lead to a bubble

Vec3 centroid(const Patch& patch) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < patch.free_count; ++i) sum += patch.positions[i];
  return sum / patch.free_count;
}

}  // namespace

Multilevel::Multilevel(const EvolvingPatch& patch, NearConvergence fits)
    : fits_(fits),
      steady_(patch, fits),
      coarse_start_left_(patch.history.empty() && patch.options.start == SteadyStart::faired &&
                         patch.options.triangles == PatchTriangles::free && worth_coarsening(patch.state.patch)) {}

void Multilevel::step(EvolvingPatch& patch, const CancelToken& cancel) {
  if (!patch.require_fits()) return;
  if (std::exchange(coarse_start_left_, false) && (coarse_step(patch, cancel) || patch.stop_if(cancel))) return;
  steady_.step(patch, cancel);
}

/// @returns false if there is no coarse steady state, or it does not lower the energy; then the state is as it was.
bool Multilevel::coarse_step(EvolvingPatch& patch, const CancelToken& cancel) {
  Stopwatch watch;
  Patch copy = coarsened(patch.state.patch);
  // Between tubes there may be nothing to take away; such a copy would ask for a coarse copy of its own, without end.
  if (copy.free_count > least_coarsening * patch.state.patch.free_count) return false;
  EvolvingPatch coarse(std::move(copy));
  coarse.begin(patch.options, patch.objective);
  Multilevel stepper(coarse, fits_);
  const SteadyState& steady = stepper.steady_;
  while (coarse.status == PatchStatus::ready && coarse.history.size() < most_coarse_steps &&
         !steady.near_convergence() && !coarse.stop_if(cancel))
    stepper.step(coarse, cancel);
  StepRecord record;
  record.solve_seconds = watch.lap();
  if (coarse.status != PatchStatus::converged && !steady.near_convergence()) return false;
  EvolutionState next = make_state(refined(coarse.state, patch.state.patch.grading), patch.objective, coarse.stencil);
  record.assemble_seconds = watch.lap();
  if (!patch.acceptable(next, patch.state.measure)) return false;
  if (coarse.stencil != patch.stencil)
    patch.initial_energy = shown_energy(
        patch.options.flow, make_state(patch.start, patch.objective, coarse.stencil, nullptr, Fits::curvatures));
  patch.stencil = coarse.stencil;
  steady_.skip_fairings(steady.damping_unit());
  // Vertices come and go: only the displacement of the middle can be compared.
  patch.accept_start(std::move(next), record, (centroid(coarse.start) - centroid(coarse.state.patch)).norm());
  return true;
}

}  // namespace loopmend
