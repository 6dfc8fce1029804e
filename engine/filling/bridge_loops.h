// SPDX-License-Identifier: GPL-3.0-or-later
// From two or more loops to the G0 patch that joins them: topology, guarded remeshing, one or two relaxations.
#pragma once

#include "core/cancel.h"
#include "core/message.h"
#include "filling/loop_patch.h"
#include "mesh/patch.h"

#include <optional>
#include <vector>

namespace loopmend {

/// One patch with all loops, in two shapes.
struct Bridge {
  Patch membrane;  ///< relaxed towards a membrane: the paper's kind of initial surface, and what a person sees first
  Patch
      start;  ///< where the flow begins: minimal surfaces between tubes pinch (docs/math/energy_to_matrix.md, "Starts")
  Validity quality;  ///< of the start
  /// A ring between two walls that end (ring_bridge.h) is flat or conical, and a wall between the sides of a plate (wall_bridge.h) is
  /// straight: both shapes are the same, and no flow is to round them.
  enum class Kind { smooth, ring } kind = Kind::smooth;
};

struct BridgeOutcome {
  std::optional<Bridge> bridge;  ///< empty when none was found, or when cancelled
  Message message;               ///< error or warning; empty if none
};

/// Joins the loops by one surface without further boundaries: a tube between two, a pair of trousers between three, ... The
/// loops' neighborhood must agree in orientation (find_opposed_loops). Reads the model, never changes it.
/// @param loops  at least two, none twice; of kind hole or outer_rim.
/// @throws InvalidArgument for fewer than two loops, a loop given twice or of another kind, a density out of range.
BridgeOutcome bridge_loops(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                           const InitialPatchOptions& options, const CancelToken& cancel);

/// The ring between loops at which walls end, one of them the outline of all others, flat or conical; or the wall between two outlines
/// of a plate or the rims of its bore. Empty where the loops
/// are no such group, and where it would fold or cut itself. bridge_loops() tries it first.
/// @param loops  as bridge_loops() takes them
std::optional<Bridge> ring_between(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, double density,
                                   const CancelToken& cancel);

/// Loops whose neighborhood lies the other way round than those of the first loop, so that no two-sided surface joins
/// them. @returns indices into `loops`, ascending; empty when all agree.
std::vector<int> find_opposed_loops(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops);

}  // namespace loopmend
