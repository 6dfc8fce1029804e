// SPDX-License-Identifier: GPL-3.0-or-later
// Is a patch fit to be pasted? Folds, and intersections with itself or with any part of the model.
#pragma once

#include "mesh/boundary_loops.h"
#include "mesh/patch.h"
#include "mesh/self_intersections.h"
#include "mesh/surface_model.h"
#include "mesh/validity.h"

#include <vector>

namespace loopmend {

/// What all workers read: the model as it was, and an index of its soup triangles, but for those that are no part of the
/// surface.
struct ScanIndex {
  /// Takes a third of a second for a million triangles. @param surface  must outlive the index, and not change.
  explicit ScanIndex(const SurfaceModel& surface);
  const SurfaceModel& model;
  TriangleIndex index;
  bool holds_as_floats;  ///< whether floats hold all of its coordinates
};

/// Edges between two triangles of the patch, their ends on its boundary, that would have more than two faces of patch and scan
/// together where the scan has two at most. Ends in the same position are one, so that each part of the scan counts.
int new_nonmanifold_edges(const ScanIndex& scan, const Patch& patch);

/// For each triangle of the patch, how many others of patch and model it intersects, summed; everything that Validity tells.
/// Intersections are those of the patch as files of floats have it, where floats hold the scan.
Validity validate(const ScanIndex& scan, const Patch& patch);

/// Pairs of a triangle of the patch and a soup triangle of the model that it cuts; -1 for another of the patch.
std::vector<std::pair<int, int>> cuts_of(const ScanIndex& scan, const Patch& patch);

/// Edges of a loop that run through other triangles of the model: every patch must intersect the surface there.
int pierced_edges(const ScanIndex& scan, const BoundaryLoop& loop);

/// Which part of a patch each of its loops bounds: for each of its triangles an index into patch.loops.
std::vector<int> loop_of_triangles(const Patch& patch);
/// The same for each free vertex.
std::vector<int> loop_of_free_vertices(const Patch& patch);

}  // namespace loopmend
