#include "operators/local_fit.h"

#include "mesh/quality.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace loopmend {

namespace {

using Matrix5X = Eigen::Matrix<double, 5, Eigen::Dynamic>;

/// Smallest ratio of singular values of the weighted design matrix that a stencil may have (NUMERICS §2).
double least_condition(int rings) { return rings == 1 ? 1e-2 : rings == 2 ? 1e-4 : 1e-8; }

constexpr double least_cubic_condition = 1e-3;

/// P (5 by m): derivatives [∂u ∂v ∂uu ∂uv ∂vv] = P (f_j − f_i), by a polynomial with `terms` terms: 5 quadratic, 9 cubic.
/// False when the stencil does not determine it.
template <int terms>
bool derivative_weights(const Points& points, int i, const std::vector<int>& neighbors, const Vec3& normal, int rings,
                        Matrix5X& P) {
  using Square = Eigen::Matrix<double, terms, terms>;
  const Eigen::Index m = static_cast<Eigen::Index>(neighbors.size());
  if (m < terms) return false;
  const Vec3 e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
  Eigen::Matrix2Xd q(2, m);
  double mean = 0;
  for (Eigen::Index k = 0; k < m; ++k) {
    const Vec3 d = points[neighbors[k]] - points[i];
    const double length = d.norm();
    Eigen::Vector2d flat(d.dot(e1), d.dot(e2));
    const double flat_length = flat.norm();
    if (!(flat_length > 1e-12 * length)) return false;  // a neighbour straight above, or in the same place
    q.col(k) = flat * (length / flat_length);
    mean += length;
  }
  mean /= static_cast<double>(m);
  q /= mean;

  Eigen::Matrix<double, terms, Eigen::Dynamic> weighted_rows(terms, m);  // Aᵀ W
  Square normal_matrix = Square::Zero();
  for (Eigen::Index k = 0; k < m; ++k) {
    const double u = q(0, k), v = q(1, k);
    Eigen::Matrix<double, terms, 1> row;
    row.template head<5>() << u, v, u * u / 2, u * v, v * v / 2;
    if constexpr (terms == 9) row.template tail<4>() << u * u * u / 6, u * u * v / 2, u * v * v / 2, v * v * v / 6;
    const double weight = rings == 1 ? 1.0 : 1 / (u * u + v * v);
    weighted_rows.col(k) = weight * row;
    normal_matrix.noalias() += weighted_rows.col(k) * row.transpose();
  }
  const Eigen::LDLT<Square> factors(normal_matrix);
  const double condition = terms == 9 ? least_cubic_condition : least_condition(rings);
  if (!factors.isPositive() || !(factors.rcond() >= condition * condition)) return false;
  P.noalias() = factors.solve(weighted_rows).template topRows<5>();
  P.topRows<2>() /= mean;
  P.bottomRows<3>() /= mean * mean;
  return true;
}

/// Curvatures and weights from the derivatives (NUMERICS §2, paper §2).
void operator_weights(const Points& points, int i, const Matrix5X& P, const Vec3& reference_normal, LocalFit& fit) {
  const Eigen::Index m = P.cols();
  Eigen::Matrix<double, 3, 5> r = Eigen::Matrix<double, 3, 5>::Zero();  // r_u, r_v, r_uu, r_uv, r_vv
  for (Eigen::Index k = 0; k < m; ++k) r.noalias() += (points[fit.neighbors[k]] - points[i]) * P.col(k).transpose();
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

  fit.laplacian = (i11 * P.row(2) + 2 * i12 * P.row(3) + i22 * P.row(4) - G1 * P.row(0) - G2 * P.row(1)).transpose();
  fit.gradient = dual1 * P.row(0) + dual2 * P.row(1);
  fit.diamond = ((b22 * ru - b12 * rv) * P.row(0) + (b11 * rv - b12 * ru) * P.row(1)) / g;
  fit.second_form = b11 * dual1 * dual1.transpose() + b22 * dual2 * dual2.transpose() +
                    b12 * (dual1 * dual2.transpose() + dual2 * dual1.transpose());
  fit.gauss = fit.normal * (b11 * P.row(4) + b22 * P.row(2) - 2 * b12 * P.row(3)) / (2 * g);
  fit.H = 0.5 * fit.normal.dot(L);
  fit.K = (b11 * b22 - b12 * b12) / g;
  fit.valid = std::isfinite(fit.H) && std::isfinite(fit.K);
}

}  // namespace

void fit_quadratic(const Points& points, const Topology& topology, int i, const Vec3& reference_normal, Stencil stencil,
                   FitScratch& scratch, LocalFit& fit) {
  fit.valid = false;
  fit.H = fit.K = 0;
  fit.normal = reference_normal;
  fit.second_form.setZero();
  const bool narrow = stencil == Stencil::one_ring && topology.valence(i) >= 5 && !topology.is_boundary(i);
  Matrix5X P;
  const int first = stencil == Stencil::four_ring ? 4 : narrow ? 1 : 2;
  for (fit.rings = first; fit.rings <= std::max(first, 3) && !fit.valid; ++fit.rings) {
    topology.k_ring(i, fit.rings, fit.neighbors, scratch.mark);
    const bool cubic = stencil == Stencil::two_ring_cubic &&
                       derivative_weights<9>(points, i, fit.neighbors, reference_normal, fit.rings, P);
    if (cubic || derivative_weights<5>(points, i, fit.neighbors, reference_normal, fit.rings, P))
      operator_weights(points, i, P, reference_normal, fit);
    if (fit.valid) break;
  }
  if (fit.valid) return;
  const Eigen::Index m = static_cast<Eigen::Index>(fit.neighbors.size());
  fit.laplacian.setZero(m);
  fit.gradient.setZero(3, m);
  fit.diamond.setZero(3, m);
  fit.gauss.setZero(3, m);
  fit.H = fit.K = 0;
}

Points angle_weighted_normals(const Points& points, const Triangles& triangles) {
  Points normals(points.size(), Vec3::Zero());
  for (const Triangle& t : triangles) {
    const Vec3 normal = unit_normal(points[t[0]], points[t[1]], points[t[2]]);
    for (int k = 0; k < 3; ++k) {
      const Vec3 a = points[t[(k + 1) % 3]] - points[t[k]], b = points[t[(k + 2) % 3]] - points[t[k]];
      normals[t[k]] += std::atan2(a.cross(b).norm(), a.dot(b)) * normal;
    }
  }
  for (Vec3& n : normals) {
    const double norm = n.norm();
    n = norm > 0 ? Vec3(n / norm) : Vec3::Zero();
  }
  return normals;
}

}  // namespace loopmend
