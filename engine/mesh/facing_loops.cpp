// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/facing_loops.h"

#include "core/error.h"
#include "mesh/loop_facing.h"

namespace loopmend {

namespace {

/// How well a loop looks at a place: near, and the surface goes on towards it.
double facing_score(const SurfaceModel& model, const BoundaryLoop& loop, const Vec3& place) {
  const Vec3 way = place - loop.center;
  const double distance = way.norm();
  if (!(distance > 0)) return 0;
  return -distance * (2 - loop_facing(model, loop).onward.dot(way) / distance);
}

}  // namespace

std::vector<std::size_t> facing_loops(const std::vector<FacingPart>& parts) {
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const FacingPart& part = parts[k];
    if (part.loops.empty())
      throw InvalidArgument(say("file %1 is closed: it has no loop that could be joined to others", k + 1));
    Vec3 others = Vec3::Zero();
    for (std::size_t l = 0; l < parts.size(); ++l)
      if (l != k) others += parts[l].middle / static_cast<double>(parts.size() - 1);
    std::size_t best = 0;
    for (std::size_t l = 1; l < part.loops.size(); ++l)
      if (facing_score(*part.model, part.loops[l], others) > facing_score(*part.model, part.loops[best], others))
        best = l;
    chosen.push_back(best);
  }
  return chosen;
}

}  // namespace loopmend
