// SPDX-License-Identifier: GPL-3.0-or-later
// The steady state by Gauss-Newton on the curvature energy: the same energy and weights as the flow, symmetric.
#pragma once

#include "operators/curvature_energy.h"

namespace loopmend {

/// (μM + Bᵀ Q B) s = −½∇E, with E = Hᵀ Q H, B = ∂H/∂s. One step is a step of the flow of size τ = 1/(2μ) for small τ.
struct GaussNewtonSystem {
  double energy = 0;              ///< E at the present state
  Eigen::VectorXd half_gradient;  ///< n: ½ ∂E/∂s
  RowSparseMatrix B;              ///< #V by n
  SparseMatrix Q;                 ///< #V by #V
  Eigen::VectorXd mass;           ///< n

  /// n by n: the lower triangle of Bᵀ Q B. To form it takes as long as the rest of the system.
  SparseMatrix curvature() const;
  /// Bᵀ Q B x, without forming it. @param x  n.
  Eigen::VectorXd curvature_times(const Eigen::VectorXd& x) const;
};

GaussNewtonSystem assemble_gauss_newton(const Patch& patch, const OperatorSet& ops, const EnergyWeights& weights);

/// A matrix near μM + BᵀQB with a third of its fill, lower triangle: B is near half the Laplacian, of which the clamped cotan
/// one has the fewest neighbours.
SparseMatrix near_gauss_newton(const Patch& patch, const EnergyWeights& weights, double mu);

}  // namespace loopmend
