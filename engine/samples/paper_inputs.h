// The inputs of the paper's section 5, made by our own code; sizes as near to Table 5.1 as the meshes allow.
#pragma once

#include "mesh/triangle_soup.h"

#include <vector>

namespace loopmend {

/// Open tube of circular section, outward normals, first rim at `start`.
/// @param direction  unit: the tube runs that way for `length`.
/// @param around     vertices on a circle, ≥ 8; the spacing along the tube follows it.
struct TubeShape {
  Vec3 start = Vec3::Zero();
  Vec3 direction = Vec3::UnitX();
  double radius = 1;  ///< > 0
  double length = 2;  ///< > 0
  int around = 24;
};
TriangleSoup make_tube(const TubeShape& shape);

/// All in one list, in order. Colours are dropped.
TriangleSoup joined(const std::vector<TriangleSoup>& parts);

}  // namespace loopmend
