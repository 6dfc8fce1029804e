// SPDX-License-Identifier: GPL-3.0-or-later
// The problems of the accuracy table: analytic surfaces with pieces cut out, and what must be reached on each.
#pragma once

#include "hole_problem.h"
#include "known_surfaces.h"

#include <functional>
#include <string>
#include <vector>

namespace loopmend::bench {

struct AccuracyCase {
  std::string name;
  std::function<HoleProblem(MeshKind)> make;
  /// d must be below this (1e-3 of the hole's diameter). 0: the surface is no solution of the equation, and d must not be
  /// above the best peer's.
  double target = 0;
  bool compares_g2 = false;  ///< g2 must be below the best peer's, too
};

std::vector<AccuracyCase> accuracy_cases();

/// Those that are filled at several densities as well.
std::vector<AccuracyCase> density_cases();

}  // namespace loopmend::bench
