// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/evolve_filler.h"

#include "core/threads.h"
#include "evolution/best_start.h"
#include "evolution/local_retreat.h"
#include "evolution/state.h"
#include "mesh/quality.h"
#include "rim/rim_blend.h"
#include "rim/stray_vertices.h"
#include "rim/white_noise.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace loopmend {

namespace {

/// A flow that stalled has stopped early, like one that ran out of steps; its message says which.
LoopStatus status_after(EvolutionStatus status) {
  switch (status) {
    case EvolutionStatus::converged: return LoopStatus::converged;
    case EvolutionStatus::faired: return LoopStatus::faired;
    default: return LoopStatus::step_limit;
  }
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

/// What the surroundings are worth to the sixth order.
struct JudgedRim {
  RimRoughness roughness;
  std::optional<CalmSurroundings> calm;  ///< where single vertices stand off surroundings that are smooth without them
};

/// Empty where the options leave nothing to be judged.
std::optional<JudgedRim> judged_rim(const Patch& filler, const EvolutionOptions& options, const RimSurvey* survey) {
  if (!is_judged(options)) return std::nullopt;
  CalmSurroundings calm = survey ? without_strays(filler, survey->strays) : without_strays(filler);
  if (calm.strays > 0) {
    const RimRoughness roughness = rim_roughness(calm.patch);
    // White noise is taken off by robust fits, and the rough patch doubts its rim, each with the strays in it.
    if (roughness.noise_share == 0 && roughness.rough_share < 1) return JudgedRim{roughness, std::move(calm)};
  }
  return JudgedRim{options.roughness ? *options.roughness : rim_roughness(filler), std::nullopt};
}

/// What all runs for one filler have in common.
struct Run {
  const FillSite& site;
  const Patch& filler;
  double noise_share;            ///< of the surroundings' noise that the flow does not meet
  const CalmSurroundings* calm;  ///< which the flow meets in place of the filler's; null: these
  const Evolution::OnStep& on_step;
  const CancelToken& cancel;

  /// What the flow sets out from.
  Patch start_from(const Patch& start) const {
    if (noise_share > 0) return without_noise(start, site.model, noise_share);
    return calm != nullptr ? with_noise_again(start, calm->patch, reach_of_strays()) : start;
  }
  /// What it came to, between the surroundings as they are.
  Patch result_from(const Patch& evolved) const {
    if (noise_share > 0) return with_noise_again(evolved, filler);
    return calm != nullptr ? with_noise_again(evolved, filler, reach_of_strays()) : evolved;
  }
  /// A single vertex off its place is of no account a few edges away.
  double reach_of_strays() const {
    return mean_edge_length(filler.positions, filler.triangles, filler.patch_triangles);
  }
};

std::string words_on_strays(int strays) {
  return strays == 1
             ? "one vertex at the rim stands off the surface round about: the patch meets it, but does not take its "
               "curvature from it"
             : std::to_string(strays) +
                   " vertices at the rim stand off the surface round about: the patch meets them, but does not take "
                   "its curvature from them";
}

/// One run of the flow. @returns true if its result may be kept: if it is no worse than the filler.
bool evolve_once(const Run& run, const Patch& start, const EvolutionOptions& options, Evolved& result) {
  const FillSite& site = run.site;
  const Patch& filler = run.filler;
  Evolution evolution(run.start_from(start), options);
  const EvolutionStatus status = evolution.run(run.on_step, run.cancel);
  take_figures(evolution, result);
  if (status == EvolutionStatus::cancelled) return false;
  if (status == EvolutionStatus::failed && evolution.history().empty()) {
    result.message = "the flow could not start: " + evolution.message();
    return false;
  }
  Patch patch = run.result_from(evolution.patch());
  PatchVerdict verdict;
  std::vector<SeamReport> seams;
  parallel_invoke([&] { verdict = judge(site, patch); }, [&] { seams = seam_reports(patch); });
  const bool clean = verdict.folds == 0 && verdict.total() == 0;
  if (!clean && !no_worse(verdict, judge(site, filler))) {
    result.message = "the flow would have folded the patch or cut the surface";
    return false;
  }
  result.patch = std::move(patch);
  result.verdict = std::move(verdict);
  result.seams = std::move(seams);
  result.status = status_after(status);
  result.method = run.noise_share > 0 ? Method::denoised_flow : evolution.method();
  result.message = evolution.message();
  if (result.message.empty() && run.calm != nullptr) result.message = words_on_strays(run.calm->strays);
  result.bending = evolution.bending();
  return true;
}

RunRating rate(const Evolved& evolved) {
  const bool at_its_end = evolved.status == LoopStatus::converged || evolved.status == LoopStatus::faired;
  return {evolved.status != LoopStatus::filled, at_its_end, evolved.faired, evolved.steps, evolved.final_energy};
}

/// @returns true if a result may be kept.
bool from_the_best_start(const Run& run, const EvolutionOptions& options, Evolved& result) {
  result = best_of_starts(
      run.filler, options, run.cancel,
      [&](const Patch& start, const EvolutionOptions& from) {
        Evolved evolved;
        evolved.patch = run.filler;
        evolve_once(run, start, from, evolved);
        return evolved;
      },
      rate);
  return result.status != LoopStatus::filled;
}

/// Those of the linear fairings for rough surroundings, whatever share the surroundings ask for.
EvolutionOptions robust_options(EvolutionOptions options, const RimRoughness& rim) {
  options.boundary = BoundaryTrust::robust;
  options.roughness = rim;
  return options;
}

/// The share of the robust patch, raised where the literal one strays from it: sixth order that goes far from what the
/// surroundings allow has been led astray by their roughness.
double share_between(const Patch& literal, const Patch& robust, const RimRoughness& rim) {
  constexpr double near = 0.1, astray = 0.3;  // of the patch's radius
  double way = 0;
  for (int i = 0; i < literal.free_count; ++i) way = std::max(way, (literal.positions[i] - robust.positions[i]).norm());
  const double trust = std::clamp((astray - way / rim.radius) / (astray - near), 0.0, 1.0);
  return 1 - (1 - rim.rough_share) * trust;
}

/// Between smooth and rough surroundings: both patches on the filler's vertices, and the way from one to the other.
/// @returns false if there is no such passage, since one of them does not exist or the mesh had to be changed.
bool evolve_between(const Run& run, const Patch& start, const EvolutionOptions& options, const RimRoughness& rim,
                    Evolved& result) {
  EvolutionOptions literal_options = options;
  literal_options.bending = (1 - run.noise_share) * rim.bending;
  literal_options.triangles = PatchTriangles::kept;
  Evolved literal;
  if (!evolve_once({run.site, run.filler, 0, nullptr, run.on_step, run.cancel}, start, robust_options(options, rim),
                   result))
    return false;
  if (!evolve_once(run, start, literal_options, literal)) return true;
  if (literal.patch.free_count != result.patch.free_count) return true;
  const Eigen::VectorXd trust = rim_trust(result.patch, rim.radius, data_trust(result.patch, rim.radius));
  const double share = share_between(literal.patch, result.patch, rim);
  Patch patch = passage_between(literal.patch, result.patch, share, trust);
  PatchVerdict verdict = judge(run.site, patch);
  if (!no_worse(verdict, result.verdict)) return true;
  result.patch = std::move(patch);
  result.verdict = std::move(verdict);
  result.seams = seam_reports(result.patch);
  result.method = Method::interpolated;
  if (result.message.empty() && run.calm != nullptr) result.message = words_on_strays(run.calm->strays);
  result.steps += literal.steps;
  result.assemble += literal.assemble;
  result.solve += literal.solve;
  result.bending = share * result.bending + (1 - share) * literal.bending;
  result.final_energy = shown_energy(
      options.flow, make_state(result.patch, {options.flow, 0}, Stencil::two_ring, nullptr, Fits::curvatures));
  return true;
}

/// The filler of the same loops before it was relaxed. Empty if there is none.
std::optional<Patch> unrelaxed(const FillSite& site, const Patch& filler, const std::vector<BoundaryLoop>& loops,
                               const CancelToken& cancel) {
  std::vector<BoundaryLoop> closed;  // a joint filler leaves out those that have none
  for (const BoundaryLoop& loop : loops)
    if (std::find(filler.loop_numbers.begin(), filler.loop_numbers.end(), loop.number) != filler.loop_numbers.end())
      closed.push_back(loop);
  std::optional<Patch> patch =
      start_patch(site.model, closed, {filler.grading.density, FillerShape::triangulated}, cancel).patch;
  return patch && patch->loop_numbers == filler.loop_numbers && patch->free_count > 0 ? patch : std::nullopt;
}

/// What it takes not to throw the fairings away as a whole for a few spoilt places. @returns true if a result may be kept.
bool fair_and_retreat(const Run& run, const Patch& start, const EvolutionOptions& options, Evolved& result) {
  Evolution evolution(start, options);
  const EvolutionStatus status = evolution.run(run.on_step, run.cancel);
  if (status == EvolutionStatus::cancelled || status == EvolutionStatus::failed) return false;
  std::optional<Retreat> retreat =
      retreat_locally(run.site, start, evolution.patch(), judge(run.site, run.filler), run.cancel);
  if (!retreat) return false;
  take_figures(evolution, result);
  result.patch = std::move(retreat->patch);
  result.verdict = std::move(retreat->verdict);
  result.seams = seam_reports(result.patch);
  result.status = status_after(status);
  result.method = evolution.method();
  result.bending = evolution.bending();
  result.final_energy = shown_energy(
      options.flow, make_state(result.patch, {options.flow, 0}, Stencil::two_ring, nullptr, Fits::curvatures));
  result.message = retreat->moved == 0
                       ? ""
                       : "the patch would have folded or cut the surface at a few places: there, at " +
                             std::to_string(retreat->moved) + " of its " + std::to_string(result.patch.free_count) +
                             " vertices, it goes back towards what it set out from";
  return true;
}

/// On rough surroundings, or between: from the first start whose result may be kept, or else may be kept in the main.
/// @returns false if there is none.
bool evolve_robustly(const Run& run, const std::vector<const Patch*>& starts, const EvolutionOptions& options,
                     const RimRoughness& rim, Evolved& result) {
  const Run plain{run.site, run.filler, 0, nullptr, run.on_step, run.cancel};
  const EvolutionOptions robust = robust_options(options, rim);
  for (const Patch* start : starts) {
    if (rim.rough_share < 1 ? evolve_between(run, *start, options, rim, result)
                            : evolve_once(plain, *start, robust, result))
      return true;
    if (run.cancel.cancelled()) return false;
  }
  for (const Patch* start : starts)
    for (const PatchTriangles triangles : {PatchTriangles::kept, PatchTriangles::fixed}) {
      EvolutionOptions same_vertices = robust;
      same_vertices.triangles = triangles;
      if (fair_and_retreat(plain, *start, same_vertices, result)) return true;
    }
  return false;
}

/// What to try where the flow spoils the patch: bending energy blended in, and lower orders, which bulge less. On rough
/// surroundings these come first.
std::vector<EvolutionOptions> gentler_options(Surroundings surroundings, const EvolutionOptions& options) {
  std::vector<EvolutionOptions> gentler(4, options);
  gentler[0].bending = 60;
  gentler[1].bending = 300;
  gentler[2].boundary = BoundaryTrust::robust;
  gentler[3].continuity = SeamContinuity::tangent;
  if (surroundings == Surroundings::rough) std::reverse(gentler.begin(), gentler.end());
  return gentler;
}

/// The results of the methods in the order in which they are tried.
Evolved first_that_holds(const FillSite& site, const Patch& filler, const std::vector<BoundaryLoop>& loops,
                         const EvolutionOptions& asked_for, const Evolution::OnStep& on_step, const CancelToken& cancel,
                         const RimSurvey* survey) {
  Evolved result;
  result.patch = filler;
  const std::optional<JudgedRim> judged = judged_rim(filler, asked_for, survey);
  const std::optional<RimRoughness> rim = judged ? std::optional(judged->roughness) : std::nullopt;
  EvolutionOptions options = asked_for;
  if (rim) options.roughness.reset();  // of the filler as it is: runs whose surroundings are smoothed have another
  const double noise_share = rim ? rim->noise_share : 0;
  const CalmSurroundings* calm = judged && judged->calm ? &*judged->calm : nullptr;
  const Run run{site, filler, noise_share, calm, on_step, cancel}, plain{site, filler, 0, calm, on_step, cancel};
  if (rim) result.reason = reason_for(*rim);
  if (rim && rim->rough_share > 0) {
    const std::optional<Patch> creased = loops.empty() ? std::nullopt : unrelaxed(site, filler, loops, cancel);
    std::vector<const Patch*> starts{&filler};
    if (creased) starts.insert(starts.begin(), &*creased);
    if (evolve_robustly(run, starts, options, *rim, result) || cancel.cancelled()) return result;
  } else {
    EvolutionOptions first = options;
    if (noise_share > 0)
      first.bending = (1 - noise_share) * rim->bending;
    else
      first.roughness = rim;
    std::string reason = std::move(result.reason);
    const bool holds = from_the_best_start(run, first, result);
    result.reason = std::move(reason);
    if (holds || cancel.cancelled()) return result;
  }
  if (options.flow == FlowKind::mmcvf && options.mode == EvolutionMode::steady && !options.bending) {
    result.reason = result.message;
    const Surroundings kind = rim ? rim->kind : rim_roughness(filler).kind;
    for (const EvolutionOptions& gentler : gentler_options(kind, options))
      if (evolve_once(plain, filler, gentler, result) || cancel.cancelled()) return result;
  }
  result.reason.clear();
  result.message += ": the initial patch was kept";
  result.verdict = judge(site, filler);
  result.final_energy = result.initial_energy;
  result.steps = 0;
  return result;
}

/// A patch of less area may have more energy than the bubble that it replaces: at a tube's end on a crease 4 times as much.
/// Where most of a sphere is missing it has some 200 times as much: there the bubble, though wrong, is nearer to the truth.
constexpr double worth_its_area = 20;

double total_energy(const Evolved& evolved) {
  double energy = 0;
  for (const Proportion& part : evolved.proportions) energy += part.energy;
  return energy;
}

/// In place of a patch out of proportion: what bulges less, if that is in proportion and valid.
/// @returns false if there is none.
bool replace_by_flatter(const Run& run, const EvolutionOptions& asked_for, Evolved& result) {
  EvolutionOptions robust = asked_for, tangent = asked_for;
  robust.boundary = BoundaryTrust::robust;
  tangent.continuity = SeamContinuity::tangent;
  for (const EvolutionOptions& options : {robust, tangent}) {
    Evolved flatter;
    if (!evolve_once(run, run.filler, options, flatter)) continue;
    flatter.proportions = proportions_of(flatter.patch, run.filler);
    if (total_energy(flatter) > worth_its_area * total_energy(result)) continue;
    if (out_of_proportion(flatter.proportions) || flatter.verdict.folds > 0 || flatter.verdict.total() > 0) continue;
    flatter.reason = "the patch of " + method_name(result.method, asked_for.flow) +
                     " was out of proportion: " + describe(*out_of_proportion(result.proportions));
    result = std::move(flatter);
    return true;
  }
  return false;
}

}  // namespace

Evolved evolve_filler(const FillSite& site, const Patch& filler, const std::vector<BoundaryLoop>& loops,
                      const EvolutionOptions& asked_for, const Evolution::OnStep& on_step, const CancelToken& cancel,
                      const RimSurvey* survey) {
  if (filler.free_count == 0) {
    Evolved result;
    result.patch = filler;
    result.message = "too small to hold a free vertex: closed by triangles between its own vertices";
    result.verdict = judge(site, filler);
    return result;
  }
  Evolved result = first_that_holds(site, filler, loops, asked_for, on_step, cancel, survey);
  if (cancel.cancelled() || result.status == LoopStatus::filled) return result;
  result.proportions = proportions_of(result.patch, filler);
  if (!out_of_proportion(result.proportions)) return result;
  const Run plain{site, filler, 0, nullptr, on_step, cancel};
  if (is_judged(asked_for) && replace_by_flatter(plain, asked_for, result)) return result;
  if (cancel.cancelled()) return result;
  result.status = LoopStatus::doubtful;
  result.message = "the patch is out of proportion: " + describe(*out_of_proportion(result.proportions)) +
                   (result.message.empty() ? "" : "; " + result.message);
  return result;
}

}  // namespace loopmend
