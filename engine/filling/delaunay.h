// SPDX-License-Identifier: GPL-3.0-or-later
// The Delaunay triangulation of points in space.
#pragma once

#include "core/types.h"

namespace loopmend {

/// @return its faces, corners in ascending order; empty for points on a line. CGAL's order of faces is that of memory.
Triangles delaunay_faces(const Points& points);

/// @return the facets of the convex hull, outwards, each from its least corner on, in ascending order; empty for points in a
/// plane.
Triangles hull_facets(const Points& points);

}  // namespace loopmend
