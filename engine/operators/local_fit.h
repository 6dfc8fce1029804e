// SPDX-License-Identifier: GPL-3.0-or-later
// Local quadratic fit at one vertex, and the operator weights that follow from it (paper §4, after its reference [18]).
#pragma once

#include "operators/topology.h"

#include <Eigen/Core>

#include <vector>

namespace loopmend {

/// Over which neighbours the quadratic is fitted.
enum class Stencil {
  one_ring,        ///< the paper's N_1(i), unweighted; widened where it does not determine the quadratic
  two_ring,        ///< N_2(i), weighted by 1/d²: less sensitive to bad triangles and to noise
  two_ring_cubic,  ///< N_2(i), a cubic where it is determined
  four_ring,       ///< N_4(i), weighted likewise: to tell shape from roughness
};

/// Weights such that Θf(r_i) ≈ Σ_j w_ij (f(r_j) − f(r_i)) for j in `neighbors`; the centre's own weight is −Σ w_ij.
struct LocalFit {
  std::vector<int> neighbors;     ///< m vertices
  std::vector<double> laplacian;  ///< m, 1/length²: Δ
  Points gradient;                ///< m, 1/length: ∇
  std::vector<double> gauss;      ///< m, 1/length³: K ≈ Σ_j gauss_j ⟨n_i, r_j − r_i⟩
  Vec3 normal = Vec3::Zero();     ///< r_u × r_v, unit
  Eigen::Matrix3d second_form =
      Eigen::Matrix3d::Zero();  ///< 1/length: the surface is r + t + ½ (tᵀ II t) n for tangential t
  double H = 0;                 ///< mean curvature, 1/length; −1/R on a sphere with outward normals
  double K = 0;                 ///< Gaussian curvature, 1/length²
  int rings = 0;                ///< how far the stencil had to reach
  bool valid = false;           ///< false: rank-deficient or folded over; then all weights are 0

  void resize(std::size_t count);  ///< of the three lists of weights; new ones are 0
};

/// Of one neighbour, on the derivatives ∂u ∂v ∂uu ∂uv ∂vv of the fitted polynomial at the centre.
using DerivativeWeights = Eigen::Matrix<double, 5, 1>;

/// Scratch memory that one thread reuses over many fits.
struct FitScratch {
  explicit FitScratch(int vertex_count) : mark(vertex_count, 0) {}
  std::vector<char> mark;
  std::vector<Eigen::Vector2d> flat;           ///< the neighbours' coordinates
  std::vector<DerivativeWeights> derivatives;  ///< of the neighbours
};

/// Fits r(u, v) and f(u, v) at vertex i by [u, v, u²/2, uv, v²/2], interpolating the centre. Coordinates: projection to
/// the plane of `reference_normal`, each neighbour put back to its true distance. Where the one-ring has fewer than five
/// vertices, lies on a boundary, or is ill-conditioned, the two-ring is taken; then the three-ring.
/// @param reference_normal  unit, e.g. the angle-weighted normal at i.
void fit_quadratic(const Points& points, const Topology& topology, int i, const Vec3& reference_normal, Stencil stencil,
                   FitScratch& scratch, LocalFit& fit);

/// The same without the weights, whose lists are left empty, in about half the time; all else has the same bits.
void fit_curvatures(const Points& points, const Topology& topology, int i, const Vec3& reference_normal,
                    Stencil stencil, FitScratch& scratch, LocalFit& fit);

/// Normals weighted by the angles of the triangles at each vertex; unit, or zero where there is no area.
Points angle_weighted_normals(const Points& points, const Triangles& triangles);
/// One of them, the same bits.
Vec3 angle_weighted_normal(const Points& points, const Triangles& triangles, const Topology& topology, int i);

}  // namespace loopmend
