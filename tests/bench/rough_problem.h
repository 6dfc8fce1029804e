// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces cut out of real scans, and noisy surfaces: what a boundary that is not smooth does to a filling.
#pragma once

#include "hole_problem.h"

#include <cstdint>
#include <optional>
#include <string>

namespace loopmend::bench {

struct RoughProblem {
  HoleProblem problem;  ///< distance: from the removed original
  std::string scan;
  std::string shape;
  double size = 0;  ///< diameter of the hole in parts of the scan's extent
};

/// Number k ≥ 0 of a fixed list: the scans in turn; disc, ellipse, star, slit; 5 to 30 % of the object. Even numbers are
/// for tuning, odd ones are set aside. Cuts whose boundary runs through the scan itself are not taken: no patch could do without
/// cutting it. Empty when no clean cut was found.
std::optional<RoughProblem> make_rough_problem(std::uint64_t seed, int k);

/// A smooth surface of edge length h whose vertices were moved along the normals by white noise of this share of h, with
/// a disc cut out; distances are from the surface without noise.
enum class NoisySurface { sphere, torus };
HoleProblem make_noisy_problem(NoisySurface surface, double noise, unsigned seed);

}  // namespace loopmend::bench
