// SPDX-License-Identifier: GPL-3.0-or-later
// Of several parts, the loops that look at each other: what a person most likely wants to join.
#pragma once

#include "mesh/boundary_loops.h"

#include <span>
#include <vector>

namespace loopmend {

struct FacingPart {
  const SurfaceModel* model = nullptr;  ///< in which the loops' vertices count
  std::span<const BoundaryLoop> loops;
  Vec3 middle = Vec3::Zero();  ///< mean of the part's points
};

/// For each part, which of its loops is nearest to the others and goes on towards them.
/// @throws InvalidArgument where a part has no loop.
std::vector<std::size_t> facing_loops(const std::vector<FacingPart>& parts);

}  // namespace loopmend
