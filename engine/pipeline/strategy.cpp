// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/strategy.h"

#include "pipeline/flat_cut.h"
#include "pipeline/initial_patch.h"
#include "pipeline/multi_start.h"

#include <algorithm>
#include <utility>

namespace loopmend {

namespace {

/// One problem with all that decides which attempts are made.
struct Situation {
  AttemptContext context;
  EvolutionOptions options;            ///< as asked for
  std::optional<SplitEstimate> split;  ///< where the options leave the treatment of the boundary to be judged
  std::optional<CleanNeighborhood>
      clean_neighborhood;              ///< where single vertices stand off a neighborhood that is smooth without them
  std::optional<Patch> triangulation;  ///< the initial patch before it was relaxed
  bool flat_cut = false;               ///< every loop is one, and the options leave that to be judged

  const Patch& initial() const { return context.problem.initial; }
  bool is_rough() const { return split && !split->is_exact(options.literal_relief); }
};

/// The initial patch of the same loops before it was relaxed. Empty if there is none.
std::optional<Patch> triangulation_of(const PatchProblem& problem, const CancelToken& cancel) {
  const Patch& initial = problem.initial;
  std::vector<BoundaryLoop> closed;  // a joint patch leaves out those that have none
  for (const BoundaryLoop& loop : problem.loops)
    if (std::find(initial.loop_numbers.begin(), initial.loop_numbers.end(), loop.number) != initial.loop_numbers.end())
      closed.push_back(loop);
  if (closed.empty()) return std::nullopt;
  std::optional<Patch> patch =
      make_initial_patch(problem.scan.model, closed, {initial.grading.density, InitialShape::triangulated}, cancel)
          .patch;
  return patch && patch->loop_numbers == initial.loop_numbers && patch->free_count > 0 ? patch : std::nullopt;
}

bool flow_from_the_best_start(const Situation& s, PatchResult& result) {
  result = best_of_starts(
      s.initial(), s.options, s.context.cancel,
      [&](const Patch& start, const EvolutionOptions& from) {
        PatchResult run;
        run.patch = s.initial();
        run.status = run_once(s.context, start, from, run) ? run.status : PatchStatus::filled;
        return run;
      },
      [](const PatchResult& run) { return rating_of(run, run.status != PatchStatus::filled); });
  return result.status != PatchStatus::filled;
}

EvolutionOptions robust(EvolutionOptions options) {
  options.boundary = BoundaryTrust::robust;
  return options;
}

bool split_from(const Patch& start, const Situation& s, PatchResult& result) {
  return run_once(s.context, start, s.options, result);
}

bool robust_from(const Patch& start, const Situation& s, PatchResult& result) {
  if (!run_once(s.context, start, robust(s.options), result)) return false;
  result.reason = reason_for(*s.split, result.method);
  return true;
}

bool rollback_from(const Patch& start, const Situation& s, PatchResult& result) {
  if (!run_with_rollback(s.context, start, robust(s.options), result)) return false;
  result.reason = reason_for(*s.split, result.method);
  return true;
}

/// With other options, from the initial patch.
bool fall_back(const Situation& s, const EvolutionOptions& options, PatchResult& result) {
  return run_once(s.context, s.initial(), options, result);
}

bool mixed_order(const Situation& s, double bending, PatchResult& result) {
  EvolutionOptions options = s.options;
  options.bending = bending;
  return fall_back(s, options, result);
}

bool robust_fairing(const Situation& s, PatchResult& result) {
  EvolutionOptions options = s.options;
  options.boundary = BoundaryTrust::robust;
  return fall_back(s, options, result);
}

bool tangent_fairing(const Situation& s, PatchResult& result) {
  EvolutionOptions options = s.options;
  options.continuity = SeamContinuity::tangent;
  return fall_back(s, options, result);
}

bool flat_cap(const Situation& s, PatchResult& result) {
  EvolutionOptions options = s.options;
  options.continuity = SeamContinuity::position;
  return fall_back(s, options, result);
}

constexpr const char* flat_cut_reason =
    "the boundary lies in a plane that the surface runs into without bending, so that it was closed flat; "
    "--boundary exact runs the flow itself";

bool is_flat(const Situation& s) { return s.flat_cut; }
bool trusts_flow(const Situation& s) { return !s.is_rough(); }
bool is_rough(const Situation& s) { return s.is_rough(); }
bool has_triangulation(const Situation& s) { return s.triangulation.has_value(); }
/// The flow for which there is anything else to fall back on.
bool can_fall_back(const Situation& s) {
  return s.options.flow == FlowKind::mmcvf && s.options.mode == EvolutionMode::steady && !s.options.bending;
}
bool rough_fallback(const Situation& s) { return s.is_rough() && can_fall_back(s); }
bool flow_fallback(const Situation& s) { return !s.is_rough() && can_fall_back(s); }

struct Attempt {
  enum class Stage { asked_for, fallback } stage;
  const char* name;
  bool (*applies)(const Situation&);
  bool (*run)(const Situation&, PatchResult&);  ///< true if the result may be kept
};

using Stage = Attempt::Stage;

/// From top to bottom, the first that holds. A flat cap on a flat cut. The flow where the boundary data are exact; else its
/// split form, best from a start that was not relaxed; where that folds or intersects, robust fairing, and rollback where that
/// does so at a few places; then what bulges less.
const Attempt attempts[] = {
    {Stage::asked_for, "flat cap", is_flat, flat_cap},
    {Stage::asked_for, "flow", trusts_flow, flow_from_the_best_start},
    {Stage::asked_for, "split from triangulation", has_triangulation,
     [](const Situation& s, PatchResult& result) { return split_from(*s.triangulation, s, result); }},
    {Stage::asked_for, "split from initial patch", is_rough,
     [](const Situation& s, PatchResult& result) { return split_from(s.initial(), s, result); }},
    {Stage::asked_for, "robust from triangulation", has_triangulation,
     [](const Situation& s, PatchResult& result) { return robust_from(*s.triangulation, s, result); }},
    {Stage::asked_for, "robust from initial patch", is_rough,
     [](const Situation& s, PatchResult& result) { return robust_from(s.initial(), s, result); }},
    {Stage::asked_for, "rollback from triangulation", has_triangulation,
     [](const Situation& s, PatchResult& result) { return rollback_from(*s.triangulation, s, result); }},
    {Stage::asked_for, "rollback from initial patch", is_rough,
     [](const Situation& s, PatchResult& result) { return rollback_from(s.initial(), s, result); }},
    {Stage::fallback, "tangent fairing", rough_fallback, tangent_fairing},
    {Stage::fallback, "mixed order 60", flow_fallback,
     [](const Situation& s, PatchResult& result) { return mixed_order(s, 60, result); }},
    {Stage::fallback, "mixed order 300", flow_fallback,
     [](const Situation& s, PatchResult& result) { return mixed_order(s, 300, result); }},
    {Stage::fallback, "robust fairing", flow_fallback, robust_fairing},
    {Stage::fallback, "tangent fairing", flow_fallback, tangent_fairing},
};

constexpr const char* flatter = "flatter: robust fairing";

/// Of H, times the loop's diameter: 2 is the jump between a plane and a sphere over the loop.
constexpr double torn_jump = 20;
constexpr double torn_ratio = 8;

/// @returns true if the mean curvature jumps across the seam of a loop far more than it did before: a needle or a fold there.
/// Of 165 loops in 17 scans that were filled, two were so, at 190 and 21 times the jump before; the next was at 3.4 times.
bool tears_seam(const Situation& s, const PatchResult& result) {
  const auto jump = [](const SeamReport& seam) { return seam.h_jump_rms_times_diameter; };
  if (std::none_of(result.seams.begin(), result.seams.end(), [&](const auto& seam) { return jump(seam) > torn_jump; }))
    return false;
  const std::vector<SeamReport> before = seam_reports(s.initial());
  for (std::size_t l = 0; l < std::min(before.size(), result.seams.size()); ++l)
    if (jump(result.seams[l]) > std::max(torn_jump, torn_ratio * jump(before[l]))) return true;
  return false;
}

PatchResult first_that_holds(const Situation& s) {
  PatchResult result;
  std::vector<std::string> tried;
  std::string why_fallback;
  bool falls_back = false;
  result.patch = s.initial();
  for (const Attempt& attempt : attempts) {
    if (!attempt.applies(s)) continue;
    if (attempt.stage == Stage::fallback && !std::exchange(falls_back, true)) why_fallback = result.message;
    tried.emplace_back(attempt.name);
    bool holds = attempt.run(s, result);
    if (holds && is_judged(s.options) && tears_seam(s, result)) {
      holds = false;
      result.message = "the mean curvature would have jumped across the seam";
    }
    if (s.context.cancel.cancelled()) result.status = PatchStatus::cancelled;
    if (!holds && !s.context.cancel.cancelled()) continue;
    if (attempt.run == flat_cap) result.reason = flat_cut_reason;
    if (falls_back) result.reason = why_fallback;
    if (holds) result.made_by = attempt.name;
    result.attempts = std::move(tried);
    return result;
  }
  PatchResult kept = initial_result(s.context.problem, s.options.flow);
  kept.message = result.message + ": the initial patch was kept";
  kept.energy = {result.energy.initial, result.energy.initial};
  kept.attempts = std::move(tried);
  return kept;
}

/// A patch of less area may have more energy than the bubble that it replaces: at a tube's end on a crease 4 times as much.
/// Where most of a sphere is missing it has some 200 times as much: there the bubble, though wrong, is nearer to the truth.
constexpr double worth_its_area = 20;

double total_energy(const PatchResult& result) {
  double energy = 0;
  for (const Proportion& part : result.proportions) energy += part.energy;
  return energy;
}

/// Replaces a patch out of proportion by a valid one in proportion. @returns false if none was found.
bool replace_by_flatter(const Situation& s, PatchResult& result) {
  if (!can_fall_back(s)) return false;
  result.attempts.emplace_back(flatter);
  PatchResult next;
  if (!robust_fairing(s, next)) return false;
  next.proportions = proportions_of(next.patch, s.initial());
  if (total_energy(next) > worth_its_area * total_energy(result)) return false;
  if (out_of_proportion(next.proportions) || !next.validity.is_clean()) return false;
  next.reason = "the patch of " + method_name(result.method, s.options.flow) +
                " was out of proportion: " + describe(*out_of_proportion(result.proportions));
  next.attempts = std::move(result.attempts);
  next.made_by = flatter;
  result = std::move(next);
  return true;
}

PatchResult in_proportion(Situation& s, PatchResult result) {
  result.proportions = proportions_of(result.patch, s.initial());
  if (!out_of_proportion(result.proportions)) return result;
  if (is_judged(s.options) && replace_by_flatter(s, result)) return result;
  result.status = PatchStatus::doubtful;
  result.message = "the patch is out of proportion: " + describe(*out_of_proportion(result.proportions)) +
                   (result.message.empty() ? "" : "; " + result.message);
  return result;
}

}  // namespace

PatchResult initial_result(const PatchProblem& problem, FlowKind flow) {
  PatchResult result;
  result.status = PatchStatus::filled;
  result.flow = flow;
  result.patch = problem.initial;
  result.validity = validate(problem.scan, problem.initial);
  return result;
}

PatchResult solve_patch(const PatchProblem& problem, const EvolutionOptions& options, const Evolution::OnStep& on_step,
                        const CancelToken& cancel) {
  if (problem.initial.free_count == 0) {
    PatchResult result = initial_result(problem, options.flow);
    result.message = "too small to hold a free vertex: closed by triangles between its own vertices";
    return result;
  }
  Situation situation{{problem, nullptr, on_step, cancel}, options, std::nullopt, std::nullopt, std::nullopt};
  if (is_judged(options)) {
    if (CleanNeighborhood clean_neighborhood = remove_outliers(problem.initial); clean_neighborhood.outliers > 0) {
      const SplitEstimate without = estimate_split(clean_neighborhood.patch, cancel);
      if (without.is_exact(SplitEstimate::exact_construction)) {
        situation.split = without;
        situation.clean_neighborhood = std::move(clean_neighborhood);
        situation.context.clean_neighborhood = &*situation.clean_neighborhood;
      }
    }
    if (!situation.split) situation.split = options.split ? options.split : estimate_split(problem.initial, cancel);
    situation.options.split = situation.split;
    if (!problem.loops.empty()) situation.options.literal_relief = SplitEstimate::exact_hole;
    situation.flat_cut = !problem.loops.empty() &&
                         std::all_of(problem.loops.begin(), problem.loops.end(),
                                     [&](const BoundaryLoop& loop) { return is_flat_cut(problem.scan.model, loop); });
  }
  if (situation.is_rough()) situation.triangulation = triangulation_of(problem, cancel);
  PatchResult result = first_that_holds(situation);
  result.flow = options.flow;
  if (result.status == PatchStatus::cancelled || result.status == PatchStatus::filled) return result;
  result = in_proportion(situation, std::move(result));
  result.flow = options.flow;
  if (cancel.cancelled()) result.status = PatchStatus::cancelled;
  return result;
}

}  // namespace loopmend
