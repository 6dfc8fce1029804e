// SPDX-License-Identifier: GPL-3.0-or-later
// Which loops a `fill` command means.
#pragma once

#include "commands.h"

#include <optional>
#include <string>
#include <vector>

namespace loopmend {

struct LoopChoice {
  enum class Left {
    as_asked,
    no_hole,    ///< nobody asked for it, but there is nothing that could be filled
    wide_crack  ///< the same, where --stitch would join the sides: not done
  };
  enum class Cure { none, stitch, repair };
  bool fill = false;
  std::optional<SeamContinuity> continuity;  ///< named for this loop alone
  std::string why_not;                       ///< in words, where fill is false
  Cure cure = Cure::none;                    ///< what may make a hole of it, or close it
  Left left = Left::as_asked;
  bool is_outer_rim = false;  ///< bounds a sheet: nothing is amiss where it is left
};

/// Why a loop is left that nobody named; `fill` where nothing is against it.
LoopChoice choose_unnamed(const BoundaryLoop& loop, const FillCommand& command);

/// One choice per loop. Loops that are named (by number or vertex) are meant whatever their kind; the size limits hold
/// for all.
/// @throws UsageError for a number or vertex that names no loop.
std::vector<LoopChoice> choose_loops(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                     const FillCommand& command);

}  // namespace loopmend
