// SPDX-License-Identifier: GPL-3.0-or-later
#include "flows/symmetric_part.h"

#include "core/threads.h"
#include "operators/congruence.h"
#include "operators/curvature_energy.h"

#include <numeric>

namespace loopmend {

SparseMatrix symmetric_part(FlowKind flow, const Patch& patch, const OperatorSet& ops) {
  const int n = patch.free_count;
  if (flow == FlowKind::mcf) {
    std::vector<int> faces(patch.triangles.size());
    std::iota(faces.begin(), faces.end(), 0);
    const SparseMatrix C = clamped_cotan_stiffness(patch.positions, patch.triangles, faces, robust_clamp);
    return 0.5 * C.topLeftCorner(n, n).triangularView<Eigen::Lower>();
  }
  const EnergyWeights weights = flow == FlowKind::mmcvf ? EnergyWeights{1, 0} : EnergyWeights{0, 1};
  SparseMatrix Q;
  RowSparseMatrix B;
  parallel_invoke([&] { Q = 2 * curvature_energy(patch, ops, weights).Q; }, [&] { B = curvature_jacobian(ops, n); });
  return lower_congruence(B, Q);
}

}  // namespace loopmend
