// SPDX-License-Identifier: GPL-3.0-or-later
// From the holes of a scan to groups and their initial patches.
#pragma once

#include "core/cancel.h"
#include "core/message.h"
#include "evolution/evolution.h"
#include "filling/loop_patch.h"
#include "mesh/boundary_loops.h"
#include "neighborhood/boundary_survey.h"

#include <optional>
#include <vector>

namespace loopmend {

/// Why a hole is left open that needs more memory than there is.
Message no_memory_message();

/// Loops whose neighborhoods overlap belong to one problem; of more than two dozen, only those that lie closer, and of these, where
/// they are still as many, those that touch. @returns groups of indices into `loops`.
std::vector<std::vector<int>> group_loops(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops);

/// The holes of one group and what fills them before any flow. Loops without a valid initial patch are left out of `patch`.
struct InitialPatch {
  std::optional<Patch> patch;       ///< empty when no loop of the group could be filled
  std::vector<BoundaryLoop> loops;  ///< the group
  std::vector<LoopPatchOutcome>
      outcomes;  ///< one per loop; empty where they are to be made again when they are asked for
  /// Whether `patch` is what the loops alone lead to, or a flow has moved it: then it is solved as one, from there alone.
  /// `uncut`: made of triangles that cut nothing, since what the loops lead to cuts the surface.
  enum class Origin { loops, evolved, uncut } origin = Origin::loops;
  /// Whether the loops are known to ask for one treatment of the boundary data.
  enum class Alike { unknown, known } alike = Alike::unknown;
  std::optional<BoundarySurvey> survey;  ///< of the patch's neighborhood, where it was made beside the patch
  std::optional<SplitEstimate> split;    ///< the same of its estimate alone
  double seconds = 0;                    ///< that it took
  double survey_seconds = 0;             ///< that the survey took beyond that

  /// What is to be said of the loops that were filled; empty when all is well.
  Message message() const;
};

/// A loop that fails, for want of memory or by a fault, leaves the others alone: its outcome's message says why.
/// @throws InvalidArgument if an option is out of range.
InitialPatch make_initial_patch(const SurfaceModel& model, const std::vector<BoundaryLoop>& group,
                                const InitialPatchOptions& options, const CancelToken& cancel);

/// The same, and for a single loop beside that a look at the neighborhood, which solve_group() needs.
InitialPatch make_surveyed_patch(const SurfaceModel& model, const std::vector<BoundaryLoop>& group,
                                 const InitialPatchOptions& options, const CancelToken& cancel);

/// Those loops of a group alone, with their share of its seconds by boundary edges.
/// @param members  indices into the group's loops.
InitialPatch part_of(const SurfaceModel& model, const InitialPatch& group, const std::vector<int>& members,
                     const InitialPatchOptions& options);

/// Loops of a group that ask for the same treatment of the boundary data.
struct LoopsAlike {
  std::vector<int> members;            ///< indices into the group's loops
  std::optional<SplitEstimate> split;  ///< of the neighborhood of all of them, where it was asked for
};

/// Parts a group into groups whose loops, each looked at alone, ask for the same treatment of the boundary data: one rough
/// hole does not decide for its neighbors. Loops at which sharp edges end that run on are parts of their own.
/// @param group  whose outcomes are known.
std::vector<LoopsAlike> groups_alike(const SurfaceModel& model, const InitialPatch& group,
                                     const EvolutionOptions& options);

}  // namespace loopmend
