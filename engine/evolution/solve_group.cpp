#include "evolution/solve_group.h"

#include "evolution/evolve_filler.h"
#include "evolution/side_work.h"
#include "mesh/quality.h"

#include <algorithm>
#include <chrono>

namespace loopmend {

namespace {

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

std::string why_left_open(const FillSite& site, const BoundaryLoop& loop, int cuts) {
  if (const int pierced = pierced_edges(site, loop))
    return "its rim itself runs through the surface, with " + std::to_string(pierced) +
           " edges, so that every patch would cut the surface: left open; remove the triangles that cross there";
  return "every patch that was found would cut the surface or itself, in " + std::to_string(cuts) +
         " places: left open";
}

/// @param options  empty: the filler stays.
Evolved evolved_or_kept(const FillSite& site, const Patch& filler, const std::vector<BoundaryLoop>& loops,
                        const std::optional<EvolutionOptions>& options, const RimSurvey& survey,
                        const CancelToken& cancel) {
  if (options) return evolve_filler(site, filler, loops, *options, nullptr, cancel, &survey);
  Evolved kept;
  kept.patch = filler;
  kept.verdict = judge(site, filler);
  return kept;
}

/// The filler, its evolution, and what there is to tell of both.
void solve_beside(const FillSite& site, const std::vector<BoundaryLoop>& group, const FillOptions& options,
                  const CancelToken& cancel, SideWork& beside, GroupOutcome& outcome) {
  const auto begin = std::chrono::steady_clock::now();
  const PatchStart start = beside.make_start();
  for (std::size_t k = 0; k < group.size(); ++k) {
    outcome.results[k].message = start.fillers[k].message;
    outcome.results[k].seconds.filler = seconds_since(begin);
  }
  if (!start.patch || cancel.cancelled()) return;
  beside.report_on(*start.patch);
  Evolved evolved;
  RimRoughness roughness;
  side_by_side(
      [&] {
        const RimSurvey survey = beside.survey(start);
        roughness = rim_roughness(*start.patch, survey.fits);
        std::optional<EvolutionOptions> evolution = options.evolution;
        if (evolution) {
          evolution->roughness = roughness;
          evolution->first_fairing = beside.first_fairing();
        }
        evolved = evolved_or_kept(site, *start.patch, group, evolution, survey, cancel);
      },
      [&] { beside.help_with_report(); });
  const FillerReport before = beside.report();
  if (cancel.cancelled()) return;

  const PatchVerdict& verdict = evolved.verdict;
  const std::vector<int> free = free_vertices_per_loop(evolved.patch);
  const std::vector<SeamReport>& after = evolved.seams.empty() ? before.seams : evolved.seams;
  const std::vector<RimSummary> rims = rim_summaries(*start.patch, roughness, before.rims);
  FinishedPatch finished;
  for (std::size_t p = 0; p < evolved.patch.loops.size(); ++p) {
    const auto found = std::find_if(outcome.results.begin(), outcome.results.end(), [&](const LoopResult& r) {
      return r.loop.number == evolved.patch.loop_numbers[p];
    });
    LoopResult& result = *found;
    result.seam_before = before.seams[p];
    result.seam_after = after[p];
    result.free_vertices = free[p];
    result.rim = rims[p];
    if (verdict.total() == 0)
      take_result(evolved, result);
    else
      result.message = why_left_open(site, result.loop, verdict.intersections[p]);
    result.seconds.total = seconds_since(begin);
    finished.loops.push_back(static_cast<int>(found - outcome.results.begin()));
  }
  finished.geometry = patch_geometry(evolved.patch);
  if (verdict.total() == 0) outcome.patches.push_back(std::move(finished));
}

GroupOutcome solve_jointly(const FillSite& site, const std::vector<BoundaryLoop>& group, const FillOptions& options,
                           const CancelToken& cancel) {
  GroupOutcome outcome = failed_group(group, "");
  SideWork beside(site, group, options, cancel);
  side_by_side([&] { solve_beside(site, group, options, cancel, beside, outcome); }, [&] { beside.help(); });
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
