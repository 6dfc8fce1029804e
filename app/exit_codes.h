// SPDX-License-Identifier: GPL-3.0-or-later
// What the exit code of `loopmend` says.
#pragma once

namespace loopmend {

enum ExitCode : int {
  exit_done = 0,  ///< everything asked was done
  exit_loops_failed =
      1,  ///< some loops failed or have a bad patch, or no loop is a hole as the mesh stands; the rest is written
  exit_usage = 2,          ///< wrong usage
  exit_unreadable = 3,     ///< the input cannot be read
  exit_unwritable = 4,     ///< an output cannot be written
  exit_internal = 5,       ///< a fault of ours
  exit_reader_gone = 141,  ///< whoever read standard output has closed it; files stand. As a shell reports SIGPIPE.
  // Signals that end the process: 128 + their number, 130 for Ctrl-C (interrupt.h).
};

}  // namespace loopmend
