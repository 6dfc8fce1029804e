// SPDX-License-Identifier: GPL-3.0-or-later
// An estimate of how long work will still take, from the share of it that is done.
#pragma once

#include "mesh/boundary_loops.h"
#include "repair/repair_surface.h"

#include <optional>
#include <set>

namespace loopmend {

/// About how much work a hole is, in no unit: a patch has as many vertices as its boundary has edges, squared, and some work does
/// not depend on the size.
double work_of(const BoundaryLoop& loop);

/// Of the time that one hole takes, about this much goes into its initial patch: 0.24 to 0.36 were measured on patches of
/// 9 688 and 85 114 new vertices.
inline constexpr double share_of_initial_patch = 0.3;
/// How many steps, of those to the steady state, are likely still to come: two or three are usual where the solution takes
/// long, up to twelve elsewhere.
double steps_left(int taken);
/// Seconds that a new vertex takes where no patch was made yet: 0.18 to 0.4 ms were measured on two cores.
inline constexpr double seconds_of_a_vertex = 3e-4;

/// How much of repairing these defects, and of measuring the result, is done when the step begins, 0..1.
double share_of_repair(const std::set<Defect>& defects, const RepairStep& step);

/// How much of preparing a scan is done when the stage begins, 0..1; at least `before`, since a survey comes twice.
double share_of_preparing(RepairStage stage, double before);

/// No estimate in the first three seconds, before a twentieth is done, and at the end.
/// @param seconds  since the work began
/// @param share    of the work that is done, 0..1
std::optional<double> seconds_left(double seconds, double share);

/// Less is not worth a line.
inline constexpr double least_seconds_shown = 3;

}  // namespace loopmend
