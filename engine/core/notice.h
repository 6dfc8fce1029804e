// SPDX-License-Identifier: GPL-3.0-or-later
// What the program reports, as a value: a code and its arguments. Text is made at the edge, in English here and in other
// languages by the window.
#pragma once

#include "core/message.h"

#include <string>
#include <vector>

namespace loopmend {

/// Beside each code its arguments, in order. Lengths are in diameters of the loop, angles in degrees.
enum class NoticeCode {
  crosses_surface,      ///< number of places
  nonmanifold_edges,    ///< number of edges
  folded_edges,         ///< number of edges
  torn_seam,            ///< bend of the seam edges, number of these, their bend before
  dome_over_flat_loop,  ///< height
  flat_or_dome,         ///< none
  bubble,               ///< area in areas of the initial patch, reach beyond it
  curvature_torn,       ///< jump of H × diameter, the same before
  initial_patch_kept,   ///< none
  edges_rounded,        ///< sharp edges end at the loop, and the patch does not continue them. none
  wall_ends,            ///< a wall ends at this loop and at another one, and the patch closes this one alone. none
  crease,               ///< bend of the seam edges, number of these
  bent_inside,          ///< mean bend of edges inside the patch, their length in loop diameters
  seam_worse,           ///< rms angle at the seam, the same in the initial patch
  high_over_loop,       ///< height, height of a ball through the seam
  likely_far,           ///< likely distance from what was there
  mirror_image,         ///< copied from it: rms distance of the surface around from it
  mirror_misfit,        ///< not copied: the same
  mirror_no_gain,       ///< not copied: the same, and of the ordinary patch
  mirror_no_symmetry,   ///< not copied: misfit of the plane, in extents of the surface
  mirror_across,        ///< not made symmetric across the plane: rms distance of the surface around from its image
  mirror_symmetric,     ///< made symmetric across the plane: the same
  mirror_open,          ///< not copied: nothing is there. none
  mirror_faulty,        ///< not copied: it folds or cuts the surface. none
};

struct Notice {
  NoticeCode code = NoticeCode::crease;
  std::vector<double> arguments;

  bool operator==(const Notice&) const = default;
};

/// The word of reports: "crease".
const char* to_string(NoticeCode code);

/// A sentence without capital and full stop: "a crease of 50° along 12 edges of the seam".
Message message_of(const Notice& notice);

}  // namespace loopmend
