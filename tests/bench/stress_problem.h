// SPDX-License-Identifier: GPL-3.0-or-later
// Random hole problems, each made from one seed.
#pragma once

#include "hole_problem.h"
#include "hole_shape.h"

#include <cstdint>
#include <optional>
#include <string>

namespace loopmend::bench {

struct StressProblem {
  HoleProblem problem;
  std::string surface;  ///< "sphere", ..., "scan dragon"
  std::string shape;    ///< to_string(ShapeKind)
  std::string mesh;     ///< "regular", "jittered", "irregular"; "scan"
  double size = 0;      ///< diameter of the hole in parts of the object's extent
  /// H is constant on it, so that the truth is the answer; HoleProblem::distance is from it.
  bool has_answer = false;
  TriangleSoup removed;  ///< the original of what was cut away
};

/// Surfaces: sphere, cylinder, torus, catenoid, unduloid, graph, ellipsoid (three of four problems) and the shared scans.
/// Holes: disc, ellipse, star, slit, concave polygon, 3 to 60 % of the object, 3 to 5000 vertices cut away.
/// The same seed gives the same problem on every machine. Empty when no cut was found that is a disc.
std::optional<StressProblem> make_stress_problem(std::uint64_t seed);

}  // namespace loopmend::bench
