// SPDX-License-Identifier: GPL-3.0-or-later
// The slowest decay rate of a flow on a patch: the unit in which time steps are measured.
#pragma once

#include "core/cancel.h"
#include "flows/flow_kind.h"
#include "mesh/patch.h"
#include "operators/operator_set.h"

namespace loopmend {

/// The lower triangle of K, n by n, symmetric positive definite: the clamped cotan Laplacian to the power 1 (MCF), 2 (SDF,
/// WF) or 3 (MMCVF), patch frame. The flow's linear part is ½M⁻¹K.
SparseMatrix clamped_polyharmonic(FlowKind flow, const Patch& patch);

/// λ₁ > 0, smallest eigenvalue of the flow's linear part on the patch with clamped boundary
/// (docs/math/energy_to_matrix.md, "Time step"): of ½M⁻¹K with K as above. Patch frame, 1/time. A step of τ = σ/λ₁ shrinks the slowest mode by 1/(1+σ). 0 when the eigenvalue could not be found,
/// or when cancelled.
double slowest_decay_rate(FlowKind flow, const Patch& patch, const CancelToken& cancel = {});

/// The same of a flat disc that has the patch's area or, if that makes a smaller one, as much area for its boundary. For MMCVF on
/// a long slit up to (2π/3.9)⁶ = 17 times too small, but it costs nothing.
double rough_decay_rate(FlowKind flow, const Patch& patch);

}  // namespace loopmend
