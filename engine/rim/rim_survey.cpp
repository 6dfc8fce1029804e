// SPDX-License-Identifier: GPL-3.0-or-later
#include "rim/rim_survey.h"

namespace loopmend {

RimSurvey survey_rim(const Patch& patch) { return {fit_surroundings(patch), stray_distances(patch), rim_fits(patch)}; }

}  // namespace loopmend
