// SPDX-License-Identifier: GPL-3.0-or-later
// From where the camera sees a patch.
#pragma once

#include "scene/surface_shape.h"

#include <Eigen/Core>

namespace loopmend {

/// A patch's middle, half its size, and where its outside looks.
struct PatchFacing {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero(), outward = Eigen::Vector3d::Zero();
  double radius = 1;
};

PatchFacing facing_of(const SurfaceShape& shape);

}  // namespace loopmend
