// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles around a patch by themselves, with what fits to them need.
#pragma once

#include "mesh/patch.h"
#include "operators/topology.h"
#include "operators/vertex_normals.h"

namespace loopmend {

struct FixedSurface {
  explicit FixedSurface(const Patch& patch)
      : triangles(patch.triangles.begin() + patch.patch_triangles, patch.triangles.end()),
        topology(patch.vertex_count(), triangles),
        normals(angle_weighted_normals(patch.positions, triangles)) {}

  Triangles triangles;
  Topology topology;  ///< of all vertices; the free ones have no neighbours
  Points normals;     ///< #V, zero at the free vertices
};

}  // namespace loopmend
