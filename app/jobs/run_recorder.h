// SPDX-License-Identifier: GPL-3.0-or-later
// What a run has reached so far: the worker records every accepted state, the window takes the newest when it has time.
// Draws coalesce (latest wins), records do not get lost. Outlives the worker, so that a cancelled run keeps its states.
#pragma once

#include "document/patch_state.h"

#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

namespace loopmend {

/// What a run has made of one patch.
struct PatchRun {
  PatchStatePtr first;               ///< before any flow; null where the document has it, or it is not asked for
  std::vector<PatchStatePtr> steps;  ///< of the last attempt, from there on
};
using PatchRuns = std::map<std::set<int>, PatchRun>;  ///< by loops, as indices in the document

class RunRecorder {
 public:
  /// @param wake  called on the worker's thread when nothing was waiting before; should queue one call of take().
  explicit RunRecorder(std::function<void()> wake) : wake_(std::move(wake)) {}

  /// A patch for these loops, in place of others for any of them.
  void start(const std::set<int>& loops, PatchStatePtr first) {
    put(loops, [&](PatchRun& run) { run = {std::move(first), {}}; });
  }
  void record(const std::set<int>& loops, PatchStatePtr state) {
    put(loops, [&](PatchRun& run) { run.steps.push_back(std::move(state)); });
  }
  /// The run starts again from where it began; what was recorded is thrown away.
  void restart(const std::set<int>& loops) {
    const std::lock_guard lock(mutex_);
    runs_[loops].steps.clear();
  }
  /// The last state comes again with other words.
  void amend(const std::set<int>& loops, PatchStatePtr state) {
    put(loops, [&](PatchRun& run) {
      if (!run.steps.empty()) run.steps.pop_back();
      run.steps.push_back(std::move(state));
    });
  }

  /// Of every patch that has a new state, all of this run.
  PatchRuns take() {
    const std::lock_guard lock(mutex_);
    PatchRuns news;
    for (const std::set<int>& loops : fresh_) news[loops] = runs_[loops];
    fresh_.clear();
    return news;
  }

 private:
  template <class Act>
  void put(const std::set<int>& loops, const Act& act) {
    std::unique_lock lock(mutex_);
    const bool was_empty = fresh_.empty();
    for (int loop : loops) {
      std::set<int>& before = patch_of_[loop];
      if (before == loops) continue;
      runs_.erase(before);
      fresh_.erase(before);
      before = loops;
    }
    act(runs_[loops]);
    fresh_.insert(loops);
    lock.unlock();
    if (was_empty && wake_) wake_();
  }

  std::function<void()> wake_;
  std::mutex mutex_;
  PatchRuns runs_;
  std::map<int, std::set<int>> patch_of_;  ///< of each loop
  std::set<std::set<int>> fresh_;
};

}  // namespace loopmend
