// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a mirror image that lies within a loop, with its own triangles, joined to the loop by a strip
// (docs/math/mirror_image.md, "The cut").
#pragma once

#include "core/cancel.h"
#include "mesh/patch.h"
#include "mirror/mirror_image.h"

#include <vector>

namespace loopmend {

enum class CutFault {
  none,
  open_there,  ///< the image has a hole or an end of its own within the loop
  no_disc,     ///< what lies within the loop is in several parts, or has a handle
};

struct CutImage {
  /// The loop's vertices first, in loop order, bit for bit; patch frame. Empty with a fault.
  LoopPatch patch;
  CutFault fault = CutFault::none;
  /// What the bends at the strip's edges are beyond 40°, summed, in degrees, and 30 for each edge of the loop that the strip is wide.
  double cost = 0;
};

/// Cuts with strips of several widths, those with a fault last, the others by their cost. Empty when cancelled.
std::vector<CutImage> cut_image(const Patch& patch, const MirrorImage& image, const CancelToken& cancel);

}  // namespace loopmend
