// SPDX-License-Identifier: GPL-3.0-or-later
// Mean curvature that is accurate on smooth shape and blind to no roughness.
#pragma once

#include "operators/operator_set.h"

namespace loopmend {

/// Fits alone average out what is narrower than they are, and a descent runs away along what they do not see; the cotan operator
/// alone takes its own inconsistency on uneven triangles for curvature. So H = H of a cubic height field whose constant term is
/// free, plus what the cotan operator makes of the distances that the field leaves to the vertices.
struct HybridCurvature {
  Eigen::VectorXd H;  ///< #V, 1/length, −1/R on a sphere with outward normals; 0 where a vertex has no normal
  /// #V by #V: ∂H/∂s for displacements s along the normals, ½Δs + ½‖A‖²s: −½M⁻¹L with ⟨n_i, n_j⟩ in every entry, whose turning
  /// takes ½‖A‖² off, + ‖A‖².
  RowSparseMatrix B;
  Eigen::VectorXd bent;  ///< #V: ‖A‖² of the fits
};

/// Vertices that each fit reaches: two rings, three where these are few, the vertex itself last.
using FitNeighbors = std::vector<std::vector<int>>;
FitNeighbors fit_neighbors(const Topology& topology);

/// A sample counts less the more its normal turns away from the fit's, so that fits do not reach over creases.
/// @param normals    #V, unit or zero. @param stiffness, mass  of the cotan operator Δ = −M⁻¹L, #V
HybridCurvature hybrid_curvature(const Points& points, const Points& normals, const FitNeighbors& neighbors,
                                 const SparseMatrix& stiffness, const Eigen::VectorXd& mass);

}  // namespace loopmend
