// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/solve_group.h"

#include "core/threads.h"
#include "evolution/evolve_filler.h"
#include "rim/rim_survey.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <numeric>

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

void take_result(const Evolved& evolved, FlowKind flow, LoopResult& result) {
  result.status = evolved.status;
  result.method = method_name(evolved.method, flow);
  result.reason = evolved.reason;
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

/// The loops and what is around them, with nothing in them.
Patch without_fillers(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::vector<LoopFiller> empty(loops.size());
  for (std::size_t k = 0; k < loops.size(); ++k) empty[k].points.resize(loops[k].vertices.size());
  return make_patch(model, loops, empty);
}

struct SurveyedStart {
  PatchStart start;
  RimSurvey survey;  ///< of the patch, if there is one
};

/// The fillers, and beside that a look at the surroundings.
/// @param known  fillers, one per loop; empty: they are made.
SurveyedStart surveyed_start(const FillSite& site, const std::vector<BoundaryLoop>& group,
                             const std::vector<FillerOutcome>& known, const FillerOptions& options,
                             const CancelToken& cancel) {
  SurveyedStart result;
  const bool surveyable = std::all_of(group.begin(), group.end(), [](const auto& loop) { return loop.diameter > 0; });
  const auto start = [&]() -> PatchStart {
    if (known.empty()) return start_patch(site.model, group, options, cancel);
    return {joined_patch(site.model, group, known, options.density), known};
  };
  parallel_invoke([&] { result.start = start(); },
                  [&] {
                    if (surveyable) result.survey = survey_rim(without_fillers(site.model, group));
                  });
  const std::optional<Patch>& patch = result.start.patch;
  if (patch && (!surveyable || patch->loops.size() < group.size())) result.survey = survey_rim(*patch);
  return result;
}

/// @param options  empty: the filler stays.
Evolved evolved_or_kept(const FillSite& site, const Patch& filler, const std::vector<BoundaryLoop>& loops,
                        const std::optional<EvolutionOptions>& options, const RimRoughness& roughness,
                        const RimSurvey& survey, const CancelToken& cancel) {
  if (options) {
    EvolutionOptions evolution = *options;
    evolution.roughness = roughness;
    return evolve_filler(site, filler, loops, evolution, nullptr, cancel, &survey);
  }
  Evolved kept;
  kept.patch = filler;
  kept.verdict = judge(site, filler);
  return kept;
}

/// @param fillers  as for surveyed_start.
GroupOutcome solve_jointly(const FillSite& site, const std::vector<BoundaryLoop>& group,
                           const std::vector<FillerOutcome>& fillers, const FillOptions& options,
                           const CancelToken& cancel) {
  const auto start = std::chrono::steady_clock::now();
  GroupOutcome outcome = failed_group(group, "");
  const SurveyedStart surveyed = surveyed_start(site, group, fillers, options.filler, cancel);
  const PatchStart& first = surveyed.start;  // no structured binding: clang 14 has none in a lambda's captures
  const RimSurvey& survey = surveyed.survey;
  for (std::size_t k = 0; k < group.size(); ++k) {
    outcome.results[k].message = first.fillers[k].message;
    outcome.results[k].seconds.filler = seconds_since(start);
  }
  if (!first.patch || cancel.cancelled()) return outcome;
  Evolved evolved;
  RimRoughness roughness;
  std::vector<SeamReport> before;
  parallel_invoke(
      [&] {
        roughness = rim_roughness(*first.patch, survey.fits);
        evolved = evolved_or_kept(site, *first.patch, group, options.evolution, roughness, survey, cancel);
      },
      [&] { before = seam_reports(*first.patch); });
  if (cancel.cancelled()) return outcome;

  const PatchVerdict& verdict = evolved.verdict;
  const std::vector<int> free = free_vertices_per_loop(evolved.patch);
  const std::vector<SeamReport>& after = evolved.seams.empty() ? before : evolved.seams;
  const std::vector<RimSummary> rims = rim_summaries(*first.patch, roughness, survey.loops);
  FinishedPatch finished;
  for (std::size_t p = 0; p < evolved.patch.loops.size(); ++p) {
    const auto found = std::find_if(outcome.results.begin(), outcome.results.end(), [&](const LoopResult& r) {
      return r.loop.number == evolved.patch.loop_numbers[p];
    });
    LoopResult& result = *found;
    result.seam_before = before[p];
    result.seam_after = after[p];
    result.free_vertices = free[p];
    result.rim = rims[p];
    if (p < evolved.proportions.size()) result.proportion = evolved.proportions[p];
    if (verdict.total() == 0)
      take_result(evolved, options.evolution ? options.evolution->flow : FlowKind::mmcvf, result);
    else
      result.message = why_left_open(site, result.loop, verdict.intersections[p]);
    result.seconds.total = seconds_since(start);
    finished.loops.push_back(static_cast<int>(found - outcome.results.begin()));
  }
  finished.geometry = patch_geometry(evolved.patch);
  if (verdict.total() == 0) outcome.patches.push_back(std::move(finished));
  return outcome;
}

/// work(), which solves these loops; what goes wrong there is theirs alone.
template <class Work>
GroupOutcome guarded(const std::vector<BoundaryLoop>& loops, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return failed_group(loops, "not enough memory for this hole: left open; a smaller density needs less");
  } catch (const std::exception& error) {
    return failed_group(loops, error.what());
  }
}

