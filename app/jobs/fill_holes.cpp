// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/fill_holes.h"

#include "document/timeline.h"
#include "jobs/state_making.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

namespace loopmend {
namespace {

/// Loops that are solved jointly: indices in the document.
struct Group {
  const FillTask* task = nullptr;
  std::vector<int> loops;
};

std::vector<Group> groups_of(const FillTask& task) {
  std::vector<int> indices;
  std::vector<BoundaryLoop> loops;
  std::map<int, BoundaryLoop> all = task.wanted;
  all.insert(task.filled.begin(), task.filled.end());
  for (const auto& [index, loop] : all) {
    indices.push_back(index);
    loops.push_back(loop);
  }
  std::vector<Group> groups;
  for (const std::vector<int>& members : group_loops(task.site->model(), loops)) {
    Group group{&task, {}};
    for (int k : members) group.loops.push_back(indices[static_cast<std::size_t>(k)]);
    if (std::any_of(group.loops.begin(), group.loops.end(), [&](int loop) { return task.wanted.contains(loop); }))
      groups.push_back(std::move(group));
  }
  return groups;
}

const BoundaryLoop& loop_of(const FillTask& task, int index) {
  const auto found = task.wanted.find(index);
  return found != task.wanted.end() ? found->second : task.filled.at(index);
}

/// Fills one group, and puts what came of it into `result` under its lock.
class GroupFiller {
 public:
  GroupFiller(Judging judging, FillResult& result) : judging_(judging), result_(result) {}

  void fill(const Group& group, const CancelToken& cancel) {
    const FillTask& task = *group.task;
    std::vector<BoundaryLoop> loops;
    for (int index : group.loops) loops.push_back(loop_of(task, index));
    PatchStart start;
    std::string trouble;
    try {
      start = start_patch(task.site->model(), loops, task.options, cancel);
    } catch (const std::exception& error) {
      trouble = error.what();
    }
    if (!cancel.cancelled()) record(group, std::move(start), trouble);
  }

 private:
  void record(const Group& group, PatchStart start, const std::string& trouble) {
    const FillTask& task = *group.task;
    OpenPatch open;
    open.scan = task.scan;
    std::map<int, std::string> failures, remarks;
    bool anything_new = false;
    for (std::size_t k = 0; k < group.loops.size(); ++k) {
      const int index = group.loops[k];
      const bool filled = k < start.fillers.size() && start.fillers[k].filler.has_value() && start.patch.has_value();
      const std::string words = k < start.fillers.size() ? start.fillers[k].message : trouble;
      if (filled) open.loops.push_back(index);
      if (filled && !words.empty()) remarks[index] = words;
      if (!task.wanted.contains(index)) continue;
      anything_new = anything_new || filled;
      if (!filled) failures[index] = words.empty() ? "No valid triangulation of this loop was found." : words;
    }
    std::string message;
    for (const auto& [index, words] : remarks) message += (message.empty() ? "" : " ") + words;
    if (anything_new) {
      open.state = first_state(std::move(*start.patch), message, task.options.density, task.origin);
      if (judging_ == Judging::cuts) open.state = judged(open.state, nullptr, *task.site);
      open.timeline = start_timeline(open.state);
    }
    const std::lock_guard lock(mutex_);
    if (open.state) result_.patches.push_back(std::move(open));
    result_.failures.merge(failures);
    if (anything_new) result_.remarks.merge(remarks);
  }

  Judging judging_;
  FillResult& result_;
  std::mutex mutex_;
};

}  // namespace

FillResult fill_holes(const std::vector<FillTask>& tasks, Judging judging, const std::function<void(int)>& progress,
                      const CancelToken& cancel) {
  FillResult result;
  GroupFiller filler(judging, result);
  std::vector<Group> groups;
  for (const FillTask& task : tasks) {
    std::vector<Group> more = groups_of(task);
    std::move(more.begin(), more.end(), std::back_inserter(groups));
  }
  std::atomic<std::size_t> next{0};
  std::mutex progress_mutex;
  int done = 0;
  const auto work = [&] {
    for (std::size_t g = next++; g < groups.size() && !cancel.cancelled(); g = next++) {
      filler.fill(groups[g], cancel);
      const std::lock_guard lock(progress_mutex);
      done += static_cast<int>(groups[g].loops.size());
      progress(done);
    }
  };
  std::vector<std::jthread> helpers;
  const std::size_t most = std::min<std::size_t>(std::max(1u, std::thread::hardware_concurrency()), groups.size());
  try {
    for (std::size_t i = 1; i < most; ++i) helpers.emplace_back(work);
  } catch (const std::system_error&) {
    // No further thread is to be had: those that are there do all the work.
  }
  work();
  helpers.clear();
  std::sort(result.patches.begin(), result.patches.end(),
            [](const OpenPatch& a, const OpenPatch& b) { return a.loops < b.loops; });
  return result;
}

}  // namespace loopmend
