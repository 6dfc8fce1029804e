// SPDX-License-Identifier: GPL-3.0-or-later
// A limit of time.
#pragma once

#include "core/cancel.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

namespace loopmend {

/// Cancels the token when the time is over, unless this object is gone by then.
class Deadline {
 public:
  /// @param seconds  from `start` on; none: no deadline. @throws LimitError where the system allows no more threads.
  Deadline(std::chrono::steady_clock::time_point start, std::optional<double> seconds, const CancelToken& token);
  ~Deadline();
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

  /// Whether it was this deadline that cancelled the token, and no one before.
  bool passed() const { return passed_; }

 private:
  std::mutex mutex_;
  std::condition_variable gone_;
  bool over_ = false;
  std::atomic<bool> passed_ = false;
  std::thread thread_;
};

}  // namespace loopmend
