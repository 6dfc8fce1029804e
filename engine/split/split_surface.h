// SPDX-License-Identifier: GPL-3.0-or-later
// The operators of the split, on one connectivity whose vertices move.
#pragma once

#include "operators/hybrid_curvature.h"

namespace loopmend {

/// A surface at one moment.
struct SplitGeometry {
  Points normals;                ///< #V, angle-weighted, unit; zero where there is no area
  SparseMatrix stiffness;        ///< #V by #V: ∫‖∇f‖², weights clamped
  Eigen::VectorXd mass;          ///< #V
  SparseMatrix inner_stiffness;  ///< the same over the triangles without a border vertex, where H is known
  HybridCurvature curvature;

  /// ∫‖∇H‖² over these triangles.
  double variation() const { return curvature.H.dot(inner_stiffness * curvature.H); }
  /// BᵀKH, half the derivative of variation() along displacements at fixed metric; #V.
  Eigen::VectorXd half_gradient() const;
  /// BᵀKB, lower triangle.
  SparseMatrix hessian() const;
  /// ∫ ((Δ − κ²) f)² as fᵀ U f; lower triangle.
  SparseMatrix roughness(double kappa) const;
};

class SplitSurface {
 public:
  SplitSurface(int vertex_count, Triangles triangles);

  SplitGeometry at(const Points& points) const;
  /// Vertices whose H counts, less one for each connected part of them: what ∫‖∇H‖² determines.
  int rank() const { return rank_; }

 private:
  Triangles triangles_;
  std::vector<int> all_, inner_;  ///< triangles; those without a border vertex
  FitNeighbors neighbors_;
  int rank_ = 0;
};

}  // namespace loopmend
