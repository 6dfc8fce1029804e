// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/one_sided_fit.h"

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <cmath>

namespace loopmend {

namespace {

/// Normal and H at the origin of r(u, v), from its derivatives r_u, r_v, r_uu, r_uv, r_vv in the columns.
std::optional<OneSidedFit> at_origin(const Eigen::Matrix<double, 3, 5>& r, const Vec3& reference_normal) {
  const Vec3 square = r.col(0).cross(r.col(1));
  if (!(square.dot(reference_normal) > 0)) return std::nullopt;
  OneSidedFit fit;
  fit.normal = square.normalized();
  const double g11 = r.col(0).squaredNorm(), g12 = r.col(0).dot(r.col(1)), g22 = r.col(1).squaredNorm();
  const Eigen::RowVector3d second = fit.normal.transpose() * r.rightCols<3>();
  fit.H = (g22 * second[0] - 2 * g12 * second[1] + g11 * second[2]) / (2 * square.squaredNorm());
  return std::isfinite(fit.H) ? std::optional(fit) : std::nullopt;
}

/// Of a quadratic (5 columns) or a cubic (9) to the neighbours.
template <int columns>
std::optional<OneSidedFit> fit_to(const std::vector<int>& neighbors, const Points& points, int i,
                                  const Vec3& reference_normal) {
  const Eigen::Index m = static_cast<Eigen::Index>(neighbors.size());
  if (m < columns + 1) return std::nullopt;
  const Vec3 e1 = reference_normal.unitOrthogonal(), e2 = reference_normal.cross(e1);
  double mean = 0;
  for (int j : neighbors) mean += (points[j] - points[i]).norm() / static_cast<double>(m);
  if (!(mean > 0)) return std::nullopt;
  Eigen::Matrix<double, Eigen::Dynamic, columns> A(m, columns);
  Eigen::MatrixX3d place(m, 3);
  for (Eigen::Index k = 0; k < m; ++k) {
    const Vec3 d = (points[neighbors[k]] - points[i]) / mean;
    const double length = d.norm(), flat = std::hypot(d.dot(e1), d.dot(e2));
    if (!(flat > 1e-12 * length)) return std::nullopt;  // a neighbour straight above, or in the same place
    // At its true distance, not the projected one: then a sphere is quadratic, and the error on others a fraction.
    const double u = d.dot(e1) * length / flat, v = d.dot(e2) * length / flat, weight = 1 / (0.1 + length);
    A.row(k).template head<5>() << u, v, u * u / 2, u * v, v * v / 2;
    if constexpr (columns == 9) A.row(k).template tail<4>() << u * u * u, u * u * v, u * v * v, v * v * v;
    A.row(k) *= weight;
    place.row(k) = weight * d.transpose();
  }
  Eigen::ColPivHouseholderQR<Eigen::Matrix<double, Eigen::Dynamic, columns>> qr(A);
  qr.setThreshold(1e-6);
  if (qr.rank() < columns) return std::nullopt;
  const Eigen::Matrix<double, columns, 3> derivatives = qr.solve(place);
  std::optional<OneSidedFit> fit = at_origin(derivatives.template topRows<5>().transpose(), reference_normal);
  if (fit) fit->H /= mean;
  return fit;
}

}  // namespace

std::optional<OneSidedFit> one_sided_fit(const Points& points, const Topology& side, int i,
                                         const Vec3& reference_normal, std::vector<char>& mark) {
  if (reference_normal.isZero()) return std::nullopt;
  std::vector<int> neighbors;
  for (int rings = 2; rings <= 5 && neighbors.size() < 18; ++rings) side.k_ring(i, rings, neighbors, mark);
  return neighbors.size() >= 14 ? fit_to<9>(neighbors, points, i, reference_normal)
                                : fit_to<5>(neighbors, points, i, reference_normal);
}

}  // namespace loopmend
