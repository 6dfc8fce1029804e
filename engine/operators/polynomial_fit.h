// SPDX-License-Identifier: GPL-3.0-or-later
// Least-squares polynomial r(u, v) through the neighbours of a vertex: normal, H and K there, their uncertainty, and the
// weights of the operators (paper §4, after its reference [18]).
#pragma once

#include "operators/topology.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace loopmend {

/// Parameters (u, v) of a neighbour, in the plane of the reference normal.
enum class Coordinates {
  true_distance,  ///< its direction there, at its distance in space: a sphere is then a quadratic
  projected       ///< its projection: the polynomial is a height field
};

enum class Weighting { inverse_square, equal };

/// What the vertex itself is to the fit.
enum class Centre {
  interpolated,  ///< the polynomial runs through it
  sample,        ///< one sample among the others
  left_out       ///< no sample: the fit tells where it would be if its neighbours were right
};

enum class Outliers {
  count,         ///< plain least squares
  weighted_down  ///< Huber's weights at 1.5 × 1.4826 × median |residual|, four rounds (docs/math/energy_to_matrix.md, "Rough boundaries")
};

/// What is wanted of a fit beside the derivatives, normal and curvatures.
enum class FitOutput {
  curvatures,        ///< nothing
  operator_weights,  ///< takes twice the time
  uncertainty
};

/// The default is the fit of the operators. A fit from one side of a seam is one over the Topology of that side.
struct FitOptions {
  int rings = 2;       ///< 1 to 10: the samples are the vertices within so many edges
  int most_rings = 3;  ///< rings to 10: they reach on so far where they are too few or do not determine the polynomial
  int enough = 0;      ///< samples; where there are fewer, the next ring is taken
  int degree = 2;      ///< 2 or 3
  int least_degree = 2;  ///< 2 to degree: taken where the samples do not determine a higher one
  int spare = 0;         ///< ≥ 0: samples needed beyond the terms of the polynomial
  /// 0 to 1: least ratio of singular values of the weighted design matrix A in units of the mean distance, by the bound
  /// 1 / √(tr AᵀA · tr (AᵀA)⁻¹). Where neither a lower degree nor a further ring is left, last_condition is enough.
  double least_condition = 1e-3;
  Coordinates coordinates = Coordinates::true_distance;
  Weighting weighting = Weighting::inverse_square;
  double softening = 0;                  ///< s ≥ 0, mean distances: the weights at d mean distances are 1 / (s + d)²
  Centre centre = Centre::interpolated;  ///< otherwise the weights must be equal, or s > 0
  Outliers outliers = Outliers::count;
  FitOutput output = FitOutput::curvatures;
};

inline constexpr double last_condition = 1e-6;

/// A cubic height field over so many rings, the vertex one sample among the others: for positions that are not exact.
constexpr FitOptions cubic_height_field(int rings, Outliers outliers, FitOutput output) {
  FitOptions options;
  options.rings = options.most_rings = rings;
  options.degree = options.least_degree = 3;
  options.spare = 4;
  options.coordinates = Coordinates::projected;
  options.weighting = Weighting::equal;
  options.centre = Centre::sample;
  options.outliers = outliers;
  options.output = output;
  return options;
}

struct PolynomialFit {
  bool valid = false;                        ///< false: not determined, or folded over; then H, K and all weights are 0
  std::vector<int> samples;                  ///< m vertices
  int rings = 0, degree = 0;                 ///< that were taken
  Eigen::Matrix<double, 3, 10> derivatives;  ///< r − r_i, r_u, r_v, r_uu, r_uv, r_vv, r_uuu, ... at the centre
  Vec3 normal = Vec3::Zero();                ///< r_u × r_v, unit
  Eigen::Matrix3d second_form = Eigen::Matrix3d::Zero();  ///< 1/length: the surface is r + t + ½ (tᵀ II t) n
  double H = 0;  ///< mean curvature, 1/length; −1/R on a sphere with outward normals
  double K = 0;  ///< Gaussian curvature, 1/length²

  // For FitOutput::operator_weights, else empty: Θf(r_i) ≈ Σ_j w_j (f(r_j) − f(r_i)) over the samples.
  std::vector<double> laplacian;  ///< m, 1/length²: Δ
  Points gradient;                ///< m, 1/length: ∇
  std::vector<double> gauss;      ///< m, 1/length³: K ≈ Σ_j gauss_j ⟨n_i, r_j − r_i⟩

  // For FitOutput::uncertainty: standard deviations to first order, as far as the residuals tell. With equal weights.
  double residual = 0;       ///< rms distance of the samples, degrees of freedom taken off, length
  double normal_sigma = 0;   ///< radians
  double H_sigma = 0;        ///< 1/length
  double H_slope = 0;        ///< ‖∇H‖ of a cubic height field, 1/length²; 0 of a quadratic
  double H_slope_sigma = 0;  ///< 1/length²
};

/// Scratch memory that one thread reuses over many fits.
struct FitScratch {
  explicit FitScratch(int vertex_count) : mark(vertex_count, 0) {}
  std::vector<char> mark;  ///< of Topology::k_ring
  // Of each sample:
  std::vector<Eigen::Vector2d> flat;  ///< (u, v) in mean distances
  std::vector<double> weight, residual;
  std::vector<Eigen::Matrix<double, 5, 1>> differences;  ///< weights of r_u, r_v, r_uu, r_uv, r_vv
  Eigen::Matrix<double, 10, 10> covariance;              ///< of PolynomialFit::derivatives
};

/// @param reference_normal  unit, e.g. the angle-weighted normal at i; zero: no fit. @param fit  may be one from before.
/// @returns fit.valid.
bool fit_polynomial(std::span<const Vec3> points, const Topology& topology, int i, const Vec3& reference_normal,
                    const FitOptions& options, FitScratch& scratch, PolynomialFit& fit);

}  // namespace loopmend
