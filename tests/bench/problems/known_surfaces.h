// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces whose every point is known: as a mesh, and as the nearest point to any place. Lengths in the surface's own unit.
#pragma once

#include "mesh/triangle_soup.h"

#include <functional>
#include <string>

namespace loopmend::bench {

/// What a mesh is made of: equal triangles, moved vertices, or moved vertices and valences 4 to 9.
enum class MeshKind { regular, jittered, irregular };

const char* to_string(MeshKind kind);

struct KnownSurface {
  std::string name;
  TriangleSoup mesh;                         ///< regular, outward normals
  std::function<Vec3(const Vec3&)> project;  ///< nearest point of the surface; exact to rounding, for places near it

  double distance(const Vec3& p) const { return (p - project(p)).norm(); }
};

/// Unit sphere: an icosahedron with every edge in `frequency` ≥ 1 parts, 10·frequency² + 2 vertices.
KnownSurface known_sphere(int frequency);
/// Radius 1 about z, −height/2 ≤ z ≤ height/2. @param around  vertices on a circle, ≥ 8.
KnownSurface known_cylinder(double height, int around);
/// Radii 1 and `minor` < 1. @param around  vertices around the axis, ≥ 8.
KnownSurface known_torus(double minor, int around);
/// Half axes along x, y, z.
KnownSurface known_ellipsoid(const Vec3& half_axes, int frequency);
/// z = 0.3 sin 2x cos 1.5y + 0.1x² over [−1, 1]², normals up. @param cells  quads along a side.
KnownSurface known_graph(int cells);
/// H = 0, waist 1, arc length −half_length..half_length along its profile. @param around  vertices on a circle.
KnownSurface known_catenoid(double half_length, int around);
/// Delaunay's unduloid with |H| = 1/2 and radii 1 ± bulge: Kenmotsu's arc-length form, arc length 0 (mean radius, between
/// neck at −π/2 and bulge at π/2) in the middle, −half_length..half_length.
KnownSurface known_unduloid(double bulge, double half_length, int around);

/// The cylinder over mvc_profile({0.8, 1.2, -1.5, -0.8}, 1.1), arc length and height −1..1: an exact solution of the paper's
/// equation whose H is not constant. @param cells  quads along a side.
KnownSurface known_mvc_cylinder(int cells);
/// z = the sum of four waves over [−1, 1]², their heights and wave vectors drawn by `seed`, normals up.
KnownSurface known_sheet(unsigned seed, int cells);

/// The surface's mesh made irregular; the vertices stay on the surface.
KnownSurface with_mesh(KnownSurface surface, MeshKind kind, unsigned seed);

/// Keeps what lies within `radius` of `center`: only the neighborhood of a hole matter to its filling.
KnownSurface cropped(KnownSurface surface, const Vec3& center, double radius);

}  // namespace loopmend::bench
