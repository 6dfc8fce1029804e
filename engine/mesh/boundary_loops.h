// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary loops of a surface: what a person sees as holes and rims.
#pragma once

#include "mesh/surface_model.h"

#include <string>
#include <vector>

namespace loopmend {

enum class LoopKind {
  hole,       ///< can be filled
  outer_rim,  ///< the rim of an open sheet: filled only when asked for
  touching,   ///< passes twice through one vertex, or meets another loop there
  crack,      ///< each edge lies exactly on another boundary edge: nothing is missing, the sides are only not joined
  cut,        ///< runs where the view had to be cut (an edge with more than two faces, a one-sided surface): no hole
};

const char* to_string(LoopKind kind);

/// One closed chain of boundary edges. Lengths in mesh units.
struct BoundaryLoop {
  int number = 0;             ///< from 1, by falling perimeter; stable for one model
  std::vector<int> vertices;  ///< view vertices in the order of the boundary halfedges (the hole lies to their left)
  double perimeter = 0;
  double diameter = 0;   ///< largest distance between two loop vertices
  double planarity = 0;  ///< rms distance from the best plane, divided by the diameter: 0 is flat
  double area = 0;       ///< of the projection to the best plane
  double turning =
      0;  ///< total geodesic curvature seen from the surface, in units of 2π: −1 round hole, +1 rim of a sheet
  Vec3 center = Vec3::Zero();  ///< mean of the loop's vertices
  int coincident = 0;          ///< edges that lie exactly on another boundary edge, of this loop or another
  LoopKind kind = LoopKind::hole;

  int edges() const { return static_cast<int>(vertices.size()); }
};

/// Whether the loop runs round a sheet, also where it touches itself or another loop on its way; its kind is `touching`
/// then.
bool bounds_a_sheet(const BoundaryLoop& loop);

/// All loops, by falling perimeter, then by lowest view vertex.
std::vector<BoundaryLoop> find_boundary_loops(const SurfaceModel& model);

}  // namespace loopmend
