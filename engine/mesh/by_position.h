// SPDX-License-Identifier: GPL-3.0-or-later
// An order of points that does not depend on how a file numbers them, and points in exactly the same position.
#pragma once

#include "core/types.h"

#include <algorithm>

namespace loopmend {

/// The lexicographic order of coordinates.
inline bool precedes(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/// The triangles, each from its first corner by position on, in an order that does not depend on their numbers.
Triangles sorted_by_position(const Points& points, Triangles triangles);

/// For each of `points` the number of its position among the distinct positions of `places`, in lexicographic order; −1
/// where no place has that position. Fast for many points and few places.
std::vector<int> position_numbers(const Points& points, const Points& places);

}  // namespace loopmend
