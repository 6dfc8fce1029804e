// SPDX-License-Identifier: GPL-3.0-or-later
// A comparison of flows in numbers, the same on the command line and in the window.
#pragma once

#include "pipeline/compare.h"

#include <string>
#include <vector>

namespace loopmend {

/// "MCF", "SDF", "WF", "MMCVF".
std::string upper_name(FlowKind flow);

/// Root mean square over the loops of a patch; NaN where there is none.
struct SeamFigures {
  double jump = 0;                 ///< of H, 1/length
  double jump_times_diameter = 0;  ///< without a unit
  double angle = 0;                ///< between the normals, degrees
};
SeamFigures seam_figures(const std::vector<SeamReport>& seams);

/// Heads of the table: name, status, steps, three energies, jumps of H, angle, folds, cuts.
const std::vector<std::string>& comparison_heads();
/// The start, then each flow; cells as in comparison_heads().
std::vector<std::vector<std::string>> comparison_rows(const FlowComparison& comparison);
/// One row. @param wide_jump  NaN where it was not measured.
std::vector<std::string> comparison_row(const std::string& name, const std::string& status, int steps,
                                        const PatchEnergies& energies, const std::vector<SeamReport>& seams,
                                        double wide_jump, const Validity& quality);

std::string comparison_csv(const FlowComparison& comparison);
/// The same from rows that were made elsewhere.
std::string csv_of(const std::vector<std::vector<std::string>>& rows);
/// Markdown, for people: the rows, then why flows stopped early.
std::string comparison_table(const FlowComparison& comparison);
/// flow, distance, H, its standard deviation in the neighborhood (empty in the patch): 17 digits.
std::string profile_csv(const FlowComparison& comparison);

}  // namespace loopmend
