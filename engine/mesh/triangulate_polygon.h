// SPDX-License-Identifier: GPL-3.0-or-later
// A polygon into triangles.
#pragma once

#include "core/types.h"

#include <span>
#include <vector>

namespace loopmend {

/// Appends size - 2 triangles over the polygon's vertices, oriented like it, in an order that depends on the polygon
/// alone. Quads take the diagonal inside them, the shorter one if both are; larger polygons, also concave ones and ones
/// with a hole cut in along a double edge, a constrained Delaunay triangulation in the plane that fits them best; ones
/// that cross themselves the triangulation of least area (up to 128 corners) or a fan.
/// @param polygon  at least 3 indices into `points`
void triangulate_polygon(const Points& points, std::span<const int> polygon, Triangles& triangles);

/// A constrained Delaunay triangulation of the polygon, seen along the axis to which its area vector is nearest.
/// @return size - 2 triangles over the polygon's vertices, oriented like it, each from its least vertex on, in ascending order;
/// empty where it crosses itself when seen so, or touches itself.
Triangles triangulate_seen_flat(const Points& points, std::span<const int> polygon);

/// The same of what lies between several closed curves: an outline, and curves within it that run round in the other direction.
/// @param curves  each as a polygon above
Triangles triangulate_seen_flat(const Points& points, const std::vector<std::vector<int>>& curves);

}  // namespace loopmend
