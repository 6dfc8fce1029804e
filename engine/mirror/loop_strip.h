// SPDX-License-Identifier: GPL-3.0-or-later
// The strip between the loop of a patch and what lies within it (docs/math/mirror_image.md, "The cut").
#pragma once

#include "mesh/patch.h"

#include <vector>

namespace loopmend {

/// What lies within a loop.
struct InnerSheet {
  const Points& points;        ///< patch frame
  const Triangles& triangles;  ///< with one border
  std::vector<int> border;     ///< its vertices, against the sense in which their triangles have them
};

/// The least folded strip without new vertices: shortest cross edges part it into polygons of some ten edges of the loop, and each of these
/// is triangulated with the least dihedral angles, those with the triangles on both sides of the strip among them.
/// @returns triangles over the places of the loop, and after them those of the border; empty where there is none
Triangles strip_to_loop(const Patch& patch, const InnerSheet& inner);

}  // namespace loopmend
