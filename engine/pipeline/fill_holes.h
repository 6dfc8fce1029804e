// SPDX-License-Identifier: GPL-3.0-or-later
// Filling the holes of a scan from end to end: group, initial patch, candidates, validation, paste. The window, which pastes when it
// writes a file, calls solve_holes(), and all others fill_holes().
#pragma once

#include "core/cancel.h"
#include "core/message.h"
#include "evolution/option_names.h"
#include "neighborhood/trim_boundary.h"
#include "pipeline/solve_group.h"

#include <array>
#include <functional>
#include <limits>
#include <set>
#include <vector>

namespace loopmend {

struct FillOptions : GroupOptions {
  int threads = 0;  ///< groups worked on at once; 0: as many as there are cores. The result does not depend on it.
  /// Pieces of surface within a hole that is filled: joined to its patch, or where that fails covered by it. Walls that end in one
  /// plane (find_missing_faces) and are all to be filled: joined by one face, or a patch for each.
  enum class Islands { cover, join } islands = Islands::join;
  /// Whether the planes of symmetry of the whole surface are looked for, for GroupOptions::mirror_planes.
  enum class Mirror { as_given, find } mirror = Mirror::as_given;
  /// Megabytes that the patches under way may take together, above 0. A loop that needs more is left open with its reason:
  /// before its patch is begun, where its size decides that, or else before it is solved.
  double most_memory_mb = std::numeric_limits<double>::infinity();
  /// When cancelled: leave the model as it was, or fill what was finished by then.
  enum class OnCancel { discard, keep_finished } on_cancel = OnCancel::discard;
};

/// @throws InvalidArgument if an option is out of range.
void check(const FillOptions& options);

inline constexpr std::array<Named<FillOptions::Islands>, 2> islands_names{
    {{"join", FillOptions::Islands::join}, {"cover", FillOptions::Islands::cover}}};

struct FillProgress {
  int loops_done = 0;
  int loops_total = 0;
  int loop_number = 0;  ///< the one that was just worked on
};
/// May be called from several threads, one call at a time.
using OnFillProgress = std::function<void(const FillProgress&)>;

/// Holes of one surface.
struct HolesToSolve {
  std::vector<BoundaryLoop> loops;    ///< from their boundaries
  std::vector<InitialPatch> moved{};  ///< from where a flow has left them: InitialPatch::Origin::evolved
  std::set<int> closed{};             ///< numbers of loops that have a patch: no islands to be joined
};

/// Patches for the holes, within the memory that the options allow. What goes wrong in one hole leaves the others alone.
/// @returns the groups in no particular order; when cancelled, none, or holes without a patch as well (FillOptions::on_cancel).
/// @throws InvalidArgument as fill_holes().
std::vector<GroupResult> solve_holes(const ScanIndex& scan, const HolesToSolve& holes, const FillOptions& options,
                                     const SolveObserver& observer, const OnFillProgress& progress,
                                     const CancelToken& cancel);

/// Fills the loops and pastes the patches.
/// @param loops  of the model as it is.
/// @throws InvalidArgument if an option is out of range, or the view of the surface ends too near to a loop.
/// @returns one result per loop, in order, then those of islands that were joined to one of them; empty when cancelled
/// and nothing is kept. Where finished patches are kept, the other loops are `skipped`.
std::vector<HoleResult> fill_holes(SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                   const FillOptions& options, const OnFillProgress& progress,
                                   const CancelToken& cancel);

/// The holes among `asked` in which pieces of surface lie that can be joined to them, each as the hole followed by the loops of
/// these islands. Fragments, and pieces that face the hole with their inside, are no such pieces.
std::vector<std::vector<BoundaryLoop>> holes_with_islands(const SurfaceModel& model,
                                                          const std::vector<BoundaryLoop>& asked);

/// What is said of a hole whose patch covers an island that should have been joined. @param why  no bridge was made.
Message island_not_joined(const Message& why);

/// Every hole of the model; outer rims and cut seams are left. @throws InvalidArgument if an option is out of range.
std::vector<HoleResult> fill_all_holes(SurfaceModel& model, const FillOptions& options = {},
                                       const CancelToken& cancel = {});

}  // namespace loopmend
