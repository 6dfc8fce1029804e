// SPDX-License-Identifier: GPL-3.0-or-later
// Matches two boundaries that lie beside each other all along, as the sides of a gap round a whole body do.
#pragma once

#include "core/types.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace loopmend {

/// With the pairs made one vertex each and the edges cut at the vertices on them, both boundaries are closed.
struct ZippedBoundaries {
  std::vector<std::pair<int, int>> pairs;  ///< a vertex of either boundary
  /// By the ends of an edge, as its boundary runs: vertices of the other boundary on it, in their order.
  std::map<std::pair<int, int>, std::vector<int>> on_edges;
};

/// The largest distance of a vertex of either boundary from the other one's edges, mesh units.
double distance_all_along(const Points& points, const std::vector<int>& a, const std::vector<int>& b);

/// The match that moves the vertices least (sum of squares). Empty where a boundary has more than a few thousand vertices, or one has
/// many more than the other.
/// @param a, b  vertices as the boundaries run, each once: opposite ways where the surfaces on both sides agree
std::optional<ZippedBoundaries> zip_boundaries(const Points& points, const std::vector<int>& a,
                                               const std::vector<int>& b);

}  // namespace loopmend
