// SPDX-License-Identifier: GPL-3.0-or-later
// How far a patch is likely from what was there, estimated from its distance to a fairing of second order
// (docs/math/filling.md, "Validity checks").
#pragma once

#include "core/cancel.h"
#include "mesh/patch.h"

#include <limits>
#include <vector>

namespace loopmend {

/// Rms distance of the part of a patch that one loop bounds from the surface that was there, mesh units: bounds that held for
/// 50, 80 and 90 % of the holes of the calibration. NaN without an estimate: no free vertices, or another treatment of the
/// boundary than the default.
struct ExpectedDeviation {
  double half = std::numeric_limits<double>::quiet_NaN();
  double likely = std::numeric_limits<double>::quiet_NaN();
  double most = std::numeric_limits<double>::quiet_NaN();
  double second_order = 0;  ///< rms difference from the least ∫‖Δr‖² on the same triangles, in loop diameters

  bool is_known() const { return likely >= 0; }
};

struct DeviationEstimate {
  std::vector<ExpectedDeviation> loops;  ///< one for each loop of the patch; empty without an estimate
  std::vector<double> vertices;          ///< of each free vertex, mesh units: the rms over a loop's part is `likely`
};

/// A linear fairing of the patch's own triangles, and the calibration.
DeviationEstimate expected_deviation(const Patch& patch, const CancelToken& cancel = {});

/// The calibration alone. @param second_order  in loop diameters. @returns bounds in loop diameters.
ExpectedDeviation expected_deviation(double second_order);

}  // namespace loopmend
