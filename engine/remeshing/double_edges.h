// SPDX-License-Identifier: GPL-3.0-or-later
// Where a patch passes a boundary vertex twice, both of its sides may reach the same other vertex: one edge for four triangles.
#pragma once

#include "core/types.h"

namespace loopmend {

/// Splits edges between triangles in their middle until none has its ends in the places of another edge. Those on the boundary
/// stay.
/// @param places  the first so many points are on the boundary; only they may lie in one place. No work where none do.
void split_double_edges(int places, Points& points, Triangles& triangles);

}  // namespace loopmend
