// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces from one sparse solve: as initial patches, and as starts of the flow.
#pragma once

#include "core/cancel.h"
#include "mesh/patch.h"
#include "operators/operator_set.h"

namespace loopmend {

/// Minimises xᵀ A x for each coordinate over the points [begin, end), the others fixed. @param A  #points square, symmetric.
/// @returns false if there is nothing to move, A is not positive definite there, or when cancelled; the points are then as they
/// were.
bool minimise_quadratic_form(const SparseMatrix& A, Points& points, int begin, int end, const CancelToken& cancel = {});

/// Minimises the area to second order about the given shape (cotan Laplace equation, weights clamped), with vertices
/// 0..locked−1 fixed: one step of Pinkall and Polthier. Returns the new positions, or the old ones if the solve fails or is cancelled.
Points minimal_surface_step(const Points& points, const Triangles& triangles, int locked,
                            const CancelToken& cancel = {});

/// Vectors at the fixed vertices extended to the others without bias: each of these gets the mean of its neighbours.
/// @param fixed  #V, not 0 where `vectors` (#V) is given. Where nothing is fixed, the vectors are left as they are.
void extend_evenly(const Triangles& triangles, const std::vector<char>& fixed, Points& vectors);

/// Minimises ∫‖∇Δr‖² + bending ∫‖Δr‖² over the patch for the metric of its present shape (triharmonic, cotan weights clamped), with the
/// fixed rings as data: to first order, curvature runs through the seam.
/// @returns positions of all vertices, fixed ones bit-identical; the present positions if the solve fails or is cancelled.
Points linear_fairing(const Patch& patch, double bending, CotanClamp clamp, const CancelToken& cancel = {});

/// @param topology  of the patch.
Points linear_fairing(const Patch& patch, const Topology& topology, double bending, CotanClamp clamp,
                      const CancelToken& cancel = {});

/// The third order with all weights one: the triangles' shapes do not count, so that pinched necks and slivers of the
/// present shape leave no trace (docs/math/energy_to_matrix.md, "Starts"). @returns as linear_fairing.
Points graph_fairing(const Patch& patch, const CancelToken& cancel = {});

}  // namespace loopmend
