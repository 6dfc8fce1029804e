// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts one disc-shaped piece out of a mesh, by growing a region over its edges.
#pragma once

#include "hole_problem.h"
#include "hole_shape.h"
#include "mesh/triangle_soup.h"

#include <optional>

namespace loopmend::bench {

/// Where and how to cut. Lengths in mesh units.
struct RegionPlan {
  int center = 0;     ///< vertex
  HoleShape shape;    ///< laid into the tangent plane at the centre, distances measured straight through space
  double radius = 0;  ///< of the shape's unit circle
  double turn = 0;    ///< of the shape about the normal, radians
  int clearance = 3;  ///< rings that must lie between the hole and any boundary of the mesh
};

struct RegionCut {
  TriangleSoup open;         ///< the mesh with one more boundary loop
  TriangleSoup removed;      ///< what was cut away: a topological disc
  int removed_vertices = 0;  ///< that are not on the new loop
};

/// Of larger meshes, in vertices, only the neighbourhood of a cut is kept.
inline constexpr std::size_t most_kept_whole = 50000;

/// @param whole  one component, oriented, edge-manifold; boundaries trimmed (trim_boundaries) if it is kept whole, so that all that
///               is missing afterwards was cut away.
/// @returns nothing when the region is not a disc, comes too close to a boundary, severs a part or holds no vertex.
std::optional<RegionCut> cut_region(const TriangleSoup& whole, const RegionPlan& plan);

/// Vertices that the planned cut will take away, roughly and fast.
double expected_vertices(const TriangleSoup& whole, const RegionPlan& plan);

/// Keeps triangles within `rings` edges of the cut: huge scans are slow to carry along.
void crop_around_cut(RegionCut& cut, int rings);

/// The hole that the cut made, as a problem. @param distance  from the truth; by default from what was removed.
HoleProblem problem_of(std::string name, RegionCut cut, std::function<double(const Vec3&)> distance = nullptr);

/// What was removed, put back: pairs of triangles that cut each other and edges folded by more than 90° there. Scans have
/// such places of their own, where no program can do better.
struct OriginalFaults {
  int cuts = 0, folds = 0;
};
OriginalFaults faults_of_original(const TriangleSoup& removed, const TriangleSoup& open);

/// The component with the most triangles, without unused points.
TriangleSoup largest_component(const TriangleSoup& soup);

}  // namespace loopmend::bench
