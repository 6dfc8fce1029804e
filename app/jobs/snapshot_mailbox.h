// Latest-wins mailbox: a worker leaves states, the window takes the newest of each patch. Nothing ever queues up.
#pragma once

#include "document/patch_state.h"

#include <functional>
#include <map>
#include <mutex>

namespace loopmend {

class SnapshotMailbox {
 public:
  /// @param wake  called on the worker's thread when the mailbox was empty before; should queue one call of take().
  explicit SnapshotMailbox(std::function<void()> wake) : wake_(std::move(wake)) {}

  void put(int patch_id, PatchStatePtr state) {
    std::unique_lock lock(mutex_);
    const bool was_empty = newest_.empty();
    newest_[patch_id] = std::move(state);
    lock.unlock();
    if (was_empty) wake_();
  }

  std::map<int, PatchStatePtr> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(newest_, {});
  }

 private:
  std::function<void()> wake_;
  std::mutex mutex_;
  std::map<int, PatchStatePtr> newest_;
};

}  // namespace loopmend
