// SPDX-License-Identifier: GPL-3.0-or-later
// Point interpolation from end to end. What `loopmend interpolate` calls.
#pragma once

#include "core/message.h"
#include "filling/subdivide_polyhedron.h"
#include "pipeline/patch_result.h"

namespace loopmend {

struct Interpolation {
  TriangleSoup initial;  ///< the subdivided polyhedron: the paper's initial surface
  TriangleSoup surface;  ///< fixed vertices first (see PolyhedronPatch::fixed), then the new ones
  int fixed_count = 0;
  PatchResult outcome;  ///< of the finest subdivision; times and steps are sums over all
};

/// Subdivides and evolves from coarse to fine: the shape is found where there are few vertices, and each finer
/// subdivision starts from it. With evolution options empty the surface is the subdivided polyhedron. Boundaries are held, and
/// nothing else is asked there: what the flow then finds meets the natural conditions of ∫‖∇H‖², whose least value a sphere
/// or a cylinder through the boundary has.
/// @throws InvalidArgument as subdivide_polyhedron and Evolution.
Interpolation interpolate_points(const SurfaceModel& polyhedron, const SubdivisionOptions& subdivision,
                                 const std::optional<EvolutionOptions>& evolution, const CancelToken& cancel,
                                 const Evolution::OnStep& on_step = nullptr);

/// Why what was found must not be used; empty when it may.
Message refusal_of(const PatchResult& interpolated);

}  // namespace loopmend
