// SPDX-License-Identifier: GPL-3.0-or-later
// An estimate of how long work will still take, from the share of it that is done.
#pragma once

#include "mesh/boundary_loops.h"

#include <optional>

namespace loopmend {

/// About how much work a hole is, in no unit: a patch has as many vertices as its boundary has edges, squared, and some work does
/// not depend on the size.
double work_of(const BoundaryLoop& loop);

/// No estimate in the first three seconds, before a twentieth is done, and at the end.
/// @param seconds  since the work began
/// @param share    of the work that is done, 0..1
std::optional<double> seconds_left(double seconds, double share);

}  // namespace loopmend
