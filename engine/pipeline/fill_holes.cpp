// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/fill_holes.h"

#include "core/error.h"
#include "core/threads.h"
#include "mesh/pieces.h"
#include "pipeline/blend.h"
#include "pipeline/paste.h"

#include <algorithm>
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

std::vector<HoleResult> fill_groups(SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                    const FillOptions& options, const OnFillProgress& progress,
                                    const CancelToken& cancel) {
  const std::vector<Group> groups = sorted_groups(model, loops);
  const ScanIndex scan(model);
  std::vector<GroupResult> solved(groups.size());
  std::mutex progress_mutex;
  FillProgress state;
  state.loops_total = static_cast<int>(loops.size());
  const auto solve = [&](int g) {
    if (cancel.cancelled()) return;
    std::vector<BoundaryLoop> group;
    for (int k : groups[g]) group.push_back(loops[k]);
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
    state.loops_done += static_cast<int>(group.size());
    state.loop_number = group.front().number;
    if (progress) progress(state);
  };
  parallel_for(0, static_cast<int>(groups.size()), 1, solve);
  return cancel.cancelled() ? std::vector<HoleResult>() : pasted(model, loops.size(), groups, solved);
}

/// A hole and the islands in it, by points of the soup through which their loops run: patches that are pasted meanwhile
/// change the numbers of loops.
struct Place {
  std::vector<BoundaryLoop> loops;  ///< the hole's first
  std::vector<int> anchors;

  Place(const SurfaceModel& model, std::vector<BoundaryLoop> ends) : loops(std::move(ends)) {
    for (const BoundaryLoop& loop : loops) anchors.push_back(model.soup_vertex[loop.vertices.front()]);
  }
};

BoundaryLoop loop_through(const SurfaceModel& model, int soup_point) {
  for (const BoundaryLoop& loop : find_boundary_loops(model))
    for (int v : loop.vertices)
      if (model.soup_vertex[v] == soup_point) return loop;
  throw InvalidArgument("another patch closed it already");
}

std::vector<HoleResult> joined_islands(SurfaceModel& model, const Place& place, const GroupOptions& options,
                                       const CancelToken& cancel) {
  BlendResult blend;
  try {
    std::vector<BoundaryLoop> ends;
    for (int anchor : place.anchors) ends.push_back(loop_through(model, anchor));
    blend = blend_loops(model, ends, options, cancel);
  } catch (const std::exception& error) {  // one place does not take the others with it
    blend.outcome.message = error.what();
  }
  const auto patch = blend.outcome.status == PatchStatus::failed
                         ? nullptr
                         : std::make_shared<const PatchResult>(std::move(blend.outcome));
  std::vector<HoleResult> results;
  for (std::size_t k = 0; k < place.loops.size(); ++k) {
    HoleResult result = open_hole(place.loops[k], PatchStatus::failed, blend.outcome.message);
    if (patch) {
      result.patch = patch;
      result.status = patch->status;
      result.place = static_cast<int>(k);
      result.seconds = patch->seconds.total;
      result.message = k == 0 ? patch->message : "an island: joined to hole " + std::to_string(place.loops[0].number);
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
  SurfaceModel work = model;
  std::vector<Place> places;
  for (std::vector<BoundaryLoop>& ends : holes_with_islands(model, loops)) places.emplace_back(model, std::move(ends));
  std::set<int> joined;
  for (const Place& place : places)
    for (const BoundaryLoop& loop : place.loops) joined.insert(loop.number);
  std::vector<BoundaryLoop> others;
  for (const BoundaryLoop& loop : loops)
    if (!joined.contains(loop.number)) others.push_back(loop);
  std::map<int, HoleResult> by_number;
  const auto put = [&](std::vector<HoleResult> results) {
    for (HoleResult& result : results) by_number[result.loop.number] = std::move(result);
  };
  FillProgress state;
  state.loops_total = static_cast<int>(others.size() + joined.size());
  const auto report = [&](const FillProgress& groups) {
    state.loops_done = groups.loops_done;
    state.loop_number = groups.loop_number;
    if (progress) progress(state);
  };
  if (!others.empty()) put(fill_groups(work, others, options, report, cancel));
  for (const Place& place : places) {
    if (cancel.cancelled()) return {};
    report({state.loops_done + static_cast<int>(place.loops.size()), 0, place.loops.front().number});
    put(joined_islands(work, place, options, cancel));
  }
  if (cancel.cancelled()) return {};
  model = std::move(work);
  std::vector<HoleResult> results;
  for (const BoundaryLoop& loop : loops) {
    results.push_back(std::move(by_number.at(loop.number)));
    by_number.erase(loop.number);
  }
  for (auto& [number, result] : by_number) results.push_back(std::move(result));
  return results;
}

}  // namespace

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
    places.push_back({all[found.hole]});
    for (int island : found.islands) places.back().push_back(all[island]);
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
