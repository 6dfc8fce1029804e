#include "analysis/one_sided_fit.h"

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <cmath>

namespace loopmend {

std::optional<OneSidedFit> one_sided_fit(const Points& points, const Topology& side, int i,
                                         const Vec3& reference_normal, std::vector<char>& mark) {
  if (reference_normal.isZero()) return std::nullopt;
  std::vector<int> neighbors;
  for (int rings = 2; rings <= 5 && neighbors.size() < 18; ++rings) side.k_ring(i, rings, neighbors, mark);
  const Eigen::Index m = static_cast<Eigen::Index>(neighbors.size());
  const int columns = m >= 14 ? 9 : 5;
  if (m < columns + 1) return std::nullopt;

  const Vec3 e1 = reference_normal.unitOrthogonal(), e2 = reference_normal.cross(e1);
  double mean = 0;
  for (int j : neighbors) mean += (points[j] - points[i]).norm() / static_cast<double>(m);
  if (!(mean > 0)) return std::nullopt;
  Eigen::MatrixXd A(m, columns);
  Eigen::VectorXd height(m);
  for (Eigen::Index k = 0; k < m; ++k) {
    const Vec3 d = (points[neighbors[k]] - points[i]) / mean;
    const double u = d.dot(e1), v = d.dot(e2), weight = 1 / (0.1 + d.norm());
    A.row(k).head<5>() << u, v, u * u / 2, u * v, v * v / 2;
    if (columns == 9) A.row(k).tail<4>() << u * u * u, u * u * v, u * v * v, v * v * v;
    A.row(k) *= weight;
    height[k] = weight * d.dot(reference_normal);
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A);
  qr.setThreshold(1e-6);
  if (qr.rank() < columns) return std::nullopt;
  const Eigen::VectorXd c = qr.solve(height);
  const double fu = c[0], fv = c[1], fuu = c[2], fuv = c[3], fvv = c[4];
  const double w2 = 1 + fu * fu + fv * fv;
  OneSidedFit fit;
  fit.normal = (reference_normal - fu * e1 - fv * e2).normalized();
  fit.H = ((1 + fv * fv) * fuu - 2 * fu * fv * fuv + (1 + fu * fu) * fvv) / (2 * w2 * std::sqrt(w2)) / mean;
  return std::isfinite(fit.H) ? std::optional(fit) : std::nullopt;
}

}  // namespace loopmend
