// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/system_memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace loopmend {

namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

double page_size() { return static_cast<double>(sysconf(_SC_PAGESIZE)); }

// The files of Linux; other systems have none of them, and nothing is known there.

double machine_has() {
  std::ifstream memory("/proc/meminfo");
  std::string name, unit;
  for (double kilobytes = 0; memory >> name >> kilobytes; std::getline(memory, unit))
    if (name == "MemAvailable:") return kilobytes * 1024;
  return unknown;
}

/// The limit of a container, where there is one.
double control_group_has() {
  std::ifstream limit("/sys/fs/cgroup/memory.max"), used("/sys/fs/cgroup/memory.current");
  double most = 0, taken = 0;
  if (!(limit >> most) || !(used >> taken)) return unknown;  // "max", or no such file
  // What the system keeps of files that were read counts as taken, but is given back at once.
  std::ifstream parts("/sys/fs/cgroup/memory.stat");
  std::string name;
  for (double bytes = 0; parts >> name >> bytes;)
    if (name == "inactive_file" || name == "active_file" || name == "slab_reclaimable") taken -= bytes;
  return most - std::max(0.0, taken);
}

}  // namespace

double memory_of_machine() {
  const long pages = sysconf(_SC_PHYS_PAGES);
  return pages > 0 ? static_cast<double>(pages) * page_size() : unknown;
}

double memory_to_be_had() { return std::min(machine_has(), control_group_has()); }

double memory_of_process() {
  std::ifstream pages("/proc/self/statm");
  double all = 0, resident = 0;
  return pages >> all >> resident ? resident * page_size() : 0;
}

double peak_memory_of_process() {
#ifdef __APPLE__
  constexpr double unit = 1;
#else
  constexpr double unit = 1024;
#endif
  rusage usage{};
  return getrusage(RUSAGE_SELF, &usage) == 0 ? static_cast<double>(usage.ru_maxrss) * unit : 0;
}

}  // namespace loopmend
