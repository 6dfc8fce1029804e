// SPDX-License-Identifier: GPL-3.0-or-later
// What single precision makes of coordinates. Functions in a file of their own: where GCC 12.2 sees two neighbouring
// doubles turned into floats and stored as doubles again, it leaves them as they are (-O2, -ftree-slp-vectorize).
#pragma once

#include "core/types.h"

namespace loopmend {

/// The nearest float, as a double; infinite beyond the range.
double as_float(double value);
Vec3 as_floats(const Vec3& point);
/// Whether floats hold all coordinates.
bool holds_as_floats(const Points& points);

}  // namespace loopmend
