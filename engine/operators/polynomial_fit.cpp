// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/polynomial_fit.h"

#include "core/quantile.h"
#include "operators/small_least_squares.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace loopmend {

namespace {

constexpr int reweightings = 4;

/// The samples' coordinates, in units of their mean distance.
/// @returns that mean; 0 where a true distance has no direction: the sample is straight above, or in the same place.
double flatten(std::span<const Vec3> points, int i, const Vec3& normal, Coordinates coordinates,
               const std::vector<int>& samples, std::vector<Eigen::Vector2d>& flat) {
  flat.clear();
  const Vec3 e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
  double sum = 0;
  for (int j : samples) {
    const Vec3 d = points[j] - points[i];
    const double length = d.norm();
    Eigen::Vector2d q(d.dot(e1), d.dot(e2));
    if (coordinates == Coordinates::true_distance) {
      const double flat_length = q.norm();
      if (!(flat_length > 1e-12 * length)) return 0;
      q *= length / flat_length;
    }
    flat.push_back(q);
    sum += length;
  }
  const double mean = sum / static_cast<double>(samples.size());
  for (Eigen::Vector2d& q : flat) q /= mean;
  return mean;
}

double weight_at(const Eigen::Vector2d& q, const FitOptions& options) {
  if (options.weighting == Weighting::equal) return 1;
  if (!(options.softening > 0)) return 1 / q.squaredNorm();
  const double d = options.softening + q.norm();
  return 1 / (d * d);
}

/// The polynomial's terms are uᵃ vᵇ / (a! b!): with these a and b. Without the constant they begin with the second.
constexpr int u_power[] = {0, 1, 0, 2, 1, 0, 3, 2, 1, 0}, v_power[] = {0, 0, 1, 0, 1, 2, 0, 1, 2, 3};
constexpr double factorial[] = {1, 1, 2, 6};

/// A polynomial of second or third degree whose first term is the constant (0) or u (1).
template <int degree, int first>
struct Polynomial {
  static constexpr int terms = (degree == 2 ? 6 : 10) - first;
  using Row = Eigen::Matrix<double, terms, 1>;

  static Row monomials(const Eigen::Vector2d& q) {
    const double u = q[0], v = q[1];
    Row row;
    if constexpr (first == 0) row[0] = 1;
    row.template segment<5>(1 - first) << u, v, u * u / 2, u * v, v * v / 2;
    if constexpr (degree == 3) row.template tail<4>() << u * u * u / 6, u * u * v / 2, u * v * v / 2, v * v * v / 6;
    return row;
  }

