// SPDX-License-Identifier: GPL-3.0-or-later
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

  FlowState(const OperatorSet& operators, int free_count);
};

/// The semi-implicit step (I − τV') s = τV for scalar displacements s along the normals. V' is kept in its factors: each row
/// of it reaches over six rings, its factors over two each. Refers to the operators it was made from.
class FlowSystem {
 public:
  FlowSystem(FlowKind flow, const FlowState& state);

  const Eigen::VectorXd& velocity() const { return velocity_; }  ///< n: V at the present state, length/time
  /// V' s without the matrix. @param s  n.
  Eigen::VectorXd times_jacobian(const Eigen::VectorXd& s) const;
  SparseMatrix jacobian() const;  ///< n by n: V'

 private:
  const OperatorSet& ops_;
  Eigen::VectorXd velocity_;
  // V' = (A + b ΔΔ) B + D; A, B and D by their values in the places that OperatorSet has entries for.
  std::vector<double> A_, D_;  ///< of the rows of the free vertices: on H at the new level, on s
  std::vector<double> B_;  ///< of all rows: H at the new level = B s + H, frozen operators: ½ w^Δ_ij ⟨n_i, n_j⟩
  double b_ = 0;
};

/// V of the flow, by its terms:
///   MCF    V = H
///   SDF    V = −ΔH
///   WF     V = −ΔH − 2H(H² − K)
///   MMCVF  V = Δ²H + 2(2H² − K)ΔH + 2⟨∇H, ◇H⟩ − 2H‖∇H‖²     (eq. 3.8)
Eigen::VectorXd flow_velocity(FlowKind flow, const FlowState& state);

/// How far from the free vertices, in rings, the flow reads operators: fits are needed on rings 0..this.
inline constexpr int flow_reach = 4;

}  // namespace loopmend
