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

/// Minimises ∫ gap ds over the edges between triangles of different sides, and over the loop, where the neighborhood's side is the
/// other one; the gap is the distance between the feet of a point on both surfaces. Alpha expansion (Boykov, Veksler, Zabih 2001).
/// @returns a side for each triangle; empty when cancelled.
std::vector<int> label_faces(const Domain& domain, const Sides& sides, const CancelToken& cancel);

}  // namespace loopmend
