// SPDX-License-Identifier: GPL-3.0-or-later
// Is a patch in proportion to its loops? A flow may end in a bubble that its energy does not tell from a good patch.
#pragma once

#include "mesh/patch.h"

#include <vector>

namespace loopmend {

/// No units.
struct Proportion {
  double area = 1;    ///< of the patch, in that of the initial patch, which is about the least
  double depth = 0;   ///< farthest that the patch leaves the ball around its initial patch, in that ball's diameter
  double energy = 0;  ///< ∫‖∇H‖² dA over the patch × its area: 0 on a sphere, plane or cylinder of any size

  bool operator==(const Proportion&) const = default;
};

/// One for each loop of the patch: of the connected part that it bounds.
/// @param initial  the initial patch of the same loops, in the same order; its triangles may be others.
std::vector<Proportion> proportions_of(const Patch& patch, const Patch& initial);

/// A large or deep patch is right where it runs on as a sphere does, with next to no energy. With energy it is a bubble.
inline constexpr Proportion most_of_a_patch{2.5, 0.4, 1};
/// Sharp edges that run on have energy, and may meet in a tip some two and a half radii of the loop above it. Beyond, small errors of the
/// sides move it far.
inline constexpr Proportion most_of_sharp_sides{5, 1, 1};
bool is_out_of_proportion(const Proportion& proportion, const Proportion& most = most_of_a_patch);

}  // namespace loopmend
