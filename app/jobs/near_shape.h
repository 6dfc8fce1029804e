// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a large surface that lies near a patch: what several views can draw at once.
#pragma once

#include "scene/surface_shape.h"

namespace loopmend {

/// The shape itself while it is small; else its triangles within twice the patch's size around it.
SurfaceShapePtr near_shape(const SurfaceShapePtr& shape, const Patch& patch, const Vec3& origin);

/// The shape without these of its triangles (numbers in the order of `shape.triangles`).
SurfaceShapePtr without_triangles(const SurfaceShape& shape, const std::vector<char>& left_out);

}  // namespace loopmend
