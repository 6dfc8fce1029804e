// SPDX-License-Identifier: GPL-3.0-or-later
// The seam in numbers: do tangent and curvature run through it? The position does by construction: a patch has no boundary
// vertices of its own, it joins those of the boundary loop.
#pragma once

#include "mesh/patch.h"

#include <vector>

namespace loopmend {

/// At the vertices of a loop, from one-sided fits: inside (the patch) against outside (the neighborhood). Mesh units.
/// NaN where no vertex of the loop has enough triangles on both sides.
struct SeamReport {
  double g1_rms_deg = 0;  ///< angle between the one-sided normals
  double g1_max_deg = 0;
  double h_jump_rms = 0;  ///< |H_in − H_out|, 1/length
  double h_jump_max = 0;
  double h_jump_rms_times_diameter = 0;  ///< the same without a unit: times the loop's diameter

  bool operator==(const SeamReport&) const = default;
};

/// One report for each loop of the patch.
std::vector<SeamReport> seam_reports(const Patch& patch);

/// @param loop  which of patch.loops, 0-based.
/// @throws InvalidArgument if there is no such loop.
SeamReport seam_report(const Patch& patch, int loop);

}  // namespace loopmend
