// SPDX-License-Identifier: GPL-3.0-or-later
// A smooth closed curve through given points: the boundary of a surface that is known at some places only.
#pragma once

#include "core/types.h"

namespace loopmend {

/// The closed curve through the corners whose curvature varies least: the polygon with `pieces` edges of equal length from
/// each corner to the next that minimises the discrete ∫‖(dκ/ds)^⊥‖² ds, κ the curvature vector, ⊥ across the tangent
/// (Moreton & Séquin 1992). Circles have none of it, so corners on a circle give the circle.
/// It is found by Levenberg and Marquardt's method from the periodic cubic spline with centripetal parameters; where that
/// would bulge further than three times the way from corner to corner, the spline itself is the answer.
/// @param corners  m by 3, m ≥ 3, neighbours apart. @param pieces  1..256
/// @returns m · pieces points; number k · pieces is corner k, bit for bit.
/// @throws InvalidArgument for fewer than three corners, neighbours in one place, or pieces out of range.
Points fair_closed_curve(const Points& corners, int pieces);

}  // namespace loopmend
