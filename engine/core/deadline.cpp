// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deadline.h"

#include "core/error.h"

#include <system_error>

namespace loopmend {

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
        say("a limit of time needs a thread that watches it, and the system allows no more (ulimit -u). Raise that "
            "limit, or leave --max-time out."));
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

}  // namespace loopmend
