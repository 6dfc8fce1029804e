// SPDX-License-Identifier: GPL-3.0-or-later
// All fits to the neighborhood of a patch: they do not depend on what fills the loops, and can be made beside it.
#pragma once

#include "neighborhood/boundary_fits.h"
#include "split/split_estimate.h"

#include <optional>

namespace loopmend {

struct BoundarySurvey {
  SplitEstimate split;
  std::vector<std::vector<BoundaryFit>> loops;  ///< of Patch::loops
};

/// @param patch  its free vertices and own triangles are not looked at: there need not be any. The survey of a patch is that
/// of every patch with the same loops, to the last bit. @param split  of the patch, where it is known.
BoundarySurvey survey_boundary(const Patch& patch, const CancelToken& cancel = {},
                               const std::optional<SplitEstimate>& split = std::nullopt);

}  // namespace loopmend
