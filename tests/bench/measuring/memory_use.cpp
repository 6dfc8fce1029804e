// SPDX-License-Identifier: GPL-3.0-or-later
#include "memory_use.h"

#include <malloc.h>

#include <fstream>
#include <string>

namespace loopmend::bench {

namespace {

/// A line like "VmHWM:  1234 kB".
double status_bytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.compare(0, name.size(), name) == 0) return 1024 * std::stod(line.substr(name.size() + 1));
  return 0;
}

}  // namespace

double memory_now() { return status_bytes("VmRSS"); }

double memory_peak() { return status_bytes("VmHWM"); }

void start_memory_peak() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;  // resets VmHWM
}

}  // namespace loopmend::bench
