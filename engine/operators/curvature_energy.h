// SPDX-License-Identifier: GPL-3.0-or-later
// The energies that the flows descend, and the derivative of H along normal displacements.
#pragma once

#include "mesh/patch.h"
#include "operators/operator_set.h"

namespace loopmend {

/// Weights of the two curvature energies: E = variation · ∫‖∇H‖² dA + bending · ∫H² dA. Patch frame.
struct EnergyWeights {
  double variation = 1;  ///< minimal mean-curvature-variation, paper eq. (1.1)
  double bending = 0;    ///< Willmore, ∫H² dA
};

/// Rings of fixed vertices whose H the energies ask for.
inline constexpr int energy_reach = 3;

/// The energy as a quadratic form in H at fixed geometry, E = Hᵀ Q H, over the triangles whose H the patch can change. Where a fit
/// is missing, H is not known: triangles at that vertex have no part in ∫‖∇H‖², and the vertex has none in ∫H².
struct CurvatureEnergy {
  SparseMatrix Q;          ///< #V by #V: variation · C + bending · M
  std::vector<int> faces;  ///< triangles it runs over
  Eigen::VectorXd mass;    ///< #V: barycentric areas
};

CurvatureEnergy curvature_energy(const Patch& patch, const OperatorSet& ops, const EnergyWeights& weights);

/// E alone, for the curvatures of `ops`, without the matrix.
double energy_value(const Patch& patch, const OperatorSet& ops, const EnergyWeights& weights);

/// B = ∂H/∂s, #V by n, for displacements s along the normals of the free vertices (exact for frozen fit
/// coordinates; docs/math/energy_to_matrix.md, "Gauss-Newton step"): B_ij = ½ w^Δ_ij ⟨n_i, n_j⟩ − ⟨2H_i w^∇_ij − w^◇_ij, n_j⟩.
RowSparseMatrix curvature_jacobian(const OperatorSet& ops, int free_count);

/// ∂(Hᵀ Q H)/∂s at fixed H: how the energy changes with the metric alone. n.
Eigen::VectorXd metric_gradient(const Patch& patch, const OperatorSet& ops, const EnergyWeights& weights,
                                const std::vector<int>& faces);

/// Area of the patch's own triangles, patch frame.
double patch_area(const Patch& patch);

/// Radius of the disc with the patch's area, shared evenly between its loops, patch frame. A patch without loops, such as
/// a closed polyhedron, counts as one.
double patch_radius(const Patch& patch);

}  // namespace loopmend
