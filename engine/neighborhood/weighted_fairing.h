// SPDX-License-Identifier: GPL-3.0-or-later
// The patch for rough neighborhood: linear fairing of blended order that believes each boundary vertex as far as it deserves.
#pragma once

#include "core/cancel.h"
#include "mesh/patch.h"
#include "neighborhood/boundary_fits.h"

#include <Eigen/Core>

#include <vector>

namespace loopmend {

/// What runs through the seam.
enum class SeamContinuity {
  position,   ///< the patch meets the loop, no more: a minimal surface
  tangent,    ///< and its tangent planes: least ∫‖Δr‖²
  curvature,  ///< and its curvature: the order blend
};

/// How well the neighborhood knows its own curvature, 0..1, one value for each fixed vertex, in their order: 1 everywhere
/// but on ring 1, where it is 1 / (1 + (σ_H R / 2)²) with σ_H of the vertex's BoundaryFit, and on ring 2, which takes the mean of
/// its neighbours of ring 1: a curvature that is known no better than to that of a ball as wide as the hole counts half.
/// @param fits  boundary_fits() of the patch
Eigen::VectorXd data_confidence(const Patch& patch, double radius, const std::vector<std::vector<BoundaryFit>>& fits);
Eigen::VectorXd data_confidence(const Patch& patch, double radius);

/// Confidence in each vertex, 0..1, #V: 1 everywhere but on rings 1 and 2, where it is the lesser of the vertex's `data` and
/// min(1, (T / |Δr|)²) with 1/T = 1/(8 m) + R/8, m the median of |Δr| along the two rings, R the patch's radius: what is
/// bent much more than its neighbours, or than anything that could run through the hole, counts little.
/// @param data  of data_confidence.
Eigen::VectorXd confidence_weights(const Patch& patch, double radius, const Eigen::VectorXd& data);

/// αR² of the order blend in a rough neighborhood. Measured: 0, 10 and 30 differ by 2 %.
inline constexpr double rough_bending = 10;

/// One fairing for the metric of the present shape: minimises ∫ w ‖∇Δr‖² + α ∫ w ‖Δr‖² with α = rough_bending / R² and
/// w = confidence (a triangle takes that of its worst corner); for `tangent` ∫ ‖Δr‖², for `position` ∫ ‖∇r‖² alone.
/// @returns false if the system could not be solved, or when cancelled; the patch is then as it was.
bool blend_once(Patch& patch, SeamContinuity continuity, const Eigen::VectorXd& confidence, double radius,
                const CancelToken& cancel = {});

}  // namespace loopmend
