// SPDX-License-Identifier: GPL-3.0-or-later
// What `loopmend fill` says of its loops when it is done.
#pragma once

#include "commands.h"

#include <cstddef>
#include <cstdio>
#include <vector>

namespace loopmend {

/// What became of the loops, in numbers.
struct Outcome {
  int filled = 0, failed = 0;
  int look = 0, bad = 0;    ///< verdicts of those filled
  int left = 0;             ///< as asked
  int unfinished = 0;       ///< when the command was stopped, or its time was over
  int wide_cracks = 0;      ///< left for --stitch
  int open_cuts = 0;        ///< loops along which the surface had to be cut, but which look like holes
  std::size_t apart = 0;    ///< bodies and pieces that --union left
  int no_hole = 0;          ///< cracks, and loops where the surface had to be cut: left without being asked for
  bool holes_left = false;  ///< some loop that could be filled was left as asked

  /// No loop could be filled.
  bool in_vain() const { return filled == 0 && failed == 0 && no_hole > 0 && !holes_left; }
  int exit_code() const;
};

/// @param choices  of the same loops as the results
Outcome outcome_of(const std::vector<HoleResult>& results, const std::vector<LoopChoice>& choices);

/// One line for each loop when there are few, else for the largest; long texts below, once for each kind; then what may help.
void print_summary(std::FILE* out, const std::vector<HoleResult>& results, const Outcome& outcome,
                   const FillCommand& command, double seconds);

/// What would help where no loop is a hole.
void print_cure(std::FILE* out, const ScanPlan& scan, int wide_cracks);

}  // namespace loopmend
