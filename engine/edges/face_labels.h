// SPDX-License-Identifier: GPL-3.0-or-later
// Which side each triangle of a patch continues, so that sides change where their surfaces meet (docs/math/sharp_edges.md, "Labels").
#pragma once

#include "core/cancel.h"
#include "edges/sides.h"

#include <vector>

namespace loopmend {

/// A triangulated disc whose points 0..loop−1 are the loop, in order.
struct Domain {
  Points points;
  Triangles triangles;
  int loop = 0;
};

/// What a seam within the patch costs at a point between two sides.
enum class SeamPrice {
  apart,     ///< how far the feet of the point on both surfaces are apart: right where the patch is near the surfaces
  off_seam,  ///< a small share of the distance of the point from where both meet; where they do not, as `apart`
};

/// Minimises ∫ gap ds over the edges between triangles of different sides, and over the loop, where the neighborhood's side is the
/// other one; the gap is the distance between the feet of a point on both surfaces. Alpha expansion (Boykov, Veksler, Zabih 2001).
/// @returns a side for each triangle; empty when cancelled.
std::vector<int> label_faces(const Domain& domain, const Sides& sides, SeamPrice price, const CancelToken& cancel);

}  // namespace loopmend
