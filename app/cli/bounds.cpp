// SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds.h"

#include "commands.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>
#include <system_error>

namespace loopmend {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double share_of_the_available = 0.9;

/// The memory that this process has now.
double resident_mb() {
  std::ifstream pages("/proc/self/statm");
  double all = 0, resident = 0;
  if (!(pages >> all >> resident)) return 0;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576;
}

double machine_has_mb() {
  std::ifstream memory("/proc/meminfo");
  std::string name, unit;
  for (double kilobytes = 0; memory >> name >> kilobytes; std::getline(memory, unit))
    if (name == "MemAvailable:") return kilobytes / 1024;
  return unbounded;
}

/// The limit of a container, where there is one.
double control_group_has_mb() {
  std::ifstream limit("/sys/fs/cgroup/memory.max"), used("/sys/fs/cgroup/memory.current");
  double most = 0, taken = 0;
  if (!(limit >> most) || !(used >> taken)) return unbounded;  // "max", or no such file
  // What the system keeps of files that were read counts as taken, but is given back at once.
  std::ifstream parts("/sys/fs/cgroup/memory.stat");
  std::string name;
  for (double bytes = 0; parts >> name >> bytes;)
    if (name == "inactive_file" || name == "active_file" || name == "slab_reclaimable") taken -= bytes;
  return (most - std::max(0.0, taken)) / 1048576;
}

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
        "a limit of time needs a thread that watches it, and the system allows no more (ulimit -u). Raise that limit, or "
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
  constexpr double least = 1e-3;
  if (most_mb) return std::max(least, *most_mb - resident_mb());
  return std::max(least, share_of_the_available * std::min(machine_has_mb(), control_group_has_mb()));
}

}  // namespace loopmend
