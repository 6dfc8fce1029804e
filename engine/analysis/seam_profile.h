// SPDX-License-Identifier: GPL-3.0-or-later
// Mean curvature along a section across a seam, each side by itself, so that a jump shows as a jump (paper Fig. 5.5, 5.6).
#pragma once

#include "mesh/patch.h"

#include <span>
#include <vector>

namespace loopmend {

struct ProfilePoint {
  double distance;  ///< along the section, mesh units: < 0 in the neighborhood, > 0 in the patch, 0 twice at the seam
  double H;         ///< mean curvature from one-sided fits, 1/length; NaN where there is none
  double H_sigma;   ///< its standard deviation in the neighborhood, where it is given; else NaN
};

/// Follows the plane square to one edge of a loop, from its middle both ways, until the triangles or `reach` end.
/// @param loop   which of patch.loops, 0-based.
/// @param edge   from vertex `edge` of that loop to the next.
/// @param reach  mesh units, > 0.
/// @param H_sigma  standard deviation of H at each fixed vertex, in their order, 1/length; or nothing.
/// @returns points by rising distance.
/// @throws InvalidArgument if there is no such loop or edge.
std::vector<ProfilePoint> seam_profile(const Patch& patch, int loop, int edge, double reach,
                                       std::span<const float> H_sigma = {});

/// Root mean square of |H_in − H_out| over all loops, 1/length, from one-sided quadratic fits over three rings. Wider and
/// of lower order than those of SeamReport: they look past the layer of one or two triangles in which a flow of fourth
/// order hides its jump on a coarse mesh, so that this figure does not fall with the triangles' size unless H is
/// continuous.
double wide_curvature_jump(const Patch& patch);

/// |H_in − H_out| at each vertex of a loop, 1/length; NaN where a side is too small.
std::vector<double> seam_jumps(const Patch& patch, int loop);

}  // namespace loopmend
