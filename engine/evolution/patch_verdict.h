// SPDX-License-Identifier: GPL-3.0-or-later
// Is a patch fit to be pasted? Folds, and cuts with itself or with any part of the model.
#pragma once

#include "mesh/boundary_loops.h"
#include "mesh/patch.h"
#include "mesh/self_intersections.h"
#include "mesh/surface_model.h"

#include <vector>

namespace loopmend {

/// What all workers read: the model as it was, and an index of its triangles.
struct FillSite {
  explicit FillSite(const SurfaceModel& surface);
  const SurfaceModel& model;
  Points points;        ///< of the view
  Triangles triangles;  ///< of the view
  TriangleIndex index;
};

struct PatchVerdict {
  int folds = 0;                   ///< of the patch and its rim
  std::vector<int> intersections;  ///< per loop of the patch: cuts of its part with anything
  std::vector<int> spoiled;        ///< the patch's triangles beside a fold or in a cut, ascending
  int total() const;
};

PatchVerdict judge(const FillSite& site, const Patch& patch);

/// Edges of a loop that run through other triangles of the model: no patch whatever can avoid to cut the surface there.
int pierced_edges(const FillSite& site, const BoundaryLoop& loop);

/// True if a has no more folds and no more cuts than b.
bool no_worse(const PatchVerdict& a, const PatchVerdict& b);

/// Which part of a patch each of its loops bounds: for each of its triangles an index into patch.loops.
std::vector<int> loop_of_triangles(const Patch& patch);

}  // namespace loopmend
