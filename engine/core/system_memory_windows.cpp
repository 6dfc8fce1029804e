// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/system_memory.h"

#include <windows.h>

#include <psapi.h>

#include <limits>

namespace loopmend {

namespace {

MEMORYSTATUSEX status() {
  MEMORYSTATUSEX result{};
  result.dwLength = sizeof result;
  if (::GlobalMemoryStatusEx(&result) == 0) result.dwLength = 0;
  return result;
}

double known(const MEMORYSTATUSEX& status, DWORDLONG bytes) {
  return status.dwLength > 0 ? static_cast<double>(bytes) : std::numeric_limits<double>::infinity();
}

PROCESS_MEMORY_COUNTERS counters() {
  PROCESS_MEMORY_COUNTERS result{};
  if (::K32GetProcessMemoryInfo(::GetCurrentProcess(), &result, sizeof result) == 0) return {};
  return result;
}

}  // namespace

double memory_of_machine() {
  const MEMORYSTATUSEX now = status();
  return known(now, now.ullTotalPhys);
}

double memory_to_be_had() {
  const MEMORYSTATUSEX now = status();
  return known(now, now.ullAvailPhys);
}

double memory_of_process() { return static_cast<double>(counters().WorkingSetSize); }

double peak_memory_of_process() { return static_cast<double>(counters().PeakWorkingSetSize); }

}  // namespace loopmend
