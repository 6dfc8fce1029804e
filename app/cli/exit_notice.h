// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says on standard error where it ends at once; for signal handlers and the like: no memory, no locks.
#pragma once

namespace loopmend {

/// Words as they are.
void say_at_exit(const char* words) noexcept;

/// Which files have got their names by now, in a line; then `at_the_end`, in a line of its own. Call it after remove_unfinished_files().
void say_what_was_written(const char* at_the_end) noexcept;

}  // namespace loopmend
