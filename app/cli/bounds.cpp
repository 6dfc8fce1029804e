// SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds.h"

#include "commands.h"
#include "core/system_memory.h"

#include <algorithm>
#include <system_error>

namespace loopmend {

namespace {

constexpr double share_of_the_available = 0.9;

}  // namespace

Deadline::Deadline(std::chrono::steady_clock::time_point start, std::optional<double> seconds,
                   const CancelToken& token) {
  if (!seconds) return;
  const auto end =
      start + std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(*seconds));
  const auto watch = [this, end, token] {
    std::unique_lock lock(mutex_);
    if (gone_.wait_until(lock, end, [this] { return over_; }) || token.cancelled()) return;
    passed_ = true;
    token.cancel();
  };
  try {
    thread_ = std::thread(watch);
  } catch (const std::system_error&) {
    throw LimitError(
        "a limit of time needs a thread that watches it, and the system allows no more (ulimit -u). Raise that limit, "
        "or "
        "leave --max-time out.");
  }
}

Deadline::~Deadline() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  gone_.notify_one();
  thread_.join();
}

double memory_left_for_patches(std::optional<double> most_mb) {
  constexpr double least = 1e-3, megabyte = 1 << 20;
  if (most_mb) return std::max(least, *most_mb - memory_of_process() / megabyte);
  return std::max(least, share_of_the_available * memory_to_be_had() / megabyte);
}

}  // namespace loopmend
