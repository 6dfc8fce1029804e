// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/fill_holes.h"

#include "core/error.h"
#include "core/threads.h"
#include "filling/patch_size.h"
#include "mesh/pieces.h"
#include "pipeline/blend.h"
#include "pipeline/filling_view.h"
#include "pipeline/paste.h"
#include "pipeline/tiny_hole.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <map>
#include <mutex>
#include <new>
#include <numeric>
#include <optional>
#include <set>

namespace loopmend {

namespace {

/// What is solved at once: holes of one group, or a hole and the islands in it that are joined to it.
struct Task {
  enum class Kind { fill, join } kind = Kind::fill;
  std::vector<BoundaryLoop> loops;  ///< of `join` the hole's first
  std::set<int> asked;              ///< of `join`: numbers of those islands that are to be filled themselves

  int edges() const {
    return std::accumulate(loops.begin(), loops.end(), 0,
                           [](int sum, const BoundaryLoop& loop) { return sum + loop.edges(); });
  }
};

/// A piece smaller than this share of the hole tells nothing of the surface that is missing: the patch covers it.
constexpr double least_island = 0.05;

/// Those with the most edges first: they take the longest.
/// @param refused  numbers of loops that no patch can close.
std::vector<Task> tasks_for(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                            FillOptions::Islands islands, const std::set<int>& refused) {
  std::vector<Task> tasks;
  std::set<int> joined;
  if (islands == FillOptions::Islands::join && !loops.empty())
    for (std::vector<BoundaryLoop>& place : holes_with_islands(model, loops)) {
      std::erase_if(place, [&](const BoundaryLoop& loop) { return refused.contains(loop.number); });
      if (place.size() < 2) continue;
      Task& task = tasks.emplace_back();
      task.kind = Task::Kind::join;
      for (const BoundaryLoop& loop : loops)
        if (loop.number != place.front().number &&
            std::any_of(place.begin(), place.end(), [&](const auto& end) { return end.number == loop.number; }))
          task.asked.insert(loop.number);
      for (const BoundaryLoop& loop : place) joined.insert(loop.number);
      task.loops = std::move(place);
    }
  std::vector<BoundaryLoop> others;
  for (const BoundaryLoop& loop : loops)
    if (!joined.contains(loop.number)) others.push_back(loop);
  for (const std::vector<int>& group : group_loops(model, others)) {
    Task& task = tasks.emplace_back();
    for (int k : group) task.loops.push_back(others[k]);
  }
  std::stable_sort(tasks.begin(), tasks.end(), [](const Task& x, const Task& y) { return x.edges() > y.edges(); });
  return tasks;
}

GroupResult open_group(const std::vector<BoundaryLoop>& loops, PatchStatus status, const Message& why) {
  GroupResult result;
  for (const BoundaryLoop& loop : loops) result.holes.push_back(open_hole(loop, status, why));
  return result;
}

Message not_finished() { return say("not finished when stopped").with_code("not_finished"); }

/// Of a patch with about so many new vertices. @returns why it is not made; empty where there is no reason.
Message memory_message(double vertices, double needed_mb, double most_memory_mb) {
  if (!(needed_mb > most_memory_mb)) return {};
  if (!(vertices < 1e9))
    return say("its edges are too short for its size: left open; a smaller density needs less memory")
        .with_code("no_memory");
  return say("about %1 new vertices would take %2 MB of memory, and %3 MB are allowed: left open; a smaller density "
             "needs less",
             std::llround(vertices), std::llround(std::ceil(needed_mb)),
             std::llround(std::max(0.0, std::floor(most_memory_mb))))
      .with_code("no_memory");
}

/// Before there is a patch.
Message why_expected_too_large(const SurfaceModel& model, const BoundaryLoop& loop, const FillOptions& options) {
  if (!options.evolution || std::isinf(options.most_memory_mb)) return {};
  const double vertices = expected_new_vertices(model, loop, options.initial.density);
  return memory_message(vertices, expected_memory_mb(vertices), options.most_memory_mb);
}

GroupResult filled(const ScanIndex& scan, const std::vector<BoundaryLoop>& loops, const FillOptions& options,
                   const CancelToken& cancel);

/// A group that is too large together: loops that are not so are filled.
GroupResult each_alone(const ScanIndex& scan, const std::vector<BoundaryLoop>& loops, const FillOptions& options,
                       const CancelToken& cancel) {
  GroupResult all;
  for (const BoundaryLoop& loop : loops) {
    if (cancel.cancelled()) return open_group(loops, PatchStatus::cancelled, {});
    GroupResult one = filled(scan, {loop}, options, cancel);
    std::move(one.holes.begin(), one.holes.end(), std::back_inserter(all.holes));
    std::move(one.patches.begin(), one.patches.end(), std::back_inserter(all.patches));
  }
  return all;
}

GroupResult filled(const ScanIndex& scan, const std::vector<BoundaryLoop>& loops, const FillOptions& options,
                   const CancelToken& cancel) {
  try {
    const InitialPatch initial = make_surveyed_patch(scan.model, loops, options.initial, cancel);
    if (initial.patch && options.evolution) {
      const int vertices = initial.patch->free_count;
      const Message why = memory_message(vertices, memory_mb_of(vertices), options.most_memory_mb);
      if (!why.empty() && loops.size() > 1) return each_alone(scan, loops, options, cancel);
      if (!why.empty()) return open_group(loops, PatchStatus::failed, why);
    }
    return solve_group(scan, initial, options, nullptr, cancel);
  } catch (const std::bad_alloc&) {
    return open_group(loops, PatchStatus::failed, no_memory_message());
  } catch (const std::exception& error) {
    return open_group(loops, PatchStatus::failed, message_of(error));
  }
}

/// One patch between a hole and the islands in it. @param why  is set where there is none; its reason may be empty.
std::optional<PatchResult> bridged(const ScanIndex& scan, const std::vector<BoundaryLoop>& place,
                                   const FillOptions& options, const CancelToken& cancel, Message& why) {
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  try {
    BridgeOutcome outcome = bridge_loops(scan.model, place, options.initial, cancel);
    why = outcome.message;
    if (!outcome.bridge || cancel.cancelled()) return std::nullopt;
    const int vertices = outcome.bridge->start.free_count;
    why = memory_message(vertices, memory_mb_of(vertices), options.most_memory_mb);
    if (!why.empty()) return std::nullopt;
    const double bridge_seconds = seconds();
    PatchResult result = solve_bridge(scan, *outcome.bridge, options.evolution, nullptr, cancel);
    why = result.message;
    if (!is_filled(result.status)) return std::nullopt;
    result.seconds.initial_patch = bridge_seconds;
    result.seconds.total = seconds();
    return result;
  } catch (const std::exception& error) {  // one place does not take the others with it
    why = message_of(error);
    return std::nullopt;
  }
}

/// The hole's islands joined to it, or where that fails covered by its patch.
GroupResult joined(const ScanIndex& scan, const Task& task, const FillOptions& options, const CancelToken& cancel) {
  const std::vector<BoundaryLoop>& place = task.loops;
  Message why;
  std::optional<PatchResult> made = bridged(scan, place, options, cancel, why);
  if (!made) {
    GroupResult alone = filled(scan, {place.front()}, options, cancel);
    for (HoleResult& hole : alone.holes) hole.message = joined(std::move(hole.message), "; ", island_not_joined(why));
    for (const BoundaryLoop& island : place)
      if (task.asked.contains(island.number))
        alone.holes.push_back(
            open_hole(island, PatchStatus::skipped,
                      say("the piece lies within hole %1, whose patch covers it: left as it is", place[0].number)
                          .with_code("covered_island")));
    return alone;
  }
  GroupResult result;
  const auto patch = std::make_shared<const PatchResult>(std::move(*made));
  result.patches.push_back(patch);
  for (std::size_t k = 0; k < place.size(); ++k) {
    HoleResult& hole = result.holes.emplace_back(open_hole(place[k], patch->status, patch->message));
    hole.patch = patch;
    hole.place = static_cast<int>(k);
    hole.seconds = patch->seconds.total;
    if (k == 0)
      hole.free_vertices = patch->patch.free_count;
    else
      hole.message = say("an island: joined to hole %1", place[0].number).with_code("joined_island");
  }
  return result;
}

/// Patches that would intersect one another are left out. @returns the results in the order of `loops`, then those of islands.
std::vector<HoleResult> pasted(SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                               std::vector<GroupResult> solved) {
  std::map<const PatchResult*, std::size_t> place_of_patch;
  std::vector<const Patch*> geometry;
  for (const GroupResult& group : solved)
    for (const auto& patch : group.patches) {
      if (!is_filled(patch->status)) continue;
      place_of_patch.emplace(patch.get(), geometry.size());
      geometry.push_back(&patch->patch);
    }
  std::map<int, std::size_t> place;
  for (std::size_t k = 0; k < loops.size(); ++k) place.emplace(loops[k].number, k);
  const auto place_of = [&](const HoleResult& result) {
    const auto found = place.find(result.loop.number);
    return found != place.end() ? found->second : loops.size() + static_cast<std::size_t>(result.loop.number);
  };
  std::vector<HoleResult> results;
  for (GroupResult& group : solved) std::move(group.holes.begin(), group.holes.end(), std::back_inserter(results));
  std::stable_sort(results.begin(), results.end(),
                   [&](const HoleResult& x, const HoleResult& y) { return place_of(x) < place_of(y); });
  // From here on memory is asked for by paste_patches alone. Either the model is unchanged, or these results are handed back.
  std::vector<Message> spare(results.size(), no_memory_message());
  const std::vector<PastedPatch> outcomes = paste_patches(model, geometry);
  for (std::size_t k = 0; k < results.size(); ++k) {
    HoleResult& result = results[k];
    const auto patch = place_of_patch.find(result.patch.get());
    if (patch == place_of_patch.end()) continue;
    const PastedPatch& outcome = outcomes[patch->second];
    result.first_point = outcome.first_point;
    result.first_triangle = outcome.first_triangle;
    if (outcome.fault.empty()) continue;
    result.status = PatchStatus::failed;
    try {
      result.message = outcome.fault;
    } catch (const std::bad_alloc&) {
      result.message = std::move(spare[k]);
    }
  }
  return results;
}

/// Tasks that could not share the memory with as many others as there are threads come first, to be worked on one by one; a
/// group that is too large together comes apart. @returns how many these are.
int large_first(const SurfaceModel& model, const FillOptions& options, std::vector<Task>& tasks) {
  if (!options.evolution || std::isinf(options.most_memory_mb)) return 0;
  const auto memory_of = [&](const Task& task) {
    double vertices = 0;
    for (const BoundaryLoop& loop : task.loops) vertices += expected_new_vertices(model, loop, options.initial.density);
    return expected_memory_mb(vertices);
  };
  std::vector<Task> large, small;
  for (Task& task : tasks) {
    const double needed = memory_of(task);
    if (needed > options.most_memory_mb && task.kind == Task::Kind::fill) {
      for (BoundaryLoop& loop : task.loops) large.push_back({Task::Kind::fill, {std::move(loop)}, {}});
    } else {
      (needed * thread_budget() > options.most_memory_mb ? large : small).push_back(std::move(task));
    }
  }
  const int count = static_cast<int>(large.size());
  tasks = std::move(large);
  std::move(small.begin(), small.end(), std::back_inserter(tasks));
  return count;
}

/// Closes the tiny holes: a scan may have very many. @returns one result for each loop; nothing where it takes more, or where an
/// island is to be joined.
std::vector<std::optional<GroupResult>> tiny_holes_closed(const ScanIndex& scan, const std::vector<BoundaryLoop>& loops,
                                                          const FillOptions& options, const CancelToken& cancel) {
  std::vector<std::optional<GroupResult>> closed(loops.size());
  std::set<int> around_islands;
  if (options.islands == FillOptions::Islands::join)
    for (const std::vector<BoundaryLoop>& place : holes_with_islands(scan.model, loops))
      around_islands.insert(place.front().number);
  parallel_for(0, static_cast<int>(loops.size()), 64, [&](int k) {
    if (cancel.cancelled() || around_islands.contains(loops[k].number)) return;
    try {
      closed[k] = close_tiny_hole(scan, loops[k], options, 2);
    } catch (const std::exception&) {  // what goes wrong there is said when it is tried with all means
    }
  });
  return closed;
}

std::vector<HoleResult> fill(SurfaceModel& model, const std::vector<BoundaryLoop>& loops, const FillOptions& asked,
                             const OnFillProgress& progress, const CancelToken& cancel) {
  FillOptions options = asked;
  if (options.evolution)  // what could not be solved is not made
    options.initial.most_vertices =
        std::min(options.initial.most_vertices, options.most_memory_mb / expected_memory_mb(1));
  if (options.mirror == FillOptions::Mirror::find) options.mirror_planes = find_mirror_planes(model, cancel);
  const ScanIndex scan(model);
  std::vector<GroupResult> solved;
  std::vector<BoundaryLoop> possible;
  std::set<int> refused;
  std::vector<std::optional<GroupResult>> closed = tiny_holes_closed(scan, loops, options, cancel);
  for (std::size_t k = 0; k < loops.size(); ++k) {  // what no patch can fill is known before any is made
    const BoundaryLoop& loop = loops[k];
    if (closed[k]) {
      solved.push_back(std::move(*closed[k]));
      continue;
    }
    if (cancel.cancelled()) {
      possible.push_back(loop);
      continue;
    }
    Message why;
    try {
      if (loop.kind != LoopKind::cut) why = why_no_patch_exists(scan, loop);
      if (why.empty()) why = why_expected_too_large(model, loop, options);
    } catch (const std::exception& error) {
      why = message_of(error);
    }
    if (why.empty()) {
      possible.push_back(loop);
      continue;
    }
    refused.insert(loop.number);
    solved.push_back(open_group({loop}, PatchStatus::failed, why));
  }
  if (cancel.cancelled()) {
    if (options.on_cancel == FillOptions::OnCancel::discard) return {};
    solved.push_back(open_group(possible, PatchStatus::skipped, not_finished()));
    return pasted(model, loops, std::move(solved));
  }
  std::vector<Task> tasks = tasks_for(model, possible, options.islands, refused);
  const int one_by_one = large_first(model, options, tasks);
  std::vector<GroupResult> results(tasks.size());
  std::vector<char> finished(tasks.size(), 0);
  std::mutex progress_mutex;
  FillProgress state;
  state.loops_total =
      std::accumulate(tasks.begin(), tasks.end(), static_cast<int>(solved.size()),
                      [](int sum, const Task& task) { return sum + static_cast<int>(task.loops.size()); });
  state.loops_done = static_cast<int>(solved.size());
  if (progress && state.loops_done > 0) {
    state.loop_number = solved.back().holes.front().loop.number;
    progress(state);
  }
  const auto work_on = [&](int k) {
    if (cancel.cancelled()) return;
    const Task& task = tasks[k];
    results[k] =
        task.kind == Task::Kind::join ? joined(scan, task, options, cancel) : filled(scan, task.loops, options, cancel);
    const std::lock_guard lock(progress_mutex);
    if (cancel.cancelled()) return;
    finished[k] = 1;
    state.loops_done += static_cast<int>(task.loops.size());
    state.loop_number = task.loops.front().number;
    if (progress) progress(state);
  };
  for (int k = 0; k < one_by_one; ++k) work_on(k);
  parallel_for(one_by_one, static_cast<int>(tasks.size()), 1, work_on);
  if (cancel.cancelled() && options.on_cancel == FillOptions::OnCancel::discard) return {};
  for (std::size_t k = 0; k < tasks.size(); ++k)
    solved.push_back(finished[k] ? std::move(results[k])
                                 : open_group(tasks[k].loops, PatchStatus::skipped, not_finished()));
  return pasted(model, loops, std::move(solved));
}

}  // namespace

void check(const FillOptions& options) {
  check(options.initial);
  if (!(options.most_memory_mb > 0)) throw InvalidArgument(say("the memory for patches must be above 0 MB"));
  if (options.evolution) check(*options.evolution);
  if (!options.evolution && (options.mirror == FillOptions::Mirror::find || !options.mirror_planes.empty()))
    throw InvalidArgument(
        say("a patch without a flow is left as its first shape, and is no mirror image: choose a flow"));
}

Message island_not_joined(const Message& why) {
  return say("the piece of surface within it was not joined: %1", why.empty() ? say("no bridge was found") : why)
      .with_code("island_not_joined");
}

std::vector<HoleResult> fill_holes(SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                   const FillOptions& options, const OnFillProgress& progress,
                                   const CancelToken& cancel) {
  check(options);
  if (!holds_neighborhood(model, loops))
    throw InvalidArgument(
        say("the view of the surface ends too near to a loop that is to be filled (pipeline/filling_view.h)"));
  return with_thread_budget(options.threads, [&] { return fill(model, loops, options, progress, cancel); });
}

std::vector<std::vector<BoundaryLoop>> holes_with_islands(const SurfaceModel& model,
                                                          const std::vector<BoundaryLoop>& asked) {
  const std::vector<BoundaryLoop> all = find_boundary_loops(model);
  std::set<int> numbers;
  for (const BoundaryLoop& loop : asked) numbers.insert(loop.number);
  std::vector<std::vector<BoundaryLoop>> places;
  for (const HoleWithIslands& found : find_islands(model, all)) {
    if (!numbers.contains(all[found.hole].number)) continue;
    std::vector<BoundaryLoop> place{all[found.hole]};
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
