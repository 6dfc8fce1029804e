// SPDX-License-Identifier: GPL-3.0-or-later
// Normals of vertices from the triangles at them.
#pragma once

#include "operators/topology.h"

namespace loopmend {

/// Normals weighted by the angles of the triangles at each vertex; unit, or zero where there is no area.
Points angle_weighted_normals(const Points& points, const Triangles& triangles);
/// One of them, the same bits.
Vec3 angle_weighted_normal(const Points& points, const Triangles& triangles, const Topology& topology, int i);

}  // namespace loopmend
