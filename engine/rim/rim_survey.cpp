// SPDX-License-Identifier: GPL-3.0-or-later
#include "rim/rim_survey.h"

namespace loopmend {

RimSurvey survey_rim(const Patch& patch) {
  const FixedSurface around(patch);
  return {fit_surroundings(patch, around), stray_distances(patch, around), rim_fits(patch, around)};
}

}  // namespace loopmend
