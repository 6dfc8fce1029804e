// SPDX-License-Identifier: GPL-3.0-or-later
// One state of the evolution: a patch with everything that the acceptance test and the next step need to know of it.
#pragma once

#include "flows/flow_terms.h"
#include "mesh/patch.h"
#include "operators/operator_set.h"

#include <memory>

namespace loopmend {

/// What a flow descends. `bending` is the α of the order blend ∫‖∇H‖² + α∫H², patch frame; 0 but for MMCVF.
struct Objective {
  FlowKind flow = FlowKind::mmcvf;
  double bending = 0;
  int reach = flow_reach;  ///< rings of fixed vertices on which operators are wanted: energy_reach or flow_reach
};

/// What of OperatorSet a state holds.
enum class Fits {
  operators,  ///< all, as a step from the state needs
  curvatures  ///< no weights: enough to judge and to show it
};

/// Built once from a patch; only weights may come and go later.
struct EvolutionState {
  Patch patch;
  std::shared_ptr<const Topology> topology;  ///< shared between states of the same connectivity
  OperatorSet ops;                           ///< on rings 0..Objective::reach
  double measure = 0;                        ///< what must not grow over steps: see measure_of()
  int folds = 0;                             ///< of the patch and its boundary
  int unfitted = 0;                          ///< free vertices without a valid fit: the flow is blind there
  int missing = 0;  ///< vertices that the energy reads, of rings 0 to energy_reach, without a valid fit
};

/// Patch frame: MMCVF ∫‖∇H‖² + bending ∫H², WF ∫H², MCF area; SDF has none, and takes ∫(ΔH)².
double measure_of(const Objective& objective, const Patch& patch, const OperatorSet& ops);

/// @param topology  of the patch; made again when null.
/// @param fits      for SDF, whose measure needs weights, always operators.
EvolutionState make_state(Patch patch, const Objective& objective, Stencil stencil,
                          std::shared_ptr<const Topology> topology = nullptr, Fits fits = Fits::operators);

/// Adds the weights where they are missing. @param objective, stencil  those that the state was made with.
void add_weights(EvolutionState& state, const Objective& objective, Stencil stencil);

/// Takes them away again: on a large patch they need as much memory as a tenth of the factors.
void drop_weights(EvolutionState& state);

/// The state after moving the free vertices by s (n, patch frame) along their normals.
EvolutionState displaced(const EvolutionState& state, const Objective& objective, Stencil stencil,
                         const Eigen::VectorXd& s, Fits fits = Fits::operators);

/// The energy to show (StepRecord): MMCVF ∫‖∇H‖², WF ∫H², SDF and MCF area, in mesh units.
double shown_energy(FlowKind flow, const EvolutionState& state);

}  // namespace loopmend
