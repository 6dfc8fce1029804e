// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/fill_holes.h"

#include "core/error.h"
#include "core/threads.h"
#include "mesh/pieces.h"
#include "pipeline/blend.h"
#include "pipeline/paste.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <mutex>
#include <new>
#include <numeric>
#include <set>

namespace loopmend {

namespace {

using Group = std::vector<int>;  // indices into the loops that are asked for

/// The groups, those with the most edges first: they take the longest.
std::vector<Group> sorted_groups(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::vector<Group> groups = group_loops(model, loops);
  const auto size = [&](const Group& group) {
    return std::accumulate(group.begin(), group.end(), 0, [&](int sum, int k) { return sum + loops[k].edges(); });
  };
  std::stable_sort(groups.begin(), groups.end(), [&](const Group& a, const Group& b) { return size(a) > size(b); });
  return groups;
}

/// The results of the groups, in the order of the loops. Patches that would intersect one another are left out.
std::vector<HoleResult> pasted(SurfaceModel& model, std::size_t loops, const std::vector<Group>& groups,
                               std::vector<GroupResult>& solved) {
  std::vector<const PatchResult*> patches;
  std::vector<const Patch*> geometry;
  for (const GroupResult& group : solved)
    for (const auto& patch : group.patches) {
      if (!is_filled(patch->status)) continue;
      patches.push_back(patch.get());
      geometry.push_back(&patch->patch);
    }
  const std::vector<std::string> faults = paste_patches(model, geometry);
  std::map<const PatchResult*, std::string> fault_of;
  for (std::size_t k = 0; k < patches.size(); ++k)
    if (!faults[k].empty()) fault_of[patches[k]] = faults[k];
  std::vector<HoleResult> results(loops);
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (std::size_t k = 0; k < groups[g].size(); ++k) {
      HoleResult& result = results[groups[g][k]] = std::move(solved[g].holes[k]);
      const auto fault = fault_of.find(result.patch.get());
      if (fault == fault_of.end()) continue;
      result.status = PatchStatus::failed;
      result.message = fault->second;
    }
  return results;
}

/// By the numbers of their loops; results of other loops follow.
std::vector<HoleResult> in_the_order_of(const std::vector<BoundaryLoop>& loops, std::vector<HoleResult> results) {
  std::map<int, std::size_t> place;
  for (std::size_t k = 0; k < loops.size(); ++k) place.emplace(loops[k].number, k);
  const auto place_of = [&](const HoleResult& result) {
    const auto found = place.find(result.loop.number);
    return found != place.end() ? found->second : loops.size() + static_cast<std::size_t>(result.loop.number);
  };
  std::stable_sort(results.begin(), results.end(),
                   [&](const HoleResult& a, const HoleResult& b) { return place_of(a) < place_of(b); });
  return results;
}

GroupResult unfinished_group(const Group& group, const std::vector<BoundaryLoop>& loops) {
  GroupResult result;
  for (int k : group) result.holes.push_back(open_hole(loops[k], PatchStatus::skipped, "not finished when stopped"));
  return result;
}

std::vector<HoleResult> fill_groups(SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                    const FillOptions& options, const OnFillProgress& progress,
                                    const CancelToken& cancel) {
  const ScanIndex scan(model);
  std::vector<HoleResult> impossible;
  std::vector<BoundaryLoop> possible;
  for (const BoundaryLoop& loop : loops) {
    std::string why = loop.kind == LoopKind::cut ? "" : why_no_patch_exists(scan, loop);
    if (why.empty())
      possible.push_back(loop);
    else
      impossible.push_back(open_hole(loop, PatchStatus::failed, why));
  }
  const std::vector<Group> groups = sorted_groups(model, possible);
  std::vector<GroupResult> solved(groups.size());
  std::vector<char> finished(groups.size(), 0);
  std::mutex progress_mutex;
  FillProgress state;
  state.loops_total = static_cast<int>(loops.size());
  const auto solve = [&](int g) {
    if (cancel.cancelled()) return;
    std::vector<BoundaryLoop> group;
    for (int k : groups[g]) group.push_back(possible[k]);
    try {
      const InitialPatch initial = make_surveyed_patch(model, group, options.initial, cancel);
      solved[g] = solve_group(scan, initial, options, nullptr, cancel);
    } catch (const std::bad_alloc&) {
      for (const BoundaryLoop& loop : group)
        solved[g].holes.push_back(open_hole(loop, PatchStatus::failed, no_memory_message));
    } catch (const std::exception& error) {
      for (const BoundaryLoop& loop : group)
        solved[g].holes.push_back(open_hole(loop, PatchStatus::failed, error.what()));
    }
    const std::lock_guard lock(progress_mutex);
    if (cancel.cancelled()) return;
    finished[g] = 1;
    state.loops_done += static_cast<int>(group.size());
    state.loop_number = group.front().number;
    if (progress) progress(state);
  };
  parallel_for(0, static_cast<int>(groups.size()), 1, solve);
  if (cancel.cancelled() && options.on_cancel == FillOptions::OnCancel::discard) return {};
  for (std::size_t g = 0; g < groups.size(); ++g)
    if (!finished[g]) solved[g] = unfinished_group(groups[g], possible);
  std::vector<HoleResult> results = pasted(model, possible.size(), groups, solved);
  std::move(impossible.begin(), impossible.end(), std::back_inserter(results));
  return in_the_order_of(loops, std::move(results));
}

using Place = std::vector<BoundaryLoop>;  // a hole, then the islands in it

/// A piece smaller than this share of the hole tells nothing of the surface that is missing: the patch covers it.
constexpr double least_island = 0.05;

/// Joins the hole to the islands. Where that fails, every result says why.
std::vector<HoleResult> joined_islands(SurfaceModel& model, const Place& place, const GroupOptions& options,
                                       const CancelToken& cancel) {
  BlendResult blend;
  try {
    blend = blend_loops(model, place, options, cancel);
  } catch (const std::exception& error) {  // one place does not take the others with it
    blend.outcome.message = error.what();
  }
  const auto patch = blend.outcome.status == PatchStatus::failed
                         ? nullptr
                         : std::make_shared<const PatchResult>(std::move(blend.outcome));
  std::vector<HoleResult> results;
  for (std::size_t k = 0; k < place.size(); ++k) {
    HoleResult result = open_hole(place[k], PatchStatus::failed, blend.outcome.message);
    if (patch) {
      result.patch = patch;
      result.status = patch->status;
      result.place = static_cast<int>(k);
      result.seconds = patch->seconds.total;
      result.message = k == 0 ? patch->message : "an island: joined to hole " + std::to_string(place[0].number);
      result.free_vertices = k == 0 ? patch->patch.free_count : 0;
    }
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace

void check(const FillOptions& options) {
  check(options.initial);
  if (options.evolution) check(*options.evolution);
}

namespace {

std::vector<HoleResult> fill_and_join(SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                      const FillOptions& options, const OnFillProgress& progress,
                                      const CancelToken& cancel) {
  const std::vector<Place> places = holes_with_islands(model, loops);
  if (places.empty()) return fill_groups(model, loops, options, progress, cancel);
  SurfaceModel work = model;
  std::set<int> joined;
  std::map<int, HoleResult> by_number;
  FillProgress state;
  state.loops_total = static_cast<int>(loops.size());
  std::map<int, std::string> covered;
  for (const Place& place : places) {
    if (cancel.cancelled()) break;
    std::vector<HoleResult> results = joined_islands(work, place, options, cancel);
    if (cancel.cancelled()) break;
    state.loop_number = place.front().number;
    if (progress) progress(state);
    if (is_filled(results.front().status)) {
      ++state.loops_done;
      for (HoleResult& result : results) {
        joined.insert(result.loop.number);
        by_number[result.loop.number] = std::move(result);
      }
    } else {
      covered[place.front().number] = results.front().message;
    }
  }
  std::vector<BoundaryLoop> others;
  for (const BoundaryLoop& loop : loops)
    if (!joined.contains(loop.number)) others.push_back(loop);
  const int done = state.loops_done;
  const auto report = [&](const FillProgress& groups) {
    if (progress) progress({done + groups.loops_done, state.loops_total, groups.loop_number});
  };
  for (HoleResult& result : fill_groups(work, others, options, report, cancel)) {
    if (const auto why = covered.find(result.loop.number); why != covered.end())
      result.message += (result.message.empty() ? "" : "; ") + island_not_joined(why->second);
    by_number[result.loop.number] = std::move(result);
  }
  if (cancel.cancelled() && options.on_cancel == FillOptions::OnCancel::discard) return {};
  model = std::move(work);
  std::vector<HoleResult> results;
  for (auto& [number, result] : by_number) results.push_back(std::move(result));
  return in_the_order_of(loops, std::move(results));
}

}  // namespace

std::string island_not_joined(const std::string& why) {
  return "the piece of surface within it was not joined: " + (why.empty() ? "no bridge was found" : why);
}

std::vector<HoleResult> fill_holes(SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                   const FillOptions& options, const OnFillProgress& progress,
                                   const CancelToken& cancel) {
  check(options);
  const bool joins = options.islands == FillOptions::Islands::join;
  return with_thread_budget(options.threads, [&] {
    return joins ? fill_and_join(model, loops, options, progress, cancel)
                 : fill_groups(model, loops, options, progress, cancel);
  });
}

std::vector<std::vector<BoundaryLoop>> holes_with_islands(const SurfaceModel& model,
                                                          const std::vector<BoundaryLoop>& asked) {
  const std::vector<BoundaryLoop> all = find_boundary_loops(model);
  std::set<int> numbers;
  for (const BoundaryLoop& loop : asked) numbers.insert(loop.number);
  std::vector<std::vector<BoundaryLoop>> places;
  for (const HoleWithIslands& found : find_islands(model, all)) {
    if (!numbers.contains(all[found.hole].number)) continue;
    Place place{all[found.hole]};
    for (int island : found.islands) {
      const bool is_crumb = all[island].diameter < least_island * place.front().diameter;
      if (!is_crumb && find_opposed_loops(model, {place.front(), all[island]}).empty()) place.push_back(all[island]);
    }
    if (place.size() > 1) places.push_back(std::move(place));
  }
  return places;
}

std::vector<HoleResult> fill_all_holes(SurfaceModel& model, const FillOptions& options, const CancelToken& cancel) {
  std::vector<BoundaryLoop> holes;
  for (BoundaryLoop& loop : find_boundary_loops(model))
    if (loop.kind == LoopKind::hole) holes.push_back(std::move(loop));
  return fill_holes(model, holes, options, nullptr, cancel);
}

}  // namespace loopmend
