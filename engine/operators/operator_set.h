// SPDX-License-Identifier: GPL-3.0-or-later
// The operators ∇, ◇, Δ and the curvatures H, K at many vertices at once, in flat arrays, and their sparse assembly.
#pragma once

#include "operators/polynomial_fit.h"

#include <Eigen/SparseCore>

#include <array>

namespace loopmend {

using SparseMatrix = Eigen::SparseMatrix<double>;
using RowSparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Over which neighbours the operators are fitted.
enum class Stencil {
  two_ring,  ///< a quadratic over N_2(i), weighted by 1/d²: less sensitive to bad triangles and to noise than N_1(i)
  two_ring_cubic  ///< a cubic where N_2(i) determines it
};

/// Row i holds the weights of vertex i; entry `offset[i]` is the centre, the others its neighbours. Rows of vertices that
/// were not asked for, or whose fit failed, are empty.
struct OperatorSet {
  std::vector<int> offset;  ///< #V + 1
  std::vector<int> index;   ///< vertex of each entry
  std::vector<double> laplacian;
  Points gradient;
  std::vector<double> gauss;  ///< times n_i: see PolynomialFit
  Points normal;              ///< #V, unit: of the fit, or angle-weighted where it failed; 0 where it was not wanted
  std::vector<Eigen::Matrix3d> second_form;  ///< #V, see PolynomialFit
  Eigen::VectorXd H, K;                      ///< #V, 0 in empty rows
  std::vector<char> valid;                   ///< #V

  double apply_laplacian(int i, const Eigen::VectorXd& f) const;
  Vec3 apply_gradient(int i, const Eigen::VectorXd& f) const;
  Vec3 apply_diamond(int i, const Eigen::VectorXd& f) const;
  /// ◇ = 2H∇ − S∇ at vertex i (§2): takes the gradient of a function, or a weight of ∇, to that of ◇. Symmetric.
  Vec3 diamond(int i, const Vec3& tangent) const { return 2 * H[i] * tangent - second_form[i] * tangent; }
};

/// Fits from before, by the same stencil on the same topology. Those that reach no vertex which has moved since are not
/// made again: they would have the same bits.
struct KnownFits {
  const OperatorSet* set = nullptr;  ///< null, or without weights: nothing is known
  int moved = 0;                     ///< the first so many vertices may have moved; all others are where they were
};

/// Fits every vertex i with wanted[i] != 0; in parallel, with the same bits for any number of threads.
OperatorSet compute_operators(const Points& points, const Triangles& triangles, const Topology& topology,
                              Stencil stencil, const std::vector<char>& wanted, const KnownFits& known = {});

/// The same curvatures and normals without weights, whose arrays, `offset` too, are left empty: about half the work.
OperatorSet compute_curvatures(const Points& points, const Triangles& triangles, const Topology& topology,
                               Stencil stencil, const std::vector<char>& wanted, const KnownFits& known = {});

/// Clamp for cotangent weights where a matrix must stay well-conditioned on slivers
/// (docs/math/energy_to_matrix.md, "Linear solvers").
struct CotanClamp {
  double low, high;  ///< of the half sum of the two cotangents at an edge
};
inline constexpr CotanClamp robust_clamp{0.05, 5};
/// Nearly the weights of equilateral triangles (0.577), whatever the triangles are.
inline constexpr CotanClamp even_clamp{0.3, 1};

/// Half cotangents of the angles at the three corners; corner k is opposite the edge (k+1, k+2).
std::array<double, 3> half_cotangents(const Points& points, const Triangle& triangle);

/// Cotangent stiffness matrix over the given triangles: xᵀ C x = ∫‖∇x‖² for piecewise linear x. #V by #V, symmetric,
/// positive semi-definite.
SparseMatrix cotan_stiffness(const Points& points, const Triangles& triangles, const std::vector<int>& faces);
/// The same with the weight of every edge clamped; no longer the exact integral.
SparseMatrix clamped_cotan_stiffness(const Points& points, const Triangles& triangles, const std::vector<int>& faces,
                                     CotanClamp clamp);

/// A third of the area of the triangles at each vertex; #V. Never below 5 % of the mean.
Eigen::VectorXd barycentric_areas(const Points& points, const Triangles& triangles);

}  // namespace loopmend
