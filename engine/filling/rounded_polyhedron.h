// SPDX-License-Identifier: GPL-3.0-or-later
// A start for point interpolation that is round from the first: flat faces and their creases are far from any smooth surface.
#pragma once

#include "filling/subdivide_polyhedron.h"

#include <optional>

namespace loopmend {

/// The subdivided faces projected onto the sphere that fits the fixed vertices best, their vertices spread evenly there, and
/// the whole then bent so that it goes through the fixed vertices. For four vertices, or any on one sphere, that is it.
/// @returns the patch with these positions; nothing where a projection from the polyhedron's middle does not exist.
std::optional<Patch> rounded_polyhedron(const PolyhedronPatch& polyhedron);

}  // namespace loopmend
