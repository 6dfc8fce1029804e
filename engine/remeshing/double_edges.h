// SPDX-License-Identifier: GPL-3.0-or-later
// Where a patch passes a boundary vertex twice, both of its sides may reach the same other vertex: one edge for four triangles.
#pragma once

#include "core/types.h"

#include <vector>

namespace loopmend {

/// Splits edges in their middle until no two edges, seen with each place replaced by its vertex, have the same ends.
/// @param vertex  for each of the first points, its places, the first place of the same vertex. No work where none is repeated.
void split_double_edges(const std::vector<int>& vertex, Points& points, Triangles& triangles);

}  // namespace loopmend
