// SPDX-License-Identifier: GPL-3.0-or-later
// Normal and mean curvature at a vertex from one side of a seam only.
#pragma once

#include "operators/topology.h"

#include <optional>

namespace loopmend {

struct OneSidedFit {
  Vec3 normal;  ///< unit
  double H;     ///< mean curvature, 1/length
};

/// Fits r(u, v) of third degree (second where there are fewer than 14 neighbours) to the nearest rings of `side` that
/// hold at least 18 vertices (at most five rings). Coordinates as in fit_quadratic: neighbours in the plane of
/// `reference_normal`, at their true distance. Empty when the side is too small or does not determine the fit.
std::optional<OneSidedFit> one_sided_fit(const Points& points, const Topology& side, int i,
                                         const Vec3& reference_normal, std::vector<char>& mark);

}  // namespace loopmend
