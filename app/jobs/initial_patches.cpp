// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/initial_patches.h"

#include "core/error.h"
#include "core/threads.h"
#include "document/timeline.h"
#include "filling/bridge_loops.h"
#include "jobs/state_making.h"

#include <algorithm>
#include <mutex>
#include <new>

namespace loopmend {
namespace {

/// Loops that are solved jointly: indices in the document.
struct Group {
  const FillTask* task = nullptr;
  PatchRecipe::Start start = PatchRecipe::Start::holes;
  std::vector<int> indices;
  std::vector<BoundaryLoop> loops;
};

std::vector<BoundaryLoop> wanted_loops(const FillTask& task) {
  std::vector<BoundaryLoop> loops;
  for (const auto& [index, loop] : task.wanted) loops.push_back(loop);
  return loops;
}

/// Holes whose islands are joined to them.
std::vector<Group> bridges_of(const FillTask& task) {
  std::vector<Group> groups;
  if (task.options.islands == FillOptions::Islands::cover) return groups;
  for (std::vector<BoundaryLoop>& loops : holes_with_islands(task.scan_context->model(), wanted_loops(task))) {
    Group group{&task, PatchRecipe::Start::bridge, {}, std::move(loops)};
    for (const BoundaryLoop& loop : group.loops) group.indices.push_back(task.first_loop + loop.number - 1);
    // An island that has a patch of its own stays as it is.
    if (std::any_of(group.indices.begin(), group.indices.end(), [&](int k) { return task.taken.contains(k); }))
      continue;
    groups.push_back(std::move(group));
  }
  return groups;
}

std::vector<Group> groups_of(const FillTask& task) {
  std::vector<Group> groups = bridges_of(task);
  std::map<int, BoundaryLoop> all = task.wanted;
  all.insert(task.filled.begin(), task.filled.end());
  for (const Group& bridge : groups)
    for (int index : bridge.indices) all.erase(index);
  std::vector<int> indices;
  std::vector<BoundaryLoop> loops;
  for (const auto& [index, loop] : all) {
    indices.push_back(index);
    loops.push_back(loop);
  }
  for (const std::vector<int>& members : group_loops(task.scan_context->model(), loops)) {
    Group group{&task, PatchRecipe::Start::holes, {}, {}};
    for (int k : members) {
      group.indices.push_back(indices[static_cast<std::size_t>(k)]);
      group.loops.push_back(loops[static_cast<std::size_t>(k)]);
    }
    if (std::any_of(group.indices.begin(), group.indices.end(), [&](int k) { return task.wanted.contains(k); }))
      groups.push_back(std::move(group));
  }
  return groups;
}

/// The patch that the group sets out from, as a document holds it.
void add_patch(const Group& group, std::vector<int> loops, Patch patch, const Message& message, FillResult& result) {
  const FillTask& task = *group.task;
  OpenPatch open;
  open.scan = task.scan;
  open.loops = std::move(loops);
  auto first = std::make_shared<PatchState>(
      *first_state(std::move(patch), message, task.options.initial.density, task.origin, task.scan_context->colors()));
  first->recipe.start = group.start;
  open.state = judged(std::move(first), nullptr, *task.scan_context);
  open.timeline = start_timeline(open.state);
  result.patches.push_back(std::move(open));
}

void fill(const Group& group, const CancelToken& cancel, FillResult& result) {
  const FillTask& task = *group.task;
  InitialPatch initial = make_initial_patch(task.scan_context->model(), group.loops, task.options.initial, cancel);
  if (cancel.cancelled()) return;
  std::vector<int> filled;
  bool anything_new = false;
  for (std::size_t k = 0; k < group.indices.size(); ++k) {
    const int index = group.indices[k];
    const Message& message = initial.outcomes[k].message;
    const bool wanted = task.wanted.contains(index);
    if (!initial.outcomes[k].patch) {
      if (wanted)
        result.failures[index] = message.empty() ? say("no valid triangulation of this loop was found") : message;
      continue;
    }
    filled.push_back(index);
    anything_new = anything_new || wanted;
    if (!message.empty()) result.remarks[index] = message;
  }
  if (!anything_new)
    result.remarks.clear();
  else
    add_patch(group, std::move(filled), std::move(*initial.patch), initial.message(), result);
}

/// Where no bridge is found, the hole's patch covers the islands.
void bridge(const Group& group, const CancelToken& cancel, FillResult& result) {
  const SurfaceModel& model = group.task->scan_context->model();
  BridgeOutcome outcome;
  try {
    outcome = bridge_loops(model, group.loops, group.task->options.initial, cancel);
  } catch (const std::exception& error) {
    outcome.message = message_of(error);
  }
  if (cancel.cancelled()) return;
  if (!outcome.bridge) {
    fill({group.task, PatchRecipe::Start::holes, {group.indices.front()}, {group.loops.front()}}, cancel, result);
    result.remarks[group.indices.front()] = island_not_joined(outcome.message);
    return;
  }
  if (!outcome.message.empty()) result.remarks[group.indices.front()] = outcome.message;
  add_patch(group, group.indices, std::move(outcome.bridge->membrane), outcome.message, result);
}

/// Takes loops out of the task that no patch can close.
void refuse(FillTask& task, const CancelToken& cancel, FillResult& result) {
  std::erase_if(task.wanted, [&](const auto& entry) {
    const auto& [index, loop] = entry;
    if (cancel.cancelled() || loop.kind == LoopKind::cut) return false;
    Message why;
    try {
      why = why_no_patch_exists(task.scan_context->index(), loop);
    } catch (const std::exception& error) {
      why = message_of(error);
    }
    if (!why.empty()) result.failures[index] = why;
    return !why.empty();
  });
}

/// What goes wrong in one group leaves the others alone.
FillResult failed(const Group& group, const Message& why) {
  FillResult result;
  for (int index : group.indices)
    if (group.task->wanted.contains(index)) result.failures[index] = why;
  return result;
}

}  // namespace

FillResult make_initial_patches(const std::vector<FillTask>& tasks, const std::function<void(int)>& progress,
                                const CancelToken& cancel) {
  FillResult result;
  std::vector<FillTask> possible = tasks;
  for (FillTask& task : possible) refuse(task, cancel, result);
  std::vector<Group> groups;
  for (const FillTask& task : possible) {
    std::vector<Group> more = groups_of(task);
    std::move(more.begin(), more.end(), std::back_inserter(groups));
  }
  std::mutex mutex;
  int done = 0;
  parallel_for(0, static_cast<int>(groups.size()), 1, [&](int k) {
    const Group& group = groups[static_cast<std::size_t>(k)];
    if (cancel.cancelled()) return;
    FillResult one;
    try {
      group.start == PatchRecipe::Start::bridge ? bridge(group, cancel, one) : fill(group, cancel, one);
    } catch (const std::bad_alloc&) {
      one = failed(group, no_memory_message());
    } catch (const std::exception& error) {
      one = failed(group, message_of(error));
    }
    const std::lock_guard lock(mutex);
    std::move(one.patches.begin(), one.patches.end(), std::back_inserter(result.patches));
    result.failures.merge(one.failures);
    result.remarks.merge(one.remarks);
    done += static_cast<int>(group.loops.size());
    progress(done);
  });
  std::sort(result.patches.begin(), result.patches.end(),
            [](const OpenPatch& a, const OpenPatch& b) { return a.loops < b.loops; });
  return result;
}

}  // namespace loopmend