  /// Lower triangle of Aᵀ W A, from the moments Σ w uᵃ vᵇ: it has no other entries.
  static void normal_matrix(const FitScratch& scratch, double (&N)[terms][terms]) {
    Moments<2 * first, 2 * degree> moments(0.0);
    for (std::size_t k = 0; k < scratch.flat.size(); ++k)
      moments.add(scratch.weight[k], scratch.flat[k][0], scratch.flat[k][1]);
    const auto scale = [](int k) { return 1 / (factorial[u_power[k]] * factorial[v_power[k]]); };
    for (int i = 0; i < terms; ++i)
      for (int j = 0; j <= i; ++j) {
        const int k = i + first, l = j + first;
        N[i][j] = scale(k) * scale(l) * moments(u_power[k] + u_power[l], v_power[k] + v_power[l]);
      }
  }
};

/// Sum of the eigenvalues: at most `size` times the largest.
template <int size>
double trace(const double (&matrix)[size][size]) {
  double sum = 0;
  for (int i = 0; i < size; ++i) sum += matrix[i][i];
  return sum;
}

/// Huber's weights times those that the samples had at first.
void weigh_down_outliers(const FitOptions& options, FitScratch& scratch) {
  const double limit = 1.5 * 1.4826 * median(scratch.residual);
  for (std::size_t k = 0; k < scratch.flat.size(); ++k) {
    const double residual = scratch.residual[k];
    scratch.weight[k] = weight_at(scratch.flat[k], options) * (residual > limit ? limit / residual : 1);
  }
}

/// Of the derivatives, from the residuals. @param inverse  of the normal matrix, for the derivatives.
template <int first, int terms>
void estimate_covariance(const Eigen::Matrix<double, terms, terms>& inverse, FitScratch& scratch, PolynomialFit& fit) {
  double squares = 0, weights = 0;
  for (std::size_t k = 0; k < scratch.flat.size(); ++k) {
    squares += scratch.weight[k] * scratch.residual[k] * scratch.residual[k];
    weights += scratch.weight[k];
  }
  const double variance = squares / std::max(weights - terms, 1.0);
  fit.residual = std::sqrt(variance);
  scratch.covariance.setZero();
  scratch.covariance.block<terms, terms>(first, first) = variance * inverse;
}

/// Derivatives of the surface and what else the output asks for, to samples in units of their mean distance.
/// @returns whether the samples determine the polynomial. All sizes are known to the compiler: this is the innermost loop.
template <int degree, int first>
bool solve(std::span<const Vec3> points, int centre, const FitOptions& options, double least_condition, double mean,
           FitScratch& scratch, PolynomialFit& fit) {
  using P = Polynomial<degree, first>;
  constexpr int terms = P::terms;
  const std::size_t count = scratch.flat.size();
  if (count < static_cast<std::size_t>(terms + options.spare)) return false;
  const double units[] = {1, mean, mean * mean, mean * mean * mean};
  Eigen::Matrix<double, terms, 1> unit;
  for (int i = 0; i < terms; ++i) unit[i] = units[u_power[i + first] + v_power[i + first]];
  double N[terms][terms], inverse[terms][terms];
  SmallCholesky<terms> factors;
  Eigen::Matrix<double, terms, terms> rows;
  Eigen::Matrix<double, 3, terms> r;
  for (int round = options.outliers == Outliers::count ? reweightings : 0; round <= reweightings; ++round) {
    P::normal_matrix(scratch, N);
    if (!factors.factorize(N)) return false;
    factors.invert(inverse);
    if (!(trace(N) * trace(inverse) * least_condition * least_condition <= 1)) return false;
    for (int i = 0; i < terms; ++i)
      for (int j = 0; j < terms; ++j) rows(i, j) = inverse[std::max(i, j)][std::min(i, j)] / unit[i];
    Eigen::Matrix<double, terms, 3> right = Eigen::Matrix<double, terms, 3>::Zero();  // its columns fill vectors
    for (std::size_t k = 0; k < count; ++k) {
      const typename P::Row row = scratch.weight[k] * P::monomials(scratch.flat[k]);
      const Vec3 way = points[fit.samples[k]] - points[centre];
      for (int c = 0; c < 3; ++c) right.col(c) += way[c] * row;
      if (options.output == FitOutput::operator_weights)
        scratch.differences[k].noalias() = rows.template middleRows<5>(1 - first) * row;
    }
    const Eigen::Matrix<double, 3, terms> transposed = right.transpose();
    r.noalias() = transposed * rows.transpose();
    if (round == reweightings && options.output != FitOutput::uncertainty) break;
    const Eigen::Matrix<double, 3, terms> in_units = r * unit.asDiagonal();
    scratch.residual.resize(count);
    for (std::size_t k = 0; k < count; ++k)
      scratch.residual[k] = (points[fit.samples[k]] - points[centre] - in_units * P::monomials(scratch.flat[k])).norm();
    if (round < reweightings) weigh_down_outliers(options, scratch);
  }
  fit.derivatives.setZero();
  fit.derivatives.template middleCols<terms>(first) = r;
  if (options.output == FitOutput::uncertainty)
    estimate_covariance<first, terms>(rows * unit.cwiseInverse().asDiagonal(), scratch, fit);
  return true;
}

void resize_weights(std::size_t count, PolynomialFit& fit) {
  fit.laplacian.resize(count);
  fit.gradient.resize(count);
  fit.gauss.resize(count);
}

/// Normal, curvatures and operator weights from the derivatives (paper §2).
void differentiate(const Vec3& reference_normal, const FitOptions& options, FitScratch& scratch, PolynomialFit& fit) {
  const auto& r = fit.derivatives;
  const Vec3 ru = r.col(1), rv = r.col(2), ruu = r.col(3), ruv = r.col(4), rvv = r.col(5);
  const double g11 = ru.squaredNorm(), g12 = ru.dot(rv), g22 = rv.squaredNorm();
  const double g = g11 * g22 - g12 * g12;
  const Vec3 cross = ru.cross(rv);
  if (!(g > 0) || cross.dot(reference_normal) <= 0) return;
  fit.normal = cross.normalized();
  const double i11 = g22 / g, i12 = -g12 / g, i22 = g11 / g;  // inverse of the first fundamental form
  const double b11 = fit.normal.dot(ruu), b12 = fit.normal.dot(ruv), b22 = fit.normal.dot(rvv);
  const Vec3 dual1 = i11 * ru + i12 * rv, dual2 = i12 * ru + i22 * rv;
  const Vec3 L = i11 * ruu + 2 * i12 * ruv + i22 * rvv;
  const double G1 = i11 * ru.dot(L) + i12 * rv.dot(L), G2 = i12 * ru.dot(L) + i22 * rv.dot(L);

  resize_weights(options.output == FitOutput::operator_weights ? fit.samples.size() : 0, fit);
  for (std::size_t k = 0; k < fit.laplacian.size(); ++k) {
    const auto& p = scratch.differences[k];
    fit.laplacian[k] = i11 * p[2] + 2 * i12 * p[3] + i22 * p[4] - G1 * p[0] - G2 * p[1];
    fit.gradient[k] = dual1 * p[0] + dual2 * p[1];
    fit.gauss[k] = (b11 * p[4] + b22 * p[2] - 2 * b12 * p[3]) / (2 * g);
  }
  fit.second_form = b11 * dual1 * dual1.transpose() + b22 * dual2 * dual2.transpose() +
                    b12 * (dual1 * dual2.transpose() + dual2 * dual1.transpose());
  fit.H = 0.5 * fit.normal.dot(L);
  fit.K = (b11 * b22 - b12 * b12) / g;
  fit.valid = std::isfinite(fit.H) && std::isfinite(fit.K);
  if (options.output != FitOutput::uncertainty) return;

  // The slopes are taken as exact: H hardly depends on them, since the reference plane is nearly tangential.
  const double cosine = fit.normal.dot(reference_normal);
  Eigen::Matrix<double, 10, 3> of_heights = Eigen::Matrix<double, 10, 3>::Zero();  // H, ∂H/∂u and ∂H/∂v
  of_heights.col(0).segment<3>(3) << cosine * i11 / 2, cosine * i12, cosine * i22 / 2;
  of_heights(6, 1) = of_heights(8, 1) = of_heights(7, 2) = of_heights(9, 2) = 0.5;
  const Eigen::Vector3d value = of_heights.transpose() * (r.transpose() * reference_normal);
  const Eigen::Matrix3d variance = of_heights.transpose() * scratch.covariance * of_heights;
  fit.normal_sigma = cosine * cosine * std::sqrt(scratch.covariance(1, 1) + scratch.covariance(2, 2));
  fit.H_sigma = std::sqrt(variance(0, 0));
  fit.H_slope = std::hypot(value[1], value[2]);
  fit.H_slope_sigma = std::sqrt(variance(1, 1) + variance(2, 2));
}

/// By the highest degree that the samples determine.
void fit_samples(std::span<const Vec3> points, int i, const Vec3& reference_normal, const FitOptions& options,
                 double mean, FitScratch& scratch, PolynomialFit& fit) {
  const bool constant = options.centre != Centre::interpolated;
  for (int degree = options.degree; degree >= options.least_degree && !fit.valid; --degree) {
    fit.degree = degree;
    scratch.weight.clear();
    for (const Eigen::Vector2d& q : scratch.flat) scratch.weight.push_back(weight_at(q, options));
    const bool last = fit.rings == options.most_rings && degree == options.least_degree;
    const auto solve_for = degree == 3 ? constant ? solve<3, 0> : solve<3, 1> : constant ? solve<2, 0> : solve<2, 1>;
    if (solve_for(points, i, options, last ? last_condition : options.least_condition, mean, scratch, fit))
      differentiate(reference_normal, options, scratch, fit);
  }
}

}  // namespace

bool fit_polynomial(std::span<const Vec3> points, const Topology& topology, int i, const Vec3& reference_normal,
                    const FitOptions& options, FitScratch& scratch, PolynomialFit& fit) {
  fit.valid = false;
  const int most_rings = reference_normal.isZero() ? 0 : options.most_rings;
  for (fit.rings = options.rings; fit.rings <= most_rings; ++fit.rings) {
    topology.k_ring(i, fit.rings, fit.samples, scratch.mark);
    if (static_cast<int>(fit.samples.size()) < options.enough && fit.rings < most_rings) continue;
    const double mean = flatten(points, i, reference_normal, options.coordinates, fit.samples, scratch.flat);
    if (!(mean > 0)) continue;
    if (options.centre == Centre::sample) {
      fit.samples.push_back(i);
      scratch.flat.emplace_back(0, 0);
    }
    scratch.differences.resize(fit.samples.size());
    fit_samples(points, i, reference_normal, options, mean, scratch, fit);
    if (fit.valid) return true;
  }
  fit.normal = reference_normal;
  fit.second_form.setZero();
  fit.H = fit.K = 0;
  resize_weights(0, fit);
  return false;
}

}  // namespace loopmend
