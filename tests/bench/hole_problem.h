// A surface with a piece cut out, and the truth about that piece.
#pragma once

#include "mesh/boundary_loops.h"

#include <functional>
#include <string>

namespace loopmend::bench {

struct HoleProblem {
  std::string name;
  SurfaceModel model;                           ///< with the holes
  std::vector<BoundaryLoop> loops;              ///< to be filled: those that the cut made
  int removed = 0;                              ///< vertices cut away
  std::function<double(const Vec3&)> distance;  ///< from the truth, mesh units

  /// Of the largest loop, mesh units: the unit of all distances told.
  double diameter() const;
};

/// Removes the vertices for which `inside` holds, and what then hangs loosely at the rim.
HoleProblem cut_problem(std::string name, const TriangleSoup& whole, const std::function<bool(const Vec3&)>& inside,
                        std::function<double(const Vec3&)> distance);

/// A problem whose holes are already cut; loops that run mostly along the boundary of `whole` are not among them.
HoleProblem open_problem(std::string name, const TriangleSoup& whole, TriangleSoup open,
                         std::function<double(const Vec3&)> distance);

}  // namespace loopmend::bench
