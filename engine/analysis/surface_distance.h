// SPDX-License-Identifier: GPL-3.0-or-later
// How far points lie from a surface, with a sign.
#pragma once

#include "core/cancel.h"
#include "mesh/surface_tree.h"
#include "mesh/triangle_soup.h"

#include <vector>

namespace loopmend {

/// Distance of each point from the closest place of the surface, positive on the side where the normal of the triangle there looks.
/// Where that place is on an edge, either of its triangles may decide the sign.
/// @param tree  of the surface's triangles
/// @returns NaN for every point where no triangle has an area; nothing of use when cancelled.
std::vector<double> signed_distances(const Points& points, const TriangleSoup& surface, const SurfaceTree& tree,
                                     const CancelToken& cancel = {});

/// Of signed distances, without those that are NaN; all 0 where there is none.
struct DistanceSummary {
  std::size_t count = 0;
  double mean = 0, rms = 0;
  double nearly_all = 0;  ///< 95 % are no larger, without their sign
  double largest = 0;     ///< without its sign
};
DistanceSummary summary_of(const std::vector<double>& distances);

}  // namespace loopmend
