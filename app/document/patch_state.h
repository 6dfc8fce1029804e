// SPDX-License-Identifier: GPL-3.0-or-later
// One accepted state of one patch, with all that is shown of it. Immutable: states are shared between document, undo
// stack, timeline, worker and view.
#pragma once

#include "mirror/mirror_plane.h"
#include "neighborhood/boundary_fits.h"
#include "pipeline/patch_result.h"
#include "scene/surface_shape.h"

#include <algorithm>
#include <memory>
#include <set>
#include <vector>

namespace loopmend {

/// One run of a flow, as the command line would name it.
struct RunRecipe {
  FlowKind flow = FlowKind::mmcvf;
  EvolutionMode mode = EvolutionMode::steps;
  double sigma = 10;                                      ///< of EvolutionMode::steps
  BoundaryTrust boundary = BoundaryTrust::automatic;      ///< of EvolutionMode::steady
  SeamContinuity continuity = SeamContinuity::curvature;  ///< likewise
  ReliefChoice relief;                                    ///< likewise
  SharpEdges edges = SharpEdges::continued;               ///< likewise
  EdgeEdits edge_edits;                                   ///< likewise
  enum class Mirror {
    none,
    found,                  ///< the mirror image in a plane of symmetry that was looked for
    placed,                 ///< that in `mirror_plane`, where it fits
  } mirror = Mirror::none;  ///< likewise
  MirrorPlane mirror_plane;
  int steps = 0;  ///< taken
  enum class End {
    whole,        ///< as far as it goes
    after_steps,  ///< stopped by a person after `steps`
    unnamed,      ///< stopped where no option of the command line can stop
  } end = End::whole;

  bool operator==(const RunRecipe&) const = default;
};

/// The run that these options lead to, before its first step.
inline RunRecipe recipe_of(const EvolutionOptions& options) {
  RunRecipe run;
  run.flow = options.flow;
  run.mode = options.mode;
  run.sigma = options.sigma;
  run.boundary = options.boundary;
  run.continuity = options.continuity;
  run.edges = options.edges;
  if (continues_edges(options)) run.edge_edits = options.edge_edits;
  if (options.mode == EvolutionMode::steady) run.relief = options.relief;
  return run;
}

/// How a state came about: the initial patch, then one run after another.
struct PatchRecipe {
  double density = 1;
  enum class Start {
    holes,   ///< each loop closed by a patch of its own
    bridge,  ///< a hole and the islands in it joined by one patch
  } start = Start::holes;
  std::vector<RunRecipe> runs;

  bool operator==(const PatchRecipe&) const = default;
};

/// What the engine made, and what is shown of it. Without the history of steps: the timeline holds the states themselves.
struct PatchState : PatchResult {
  SurfaceShapePtr shape;
  PatchRecipe recipe;    ///< `steps` counts from the initial patch on
  StepRecord last_step;  ///< meaningful when steps > 0
};
using PatchStatePtr = std::shared_ptr<const PatchState>;

/// Gives the shape of a state the likely error of its vertices, where it is known.
inline void show_deviation(PatchState& state) {
  if (!state.deviation.vertices.empty()) state.shape = with_deviation(*state.shape, state.deviation.vertices);
}

/// Memory held by a state, in bytes.
std::size_t size_of(const PatchState& state);

enum class Acceptance { pending, accepted };

/// The recorded states of a patch, from the initial patch on. Immutable, so that undo keeps it by pointer.
using Timeline = std::vector<PatchStatePtr>;
using TimelinePtr = std::shared_ptr<const Timeline>;

inline constexpr int no_patch = 0;  ///< no patch has this id

/// A patch that is open in the document.
struct OpenPatch {
  int id = 0;
  int scan = 0;            ///< which scan of the document
  std::vector<int> loops;  ///< indices into the document's loops, in the order of state->patch.loops
  PatchStatePtr state;
  TimelinePtr timeline;  ///< holds `state`
  Acceptance acceptance = Acceptance::pending;

  /// Of a loop of the document, among those of the patch; past their end where it is none of them.
  std::size_t place_of(int loop) const {
    return static_cast<std::size_t>(std::find(loops.begin(), loops.end(), loop) - loops.begin());
  }
};

inline std::set<int> loops_of(const OpenPatch& patch) { return {patch.loops.begin(), patch.loops.end()}; }

}  // namespace loopmend
