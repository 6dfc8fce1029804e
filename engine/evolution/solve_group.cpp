#include "evolution/solve_group.h"

#include "evolution/best_start.h"
#include "rim/white_noise.h"

#include <algorithm>
#include <chrono>

namespace loopmend {

namespace {

/// A flow that stalled has stopped early, like one that ran out of steps; its message says which.
LoopStatus status_after(EvolutionStatus status) {
  return status == EvolutionStatus::converged ? LoopStatus::converged : LoopStatus::step_limit;
}

/// Free vertices of the part of the patch that each loop bounds.
std::vector<int> free_vertices_per_loop(const Patch& patch) {
  const std::vector<int> loop = loop_of_triangles(patch);
  std::vector<int> owner(patch.free_count, 0), result(patch.loops.size(), 0);
  for (int f = 0; f < patch.patch_triangles; ++f)
    for (int v : patch.triangles[f])
      if (v < patch.free_count) owner[v] = loop[f];
  for (int l : owner) ++result[l];
  return result;
}

void take_figures(const Evolution& evolution, Evolved& result) {
  result.steps = static_cast<int>(evolution.history().size());
  result.faired = result.steps > 0 && evolution.history().front().sigma == 0;
  for (const StepRecord& step : evolution.history()) {
    result.assemble += step.assemble_seconds;
    result.solve += step.solve_seconds;
  }
  result.initial_energy = evolution.initial_energy();
  result.final_energy = evolution.energy();
}

/// True if the flow should meet the surroundings without their noise.
bool sees_noise(const Patch& filler, const EvolutionOptions& options) {
  const bool judged = options.flow == FlowKind::mmcvf && options.mode == EvolutionMode::steady &&
                      options.rim == RimTrust::automatic && !options.bending &&
                      options.continuity == SeamContinuity::curvature;
  return judged && rim_roughness(filler).kind == Surroundings::noisy;
}

/// One run of the flow. @returns true if its result may be kept: if it is no worse than the filler.
bool evolve_once(const FillSite& site, const Patch& filler, const Patch& start, const EvolutionOptions& options,
                 const Evolution::OnStep& on_step, const CancelToken& cancel, Evolved& result) {
  const bool noisy = sees_noise(filler, options);
  EvolutionOptions in_force = options;
  if (noisy) in_force.bending = 0;  // what is left without the noise is smooth
  Evolution evolution(noisy ? without_noise(start, site.model) : start, in_force);
  const EvolutionStatus status = evolution.run(on_step, cancel);
  take_figures(evolution, result);
  if (status == EvolutionStatus::cancelled) return false;
  if (status == EvolutionStatus::failed && evolution.history().empty()) {
    result.message = "the flow could not start (" + evolution.message() + "): the filler was kept";
    return false;
  }
  Patch patch = noisy ? with_noise_again(evolution.patch(), filler) : evolution.patch();
  PatchVerdict verdict = judge(site, patch);
  const bool clean = verdict.folds == 0 && verdict.total() == 0;
  if (!clean && !no_worse(verdict, judge(site, filler))) {
    result.message = "the flow would have folded the patch or cut the surface: the filler was kept";
    return false;
  }
  result.patch = std::move(patch);
  result.verdict = std::move(verdict);
  result.status = status_after(status);
  result.message = evolution.message();
  result.bending = evolution.bending();
  return true;
}

RunRating rate(const Evolved& evolved) {
  return {evolved.status != LoopStatus::filled, evolved.status == LoopStatus::converged, evolved.faired, evolved.steps,
          evolved.final_energy};
}

/// @returns true if a result may be kept.
bool from_the_best_start(const FillSite& site, const Patch& filler, const EvolutionOptions& options,
                         const Evolution::OnStep& on_step, const CancelToken& cancel, Evolved& result) {
  result = best_of_starts(
      filler, options, cancel,
      [&](const Patch& start, const EvolutionOptions& from) {
        Evolved evolved;
        evolved.patch = filler;
        evolve_once(site, filler, start, from, on_step, cancel, evolved);
        return evolved;
      },
      rate);
  return result.status != LoopStatus::filled;
}

/// What to try where the flow spoils the patch: bending energy blended in, and lower orders, which bulge less. On rough
/// surroundings these come first.
std::vector<EvolutionOptions> gentler_options(const Patch& filler, const EvolutionOptions& options) {
  std::vector<EvolutionOptions> gentler(4, options);
  gentler[0].bending = 60;
  gentler[1].bending = 300;
  gentler[2].rim = RimTrust::smooth;
  gentler[3].continuity = SeamContinuity::tangent;
  if (rim_roughness(filler).kind == Surroundings::rough) std::reverse(gentler.begin(), gentler.end());
  return gentler;
}

}  // namespace

Evolved evolve_filler(const FillSite& site, const Patch& filler, const EvolutionOptions& options,
                      const Evolution::OnStep& on_step, const CancelToken& cancel) {
  Evolved result;
  result.patch = filler;
  if (filler.free_count == 0) {
    result.message = "too small to hold a free vertex: closed by triangles between its own vertices";
    result.verdict = judge(site, filler);
    return result;
  }
  if (from_the_best_start(site, filler, options, on_step, cancel, result) || cancel.cancelled()) return result;
  if (options.flow == FlowKind::mmcvf && options.mode == EvolutionMode::steady && !options.bending) {
    for (const EvolutionOptions& gentler : gentler_options(filler, options))
      if (evolve_once(site, filler, filler, gentler, on_step, cancel, result) || cancel.cancelled()) return result;
  }
  result.verdict = judge(site, filler);
  result.final_energy = result.initial_energy;
  result.steps = 0;
  return result;
}

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void take_result(const Evolved& evolved, LoopResult& result) {
  result.status = evolved.status;
  // What the filler lacked is past once the flow has mended it.
  if (evolved.status != LoopStatus::filled || !evolved.message.empty()) result.message = evolved.message;
  result.steps = evolved.steps;
  result.bending = evolved.bending;
  result.energy = {evolved.initial_energy, evolved.final_energy};
  result.seconds.assemble = evolved.assemble;
  result.seconds.solve = evolved.solve;
}

GroupOutcome solve_jointly(const FillSite& site, const std::vector<BoundaryLoop>& group, const FillOptions& options,
                           const CancelToken& cancel) {
  const auto start = std::chrono::steady_clock::now();
  GroupOutcome outcome = failed_group(group, "");
  const PatchStart first = start_patch(site.model, group, options.filler, cancel);
  for (std::size_t k = 0; k < group.size(); ++k) {
    outcome.results[k].message = first.fillers[k].message;
    outcome.results[k].seconds.filler = seconds_since(start);
  }
  if (!first.patch || cancel.cancelled()) return outcome;
  Evolved evolved;
  if (options.evolution) {
    evolved = evolve_filler(site, *first.patch, *options.evolution, nullptr, cancel);
  } else {
    evolved.patch = *first.patch;
    evolved.verdict = judge(site, evolved.patch);
  }
  if (cancel.cancelled()) return outcome;

  const PatchVerdict& verdict = evolved.verdict;
  const std::vector<int> free = free_vertices_per_loop(evolved.patch);
  const std::vector<SeamReport> before = seam_reports(*first.patch), after = seam_reports(evolved.patch);
  const RimRoughness roughness = rim_roughness(*first.patch);
  FinishedPatch finished;
  for (std::size_t p = 0; p < evolved.patch.loops.size(); ++p) {
    const auto found = std::find_if(outcome.results.begin(), outcome.results.end(), [&](const LoopResult& r) {
      return r.loop.number == evolved.patch.loop_numbers[p];
    });
    LoopResult& result = *found;
    result.seam_before = before[p];
    result.seam_after = after[p];
    result.free_vertices = free[p];
    result.rim = rim_summary(*first.patch, static_cast<int>(p), roughness);
    if (verdict.total() == 0)
      take_result(evolved, result);
    else
      result.message = "every patch that was found would cut the surface or itself, in " +
                       std::to_string(verdict.intersections[p]) + " places: left open";
    result.seconds.total = seconds_since(start);
    finished.loops.push_back(static_cast<int>(found - outcome.results.begin()));
  }
  finished.geometry = patch_geometry(evolved.patch);
  if (verdict.total() == 0) outcome.patches.push_back(std::move(finished));
  return outcome;
}

GroupOutcome solve_one_by_one(const FillSite& site, const std::vector<BoundaryLoop>& group, const FillOptions& options,
                              const CancelToken& cancel) {
  GroupOutcome outcome;
  for (const BoundaryLoop& loop : group) {
    GroupOutcome single = solve_jointly(site, {loop}, options, cancel);
    for (FinishedPatch& patch : single.patches) {
      patch.loops = {static_cast<int>(outcome.results.size())};
      outcome.patches.push_back(std::move(patch));
    }
    outcome.results.push_back(std::move(single.results.front()));
  }
  return outcome;
}

int count_status(const GroupOutcome& outcome, LoopStatus status) {
  return static_cast<int>(std::count_if(outcome.results.begin(), outcome.results.end(),
                                        [&](const LoopResult& r) { return r.status == status; }));
}

}  // namespace

GroupOutcome failed_group(const std::vector<BoundaryLoop>& group, const std::string& why) {
  GroupOutcome outcome;
  for (const BoundaryLoop& loop : group) {
    LoopResult result;
    result.loop = loop;
    result.status = LoopStatus::failed;
    result.message = why;
    outcome.results.push_back(std::move(result));
  }
  return outcome;
}

GroupOutcome solve_group(const FillSite& site, const std::vector<BoundaryLoop>& group, const FillOptions& options,
                         const CancelToken& cancel) try {
  GroupOutcome joint = solve_jointly(site, group, options, cancel);
  const bool spoilt =
      count_status(joint, LoopStatus::failed) > 0 || (options.evolution && count_status(joint, LoopStatus::filled) > 0);
  if (group.size() == 1 || !spoilt || cancel.cancelled()) return joint;
  return solve_one_by_one(site, group, options, cancel);
} catch (const std::exception& error) {
  return failed_group(group, error.what());
}

}  // namespace loopmend
