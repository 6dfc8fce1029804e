// SPDX-License-Identifier: GPL-3.0-or-later
// What the operating system says about memory, in bytes; in system_memory_posix.cpp and system_memory_windows.cpp.
#pragma once

#include <optional>

namespace loopmend {

/// All of it; infinity where that is not known.
double memory_of_machine();
/// What this process could have beside what it has, before the machine, or its container, runs out; infinity where that is not known.
double memory_to_be_had();
/// What this process has now, and what it had at most; 0 where that is not known.
double memory_of_process();
double peak_memory_of_process();

/// Megabytes (2^20 bytes) that work may take beside what the process has by now.
/// @param most_mb  of the whole process; none: it may grow by nine tenths of what the machine, and the control group, have
/// available, without bound where they do not tell.
/// @returns above 0.
double memory_left_mb(std::optional<double> most_mb);

}  // namespace loopmend
