// SPDX-License-Identifier: GPL-3.0-or-later
// A symmetric matrix near the Jacobian of each flow, to precondition its step with.
#pragma once

#include "flows/flow_kind.h"
#include "mesh/patch.h"
#include "operators/operator_set.h"

namespace loopmend {

/// K, n by n, lower triangle, positive semi-definite, with K ≈ −M V': what the step of the flow would be if it descended its
/// energy exactly. MMCVF 2 Bᵀ C B and SDF, WF 2 Bᵀ M B with B = ∂H/∂s, MCF ½ C; C the cotan stiffness matrix, M the mass.
/// GMRES on M(I − τJ) with the Cholesky factors of M + τK takes some 20 iterations, for any τ and mesh size measured.
SparseMatrix symmetric_part(FlowKind flow, const Patch& patch, const OperatorSet& ops);

}  // namespace loopmend
