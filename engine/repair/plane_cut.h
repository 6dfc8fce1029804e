// SPDX-License-Identifier: GPL-3.0-or-later
// A surface cut by a plane, and the section closed by plane patches.
#pragma once

#include "mesh/triangle_soup.h"

#include <cstddef>

namespace loopmend {

/// What lies on the side to which the normal points is removed.
struct CutPlane {
  Vec3 point = Vec3::Zero();    ///< mesh units
  Vec3 normal = Vec3::UnitZ();  ///< unit
};

/// @throws InvalidArgument unless the numbers are finite, and the normal is not 0.
CutPlane make_cut_plane(const Vec3& point, const Vec3& normal);

struct PlaneCutCounts {
  std::size_t removed_faces = 0;  ///< that lay wholly on the side of the normal
  std::size_t divided_faces = 0;  ///< of which a part stays
  std::size_t closed = 0;         ///< curves of the section that bound the new faces
  std::size_t left_open = 0;      ///< curves that end at a boundary, or that cross themselves or each other
  std::size_t new_faces = 0;      ///< in the plane
};

struct CutSurface {
  /// The points of what stays, in their order and bit by bit, then those of the section; the faces that stay whole, in their order,
  /// then parts of others, then the new ones in the plane. Points of no face are gone.
  TriangleSoup soup;
  PlaneCutCounts counts;
};

/// Cuts the surface and closes the section where its curves are closed: outlines with the curves within them, as the two circles of
/// a tube. The new faces look outward like the surface. Parts of faces have the attributes of their face. Vertices within a
/// ten-millionth of the surface's extent lie in the plane. Faces may cross elsewhere.
/// @param soup  faces that agree in orientation
/// @throws InvalidArgument where the plane misses the surface, or nothing of it lies behind the plane.
CutSurface cut_by_plane(const TriangleSoup& soup, const CutPlane& plane);

}  // namespace loopmend
