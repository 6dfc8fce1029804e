// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/fill_holes.h"

#include "core/error.h"
#include "core/seconds_since.h"
#include "core/threads.h"
#include "filling/find_rings.h"
#include "filling/patch_size.h"
#include "mesh/pieces.h"
#include "pipeline/blend.h"
#include "pipeline/edge_preview.h"
#include "pipeline/filling_view.h"
#include "pipeline/paste.h"
#include "pipeline/tiny_hole.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <map>
#include <mutex>
#include <new>
#include <numeric>
#include <optional>
#include <set>

namespace loopmend {

namespace {

/// Loops that are solved together: holes of one group, a hole and the islands in it that are joined to it, the loops around a missing face, or a
/// patch that a flow has moved.
struct Task {
  enum class Kind { fill, join, face, go_on } kind = Kind::fill;
  std::vector<BoundaryLoop> loops;      ///< of `join` the hole's first, of `face` the outline
  std::set<int> asked{};                ///< of `join`: numbers of those islands that are to be filled themselves
  const InitialPatch* moved = nullptr;  ///< of `go_on`

  int edges() const {
    return std::accumulate(loops.begin(), loops.end(), 0,
                           [](int sum, const BoundaryLoop& loop) { return sum + loop.edges(); });
  }
};

/// A piece smaller than this share of the hole tells nothing of the surface that is missing: the patch covers it.
constexpr double least_island = 0.05;

/// The loops around each plane face that is missing.
std::vector<std::vector<BoundaryLoop>> faces_to_close(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                                      const FillOptions& options, const CancelToken& cancel) {
  std::vector<std::vector<BoundaryLoop>> faces;
  const bool bends = options.evolution && !is_judged(*options.evolution);  // a flow that was asked for
  if (options.islands == FillOptions::Islands::cover || bends) return faces;
  for (const std::vector<int>& face : find_missing_faces(model, loops, cancel)) {
    faces.emplace_back();
    for (const int k : face) faces.back().push_back(loops[static_cast<std::size_t>(k)]);
  }
  return faces;
}

/// Those with the most edges first: they take the longest.
/// @param no_islands  numbers of loops that no patch can close, or that have one: they are not joined to a hole.
std::vector<Task> tasks_for(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                            const FillOptions& options, const std::set<int>& no_islands, const CancelToken& cancel) {
  std::vector<Task> tasks;
  std::set<int> joined;
  for (std::vector<BoundaryLoop>& face : faces_to_close(model, loops, options, cancel)) {
    for (const BoundaryLoop& loop : face) joined.insert(loop.number);
    tasks.push_back({Task::Kind::face, std::move(face)});
  }
  if (options.islands == FillOptions::Islands::join && !loops.empty())
    for (std::vector<BoundaryLoop>& place : holes_with_islands(model, loops)) {
      std::erase_if(place, [&](const BoundaryLoop& loop) {
        return no_islands.contains(loop.number) || joined.contains(loop.number);
      });
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
  return say("about %1 new vertices would take %2 MB of memory, and %3 MB are free for it: left open; a smaller "
             "density "
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

/// What all groups of a fill share.
struct Fill {
  const ScanIndex& scan;
  const FillOptions& options;
  const SolveObserver& observer;
  const CancelToken& cancel;

  GroupResult done(GroupResult result) const {
    if (observer.on_done && !cancel.cancelled()) observer.on_done(result);
    return result;
  }
  GroupResult left_open(const std::vector<BoundaryLoop>& loops, const Message& why) const {
    return done(open_group(loops, PatchStatus::failed, why));
  }
  Message why_too_large(const Patch& patch) const {
    return memory_message(patch.free_count, memory_mb_of(patch.free_count), options.most_memory_mb);
  }
};

GroupResult filled(const Fill& fill, const std::vector<BoundaryLoop>& loops);

/// A group that is too large together: loops that are not so are filled.
GroupResult each_alone(const Fill& fill, const std::vector<BoundaryLoop>& loops) {
  GroupResult all;
  for (const BoundaryLoop& loop : loops) {
    if (fill.cancel.cancelled()) return open_group(loops, PatchStatus::cancelled, {});
    GroupResult one = filled(fill, {loop});
    std::move(one.holes.begin(), one.holes.end(), std::back_inserter(all.holes));
    std::move(one.patches.begin(), one.patches.end(), std::back_inserter(all.patches));
  }
  return all;
}

/// work(), which fills these loops; what goes wrong there is theirs alone.
template <class Work>
GroupResult isolated(const Fill& fill, const std::vector<BoundaryLoop>& loops, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return fill.left_open(loops, no_memory_message());
  } catch (const std::exception& error) {
    return fill.left_open(loops, message_of(error));
  }
}

GroupResult filled(const Fill& fill, const std::vector<BoundaryLoop>& loops) {
  return isolated(fill, loops, [&] {
    const auto make = fill.options.evolution ? make_surveyed_patch : make_initial_patch;
    const InitialPatch initial = make(fill.scan.model, loops, fill.options.initial, fill.cancel);
    if (initial.patch && fill.options.evolution) {
      const Message why = fill.why_too_large(*initial.patch);
      if (!why.empty() && loops.size() > 1) return each_alone(fill, loops);
      if (!why.empty()) return fill.left_open(loops, why);
    }
    if (initial.patch && fill.observer.on_start) fill.observer.on_start({*initial.patch, initial.message()});
    return solve_group(fill.scan, initial, fill.options, fill.observer, fill.cancel);
  });
}

GroupResult gone_on(const Fill& fill, const InitialPatch& moved) {
  return isolated(fill, moved.loops, [&] {
    const int vertices = moved.patch->free_count;
    if (const double needed = memory_mb_of(vertices); needed > fill.options.most_memory_mb)
      return fill.left_open(moved.loops, say("a step of %1 new vertices would take %2 MB of memory, and %3 MB are "
                                             "allowed: the patch stays as it is",
                                             vertices, std::llround(std::ceil(needed)),
                                             std::llround(std::floor(fill.options.most_memory_mb)))
                                             .with_code("no_memory"));
    return solve_group(fill.scan, moved, fill.options, fill.observer, fill.cancel);
  });
}

/// One patch between the loops, of a face a plane one. @param why  is set where there is none; its reason may be empty.
std::optional<PatchResult> bridged(const Fill& fill, const Task& task, Message& why) {
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] { return seconds_since(start); };
  try {
    BridgeOutcome outcome = bridge_loops(fill.scan.model, task.loops, fill.options.initial, fill.cancel);
    why = outcome.message;
    if (!outcome.bridge || fill.cancel.cancelled()) return std::nullopt;
    if (task.kind == Task::Kind::face && outcome.bridge->kind != Bridge::Kind::ring) return std::nullopt;
    const Message too_large = fill.why_too_large(outcome.bridge->start);
    if (!too_large.empty()) {
      why = too_large;
      return std::nullopt;
    }
    const double bridge_seconds = seconds();
    if (fill.observer.on_start)
      fill.observer.on_start({outcome.bridge->membrane, outcome.message, StartPatch::Kind::bridge});
    PatchResult result =
        solve_bridge(fill.scan, *outcome.bridge, fill.options.evolution, fill.observer.on_step, fill.cancel);
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

/// The hole's islands joined to it, or where that fails covered by its patch; a missing face, or a patch for each of its loops.
GroupResult joined(const Fill& fill, const Task& task) {
  const std::vector<BoundaryLoop>& place = task.loops;
  const bool is_face = task.kind == Task::Kind::face;
  Message why;
  std::optional<PatchResult> made = bridged(fill, task, why);
  if (!made && is_face) return each_alone(fill, place);
  if (!made) {
    SolveObserver quiet = fill.observer;  // more is to be said of the hole before it is done
    quiet.on_done = nullptr;
    GroupResult alone = filled({fill.scan, fill.options, quiet, fill.cancel}, {place.front()});
    for (HoleResult& hole : alone.holes) hole.message = joined(std::move(hole.message), "; ", island_not_joined(why));
    for (const BoundaryLoop& island : place)
      if (task.asked.contains(island.number))
        alone.holes.push_back(
            open_hole(island, PatchStatus::skipped,
                      say("the piece lies within hole %1, whose patch covers it: left as it is", place[0].number)
                          .with_code("covered_island")));
    return fill.done(std::move(alone));
  }
  if (const auto& flow = fill.options.evolution;
      flow && continues_edges(*flow) && !edits_at(fill.scan.model, place, flow->edge_edits).drawn.empty())
    made->reason =
        joined(std::move(made->reason), "; ", say("no sharp edge is drawn across holes that one patch joins"));
  if (!is_face) judge_islands(made->patch, made->verdicts);
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
    else if (is_face)
      hole.message =
          say("a wall ends here, too: joined to hole %1 by a plane face", place[0].number).with_code("joined_wall");
    else
      hole.message = say("an island: joined to hole %1", place[0].number).with_code("joined_island");
  }
  return fill.done(std::move(result));
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
      for (BoundaryLoop& loop : task.loops) large.push_back({Task::Kind::fill, {std::move(loop)}});
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
std::vector<std::optional<GroupResult>> tiny_holes_closed(const Fill& fill, const std::vector<BoundaryLoop>& loops) {
  std::vector<std::optional<GroupResult>> closed(loops.size());
  std::set<int> to_join;
  if (fill.options.islands == FillOptions::Islands::join)
    for (const std::vector<BoundaryLoop>& place : holes_with_islands(fill.scan.model, loops))
      to_join.insert(place.front().number);
  for (const std::vector<BoundaryLoop>& face : faces_to_close(fill.scan.model, loops, fill.options, fill.cancel))
    for (const BoundaryLoop& loop : face) to_join.insert(loop.number);
  // Two rings are enough to paste a patch; whoever watches may go on from it with a flow.
  const int rings = fill.observer.on_done ? patch_rings : 2;
  parallel_for(0, static_cast<int>(loops.size()), 64, [&](int k) {
    if (fill.cancel.cancelled() || to_join.contains(loops[k].number)) return;
    try {
      if (auto own = close_tiny_hole(fill.scan, loops[k], fill.options, rings)) closed[k] = fill.done(std::move(*own));
    } catch (const std::exception&) {  // what goes wrong there is said when it is tried with all means
    }
  });
  return closed;
}

/// What is known before any patch of a flow is made: tiny holes are closed, loops that no patch can fill are left.
/// @param refused  gets the numbers of the latter. @returns the other loops.
std::vector<BoundaryLoop> possible_loops(const Fill& fill, const std::vector<BoundaryLoop>& loops,
                                         std::vector<GroupResult>& solved, std::set<int>& refused) {
  std::vector<BoundaryLoop> possible;
  std::vector<std::optional<GroupResult>> closed = tiny_holes_closed(fill, loops);
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const BoundaryLoop& loop = loops[k];
    if (closed[k]) {
      solved.push_back(std::move(*closed[k]));
      continue;
    }
    Message why;
    try {
      if (!fill.cancel.cancelled() && loop.kind != LoopKind::cut) why = why_no_patch_exists(fill.scan, loop);
      if (!fill.cancel.cancelled() && why.empty()) why = why_expected_too_large(fill.scan.model, loop, fill.options);
    } catch (const std::exception& error) {
      why = message_of(error);
    }
    if (why.empty()) {
      possible.push_back(loop);
      continue;
    }
    refused.insert(loop.number);
    solved.push_back(fill.left_open({loop}, why));
  }
  return possible;
}

std::vector<GroupResult> solved_groups(const Fill& fill, const HolesToSolve& holes, const OnFillProgress& progress) {
  std::vector<GroupResult> solved;
  std::set<int> no_islands = holes.closed;
  const std::vector<BoundaryLoop> possible = possible_loops(fill, holes.loops, solved, no_islands);
  std::vector<Task> tasks;
  if (fill.cancel.cancelled())
    tasks.push_back({Task::Kind::fill, possible});
  else
    tasks = tasks_for(fill.scan.model, possible, fill.options, no_islands, fill.cancel);
  for (const InitialPatch& moved : holes.moved) tasks.push_back({Task::Kind::go_on, moved.loops, {}, &moved});
  const int one_by_one = large_first(fill.scan.model, fill.options, tasks);
  std::vector<GroupResult> results(tasks.size());
  std::vector<char> finished(tasks.size(), 0);
  std::mutex progress_mutex;
  FillProgress state;
  state.loops_total =
      std::accumulate(tasks.begin(), tasks.end(), static_cast<int>(solved.size()),
                      [](int sum, const Task& task) { return sum + static_cast<int>(task.loops.size()); });
  state.loops_done = static_cast<int>(solved.size());
  if (progress && state.loops_done > 0 && !fill.cancel.cancelled()) {
    state.loop_number = solved.back().holes.front().loop.number;
    progress(state);
  }
  const auto work_on = [&](int k) {
    if (fill.cancel.cancelled()) return;
    const Task& task = tasks[k];
    results[k] = task.kind == Task::Kind::fill    ? filled(fill, task.loops)
                 : task.kind == Task::Kind::go_on ? gone_on(fill, *task.moved)
                                                  : joined(fill, task);
    const std::lock_guard lock(progress_mutex);
    if (fill.cancel.cancelled()) return;
    finished[k] = 1;
    state.loops_done += static_cast<int>(task.loops.size());
    state.loop_number = task.loops.front().number;
    if (progress) progress(state);
  };
  for (int k = 0; k < one_by_one; ++k) work_on(k);
  parallel_for(one_by_one, static_cast<int>(tasks.size()), 1, work_on);
  for (std::size_t k = 0; k < tasks.size(); ++k)
    solved.push_back(finished[k] ? std::move(results[k])
                                 : open_group(tasks[k].loops, PatchStatus::skipped, not_finished()));
  if (fill.cancel.cancelled() && fill.options.on_cancel == FillOptions::OnCancel::discard) solved.clear();
  return solved;
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

std::vector<GroupResult> solve_holes(const ScanIndex& scan, const HolesToSolve& holes, const FillOptions& asked,
                                     const SolveObserver& observer, const OnFillProgress& progress,
                                     const CancelToken& cancel) {
  check(asked);
  if (!holds_neighborhood(scan.model, holes.loops))
    throw InvalidArgument(
        say("the view of the surface ends too near to a loop that is to be filled (pipeline/filling_view.h)"));
  return with_thread_budget(asked.threads, [&] {
    FillOptions options = asked;
    if (options.evolution)  // what could not be solved is not made
      options.initial.most_vertices =
          std::min(options.initial.most_vertices, options.most_memory_mb / expected_memory_mb(1));
    if (options.mirror == FillOptions::Mirror::find) options.mirror_planes = find_mirror_planes(scan.model, cancel);
    return solved_groups({scan, options, observer, cancel}, holes, progress);
  });
}

std::vector<HoleResult> fill_holes(SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                   const FillOptions& options, const OnFillProgress& progress,
                                   const CancelToken& cancel) {
  std::vector<GroupResult> solved = solve_holes(ScanIndex(model), {loops}, options, {}, progress, cancel);
  if (solved.empty()) return {};
  return with_thread_budget(options.threads, [&] { return pasted(model, loops, std::move(solved)); });
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
      const bool is_fragment = all[island].diameter < least_island * place.front().diameter;
      if (!is_fragment && find_opposed_loops(model, {place.front(), all[island]}).empty()) place.push_back(all[island]);
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
