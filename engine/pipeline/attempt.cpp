// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/attempt.h"

#include "core/seconds_since.h"
#include "core/threads.h"
#include "evolution/state.h"
#include "mesh/quality.h"
#include "pipeline/bend_aside.h"
#include "pipeline/local_rollback.h"
#include "pipeline/unfold.h"

#include <chrono>

namespace loopmend {

double energy_of(const Patch& patch, FlowKind flow) {
  return shown_energy(flow, make_state(patch, {flow, 0}, Stencil::two_ring, nullptr, Fits::curvatures));
}

namespace {

constexpr double unfolded_deg = 140;  ///< well below what the judge calls a fold

Message message_on_outliers(int outliers) {
  Message message =
      outliers == 1
          ? say("one boundary vertex is an outlier: the patch meets it, but does not take its curvature from it")
          : say("%1 boundary vertices are outliers: the patch meets them, but does not take its curvature from them",
                outliers);
  return std::move(message).with_code("outliers");
}

/// Takes the patch with the spoilt places reverted to `start`, if that has fewer faults.
void take_rolled_back(const AttemptContext& context, const Patch& start, const Evolution& evolution,
                      PatchResult& result) {
  const PatchProblem& problem = context.problem;
  std::optional<LocalRollback> rollback = roll_back_locally(problem.scan, start, evolution.patch(),
                                                            validate(problem.scan, problem.initial), context.cancel);
  if (!rollback || rollback->moved == 0) return;
  std::vector<SeamReport> seams = seam_reports(rollback->patch);
  std::vector<Verdict> verdicts = context.judge(rollback->patch, rollback->validity, seams);
  if (!(faults(verdicts) < faults(result.verdicts))) return;
  result.patch = std::move(rollback->patch);
  result.validity = std::move(rollback->validity);
  result.seams = std::move(seams);
  result.verdicts = std::move(verdicts);
  result.energy.final = energy_of(result.patch, evolution.options().flow);
  result.message = say("at %1 of its %2 vertices the patch was moved back towards its start, since it folded or cut "
                       "the surface there",
                       rollback->moved, result.patch.free_count)
                       .with_code("rolled_back");
}

struct CheckedPatch {
  Patch patch;
  Validity validity;
  std::vector<SeamReport> seams;
  bool is_bent = false;  ///< past what it cut
};

CheckedPatch checked(const PatchProblem& problem, Patch patch, const CancelToken& cancel) {
  CheckedPatch result{std::move(patch), {}, {}};
  parallel_invoke([&] { result.validity = validate(problem.scan, result.patch); },
                  [&] { result.seams = seam_reports(result.patch); });
  if (result.validity.intersections == 0) return result;
  std::optional<BentPatch> bent = bent_aside(problem.scan, result.patch, result.validity, cancel);
  if (!bent) return result;
  std::vector<SeamReport> seams = seam_reports(bent->patch);
  return {std::move(bent->patch), std::move(bent->validity), std::move(seams), true};
}

}  // namespace

bool run_once(const AttemptContext& context, const Patch& start, const EvolutionOptions& options, PatchResult& result) {
  const auto start_time = std::chrono::steady_clock::now();
  const PatchProblem& problem = context.problem;
  const double reach =
      mean_edge_length(problem.initial.positions, problem.initial.triangles, problem.initial.patch_triangles);
  const Patch from = context.clean_neighborhood ? carried_to(context.clean_neighborhood->patch, start, reach) : start;
  Evolution evolution(from, options);
  Patch faired = from;  // where the descent of a split sets out
  const PatchStatus status = evolution.run(
      [&](const Evolution& run, const StepRecord& record) {
        if (run.method() == Method::split_flow && record.split.total() == 0) faired = run.patch();
        if (context.on_step) context.on_step(run, record);
      },
      context.cancel);
  take_figures(evolution, result);
  if (status == PatchStatus::cancelled) return false;
  if (status == PatchStatus::stalled && evolution.history().empty()) {
    result.message = say("the flow could not start: %1", evolution.message()).with_code("flow_not_started");
    return false;
  }
  result.reason =
      is_judged(options) && evolution.split() ? reason_for(*evolution.split(), evolution.method()) : Message();
  const auto checks = std::chrono::steady_clock::now();
  CheckedPatch found = checked(
      problem, context.clean_neighborhood ? carried_to(problem.initial, evolution.patch(), reach) : evolution.patch(),
      context.cancel);
  result.patch = std::move(found.patch);
  result.validity = std::move(found.validity);
  result.seams = std::move(found.seams);
  result.status = status;
  result.method = evolution.method();
  result.message = evolution.message().empty() && context.clean_neighborhood
                       ? message_on_outliers(context.clean_neighborhood->outliers)
                       : evolution.message();
  if (found.is_bent) {
    result.energy.final = energy_of(result.patch, options.flow);
    add_message(result, bent_message());
  }
  result.verdicts = context.judge(result.patch, result.validity, result.seams);
  const bool spoilt = faults(result.verdicts).crossings + faults(result.verdicts).folds > 0;
  if (spoilt && evolution.method() == Method::split_flow && !context.clean_neighborhood)
    take_rolled_back(context, faired, evolution, result);
  open_folds(context, options.flow, result);
  result.seconds.checks = seconds_since(checks);
  result.seconds.total = seconds_since(start_time);
  return true;
}

void take_patch(const AttemptContext& context, const Judge& judge, FlowKind flow, Patch patch, PatchResult& result) {
  const auto checks = std::chrono::steady_clock::now();
  CheckedPatch found = checked(context.problem, std::move(patch), context.cancel);
  result.patch = std::move(found.patch);
  result.validity = std::move(found.validity);
  result.seams = std::move(found.seams);
  result.energy.initial = energy_of(context.problem.initial, flow);
  result.energy.final = energy_of(result.patch, flow);
  if (found.is_bent) add_message(result, bent_message());
  result.verdicts = judge(result.patch, result.validity, result.seams);
  result.seconds.checks = seconds_since(checks);
}

void open_folds(const AttemptContext& context, FlowKind flow, PatchResult& result) {
  if (faults(result.verdicts).folds == 0) return;
  Patch patch = result.patch;
  if (!unfold(patch, unfolded_deg, context.cancel)) return;
  Validity validity = validate(context.problem.scan, patch);
  std::vector<SeamReport> seams = seam_reports(patch);
  std::vector<Verdict> verdicts = context.judge(patch, validity, seams);
  if (!(faults(verdicts) < faults(result.verdicts))) return;
  result.patch = std::move(patch);
  result.validity = std::move(validity);
  result.seams = std::move(seams);
  result.verdicts = std::move(verdicts);
  result.energy.final = energy_of(result.patch, flow);
}

}  // namespace loopmend
