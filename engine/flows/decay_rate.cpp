// SPDX-License-Identifier: GPL-3.0-or-later
#include "flows/decay_rate.h"

#include "operators/congruence.h"
#include "operators/curvature_energy.h"
#include "operators/operator_set.h"
#include "solvers/linear_solver.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loopmend {

SparseMatrix clamped_polyharmonic(FlowKind flow, const Patch& patch) {
  int inner = patch.free_count;
  while (inner < patch.vertex_count() && patch.ring[inner] == 1) ++inner;
  std::vector<int> faces;  // that have a corner on the free vertices or the loop
  for (std::size_t f = 0; f < patch.triangles.size(); ++f)
    if (std::ranges::min(patch.triangles[f]) < inner) faces.push_back(static_cast<int>(f));
  const int n = patch.free_count;
  const SparseMatrix C = clamped_cotan_stiffness(patch.positions, patch.triangles, faces, robust_clamp);
  if (flow == FlowKind::mcf) return C.topLeftCorner(n, n).triangularView<Eigen::Lower>();
  // The Laplacian of the inner factors is taken on the free vertices and the loop.
  const Eigen::VectorXd inverse = barycentric_areas(patch.positions, patch.triangles).head(inner).cwiseInverse();
  const RowSparseMatrix C10 = C.topLeftCorner(inner, n);
  if (flow != FlowKind::mmcvf) return lower_congruence(C10, SparseMatrix(inverse.asDiagonal()));
  return lower_congruence(inverse.asDiagonal() * C10, C.topLeftCorner(inner, inner));
}

double slowest_decay_rate(FlowKind flow, const Patch& patch, const CancelToken& cancel) {
  const auto factors_of_K = make_spd_solver();
  if (!factors_of_K->factorize(clamped_polyharmonic(flow, patch), cancel)) return 0;
  const Eigen::VectorXd mass = barycentric_areas(patch.positions, patch.triangles).head(patch.free_count);
  Eigen::VectorXd x = Eigen::VectorXd::Ones(mass.size());
  double rate = 0;
  for (int iteration = 0; iteration < 30; ++iteration) {
    if (cancel.cancelled()) return 0;
    x /= std::sqrt(x.dot(mass.cwiseProduct(x)));
    Eigen::MatrixXd next;
    if (!factors_of_K->solve(mass.cwiseProduct(x), next)) return 0;
    const double growth = x.dot(mass.cwiseProduct(next.col(0)));
    if (!(growth > 0)) return 0;
    const double previous = rate;
    rate = 0.5 / growth;
    x = next.col(0);
    if (std::abs(rate - previous) < 1e-4 * rate) break;
  }
  return rate;
}

double rough_decay_rate(FlowKind flow, const Patch& patch) {
  double boundary = 0;
  for (const std::vector<int>& loop : patch.loops)
    for (std::size_t k = 0; k < loop.size(); ++k)
      boundary += (patch.positions[loop[(k + 1) % loop.size()]] - patch.positions[loop[k]]).norm();
  const double area = patch_area(patch), R = std::min(std::sqrt(area / std::numbers::pi), 2 * area / boundary);
  switch (flow) {  // docs/math/energy_to_matrix.md, "Time step": measured on discs
    case FlowKind::mcf: return 0.5 * std::pow(2.41 / R, 2);
    case FlowKind::sdf:
    case FlowKind::wf: return 0.5 * std::pow(3.2 / R, 4);
    case FlowKind::mmcvf: return 0.5 * std::pow(3.9 / R, 6);
  }
  return 0;
}

}  // namespace loopmend
