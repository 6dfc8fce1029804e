// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/local_fit.h"

#include "mesh/quality.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace loopmend {

namespace {

/// Smallest ratio of singular values of the weighted design matrix that a stencil may have
/// (docs/dev/numerics.md, "Operators from local fits").
double least_condition(int rings) { return rings == 1 ? 1e-2 : rings == 2 ? 1e-4 : 1e-8; }

constexpr double least_cubic_condition = 1e-3;

/// The neighbours in the tangent plane, each at its true distance, in units of their mean distance.
/// @returns that mean; 0 where a neighbour is straight above the centre, or in the same place.
double flatten(const Points& points, int i, const std::vector<int>& neighbors, const Vec3& normal,
               std::vector<Eigen::Vector2d>& flat) {
  flat.clear();
  const Vec3 e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
  double sum = 0;
  for (int j : neighbors) {
    const Vec3 d = points[j] - points[i];
    const double length = d.norm();
    const Eigen::Vector2d q(d.dot(e1), d.dot(e2));
    const double flat_length = q.norm();
    if (!(flat_length > 1e-12 * length)) return 0;
    flat.push_back(q * (length / flat_length));
    sum += length;
  }
  const double mean = sum / static_cast<double>(neighbors.size());
  for (Eigen::Vector2d& q : flat) q /= mean;
  return mean;
}

/// The polynomial's terms at one place: 5 of a quadratic, 9 of a cubic, both without the constant.
template <int terms>
Eigen::Matrix<double, terms, 1> monomials(const Eigen::Vector2d& q) {
  const double u = q[0], v = q[1];
  Eigen::Matrix<double, terms, 1> row;
  row.template head<5>() << u, v, u * u / 2, u * v, v * v / 2;
  if constexpr (terms == 9) row.template tail<4>() << u * u * u / 6, u * u * v / 2, u * v * v / 2, v * v * v / 6;
  return row;
}

double weight_at(const Eigen::Vector2d& q, int rings) { return rings == 1 ? 1.0 : 1 / q.squaredNorm(); }

/// Σ w uᵃ vᵇ over the neighbours for 2 ≤ a + b ≤ most: the normal matrix has no other entries. At [a + b][b].
template <int most>
struct Moments {
  double sum[most + 1][most + 1] = {};

