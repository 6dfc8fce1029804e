// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/surface_distance.h"

#include "core/quantile.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>

namespace loopmend {

std::vector<double> signed_distances(const Points& points, const TriangleSoup& surface, const SurfaceTree& tree,
                                     const CancelToken& cancel) {
  std::vector<double> distances(points.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < points.size() && !cancel.cancelled(); ++k) {
    const SurfacePoint closest = tree.closest(points[k]);
    if (closest.triangle < 0) continue;
    const Triangle& t = surface.triangles[closest.triangle];
    const auto corner = [&](int i) -> const Vec3& { return surface.points[t[i]]; };
    const Vec3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)), off = points[k] - closest.place;
    distances[k] = std::copysign(off.norm(), normal.dot(off));
  }
  return distances;
}

DistanceSummary summary_of(const std::vector<double>& distances) {
  DistanceSummary summary;
  std::vector<double> sizes;
  for (double d : distances) {
    if (std::isnan(d)) continue;
    sizes.push_back(std::abs(d));
    summary.mean += d;
    summary.rms += d * d;
    summary.largest = std::max(summary.largest, std::abs(d));
  }
  if (sizes.empty()) return summary;
  summary.count = sizes.size();
  const auto count = static_cast<double>(sizes.size());
  summary.mean /= count;
  summary.rms = std::sqrt(summary.rms / count);
  summary.nearly_all = quantile(sizes, 0.95);
  return summary;
}

}  // namespace loopmend
