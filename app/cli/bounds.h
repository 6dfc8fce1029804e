// SPDX-License-Identifier: GPL-3.0-or-later
// What a command may take: time, and memory.
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
  /// @param seconds  from `start` on; none: no deadline. @throws LimitError where the system allows no further thread.
  Deadline(std::chrono::steady_clock::time_point start, std::optional<double> seconds, const CancelToken& token);
  ~Deadline();
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

  /// Whether it was this deadline that cancelled the token, and nobody before.
  bool passed() const { return passed_; }

 private:
  std::mutex mutex_;
  std::condition_variable gone_;
  bool over_ = false;
  std::atomic<bool> passed_ = false;
  std::thread thread_;
};

/// Megabytes that patches may take beside what the process has by now.
/// @param most_mb  of the whole process; none: it may grow by nine tenths of what the machine, and the control group, have
/// available, without bound where they do not tell.
/// @returns above 0.
double memory_left_for_patches(std::optional<double> most_mb);

}  // namespace loopmend