  Moments(const std::vector<Eigen::Vector2d>& flat, int rings) {
    for (const Eigen::Vector2d& q : flat) {
      double power[most + 1];  // w uᵃ vᵇ of one degree
      power[0] = weight_at(q, rings);
      // Unrolled, the powers stay in registers.
#pragma GCC unroll 8
      for (int degree = 1; degree <= most; ++degree) {
        power[degree] = power[degree - 1] * q[1];
#pragma GCC unroll 8
        for (int k = 0; k < degree; ++k) power[k] *= q[0];
        if (degree == 1) continue;
#pragma GCC unroll 8
        for (int k = 0; k <= degree; ++k) sum[degree][k] += power[k];
      }
    }
  }
};

/// The polynomial's terms are uᵃ vᵇ / (a! b!): with these a and b.
constexpr int u_power[] = {1, 0, 2, 1, 0, 3, 2, 1, 0}, v_power[] = {0, 1, 0, 1, 2, 0, 1, 2, 3};
constexpr double factorial[] = {1, 1, 2, 6};

/// Lower triangle of Aᵀ W A.
template <int terms>
void fill_normal_matrix(const std::vector<Eigen::Vector2d>& flat, int rings, double (&N)[terms][terms]) {
  const Moments<terms == 9 ? 6 : 4> moments(flat, rings);
  const auto scale = [](int k) { return 1 / (factorial[u_power[k]] * factorial[v_power[k]]); };
  for (int i = 0; i < terms; ++i)
    for (int j = 0; j <= i; ++j) {
      const int v = v_power[i] + v_power[j];
      N[i][j] = scale(i) * scale(j) * moments.sum[u_power[i] + u_power[j] + v][v];
    }
}

/// Of the whole of a symmetric matrix whose lower triangle is given.
template <int size>
double norm1(const double (&matrix)[size][size]) {
  double largest = 0;
#pragma GCC unroll 9
  for (int i = 0; i < size; ++i) {
    double sum = 0;
#pragma GCC unroll 9
    for (int j = 0; j < size; ++j) sum += std::abs(matrix[std::max(i, j)][std::min(i, j)]);
    largest = std::max(largest, sum);
  }
  return largest;
}

/// Lower triangle of N⁻¹ from that of N, by Cholesky. False when N is not positive definite. By hand, since Eigen's
/// triangular solves take several times as long at this size.
template <int size>
bool invert(const double (&N)[size][size], double (&inverse)[size][size]) {
  double L[size][size], L_inverse[size][size];
#pragma GCC unroll 9
  for (int j = 0; j < size; ++j) {
    double pivot = N[j][j];
#pragma GCC unroll 9
    for (int k = 0; k < j; ++k) pivot -= L[j][k] * L[j][k];
    if (!(pivot > 0)) return false;
    L_inverse[j][j] = 1 / std::sqrt(pivot);
#pragma GCC unroll 9
    for (int i = j + 1; i < size; ++i) {
      double sum = N[i][j];
#pragma GCC unroll 9
      for (int k = 0; k < j; ++k) sum -= L[i][k] * L[j][k];
      L[i][j] = sum * L_inverse[j][j];
    }
  }
#pragma GCC unroll 9
  for (int j = 0; j < size; ++j)
#pragma GCC unroll 9
    for (int i = j + 1; i < size; ++i) {
      double sum = 0;
#pragma GCC unroll 9
      for (int k = j; k < i; ++k) sum -= L[i][k] * L_inverse[k][j];
      L_inverse[i][j] = sum * L_inverse[i][i];
    }
#pragma GCC unroll 9
  for (int i = 0; i < size; ++i)
#pragma GCC unroll 9
    for (int j = 0; j <= i; ++j) {
      inverse[i][j] = 0;
#pragma GCC unroll 9
      for (int k = i; k < size; ++k) inverse[i][j] += L_inverse[k][i] * L_inverse[k][j];
    }
  return true;
}

/// Derivatives of the surface at the centre: r_u, r_v, r_uu, r_uv, r_vv.
using SurfaceDerivatives = Eigen::Matrix<double, 3, 5>;

/// Derivatives [∂u ∂v ∂uu ∂uv ∂vv] by a polynomial with `terms` terms: of the surface, and where they are wanted the weights
/// P, a column for each neighbour, with which those of any f are P (f_j − f_i). False when the stencil does not determine
/// it. All sizes are known to the compiler: this is the innermost loop.
template <int terms>
bool differentiate(const Points& points, int centre, const std::vector<int>& neighbors,
                   const std::vector<Eigen::Vector2d>& flat, double mean, int rings, SurfaceDerivatives& r,
                   std::vector<DerivativeWeights>* P) {
  if (flat.size() < terms) return false;
  double N[terms][terms], inverse[terms][terms];
  fill_normal_matrix(flat, rings, N);
  if (!invert(N, inverse)) return false;
  const double condition = terms == 9 ? least_cubic_condition : least_condition(rings);
  if (!(norm1(N) * norm1(inverse) * condition * condition <= 1)) return false;
  Eigen::Matrix<double, 5, terms> rows;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < terms; ++j) rows(i, j) = inverse[std::max(i, j)][std::min(i, j)] / (i < 2 ? mean : mean * mean);
  if (P) P->resize(flat.size());
  Eigen::Matrix<double, 3, terms> right = Eigen::Matrix<double, 3, terms>::Zero();
  for (std::size_t k = 0; k < flat.size(); ++k) {
    const Eigen::Matrix<double, terms, 1> row = weight_at(flat[k], rings) * monomials<terms>(flat[k]);
    right.noalias() += (points[neighbors[k]] - points[centre]) * row.transpose();
    if (P) (*P)[k].noalias() = rows * row;
  }
  r.noalias() = right * rows.transpose();
  return true;
}

/// Curvatures, and where P is given weights, from the derivatives (paper §2;
/// docs/dev/numerics.md, "Operators from local fits").
void curvatures_and_weights(const SurfaceDerivatives& r, const Vec3& reference_normal,
                            const std::vector<DerivativeWeights>* P, LocalFit& fit) {
  const Vec3 ru = r.col(0), rv = r.col(1), ruu = r.col(2), ruv = r.col(3), rvv = r.col(4);
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

  fit.resize(P ? P->size() : 0);
  for (std::size_t k = 0; P && k < P->size(); ++k) {
    const DerivativeWeights& p = (*P)[k];
    fit.laplacian[k] = i11 * p[2] + 2 * i12 * p[3] + i22 * p[4] - G1 * p[0] - G2 * p[1];
    fit.gradient[k] = dual1 * p[0] + dual2 * p[1];
    fit.gauss[k] = (b11 * p[4] + b22 * p[2] - 2 * b12 * p[3]) / (2 * g);
  }
  fit.second_form = b11 * dual1 * dual1.transpose() + b22 * dual2 * dual2.transpose() +
                    b12 * (dual1 * dual2.transpose() + dual2 * dual1.transpose());
  fit.H = 0.5 * fit.normal.dot(L);
  fit.K = (b11 * b22 - b12 * b12) / g;
  fit.valid = std::isfinite(fit.H) && std::isfinite(fit.K);
}

