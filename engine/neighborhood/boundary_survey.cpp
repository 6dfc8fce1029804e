// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighborhood/boundary_survey.h"

namespace loopmend {

BoundarySurvey survey_boundary(const Patch& patch, const CancelToken& cancel,
                               const std::optional<SplitEstimate>& split) {
  return {split ? *split : estimate_split(patch, cancel), boundary_fits(patch, FixedSurface(patch))};
}

}  // namespace loopmend
