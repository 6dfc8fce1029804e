// SPDX-License-Identifier: GPL-3.0-or-later
// One accepted state of one patch, with all that is shown of it. Immutable: states are shared between document, undo
// stack, timeline, worker and view.
#pragma once

#include "analysis/seam_report.h"
#include "evolution/evolution.h"
#include "mesh/patch.h"
#include "rim/rim_fits.h"
#include "scene/surface_shape.h"

#include <memory>
#include <string>
#include <vector>

namespace loopmend {

enum class PatchStage {
  filled,     ///< the G0 filler
  stepped,    ///< some steps of a flow, more can be taken
  converged,  ///< at rest
  stalled,    ///< the flow found no further acceptable step; the state is the last accepted one
  cutting,    ///< it cuts the surface or itself: not part of the result unless a person accepts it
  faired,     ///< shaped by linear fairings, or by something between these and a flow
  doubtful,   ///< out of proportion: a person should look at it
};

/// One run of a flow, as the command line would name it.
struct RunRecipe {
  FlowKind flow = FlowKind::mmcvf;
  EvolutionMode mode = EvolutionMode::steps;
  double sigma = 10;  ///< of EvolutionMode::steps
  BoundaryTrust boundary = BoundaryTrust::automatic;           ///< of EvolutionMode::steady
  SeamContinuity continuity = SeamContinuity::curvature;  ///< likewise
  int steps = 0;      ///< taken
  enum class End {
    whole,        ///< as far as it goes
    after_steps,  ///< stopped by a person after `steps`
    unnamed,      ///< stopped where no option of the command line can stop
  } end = End::whole;
};

/// The run that these options lead to, before its first step.
inline RunRecipe recipe_of(const EvolutionOptions& options) {
  return {options.flow, options.mode, options.sigma, options.boundary, options.continuity, 0, RunRecipe::End::whole};
}

/// How a state came about: the filler, then one run after another.
struct PatchRecipe {
  double density = 1;
  std::vector<RunRecipe> runs;
};

/// What the surroundings know of themselves.
struct RimKnowledge {
  std::vector<RimSummary> loops;             ///< one per loop
  std::vector<float> curvature_uncertainty;  ///< of H, one for each fixed vertex (rim_fits.h)
};

struct PatchState {
  Patch patch;
  std::shared_ptr<const SurfaceShape> shape;
  PatchStage stage = PatchStage::filled;
  std::string message;  ///< the engine's words about this state; may be empty
  PatchRecipe recipe;
  FlowKind flow = FlowKind::mmcvf;
  int steps = 0;                            ///< since the filler
  StepRecord last_step;                     ///< meaningful when steps > 0
  double initial_energy = 0;                ///< of the run that led here
  double seconds = 0;                       ///< of that run
  std::vector<SeamReport> seam_before;      ///< of the filler, one per loop
  std::vector<SeamReport> seam;             ///< of this state, one per loop
  std::shared_ptr<const RimKnowledge> rim;  ///< the same for all states of a patch; null where nobody asked
};
using PatchStatePtr = std::shared_ptr<const PatchState>;

/// Memory held by a state, in bytes.
std::size_t size_of(const PatchState& state);

enum class Acceptance { pending, accepted };

/// The recorded states of a patch, from the filler on. Immutable, so that undo keeps it by pointer.
using Timeline = std::vector<PatchStatePtr>;
using TimelinePtr = std::shared_ptr<const Timeline>;

/// A patch that is open in the document.
struct OpenPatch {
  int id = 0;
  int scan = 0;            ///< which scan of the document
  std::vector<int> loops;  ///< indices into the document's loops, in the order of state->patch.loops
  PatchStatePtr state;
  TimelinePtr timeline;  ///< holds `state`
  Acceptance acceptance = Acceptance::pending;
};

}  // namespace loopmend
