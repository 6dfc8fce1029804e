// SPDX-License-Identifier: GPL-3.0-or-later
// How far a patch is likely from what was there, estimated from its distance to a fairing of second order and from the bends at
// its seam (docs/math/filling.md, "Validity checks").
#pragma once

#include "analysis/seam_report.h"
#include "core/cancel.h"
#include "mesh/patch.h"

#include <array>
#include <limits>
#include <vector>

namespace loopmend {

/// Of the part of a patch that one loop bounds: what the estimate rests on.
struct DeviationPredictors {
  double second_order = 0;      ///< rms difference from the least ∫‖Δr‖² on the same triangles, loop diameters
  double area = 0;              ///< diameters²
  double seam_deg = 0;          ///< SeamReport::g1_rms_deg
  double initial_seam_deg = 0;  ///< the same of the initial patch
};

/// Rms distance of the new vertices that one loop bounds, weighted by area, from the surface that was there, mesh units: bounds
/// that held for 50, 80 and 90 % of the holes of the calibration. NaN without an estimate: no free vertices, another
/// treatment of the boundary than the default, or a seam that is too short to be measured.
struct ExpectedDeviation {
  double half = std::numeric_limits<double>::quiet_NaN();
  double likely = std::numeric_limits<double>::quiet_NaN();
  double most = std::numeric_limits<double>::quiet_NaN();
  DeviationPredictors predictors;

  bool is_known() const { return likely >= 0; }
};

struct DeviationEstimate {
  std::vector<ExpectedDeviation> loops;  ///< one for each loop of the patch; empty without an estimate
  std::vector<double> vertices;          ///< of each free vertex, mesh units: their rms, weighted by area, is `likely`
};

/// A linear fairing of the patch's own triangles, and the calibration.
/// @param seams, initial_seams  of the patch and of the initial patch, one for each loop.
DeviationEstimate expected_deviation(const Patch& patch, const std::vector<SeamReport>& seams,
                                     const std::vector<SeamReport>& initial_seams, const CancelToken& cancel = {});

/// The calibration alone. @returns bounds in loop diameters.
ExpectedDeviation expected_deviation(const DeviationPredictors& predictors);

/// Regressors of the calibration, the first of them 1.
std::array<double, 5> regressors(const DeviationPredictors& predictors);

}  // namespace loopmend
