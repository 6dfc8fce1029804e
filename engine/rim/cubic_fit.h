// SPDX-License-Identifier: GPL-3.0-or-later
// A cubic height field over the neighbourhood of one vertex, with outliers weighted down, and how far it can be believed.
#pragma once

#include "operators/topology.h"

#include <Eigen/Cholesky>

#include <optional>

namespace loopmend {

/// In the frame (e1, e2, normal) at the vertex, heights z(u, v) = c · [1 u v u² uv v² u³ u²v uv² v³].
struct CubicFit {
  Eigen::Matrix<double, 10, 1> coefficients;
  double residual = 0;  ///< rms of the heights left over, degrees of freedom taken off, length
  Vec3 e1, e2, normal;  ///< the frame: orthonormal
  double unit = 1;      ///< length in which `factors` was computed
  Eigen::LDLT<Eigen::Matrix<double, 10, 10>> factors;  ///< of the normal matrix

  Eigen::Matrix<double, 10, 10> covariance() const;  ///< of the coefficients, from the residuals
};

enum class Outliers {
  count,         ///< least squares
  weighted_down  ///< Huber's weights at 1.5 × 1.4826 × median |residual|, four rounds
};

enum class FitCentre {
  counted,
  left_out  ///< the fit then tells where the vertex would be if its neighbours were right
};

/// Fits the vertices within `rings` edges of vertex i, itself among them unless it is left out.
/// @param reference_normal  unit. @param mark  scratch of Topology::k_ring.
/// @returns nothing where fewer than 14 vertices are there, or they do not determine a cubic.
std::optional<CubicFit> fit_cubic(const Points& points, const Topology& topology, int i, const Vec3& reference_normal,
                                  int rings, Outliers outliers, std::vector<char>& mark,
                                  FitCentre centre = FitCentre::counted);

}  // namespace loopmend
