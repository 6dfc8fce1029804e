// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices that a program for terrains left where it had no height: spikes down to -9999.
#pragma once

#include "core/types.h"

#include <vector>

namespace loopmend {

struct NoDataVertices {
  double value = 0;           ///< the coordinate that marks them
  std::vector<int> vertices;  ///< ascending; empty: there are none
};

/// Points of which one coordinate is exactly a mark for missing data (-9999, -99999, -999999, -32768, -32767 or the lowest number in single
/// precision), farther from all others in that coordinate than these are from one another. Of several marks the one of most points.
NoDataVertices find_no_data(const Points& points);

}  // namespace loopmend
