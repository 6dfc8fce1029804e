// Relaxation of a filler by one sparse solve.
#pragma once

#include "core/types.h"

namespace loopmend {

/// Minimises the area to second order about the given shape (cotan Laplace equation, weights clamped), with vertices
/// 0..locked−1 fixed: one step of Pinkall and Polthier. Returns the new positions, or the old ones if the solve fails.
Points minimal_surface_step(const Points& points, const Triangles& triangles, int locked);

}  // namespace loopmend
