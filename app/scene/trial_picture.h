// SPDX-License-Identifier: GPL-3.0-or-later
// What the picture shows of something that is being tried out, in place of the scans it would replace.
#pragma once

#include "scene/shape_glide.h"
#include "scene/surface_shape.h"

#include <set>

namespace loopmend {

struct ProblemPicture {
  std::set<int> hidden_scans;          ///< with their patches
  SurfaceShapePtr backdrop;            ///< in their place; may be null
  SurfaceShapePtr patch;               ///< that moves; may be null
  Arrival arrival = Arrival::at_once;  ///< of the patch
};

}  // namespace loopmend
