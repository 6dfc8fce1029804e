// SPDX-License-Identifier: GPL-3.0-or-later
// Edges that a patch must not have. Where it passes a boundary vertex twice, both of its sides may reach the same other vertex: one
// edge for four triangles. Where the surface joins two boundary vertices, an edge of the patch between them would be another.
#pragma once

#include "core/types.h"

#include <set>
#include <utility>

namespace loopmend {

/// Splits edges between two triangles near their middle. The new vertex lies a quarter of the distance to the middle of the
/// triangles' other corners off the edge, since another surface has an edge there.
/// @param edges  (a, b), a < b
void split_beside(const std::set<std::pair<int, int>>& edges, Points& points, Triangles& triangles);

/// Splits edges between triangles in their middle until none has its ends in the places of another edge. Those on the boundary
/// stay.
/// @param places  the first so many points are on the boundary; only they may lie in one place. No work where none do.
void split_double_edges(int places, Points& points, Triangles& triangles);

}  // namespace loopmend
