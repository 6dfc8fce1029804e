// SPDX-License-Identifier: GPL-3.0-or-later
// What single precision makes of coordinates. Functions in a file of their own: where GCC 12.2 sees two neighbouring
// doubles turned into floats and stored as doubles again, it leaves them as they are (-O2, -ftree-slp-vectorize).
#pragma once

#include "core/types.h"

#include <cstddef>

namespace loopmend {

/// The nearest float, as a double; infinite beyond the range.
double as_float(double value);
Vec3 as_floats(const Vec3& point);
/// Whether floats hold all coordinates.
bool holds_as_floats(const Points& points);
/// Whether a decimal number that means this double says no more than the nearest float does: the float, written with as many
/// significant digits, is the same number. So of every number of up to six digits, and of every float written with nine.
bool float_says_all(double value);

struct FloatRounding {
  std::size_t longer = 0;  ///< points with a coordinate of which the float does not say all
  bool in_range = true;    ///< whether every coordinate lies in the range of floats
};
/// Rounds all coordinates to the nearest floats; none where one lies beyond their range.
FloatRounding round_to_floats(Points& points);

/// What becomes of coordinates that a file declares as single precision and writes as text.
enum class FloatText {
  nearest_float,  ///< the float that every reader of floats gets
  all_digits      ///< the double that the digits mean
};

}  // namespace loopmend
