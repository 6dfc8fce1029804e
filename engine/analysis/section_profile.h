// SPDX-License-Identifier: GPL-3.0-or-later
// A plane cut across a patch and its neighborhood: how a quantity runs through the seam.
#pragma once

#include "mesh/patch.h"

#include <array>
#include <span>
#include <vector>

namespace loopmend {

/// Samples in the order of the cut. Mesh units.
struct SectionProfile {
  enum class Side : char { neighborhood, patch };
  std::vector<double> arc;    ///< #samples, length along the cut; 0 in the middle of the part inside the patch
  std::vector<double> value;  ///< #samples, interpolated along the cut edges
  std::vector<Side> side;     ///< #samples, a sample on the seam belongs to the patch
  Points path;                ///< #samples
  std::vector<std::array<int, 2>> edge;  ///< #samples, the vertices of the patch between which the sample lies
  std::vector<double> weight;            ///< #samples, in [0, 1], of the second of them
};

/// Cuts along the axis of a loop, in the direction that `angle` names within the loop's plane.
/// @param loop    which of patch.loops, 0-based.
/// @param angle   radians; 0 is the loop's longest direction.
/// @param values  #V of the patch, e.g. H.
/// @returns the connected part of the cut that runs longest through the patch; empty when the plane misses it.
/// @throws InvalidArgument if there is no such loop or the sizes disagree.
SectionProfile section_profile(const Patch& patch, int loop, double angle, std::span<const float> values);

}  // namespace loopmend
