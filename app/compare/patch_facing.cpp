// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/patch_facing.h"

#include <Eigen/Geometry>

#include <cstddef>

namespace loopmend {

PatchFacing facing_of(const SurfaceShape& shape) {
  Eigen::AlignedBox3d box;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double area = 0;
  const auto point = [&](std::size_t corner) {
    return Eigen::Vector3d(
        Eigen::Map<const Eigen::Vector3f>(shape.points.data() + 3 * static_cast<std::size_t>(shape.triangles[corner]))
            .cast<double>());
  };
  for (std::size_t t = 0; t < static_cast<std::size_t>(shape.own_triangles); ++t) {
    const Eigen::Vector3d a = point(3 * t), b = point(3 * t + 1), c = point(3 * t + 2);
    for (const Eigen::Vector3d& p : {a, b, c}) box.extend(p);
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    sum += normal;
    area += normal.norm();
  }
  PatchFacing facing;
  if (box.isEmpty()) return facing;
  facing.middle = box.center();
  facing.radius = 0.5 * box.diagonal().norm();
  if (area > 0 && sum.norm() > 0.3 * area) facing.outward = sum.normalized();
  return facing;
}

}  // namespace loopmend
