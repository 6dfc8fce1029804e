// SPDX-License-Identifier: GPL-3.0-or-later
#include "rim/cubic_fit.h"

#include "rim/quantile.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace loopmend {

namespace {

constexpr int terms = 10, least_vertices = 14, reweightings = 4;
constexpr double least_condition = 1e-12;

Eigen::VectorXd huber_weights(const Eigen::VectorXd& residuals) {
  std::vector<double> sizes(residuals.size());
  for (Eigen::Index k = 0; k < residuals.size(); ++k) sizes[k] = std::abs(residuals[k]);
  const double limit = 1.5 * 1.4826 * median(sizes);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(residuals.size());
  for (Eigen::Index k = 0; k < residuals.size(); ++k)
    if (sizes[k] > limit) weights[k] = limit / sizes[k];
  return weights;
}

using Square = Eigen::Matrix<double, terms, terms>;
using Row = Eigen::Matrix<double, terms, 1>;

/// Whether the reciprocal condition is above least_condition. Estimating it takes as long as the fit, and the pivots
/// mostly tell: entries of L are at most 1, those of its inverse 2⁸, so that it is 10 · 2¹⁸ times below their ratio at most.
bool well_conditioned(const Eigen::LDLT<Square>& factors) {
  constexpr double clearly_enough = 10.0 * (1 << 18) * least_condition;
  const auto pivots = factors.vectorD();
  return pivots.minCoeff() > clearly_enough * pivots.maxCoeff() || factors.rcond() > least_condition;
}

/// Back from the unit of the fit: a coefficient of degree p has length^(1 − p).
Row scale_of_coefficients(double unit) {
  Row scale;
  scale << unit, 1, 1, 1 / unit, 1 / unit, 1 / unit, Eigen::Vector4d::Constant(1 / (unit * unit));
  return scale;
}

}  // namespace

Square CubicFit::covariance() const {
  const double variance = residual * residual / (unit * unit);
  const Row scale = scale_of_coefficients(unit);
  return scale.asDiagonal() * Square(variance * factors.solve(Square::Identity())) * scale.asDiagonal();
}

std::optional<CubicFit> fit_cubic(const Points& points, const Topology& topology, int i, const Vec3& reference_normal,
                                  int rings, Outliers outliers, std::vector<char>& mark, FitCentre centre) {
  std::vector<int> near;
  topology.k_ring(i, rings, near, mark);
  const auto others = static_cast<double>(near.size());
  if (centre == FitCentre::counted) near.push_back(i);
  const Eigen::Index m = static_cast<Eigen::Index>(near.size());
  if (m < least_vertices) return std::nullopt;
  CubicFit fit;
  fit.normal = reference_normal;
  fit.e1 = reference_normal.unitOrthogonal();
  fit.e2 = reference_normal.cross(fit.e1);
  double unit = 0;  // mean distance, so that all columns are of one size
  for (int v : near) unit += (points[v] - points[i]).norm() / others;
  if (!(unit > 0)) return std::nullopt;
  Eigen::Matrix<double, Eigen::Dynamic, terms, Eigen::RowMajor> A(m, terms);
  Eigen::VectorXd height(m);
  for (Eigen::Index k = 0; k < m; ++k) {
    const Vec3 d = (points[near[k]] - points[i]) / unit;
    const double u = d.dot(fit.e1), v = d.dot(fit.e2);
    A.row(k) << 1, u, v, u * u, u * v, v * v, u * u * u, u * u * v, u * v * v, v * v * v;
    height[k] = d.dot(fit.normal);
  }
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(m), residuals;
  for (int round = 0; round <= (outliers == Outliers::count ? 0 : reweightings); ++round) {
    if (round > 0) weights = huber_weights(residuals);
    // Sums of small products of known size: many times faster than products of small matrices of any size.
    Square normal_matrix = Square::Zero();
    Row right = Row::Zero();
    for (Eigen::Index k = 0; k < m; ++k) {
      const Row row = A.row(k).transpose(), weighted = weights[k] * row;
      normal_matrix.noalias() += weighted * row.transpose();
      right += height[k] * weighted;
    }
    fit.factors.compute(normal_matrix);
    if (!fit.factors.isPositive() || !well_conditioned(fit.factors)) return std::nullopt;
    fit.coefficients = fit.factors.solve(right);
    residuals = height;
    for (Eigen::Index k = 0; k < m; ++k) residuals[k] -= A.row(k).dot(fit.coefficients);
  }
  const double freedom = std::max(weights.sum() - terms, 1.0);
  const double variance = (weights.array() * residuals.array().square()).sum() / freedom;
  fit.unit = unit;
  fit.residual = std::sqrt(variance) * unit;
  fit.coefficients = scale_of_coefficients(unit).asDiagonal() * fit.coefficients;
  return fit;
}

}  // namespace loopmend
