// SPDX-License-Identifier: GPL-3.0-or-later
// How far a worker steps back. In thread_priority_posix.cpp and thread_priority_windows.cpp.
#pragma once

#include "jobs/task_runner.h"

namespace loopmend {

/// The window's thread goes first when both want the processor: what works for seconds can spare milliseconds. Where the system refuses,
/// nothing is lost but smoothness.
void yield_to_window(Yielding yielding);

}  // namespace loopmend
