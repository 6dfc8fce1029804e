// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/candidate_jobs.h"

#include "core/error.h"
#include "jobs/state_making.h"
#include "pipeline/fill_holes.h"

#include <algorithm>

namespace loopmend {
namespace {

/// Relief is a choice of its own: it stays as it was chosen.
RunRecipe run_of(CandidateKind kind, const PatchRecipe& now) {
  EvolutionOptions options;
  if (!now.runs.empty()) options.relief = now.runs.back().relief;
  if (kind == CandidateKind::tangent) options.continuity = SeamContinuity::tangent;
  if (kind == CandidateKind::flat) options.continuity = SeamContinuity::position;
  if (kind == CandidateKind::robust) options.boundary = BoundaryTrust::robust;
  if (kind == CandidateKind::exact) options.boundary = BoundaryTrust::exact;
  if (kind == CandidateKind::rounded) options.edges = SharpEdges::rounded;
  RunRecipe run = recipe_of(options);
  if (kind == CandidateKind::mirror) run.mirror = RunRecipe::Mirror::found;
  return run;
}

FillOptions options_for(const CandidateTask& task, const RunRecipe& run, const CancelToken& cancel) {
  const PatchRecipe& recipe = task.patch.state->recipe;
  FillOptions options;
  options.initial.density = recipe.density;
  options.evolution->boundary = run.boundary;
  options.evolution->continuity = run.continuity;
  options.evolution->edges = run.edges;
  options.evolution->relief = run.relief;
  if (recipe.start == PatchRecipe::Start::holes) options.islands = FillOptions::Islands::cover;
  if (run.mirror == RunRecipe::Mirror::found)
    options.mirror_planes = task.mirror_planes->of(task.scan_context->model(), cancel);
  return options;
}

/// @param result  of some of the task's loops
OpenPatch open_patch(const CandidateTask& task, const PatchResult& result, const RunRecipe& run) {
  const PatchStatePtr& first = task.patch.timeline->front();
  OpenPatch open;
  open.scan = task.patch.scan;
  for (std::size_t k = 0; k < task.loops.size(); ++k) {
    const std::vector<int>& numbers = result.patch.loop_numbers;
    if (std::find(numbers.begin(), numbers.end(), task.loops[k].number) != numbers.end())
      open.loops.push_back(task.patch.loops[k]);
  }
  const auto state = with_result(*first, result, run, task.origin);
  state->recipe = {task.patch.state->recipe.density, task.patch.state->recipe.start, {state->recipe.runs.back()}};
  state->steps = result.steps;
  open.state = state;
  const bool whole = result.patch.loop_numbers == first->patch.loop_numbers;
  open.timeline = std::make_shared<Timeline>(whole ? Timeline{first, open.state} : Timeline{open.state});
  return open;
}

}  // namespace

std::vector<MirrorPlane> MirrorPlanes::of(const SurfaceModel& model, const CancelToken& cancel) {
  {
    const std::lock_guard lock(mutex_);
    if (planes_) return *planes_;
  }
  // Unlocked: while it waits, a thread may be given another task that asks for the same.
  std::vector<MirrorPlane> found = find_mirror_planes(model, cancel);
  if (cancel.cancelled()) return {};
  const std::lock_guard lock(mutex_);
  planes_ = found;
  return found;
}

std::optional<CandidateKind> kind_of(const PatchRecipe& recipe) {
  if (recipe.runs.size() != 1) return std::nullopt;
  const RunRecipe& run = recipe.runs.front();
  if (run.flow != FlowKind::mmcvf || run.mode != EvolutionMode::steady || run.end != RunRecipe::End::whole ||
      !run.edge_edits.empty())
    return std::nullopt;
  for (const CandidateKind kind :
       {CandidateKind::automatic, CandidateKind::tangent, CandidateKind::flat, CandidateKind::robust,
        CandidateKind::exact, CandidateKind::rounded, CandidateKind::mirror}) {
    const RunRecipe of_kind = run_of(kind, recipe);
    if (run.boundary == of_kind.boundary && run.continuity == of_kind.continuity && run.edges == of_kind.edges &&
        run.mirror == of_kind.mirror)
      return kind;
  }
  return std::nullopt;
}

std::vector<CandidateKind> kinds_for(const OpenPatch& patch) {
  const std::optional<CandidateKind> now = kind_of(patch.state->recipe);
  std::vector<CandidateKind> kinds{CandidateKind::automatic, CandidateKind::tangent, CandidateKind::flat,
                                   CandidateKind::robust,    CandidateKind::exact,   CandidateKind::rounded};
  // A mirror image is of one hole.
  if (patch.loops.size() == 1) kinds.push_back(CandidateKind::mirror);
  std::erase_if(kinds, [&](CandidateKind kind) {
    const bool no_edges =
        kind == CandidateKind::rounded && now == CandidateKind::automatic && patch.state->method != Method::sharp_edges;
    return kind == now || no_edges;
  });
  return kinds;
}

Candidate make_candidate(const CandidateTask& task, CandidateKind kind, const CancelToken& cancel) {
  Candidate candidate;
  candidate.kind = kind;
  const RunRecipe run = run_of(kind, task.patch.state->recipe);
  try {
    const FillOptions options = options_for(task, run, cancel);
    if (cancel.cancelled()) return candidate;
    SolveObserver observer;
    observer.on_done = [](const GroupResult&) {};  // a flow may go on from the patch
    const std::vector<GroupResult> groups =
        solve_holes(task.scan_context->index(), {task.loops}, options, observer, nullptr, cancel);
    if (cancel.cancelled()) return candidate;
    for (const GroupResult& group : groups) {
      for (const HoleResult& hole : group.holes)
        if (!hole.patch) candidate.why_not = hole.message;
      for (const auto& result : group.patches) {
        if (!is_filled(result->status)) candidate.why_not = result->message;
        if (kind == CandidateKind::mirror && !result->mirror.is_used())
          candidate.why_not = message_of(notice_on(result->mirror));
      }
    }
    if (!candidate.why_not.empty()) return candidate;
    for (const GroupResult& group : groups)
      for (const auto& result : group.patches) candidate.patches.push_back(open_patch(task, *result, run));
  } catch (const std::exception& error) {
    candidate.why_not = message_of(error);
  }
  return candidate;
}

bool are_equal(const Candidate& one, const Candidate& other) {
  return std::equal(one.patches.begin(), one.patches.end(), other.patches.begin(), other.patches.end(),
                    [](const OpenPatch& a, const OpenPatch& b) {
                      return a.loops == b.loops && a.state->patch.triangles == b.state->patch.triangles &&
                             a.state->patch.positions == b.state->patch.positions;
                    });
}

}  // namespace loopmend
