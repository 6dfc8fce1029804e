// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies whose faces look inward.
#pragma once

#include "mesh/boundary_loops.h"
#include "mesh/surface_model.h"

#include <cstddef>
#include <vector>

namespace loopmend {

/// Of a shell, a connected part of the surface, with its openings covered by flat fans.
struct InvertedShells {
  std::size_t closed = 0;  ///< inside out, and closed but for openings of a twentieth of their area
  std::size_t open =
      0;  ///< inside out with wider openings, even with half balls over them; or alone with any: it may be a room
  std::vector<char> faces;  ///< per soup triangle: 1 where it belongs to a closed one; empty where there is none
  std::size_t face_count = 0;
};

/// A shell in no other one, or in a cavity, is a body: it is inside out where its volume is negative. A shell in the material of a body
/// that is inside out is a cavity: it is inside out, too, where its volume is positive. One in the material of another body is a cavity
/// of it, or with a positive volume a part of it, and stays. What lies in several shells that cross, in one that is open and inside out, or in the box of one that
/// may be either, is left as it is. Left out are shells with edges of more than two faces, one-sided ones, and those with vertices at a
/// mark for missing data.
/// @param loops  all of the model, which may be one that holds only what lies around them
InvertedShells find_inverted_shells(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops);

/// Faces of the bodies that are inside out, open ones as well, and of the cavities that are with them. Turned, all of them leave
/// nothing that find_inverted_shells() would find.
/// @param model  all of the surface. @returns per soup triangle 1 where it is to be turned; empty where nothing looks inward.
std::vector<char> faces_inside_out(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops);

}  // namespace loopmend
