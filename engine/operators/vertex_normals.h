// SPDX-License-Identifier: GPL-3.0-or-later
// Normals of vertices from the triangles at them.
#pragma once

#include "operators/topology.h"

#include <span>

namespace loopmend {

/// Normals weighted by the angles of the triangles at each vertex; unit, or zero where there is no area.
Points angle_weighted_normals(std::span<const Vec3> points, const Triangles& triangles);
/// One of them, the same bits.
Vec3 angle_weighted_normal(std::span<const Vec3> points, const Triangles& triangles, const Topology& topology, int i);

}  // namespace loopmend
