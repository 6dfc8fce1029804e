// SPDX-License-Identifier: GPL-3.0-or-later
#include "rim/rim_survey.h"

namespace loopmend {

RimSurvey survey_rim(const Patch& patch, const CancelToken& cancel) {
  return {estimate_split(patch, cancel), rim_fits(patch, FixedSurface(patch))};
}

}  // namespace loopmend
