// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs of the paper's section 5, made by our own code; sizes as near to Table 5.1 as the meshes allow.
#pragma once

#include "mesh/triangle_soup.h"

#include <vector>

namespace loopmend {

/// Open tube of circular section, outward normals, first boundary at `start`.
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

/// Fig. 5.1(a): a unit cylinder about z, 0 ≤ z ≤ 6, with three round parts missing. 1160 free vertices in the paper.
TriangleSoup make_pierced_cylinder();

/// Fig. 5.1(d): what the three coordinate planes leave of a unit sphere, a wire-frame with eight openings. 3720.
TriangleSoup make_sphere_wireframe();

/// Fig. 5.2(a), (d), (g): tubes that leave the origin along +x, +y, +z (1074); along all six half-axes (1470); and a T
/// (800). What the paper blended is only in its pictures: these are our reading of them.
std::vector<TubeShape> three_tubes();
std::vector<TubeShape> six_tubes(int around = 50);
std::vector<TubeShape> tee_tubes();

/// Fig. 5.3(a): a head-like closed surface with holes in nose, face and jaw. 432.
TriangleSoup make_holed_head();

/// Fig. 5.4(a): a dodecahedron in the unit sphere; each pentagon as three triangles.
TriangleSoup make_dodecahedron();

/// Fig. 5.6: g(x, y) over [−1, 1]² on 60 × 60 cells. The paper prints e(u,v) = exp[−81/16 (u−½)² + (v−½)²], which grows
/// without bound; here the bracket is closed around both squares.
double bumps_height(double x, double y);
TriangleSoup make_bumps();
inline constexpr double bumps_threshold = 0.725;  ///< g > 1.5 is empty; this one frees the paper's 840 vertices

}  // namespace loopmend
