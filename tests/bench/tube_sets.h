// SPDX-License-Identifier: GPL-3.0-or-later
// Random sets of tubes to be blended, each made from one seed.
#pragma once

#include "samples/paper_inputs.h"

#include <cstdint>
#include <string>
#include <vector>

namespace loopmend::bench {

struct TubeSet {
  std::vector<TubeShape> tubes;
  std::string angles;  ///< "right": along the axes; "odd": any that leave room between the tubes
  std::string radii;   ///< "equal", "unequal"
};

/// 2, 3, 4 or 6 tubes of radius 0.4 to 0.8 that leave the origin at 1.2 to 2.2, 16 to 40 vertices around. The seed's lowest
/// bits choose count, angles and radii in turn, so that sixteen seeds in a row hold every combination once.
/// @param finer  factor on the vertices around, ≥ 1.
TubeSet make_tube_set(std::uint64_t seed, int finer = 1);

}  // namespace loopmend::bench
