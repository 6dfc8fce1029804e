// SPDX-License-Identifier: GPL-3.0-or-later
// Filling the loops of a model from end to end: fillers, evolution, checks, paste. What `loopmend fill` and the
// window's "Fill" call.
#pragma once

#include "analysis/seam_report.h"
#include "core/cancel.h"
#include "evolution/evolution.h"
#include "evolution/proportion.h"
#include "filling/loop_filler.h"
#include "mesh/boundary_loops.h"
#include "rim/rim_fits.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace loopmend {

struct FillOptions {
  FillerOptions filler;
  std::optional<EvolutionOptions> evolution = EvolutionOptions{};  ///< empty: leave the G0 filler
  int threads = 0;  ///< loops worked on at once; 0: as many as there are cores. The result does not depend on it.
};

enum class LoopStatus {
  converged,   ///< filled; the flow that the method names reached its steady state
  faired,      ///< filled by linear fairings, or by something between these and a flow: see the method
  step_limit,  ///< filled, stopped at the step limit or stalled before the steady state (see the message)
  doubtful,    ///< filled, but the patch is out of proportion (see the message): look at it
  filled,      ///< the initial patch alone: asked for, or because the flow would have spoilt it (see the message)
  failed,      ///< left open; the message says why
  skipped,     ///< not asked for
};

const char* to_string(LoopStatus status);
/// True if there is a patch in the loop.
bool is_filled(LoopStatus status);

struct LoopResult {
  BoundaryLoop loop;
  LoopStatus status = LoopStatus::skipped;
  std::string message;
  std::string method;     ///< method_name() of what shaped the patch; empty where there is none
  std::string reason;     ///< why it was not the flow that was asked for, and how to get that; empty if it was
  Proportion proportion;  ///< of the patch
  int free_vertices = 0;
  int steps = 0;
  double bending = 0;  ///< EvolutionOptions::bending that was used: above 0 where the surroundings are rough
  struct {
    double filler = 0, assemble = 0, solve = 0, total = 0;
  } seconds;
  struct {
    double initial = 0, final = 0;
  } energy;  ///< of the whole problem that the loop was solved in
  SeamReport seam_before, seam_after;
  RimSummary rim;  ///< of the surroundings; all zero where nothing was filled
};

struct FillProgress {
  int loops_done = 0;
  int loops_total = 0;
  int loop_number = 0;  ///< the one that was just worked on
};
/// May be called from several threads, one call at a time.
using OnFillProgress = std::function<void(const FillProgress&)>;

/// Loops whose surroundings overlap belong to one problem. @returns groups of indices into `loops`.
std::vector<std::vector<int>> group_loops(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops);

/// The fillers of one group, made into a problem. Loops without a valid filler are left out.
struct PatchStart {
  std::optional<Patch> patch;          ///< empty when no loop of the group could be filled
  std::vector<FillerOutcome> fillers;  ///< one per loop of the group
};
PatchStart start_patch(const SurfaceModel& model, const std::vector<BoundaryLoop>& group, const FillerOptions& options,
                       const CancelToken& cancel);

/// The patch of those loops of a group that have an initial patch; empty if none has.
/// @param fillers  one per loop of the group. @param density  Grading::density.
std::optional<Patch> joined_patch(const SurfaceModel& model, const std::vector<BoundaryLoop>& group,
                                  const std::vector<FillerOutcome>& fillers, double density);

/// Parts a group into groups whose loops, each looked at alone, ask for the same treatment of the boundary data: one rough
/// hole does not decide for its neighbours. @returns groups of indices into `group`.
std::vector<std::vector<int>> groups_alike(const SurfaceModel& model, const std::vector<BoundaryLoop>& group,
                                           const std::vector<FillerOutcome>& fillers);

/// Fills the loops and pastes the patches in the order of `loops`. On cancel the model is as it was.
/// @returns one result per loop, in order; empty when cancelled.
std::vector<LoopResult> fill_loops(SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                   const FillOptions& options, const OnFillProgress& progress,
                                   const CancelToken& cancel);

}  // namespace loopmend
