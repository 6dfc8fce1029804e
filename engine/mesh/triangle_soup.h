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

}  // namespace loopmend
