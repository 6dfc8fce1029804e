// One state of the evolution: a patch with everything that the acceptance test and the next step need to know of it.
#pragma once

#include "flows/flow_terms.h"
#include "mesh/patch.h"
#include "operators/operator_set.h"

#include <memory>

namespace loopmend {

/// Built once from a patch, never changed afterwards.
struct EvolutionState {
  Patch patch;
  std::shared_ptr<const Topology> topology;  ///< shared between states of the same connectivity
  OperatorSet ops;                           ///< on rings 0..flow_reach
  double measure = 0;                        ///< what must not grow over steps: see measure_of()
  int folds = 0;                             ///< of the patch and its rim
};

/// What the flow descends, patch frame: MMCVF ∫‖∇H‖², WF ∫H², MCF area; SDF has none, and takes ∫(ΔH)².
double measure_of(FlowKind flow, const Patch& patch, const OperatorSet& ops);

/// @param topology  of the patch; made anew when null.
EvolutionState make_state(Patch patch, FlowKind flow, Stencil stencil, std::shared_ptr<const Topology> topology = nullptr);

/// The state after moving the free vertices by s (n, patch frame) along their normals.
EvolutionState displaced(const EvolutionState& state, FlowKind flow, Stencil stencil, const Eigen::VectorXd& s);

/// The energy to show (StepRecord): MMCVF ∫‖∇H‖², WF ∫H², SDF and MCF area, in mesh units.
double shown_energy(FlowKind flow, const EvolutionState& state);

}  // namespace loopmend
