// SPDX-License-Identifier: GPL-3.0-or-later
// What programs have worked, as a bound for what must not take for ever: time on the clock depends on what else a machine does.
#pragma once

#include <sys/types.h>

#include <ctime>

namespace loopmend::test {

/// Of all threads of this process since it began, s.
inline double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Of a child that runs, s; -1 where it is gone.
inline double processor_seconds(pid_t child) {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(child, &clock) != 0 || clock_gettime(clock, &time) != 0) return -1;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace loopmend::test
