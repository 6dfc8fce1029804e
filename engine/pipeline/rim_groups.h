// SPDX-License-Identifier: GPL-3.0-or-later
// Loops that lie across from each other, and what joins them.
#pragma once

#include "core/cancel.h"
#include "core/message.h"
#include "mesh/boundary_loops.h"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace loopmend {

struct RimGroup {
  enum class Kind {
    ring,  ///< a wall ends at all of them: a ring joins them, flat or conical; of a block with bores an outline and their rims
    plate,  ///< outlines of the two sides of a plate: a straight wall joins them
    tube,   ///< two ends of tubes that look at each other: a smooth tube joins them
    gap     ///< outlines that run beside each other along a part: strips at both ends of it make a hole of the gap
  };
  std::vector<int> loops;  ///< indices, ascending; two, but for rings
  Kind kind = Kind::ring;
  double width = 0;                              ///< of a gap, mesh units
  std::array<std::pair<int, int>, 2> bridges{};  ///< over a gap: soup points for with_bridge() (pipeline/hand_bridge.h)
};

/// Each loop is in one group at most, but for those of gaps. Loops that touch others are left out.
std::vector<RimGroup> find_rim_groups(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                      const CancelToken& cancel);

/// Per loop whether it bounds the wall of a pipe or a side of a plate, and what lies beside it is the other side of that, not of a crack.
/// @param groups  rings and plates among them
std::vector<char> are_at_walls(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                               const std::vector<RimGroup>& groups);

/// Rings and plates alone.
std::vector<RimGroup> find_walls(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                 const CancelToken& cancel);

/// The gap between two outlines; empty where there is none.
std::optional<RimGroup> find_gap(const SurfaceModel& model, const BoundaryLoop& a, const BoundaryLoop& b);

/// What lies across from a loop of the group, and the command that joins them. Without a full stop.
/// @param own  its index
Message advice(const RimGroup& group, int own);

/// The command that closes a gap.
Message gap_cure(const RimGroup& gap);

}  // namespace loopmend
