// SPDX-License-Identifier: GPL-3.0-or-later
// What the operating system says about memory, in bytes; in system_memory_posix.cpp and system_memory_windows.cpp.
#pragma once

namespace loopmend {

/// All of it; infinity where that is not known.
double memory_of_machine();
/// What this process could have beside what it has, before the machine, or its container, runs out; infinity where that is not known.
double memory_to_be_had();
/// What this process has now, and what it had at most; 0 where that is not known.
double memory_of_process();
double peak_memory_of_process();

}  // namespace loopmend
