// SPDX-License-Identifier: GPL-3.0-or-later
// A bridge that a person asks for: a strip across a complex hole makes two simpler ones of it.
#pragma once

#include "mesh/boundary_loops.h"
#include "mesh/surface_model.h"

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace loopmend {

/// A strip of triangles between two boundary vertices.
struct BridgeStrip {
  Points points{};              ///< its own
  std::vector<Color> colors{};  ///< of its points; empty where the surface has none
  Triangles triangles{};        ///< soup points of the surface; its own are numbered after the last of these
  int from = 0, to = 0;         ///< soup points at which it begins and ends
  /// From the first end to the second: left, middle and right soup point of each row across.
  std::vector<std::array<int, 3>> rows{};
};

/// Makes strips on one surface. Each is two triangles wide and takes the boundary edges on both sides of both ends. Its middle is
/// a cubic that leaves the surface tangentially towards the other end; the surface's tangent planes at the ends are means over a few
/// boundary edges, so that a ragged boundary does not twist the strip. Where a tooth of the boundary stands before it, an end moves
/// aside by one or two boundary edges.
class BridgeMaker {
 public:
  /// @param model  must outlive this, and not change.
  explicit BridgeMaker(const SurfaceModel& model);

  /// @param a, b  soup points on boundary loops. On one loop, the strip parts it into two; on two, it makes one of them.
  /// @throws InvalidArgument where a point is on no boundary, or both ends have a vertex of their edges in common.
  BridgeStrip strip(int a, int b) const;

  /// Of the surface.
  const std::vector<BoundaryLoop>& loops() const { return loops_; }

 private:
  struct Place {
    std::size_t loop;
    int vertex;  ///< of the loop
  };
  std::vector<Place> places_of(int point) const;

  const SurfaceModel& model_;
  std::vector<BoundaryLoop> loops_;
  std::multimap<int, Place> places_;  ///< by soup point, in the order of the loops
};

/// Adds the strip of a surface to its soup, or to one that has the surface's points first.
/// @param surface_points  their count
void append(TriangleSoup& soup, const BridgeStrip& strip, std::size_t surface_points);

/// One strip, as BridgeMaker makes it. Its points and faces come last.
TriangleSoup with_bridge(const SurfaceModel& model, int a, int b);

}  // namespace loopmend
