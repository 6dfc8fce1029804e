// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of surfaces whose answer is known, for the paper's figures, tests and benches.
#pragma once

#include "mesh/triangle_soup.h"

#include <functional>

namespace loopmend {

/// Unit sphere from an icosahedron split `level` times (0..8): 10·4^level + 2 vertices, outward normals.
TriangleSoup make_icosphere(int level);

/// Cylinder of radius 1 about z, 0 ≤ z ≤ height, open at both ends, outward normals. Alternating diagonals.
/// @param around  vertices on a circle, ≥ 8; the spacing along z follows it.
TriangleSoup make_cylinder(double height, int around);

/// Surface of revolution about z for z0 ≤ z ≤ z1, open at both ends, outward normals, rows evenly spaced in z.
/// A catenoid has radius cosh z (H = 0 everywhere).
/// @param radius  > 0 on the whole interval.
/// @param around  vertices on a circle, ≥ 8.
/// @param rows    strips of quads along z, ≥ 1.
TriangleSoup make_revolution(const std::function<double(double)>& radius, double z0, double z1, int around, int rows);

/// Torus about z with radii `major` > `minor`, outward normals: around_major·around_minor vertices, each count ≥ 3.
TriangleSoup make_torus(double major, double minor, int around_major, int around_minor);

/// Graph z = height(x, y) over the square [−half, half]², normals up: (cells + 1)² vertices.
/// @param cells  quads along a side, ≥ 1.
TriangleSoup make_graph(const std::function<double(double, double)>& height, double half, int cells);

/// Removes every triangle that has a corner for which `inside` holds, and the points that are then unused, so that the
/// boundary is as regular as the mesh allows. The order of what stays is kept.
TriangleSoup cut(const TriangleSoup& soup, const std::function<bool(const Vec3&)>& inside);

/// Removes triangles that hang on the rest by one edge or one vertex only, until every boundary vertex lies on exactly
/// one loop and no triangle has two boundary edges; then the unused points. The order of what stays is kept.
/// @param soup  edge-manifold and consistently oriented.
TriangleSoup trim_boundaries(const TriangleSoup& soup);

}  // namespace loopmend
