// SPDX-License-Identifier: GPL-3.0-or-later
// All fits to the neighborhood of a patch: they do not depend on what fills the loops, and can be made beside it.
#pragma once

#include "rim/rim_fits.h"
#include "split/split_estimate.h"

namespace loopmend {

struct RimSurvey {
  SplitEstimate split;
  std::vector<std::vector<RimFit>> loops;  ///< of Patch::loops
};

/// @param patch  its free vertices and own triangles are not looked at: there need not be any. The survey of a patch is that
/// of every patch with the same loops, to the last bit.
RimSurvey survey_rim(const Patch& patch, const CancelToken& cancel = {});

}  // namespace loopmend
