// SPDX-License-Identifier: GPL-3.0-or-later
// One body of closed ones that overlap.
#pragma once

#include "core/cancel.h"
#include "mesh/triangle_soup.h"

#include <cstddef>

namespace loopmend {

struct UnionCounts {
  std::size_t bodies = 0;          ///< that overlapped, touched along faces, or lay within another
  std::size_t made = 0;            ///< bodies that they became
  std::size_t removed_faces = 0;   ///< within a body, or divided
  std::size_t new_faces = 0;       ///< parts of the divided ones
  std::size_t open_pieces = 0;     ///< of surface that cross others, hold a body or lie in one: left as they are
  std::size_t crossing = 0;        ///< closed ones that do so, and cross themselves: left as they are
  std::size_t touching = 0;        ///< pairs that touch at points or edges alone: left as they are
  std::size_t refused = 0;         ///< pairs that overlap, but have no union (exact_union.h): left as they are
  std::size_t crossing_parts = 0;  ///< pairs of faces of the unions that cross after rounding

  std::size_t left() const { return open_pieces + crossing + refused; }
};

struct UnitedSurface {
  /// The points given, in their order and bit by bit, then new ones; the faces that stay whole, in their order, then parts of
  /// others.
  TriangleSoup soup;
  UnionCounts counts;
};

/// Unites closed bodies, outward shells with the cavities within, in exact arithmetic; new points are rounded at the end. A
/// cavity stays, but for what another body takes of it. Parts of faces have the attributes of their face. Bodies that nothing
/// overlaps keep their faces.
/// @param soup  an oriented manifold, as repair_surface() makes it
/// @returns the soup as it was when cancelled
UnitedSurface unite_bodies(const TriangleSoup& soup, const CancelToken& cancel = {});

}  // namespace loopmend
