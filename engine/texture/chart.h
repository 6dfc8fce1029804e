// SPDX-License-Identifier: GPL-3.0-or-later
// A piece of surface in the plane.
#pragma once

#include "core/types.h"

#include <optional>
#include <vector>

namespace loopmend {

using Vec2 = Eigen::Vector2d;

/// Least squares conformal map (Lévy, Petitjean, Ray, Maillot 2002): the Dirichlet energy minus the area, with two points
/// held. The first `own` triangles have the same area in the plane as in space.
/// @returns nothing where the map cannot be found or turns one of the first `own` triangles round
std::optional<std::vector<Vec2>> flatten(const Points& points, const Triangles& triangles, std::size_t own);

}  // namespace loopmend
