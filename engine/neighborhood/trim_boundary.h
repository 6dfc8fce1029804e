// SPDX-License-Identifier: GPL-3.0-or-later
// Bad triangles at the boundary of a hole: finding them, and taking them away where a person asks for it.
#pragma once

#include "mesh/boundary_loops.h"
#include "mesh/surface_model.h"

#include <vector>

namespace loopmend {

enum class BoundaryFault {
  dangling,  ///< stands on one edge: its other two are open
  sliver,    ///< smallest angle under 5°
  spike,     ///< at a boundary vertex all of whose triangles lean by more than 60° against what lies round about
  flipped,   ///< turned by more than 120° against some neighbour
  crossing,  ///< cuts another triangle of the surface, so that every patch at its open edge would; found by trimming alone
  fragment,  ///< one of at most two triangles that trimming cut off from the rest
};

const char* to_string(BoundaryFault fault);

struct BadBoundaryFace {
  int face = 0;  ///< soup triangle
  BoundaryFault fault = BoundaryFault::dangling;
  int ring = 1;  ///< the round of trimming that took it, from 1
};

/// Among the triangles at these loops, by rising number. Only holes count; other kinds of loops are left.
std::vector<BadBoundaryFace> bad_boundary_faces(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops);

struct TrimmedModel {
  SurfaceModel model;                    ///< all points are kept, in their order; the other triangles too, in theirs
  std::vector<BadBoundaryFace> removed;  ///< in the order of removal; numbers as in the soup that was given
  std::vector<BoundaryLoop>
      loops;               ///< those that grew out of the loops given; numbers as find_boundary_loops gives them
  std::size_t spared = 0;  ///< pieces of surface that would have lost more than the largest shares: not trimmed at all
};

/// Trimming takes at most these shares of the triangles of a piece of surface, and of its area; of a coarse part it would take
/// what is meant.
inline constexpr double largest_trim = 0.2, largest_trim_of_area = 0.1;
/// More than this share of either is no fault of a boundary: trimming is not proposed.
inline constexpr double largest_proposed_trim = 0.05;

/// Those that lie in pieces of surface of which they are not too many for trimming to be proposed.
std::vector<BadBoundaryFace> few_of_their_pieces(const SurfaceModel& model, const std::vector<BadBoundaryFace>& bad);

/// Takes the bad triangles away, and those that cross others, then those that are bad at the new boundary, `rounds` times at most;
/// those that cross up to ten times. A piece of surface that would lose too many is left as it is.
/// @param rounds  0..100. @throws InvalidArgument if it is not.
TrimmedModel trim_boundary(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, int rounds);

/// Takes only the triangles away whose edge on a loop runs through the surface, so that no patch could be valid there, and those
/// of which the same is true then, up to ten times. A boundary whose edges run through the surface even so is left as it is.
/// @throws InvalidArgument if nothing would be left.
TrimmedModel trim_pierced(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops);

}  // namespace loopmend
