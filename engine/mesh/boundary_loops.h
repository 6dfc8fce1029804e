// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary loops of a surface: what a person sees as holes and outer rims.
#pragma once

#include "core/message.h"
#include "mesh/surface_model.h"

#include <string>
#include <utility>
#include <vector>

namespace loopmend {

enum class LoopKind {
  hole,       ///< can be filled
  outer_rim,  ///< the outline of an open sheet: filled only when asked for
  crack,      ///< each edge lies exactly on another boundary edge, or all on one face: nothing is missing
  cut,        ///< runs where the view had to be cut (an edge with more than two faces, a one-sided surface): no hole
};

const char* to_string(LoopKind kind);

/// One closed chain of boundary edges. Where loops touch, each goes on across the gap between two fans of faces, so that a
/// vertex may lie on several loops, or twice on one. Lengths in mesh units.
struct BoundaryLoop {
  int number = 0;             ///< from 1, by falling perimeter; stable for one model
  std::vector<int> vertices;  ///< view vertices in the order of the boundary halfedges (the hole lies to their left)
  double perimeter = 0;
  double diameter = 0;   ///< largest distance between two loop vertices
  double planarity = 0;  ///< rms distance from the best plane, divided by the diameter: 0 is flat
  double area = 0;       ///< of the projection to the best plane
  /// Exactly plane, with at most eight edges, or at most 16 corners, which half of its vertices or more are not: as around a
  /// missing face of a part.
  bool is_polygon = false;
  /// Across the longest direction, as of an ellipse: the diameter of a circle. Of a slot that is bent, and as large as its piece of
  /// surface, the distance between its sides.
  double width = 0;
  double turning =
      0;  ///< total geodesic curvature seen from the surface, in units of 2π: −1 round hole, +1 boundary of a sheet
  Vec3 center = Vec3::Zero();  ///< mean of the loop's vertices
  double extent = 0;           ///< diagonal of the loop's box divided by that of its piece of surface
  double depth =
      0;  ///< reach of its piece from the loop's plane, in diameters; 0 where the extent rules an outline out
  bool ends_tube = false;  ///< it runs round its whole piece, as does another loop of it, and neither turns to a side
  bool on_sphere = false;  ///< its piece is a part of an exact sphere, deeper than a lens or a dish
  double onward = 0;       ///< how straight the surface runs on beyond the loop: 1 at the end of a tube, 0 in a plane
  int coincident = 0;      ///< edges that lie exactly on another boundary edge, of this loop or another
  bool one_sided = false;  ///< cut only since the surface has one side, as a Möbius strip: at edges of two faces
  LoopKind kind = LoopKind::hole;
  /// Chords (i, k), i < k, over indices into `vertices`: the surface has an edge between these positions, on whatever part of
  /// it, so that a patch with that edge would make one of more than two faces. Ascending.
  std::vector<std::pair<int, int>> joined{};
  /// Per vertex whether another loop that can be filled, or this one again, passes its position. Empty: none does.
  std::vector<char> shared{};

  int edges() const { return static_cast<int>(vertices.size()); }
};

/// Whether it turns and lies as a hole does, and not as the outline of a sheet, whatever else its kind says. The opening of an
/// exact sphere is a hole, since its missing part is known.
bool is_shaped_like_a_hole(const BoundaryLoop& loop);

/// Why it is an outer rim and no hole, without a full stop; empty for other kinds.
Message why_outer_rim(const BoundaryLoop& loop);

/// All loops, by falling perimeter, then by lowest view vertex.
std::vector<BoundaryLoop> find_boundary_loops(const SurfaceModel& model);

}  // namespace loopmend
