// SPDX-License-Identifier: GPL-3.0-or-later
// Patch: the part of a surface that evolves, with the rings of fixed vertices around it.
#pragma once

#include "core/types.h"
#include "mesh/boundary_loops.h"
#include "mesh/surface_model.h"

#include <limits>

namespace loopmend {

/// An initial patch for one loop: the loop's vertices first, in loop order, then the new ones.
struct LoopPatch {
  Points points;        ///< mesh units
  Triangles triangles;  ///< oriented like the neighborhood
};

/// How the target length of a patch's edges changes inward from its boundary.
struct Grading {
  double density = 1;  ///< 0.1..10: edges aim at those of the boundary divided by this
  double growth = 0;   ///< 0..1: where not 0, what edges gain per length of way from the boundary, whatever the density
  double longest = std::numeric_limits<double>::max();  ///< edge that growth may lead to, patch frame
};

/// Free vertices come first, then ring 1 (the loops), ring 2, ... All positions are in the patch's own frame
/// (centre 0, size about 1), so that no tolerance depends on the unit of the scan. Fixed vertices are copies: they are
/// never written back, so the neighborhood cannot move, not by one bit.
struct Patch {
  int free_count = 0;   ///< n, the unknowns
  Points positions;     ///< #V, patch frame: x = (mesh − center) / scale
  Triangles triangles;  ///< the patch's own `patch_triangles` first, then those of the neighborhood
  int patch_triangles = 0;
  std::vector<int> ring;                ///< #V: 0 free, 1 on a loop, 2, 3, ... edges away from the loops
  std::vector<int> view_vertex;         ///< #V: vertex of the model's view; −1 for free vertices
  std::vector<std::vector<int>> loops;  ///< per loop: its patch vertices (all of ring 1), in loop order
  std::vector<int> loop_numbers;        ///< BoundaryLoop::number of each
  Vec3 center = Vec3::Zero();           ///< of the frame, mesh units
  double scale = 1;                     ///< of the frame, mesh units
  Grading grading;                      ///< what remeshing aims at

  int vertex_count() const { return static_cast<int>(positions.size()); }
  Vec3 to_mesh(const Vec3& p) const { return p * scale + center; }
  Vec3 to_frame(const Vec3& p) const { return (p - center) / scale; }
};

/// How many rings of fixed vertices a patch carries: the semi-implicit MMCVF step on two-ring fits reaches that far.
inline constexpr int patch_rings = 6;

/// Joins loops and their initial patches into one problem. Several loops are given together when their rings overlap.
/// @throws InvalidArgument if sizes disagree.
Patch make_patch(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                 const std::vector<LoopPatch>& initial_patches);

/// make_patch() with so many rings, at least 1: two are enough to look for folds and to paste it.
Patch make_narrow_patch(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                        const std::vector<LoopPatch>& initial_patches, int rings);

/// Largest distance between two vertices of the loop, patch frame. @param loop  which of patch.loops.
double loop_diameter(const Patch& patch, std::size_t loop);

/// The patch in mesh units, ready for append_patch.
PatchGeometry patch_geometry(const Patch& patch);

}  // namespace loopmend
