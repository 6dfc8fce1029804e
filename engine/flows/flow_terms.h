// The four flows as lists of terms, each split into a part at the new time level and a frozen part (paper §4).
#pragma once

#include "flows/flow_kind.h"
#include "mesh/patch.h"
#include "operators/operator_set.h"

namespace loopmend {

const char* to_string(FlowKind flow);

/// One state of a patch with what every term needs; n free vertices come first among #V.
struct FlowState {
  const OperatorSet& ops;
  int n = 0;
  Eigen::VectorXd lap_H;  ///< #V; 0 where there is no fit
  Points grad_H, dia_H;   ///< n
  RowSparseMatrix B;      ///< #V by n: H at the new level = B s + H, frozen operators: ½ w^Δ_ij ⟨n_i, n_j⟩
  RowSparseMatrix L;      ///< #V by #V: Δ

  FlowState(const OperatorSet& operators, int free_count);
};

/// The semi-implicit step (I − τJ) s = τV for scalar displacements s along the normals.
struct FlowSystem {
  Eigen::VectorXd velocity;  ///< n: V at the present state, length/time
  SparseMatrix jacobian;     ///< n by n: J
};

/// Adds up the flow's terms:
///   MCF    V = H
///   SDF    V = −ΔH
///   WF     V = −ΔH − 2H(H² − K)
///   MMCVF  V = Δ²H + 2(2H² − K)ΔH + 2⟨∇H, ◇H⟩ − 2H‖∇H‖²     (eq. 3.8)
FlowSystem assemble_flow(FlowKind flow, const FlowState& state);

/// V alone.
Eigen::VectorXd flow_velocity(FlowKind flow, const FlowState& state);

/// How far from the free vertices, in rings, the flow reads operators: fits are needed on rings 0..this.
inline constexpr int flow_reach = 4;

}  // namespace loopmend
