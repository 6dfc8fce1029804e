// SPDX-License-Identifier: GPL-3.0-or-later
// The largest distance between two of many points.
#pragma once

#include "core/types.h"

namespace loopmend {

/// To the last bit what comparing all pairs gives, 0 for fewer than two points. Pairs of boxes that cannot hold a larger
/// distance than one that was found are left out: on a curve the work grows about as n log n, where all pairs are n².
double diameter_of(const Points& points);

}  // namespace loopmend
