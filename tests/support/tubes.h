// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of tubes to be blended, which several tests share.
#pragma once

#include "mesh/boundary_loops.h"
#include "samples/paper_inputs.h"

#include <vector>

namespace loopmend::test {

/// A tube of length 2 that leaves the origin at `distance`.
inline TubeShape tube_towards(const Vec3& direction, double distance = 1.5, double radius = 0.8, int around = 24) {
  return {distance * direction.normalized(), direction.normalized(), radius, 2, around};
}

inline SurfaceModel tubes_model(const std::vector<TubeShape>& tubes) {
  std::vector<TriangleSoup> parts;
  for (const TubeShape& tube : tubes) parts.push_back(make_tube(tube));
  return make_surface_model(joined(parts));
}

/// The boundaries where the tubes start, in their order.
inline std::vector<BoundaryLoop> inner_boundaries(const SurfaceModel& model, const std::vector<TubeShape>& tubes) {
  const std::vector<BoundaryLoop> all = find_boundary_loops(model);
  std::vector<BoundaryLoop> boundaries;
  for (const TubeShape& tube : tubes)
    for (const BoundaryLoop& loop : all)
      if ((loop.center - tube.start).norm() < 1e-6) boundaries.push_back(loop);
  return boundaries;
}

}  // namespace loopmend::test
