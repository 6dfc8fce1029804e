#include "flows/decay_rate.h"

#include "operators/operator_set.h"
#include "solvers/linear_solver.h"

#include <cmath>
#include <numeric>

namespace loopmend {

namespace {

/// The Laplacian of the inner factors is taken on the free vertices and the loop.
SparseMatrix power_of_laplacian(FlowKind flow, const SparseMatrix& C, const Eigen::VectorXd& mass, int n, int inner) {
  const SparseMatrix C00 = C.topLeftCorner(n, n);
  if (flow == FlowKind::mcf) return C00;
  const SparseMatrix C10 = C.topLeftCorner(inner, n);
  const Eigen::VectorXd inverse = mass.head(inner).cwiseInverse();
  const SparseMatrix scaled = inverse.asDiagonal() * C10;
  const SparseMatrix transposed = scaled.transpose();
  if (flow != FlowKind::mmcvf) return transposed * C10;
  const SparseMatrix C11 = C.topLeftCorner(inner, inner);
  return transposed * C11 * scaled;
}

}  // namespace

SparseMatrix clamped_polyharmonic(FlowKind flow, const Patch& patch) {
  int inner = patch.free_count;
  while (inner < patch.vertex_count() && patch.ring[inner] == 1) ++inner;
  std::vector<int> faces(patch.triangles.size());
  std::iota(faces.begin(), faces.end(), 0);
  const SparseMatrix C = clamped_cotan_stiffness(patch.positions, patch.triangles, faces, robust_clamp);
  return power_of_laplacian(flow, C, barycentric_areas(patch.positions, patch.triangles), patch.free_count, inner);
}

double slowest_decay_rate(FlowKind flow, const Patch& patch) {
  const SparseMatrix K = clamped_polyharmonic(flow, patch);
  const Eigen::Index n = K.rows();
  const auto solver = make_spd_solver();
  if (!solver->factorize(K)) return 0;
  const Eigen::VectorXd M = barycentric_areas(patch.positions, patch.triangles).head(n);
  Eigen::VectorXd x = Eigen::VectorXd::Ones(n);
  double rate = 0;
  for (int iteration = 0; iteration < 30; ++iteration) {
    x /= std::sqrt(x.dot(M.cwiseProduct(x)));
    Eigen::MatrixXd next;
    if (!solver->solve(M.cwiseProduct(x), next)) return 0;
    const double growth = x.dot(M.cwiseProduct(next.col(0)));
    if (!(growth > 0)) return 0;
    const double previous = rate;
    rate = 0.5 / growth;
    x = next.col(0);
    if (std::abs(rate - previous) < 1e-4 * rate) break;
  }
  return rate;
}

}  // namespace loopmend
