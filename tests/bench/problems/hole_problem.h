// SPDX-License-Identifier: GPL-3.0-or-later
// A surface with a piece cut out, and the truth about that piece.
#pragma once

#include "mesh/boundary_loops.h"

#include <array>
#include <functional>
#include <set>
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

/// Removes the vertices for which `inside` holds, and what then hangs loosely at the boundary.
HoleProblem cut_problem(std::string name, const TriangleSoup& whole, const std::function<bool(const Vec3&)>& inside,
                        std::function<double(const Vec3&)> distance);

/// A problem whose holes are already cut: the loops that run mostly over vertices for which `on_cut` holds.
HoleProblem open_problem(std::string name, TriangleSoup open, const std::function<bool(const Vec3&)>& on_cut,
                         std::function<double(const Vec3&)> distance);

/// The exact places of points, to be asked for.
class PlaceSet {
 public:
  explicit PlaceSet(const Points& points);
  bool contains(const Vec3& p) const { return places_.contains({p.x(), p.y(), p.z()}); }

 private:
  std::set<std::array<double, 3>> places_;
};

}  // namespace loopmend::bench
