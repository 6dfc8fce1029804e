// SPDX-License-Identifier: GPL-3.0-or-later
// What the system has to give before a window opens. In window_start_posix.cpp and window_start_windows.cpp.
#pragma once

namespace loopmend {

/// Whether there is something to open a window on.
bool has_display();

/// A program with a window has no console on Windows. Where it was started from one, its words go there. Elsewhere nothing is done.
void find_console();

}  // namespace loopmend