GroupOutcome solve_one_by_one(const FillSite& site, const std::vector<BoundaryLoop>& group,
                              const std::vector<FillerOutcome>& fillers, const FillOptions& options,
                              const CancelToken& cancel) {
  GroupOutcome outcome;
  for (std::size_t k = 0; k < group.size(); ++k) {
    GroupOutcome single =
        guarded({group[k]}, [&] { return solve_jointly(site, {group[k]}, {fillers[k]}, options, cancel); });
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

/// Loops that ask for one treatment, as far as the options leave that to the boundary data.
std::vector<std::vector<int>> parts_of(const SurfaceModel& model, const std::vector<BoundaryLoop>& group,
                                       const std::vector<FillerOutcome>& fillers, const FillOptions& options) {
  std::vector<int> all(group.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<std::vector<int>> parts{all};
  if (options.evolution && is_judged(*options.evolution))
    guarded(group, [&] {  // where that cannot be told, all loops stay together
      parts = groups_alike(model, group, fillers);
      return GroupOutcome{};
    });
  return parts;
}

/// Jointly; where that leaves one of the loops cut, folded, out of proportion or open, each by itself.
GroupOutcome solve_part(const FillSite& site, const std::vector<BoundaryLoop>& loops,
                        const std::vector<FillerOutcome>& fillers, const FillOptions& options,
                        const CancelToken& cancel) {
  GroupOutcome joint = guarded(loops, [&] { return solve_jointly(site, loops, fillers, options, cancel); });
  const bool spoilt = count_status(joint, LoopStatus::failed) > 0 || count_status(joint, LoopStatus::doubtful) > 0 ||
                      (options.evolution && count_status(joint, LoopStatus::filled) > 0);
  if (loops.size() == 1 || !spoilt || cancel.cancelled()) return joint;
  return solve_one_by_one(site, loops, fillers, options, cancel);
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
                         const CancelToken& cancel) {
  if (group.size() == 1) return guarded(group, [&] { return solve_jointly(site, group, {}, options, cancel); });
  const auto start = std::chrono::steady_clock::now();
  GroupOutcome outcome = failed_group(group, "");
  std::vector<FillerOutcome> fillers;
  for (const BoundaryLoop& loop : group) {
    FillerOutcome filler;
    const GroupOutcome made = guarded({loop}, [&] {
      filler = start_patch(site.model, {loop}, options.filler, cancel).fillers.front();
      return GroupOutcome{};
    });
    if (!made.results.empty()) filler.message = made.results.front().message;
    fillers.push_back(std::move(filler));
  }
  const double filler_seconds = seconds_since(start);
  if (cancel.cancelled()) return outcome;
  for (const std::vector<int>& alike : parts_of(site.model, group, fillers, options)) {
    std::vector<BoundaryLoop> loops;
    std::vector<FillerOutcome> own;
    for (int k : alike) {
      loops.push_back(group[k]);
      own.push_back(fillers[k]);
    }
    GroupOutcome part = solve_part(site, loops, own, options, cancel);
    if (cancel.cancelled()) return outcome;
    for (FinishedPatch& patch : part.patches) {
      for (int& k : patch.loops) k = alike[k];
      outcome.patches.push_back(std::move(patch));
    }
    for (std::size_t k = 0; k < alike.size(); ++k) {
      LoopResult& result = outcome.results[alike[k]] = std::move(part.results[k]);
      result.seconds.filler = filler_seconds;  // of the whole group, as its loops were made one after another
      result.seconds.total = seconds_since(start);
    }
  }
  return outcome;
}

}  // namespace loopmend
