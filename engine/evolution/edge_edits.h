// SPDX-License-Identifier: GPL-3.0-or-later
// What a person says of the sharp edges of holes (docs/math/sharp_edges.md, "By hand").
#pragma once

#include <utility>
#include <vector>

namespace loopmend {

/// Of all holes of a scan. Points of its soup, on the boundary of a hole.
struct EdgeEdits {
  std::vector<std::pair<int, int>> drawn;  ///< both ends of an edge across one hole, whatever the neighborhood shows
  std::vector<int> stopped;                ///< where an edge ends that is not to run on

  bool empty() const { return drawn.empty() && stopped.empty(); }
  bool operator==(const EdgeEdits&) const = default;
};

}  // namespace loopmend