/// @param P  scratch memory; null where weights are not wanted.
void fit_at(const Points& points, const Topology& topology, int i, const Vec3& reference_normal, Stencil stencil,
            FitScratch& scratch, std::vector<DerivativeWeights>* P, LocalFit& fit) {
  fit.valid = false;
  fit.H = fit.K = 0;
  fit.normal = reference_normal;
  fit.second_form.setZero();
  const bool narrow = stencil == Stencil::one_ring && topology.valence(i) >= 5 && !topology.is_boundary(i);
  const int first = stencil == Stencil::four_ring ? 4 : narrow ? 1 : 2;
  for (fit.rings = first; fit.rings <= std::max(first, 3); ++fit.rings) {
    topology.k_ring(i, fit.rings, fit.neighbors, scratch.mark);
    const double mean = flatten(points, i, fit.neighbors, reference_normal, scratch.flat);
    if (!(mean > 0)) continue;
    SurfaceDerivatives r;
    const bool cubic = stencil == Stencil::two_ring_cubic &&
                       differentiate<9>(points, i, fit.neighbors, scratch.flat, mean, fit.rings, r, P);
    if (cubic || differentiate<5>(points, i, fit.neighbors, scratch.flat, mean, fit.rings, r, P))
      curvatures_and_weights(r, reference_normal, P, fit);
    if (fit.valid) return;
  }
  fit.resize(0);
  fit.resize(P ? fit.neighbors.size() : 0);
  fit.H = fit.K = 0;
}

}  // namespace

void fit_quadratic(const Points& points, const Topology& topology, int i, const Vec3& reference_normal, Stencil stencil,
                   FitScratch& scratch, LocalFit& fit) {
  fit_at(points, topology, i, reference_normal, stencil, scratch, &scratch.derivatives, fit);
}

void fit_curvatures(const Points& points, const Topology& topology, int i, const Vec3& reference_normal,
                    Stencil stencil, FitScratch& scratch, LocalFit& fit) {
  fit_at(points, topology, i, reference_normal, stencil, scratch, nullptr, fit);
}

void LocalFit::resize(std::size_t count) {
  laplacian.resize(count, 0.0);
  gradient.resize(count, Vec3::Zero());
  gauss.resize(count, 0.0);
}

namespace {

/// The share of corner k of the triangle in the normal there.
double angle_at(const Points& points, const Triangle& t, int k) {
  const Vec3 a = points[t[(k + 1) % 3]] - points[t[k]], b = points[t[(k + 2) % 3]] - points[t[k]];
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

Vec3 unit_or_zero(const Vec3& sum) {
  const double norm = sum.norm();
  return norm > 0 ? Vec3(sum / norm) : Vec3::Zero();
}

}  // namespace

Points angle_weighted_normals(const Points& points, const Triangles& triangles) {
  Points normals(points.size(), Vec3::Zero());
  for (const Triangle& t : triangles) {
    const Vec3 normal = unit_normal(points[t[0]], points[t[1]], points[t[2]]);
    for (int k = 0; k < 3; ++k) normals[t[k]] += angle_at(points, t, k) * normal;
  }
  for (Vec3& n : normals) n = unit_or_zero(n);
  return normals;
}

Vec3 angle_weighted_normal(const Points& points, const Triangles& triangles, const Topology& topology, int i) {
  Vec3 sum = Vec3::Zero();
  for (int f : topology.faces(i)) {
    const Triangle& t = triangles[f];
    const int k = t[0] == i ? 0 : t[1] == i ? 1 : 2;
    sum += angle_at(points, t, k) * unit_normal(points[t[0]], points[t[1]], points[t[2]]);
  }
  return unit_or_zero(sum);
}

}  // namespace loopmend
