// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/single_precision.h"

#include <algorithm>

namespace loopmend {

double as_float(double value) {
  volatile float narrow = static_cast<float>(value);  // in a register, a pair of them would stay double
  return static_cast<double>(narrow);
}

Vec3 as_floats(const Vec3& point) { return {as_float(point.x()), as_float(point.y()), as_float(point.z())}; }

bool holds_as_floats(const Points& points) {
  return std::all_of(points.begin(), points.end(), [](const Vec3& p) { return as_floats(p) == p; });
}

}  // namespace loopmend
