// Linear fairing: surfaces from one sparse solve, as fillers and as starts of the flow.
#pragma once

#include "mesh/patch.h"

namespace loopmend {

/// Minimises the area to second order about the given shape (cotan Laplace equation, weights clamped), with vertices
/// 0..locked−1 fixed: one step of Pinkall and Polthier. Returns the new positions, or the old ones if the solve fails.
Points minimal_surface_step(const Points& points, const Triangles& triangles, int locked);

/// What a linear fairing joins the surroundings by.
enum class FairingOrder {
  second = 2,  ///< biharmonic: tangents run through the seam
  third = 3,   ///< triharmonic: curvature runs through the seam, to first order
};

/// Minimises ∫|Δr|² or ∫|∇Δr|² over the patch for the metric of its present shape, with the fixed rings as data.
/// @returns positions of all vertices, fixed ones bit-identical; the present positions if the solve fails.
Points linear_fairing(const Patch& patch, FairingOrder order);

/// The third order with all weights one: the triangles' shapes do not count, so that pinched necks and slivers of the
/// present shape leave no trace (NUMERICS §7). @returns as linear_fairing.
Points graph_fairing(const Patch& patch);

}  // namespace loopmend
