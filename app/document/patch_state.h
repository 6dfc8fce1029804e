// One accepted state of one patch, with all that is shown of it. Immutable: states are shared between document, undo
// stack, worker and view.
#pragma once

#include "analysis/seam_report.h"
#include "evolution/evolution.h"
#include "mesh/patch.h"
#include "scene/surface_shape.h"

#include <memory>
#include <string>
#include <vector>

namespace loopmend {

enum class PatchStage {
  filled,   ///< the G0 filler
  stepped,  ///< some steps of a flow, more can be taken
  converged,
  failed,  ///< the flow found no further acceptable step; the state is the last accepted one
};

struct PatchState {
  Patch patch;
  std::shared_ptr<const SurfaceShape> shape;
  PatchStage stage = PatchStage::filled;
  std::string message;  ///< the engine's words about this state; may be empty
  FlowKind flow = FlowKind::mmcvf;
  int steps = 0;                        ///< since the filler
  StepRecord last_step;                 ///< meaningful when steps > 0
  double initial_energy = 0;            ///< of the run that led here
  double seconds = 0;                   ///< of that run
  std::vector<SeamReport> seam_before;  ///< of the filler, one per loop
  std::vector<SeamReport> seam;         ///< of this state, one per loop
};
using PatchStatePtr = std::shared_ptr<const PatchState>;

/// A patch that is open in the document.
struct OpenPatch {
  int id = 0;
  std::vector<int> loops;  ///< indices into the document's loops, in the order of state->patch.loops
  PatchStatePtr state;
};

}  // namespace loopmend
