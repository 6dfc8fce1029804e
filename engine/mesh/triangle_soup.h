// SPDX-License-Identifier: GPL-3.0-or-later
// A surface as a file holds it: points and triangles by index. This is what is read, and what is written back.
#pragma once

#include "core/types.h"

namespace loopmend {

/// Points may be unreferenced; triangles may be non-manifold or disagree in orientation. Indices are always in range
/// and coordinates finite (the readers see to that).
struct TriangleSoup {
  Points points;              ///< #V, mesh units
  Triangles triangles;        ///< #F
  std::vector<Color> colors;  ///< #V, or empty when the file had no vertex colours
};

/// Adds the points and triangles of `part`; where only one of the two has colours, the other's points become white.
void append(TriangleSoup& all, const TriangleSoup& part);
/// One soup from several, in their order, as append() does it.
TriangleSoup joined(std::vector<TriangleSoup> parts);

}  // namespace loopmend
