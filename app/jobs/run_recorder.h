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

class RunRecorder {
 public:
  /// @param wake  called on the worker's thread when nothing was waiting before; should queue one call of take().
  explicit RunRecorder(std::function<void()> wake) : wake_(std::move(wake)) {}

  void record(int patch_id, PatchStatePtr state) {
    put([&] { runs_[patch_id].push_back(std::move(state)); }, patch_id);
  }
  /// The run starts again from where it began; what was recorded is thrown away.
  void restart(int patch_id) {
    const std::lock_guard lock(mutex_);
    runs_[patch_id].clear();
  }
  /// The last state comes again with other words.
  void amend(int patch_id, PatchStatePtr state) {
    put(
        [&] {
          auto& run = runs_[patch_id];
          if (!run.empty()) run.pop_back();
          run.push_back(std::move(state));
        },
        patch_id);
  }

  /// The run goes on with these patches in place of one.
  void divide(int patch_id, std::vector<OpenPatch> parts) {
    put([&] { divisions_[patch_id] = std::move(parts); }, patch_id);
  }

  struct News {
    std::map<int, std::vector<OpenPatch>> divisions;   ///< since the last time; come before the states of their parts
    std::map<int, std::vector<PatchStatePtr>> states;  ///< all of this run, of every patch that has a new one
  };
  News take() {
    const std::lock_guard lock(mutex_);
    News news;
    news.divisions = std::exchange(divisions_, {});
    for (int id : fresh_) news.states[id] = runs_[id];
    fresh_.clear();
    return news;
  }

 private:
  template <class Act>
  void put(const Act& act, int patch_id) {
    std::unique_lock lock(mutex_);
    const bool was_empty = fresh_.empty();
    act();
    fresh_.insert(patch_id);
    lock.unlock();
    if (was_empty) wake_();
  }

  std::function<void()> wake_;
  std::mutex mutex_;
  std::map<int, std::vector<PatchStatePtr>> runs_;
  std::map<int, std::vector<OpenPatch>> divisions_;
  std::set<int> fresh_;
};

}  // namespace loopmend
