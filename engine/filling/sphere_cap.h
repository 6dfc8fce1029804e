// SPDX-License-Identifier: GPL-3.0-or-later
// The missing part of a sphere, where the surface around a hole lies on one.
#pragma once

#include "core/cancel.h"
#include "mesh/boundary_loops.h"
#include "mesh/patch.h"

#include <optional>

namespace loopmend {

struct Sphere {
  Vec3 center = Vec3::Zero();
  double radius = 0;
};

/// On which all fixed vertices of a patch lie, to 1e-4 of its radius, patch frame. Nothing where none does, where edges
/// are too long to tell a sphere from a prism (0.7 radii), and where the vertices lie on other quadrics, too, as those of
/// one row of a wall do on two planes.
std::optional<Sphere> sphere_around(const Patch& patch);

/// Largest distance of a free vertex from the sphere, in its radius.
double distance_from(const Sphere& sphere, const Patch& patch);

/// The patch of one loop on the sphere: the loop unrolled from the middle of the missing part (distances from there are
/// kept), filled in the plane, put back, and remeshed.
/// @param initial  a patch of the loop
/// @returns nothing where the loop crosses itself when unrolled, or when cancelled.
std::optional<Patch> sphere_cap(const SurfaceModel& model, const BoundaryLoop& loop, const Patch& initial,
                                const Sphere& sphere, const CancelToken& cancel);

}  // namespace loopmend
