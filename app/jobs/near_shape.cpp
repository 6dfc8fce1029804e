// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/near_shape.h"

#include <Eigen/Geometry>

namespace loopmend {
namespace {

constexpr int small_enough = 60000;  ///< triangles that four views draw without effort
constexpr double reach = 1.5;        ///< patch sizes around the patch's middle

}  // namespace

SurfaceShapePtr near_shape(const SurfaceShapePtr& shape, const Patch& patch, const Vec3& origin) {
  if (static_cast<int>(shape->triangles.size() / 3) <= small_enough || patch.free_count == 0) return shape;
  Eigen::AlignedBox3d box;
  for (int i = 0; i < patch.vertex_count(); ++i)
    if (patch.ring[i] <= 1) box.extend(Vec3(patch.to_mesh(patch.positions[i]) - origin));
  const Eigen::Vector3f middle = box.center().cast<float>();
  const auto too_far = static_cast<float>(reach * box.diagonal().norm());
  std::vector<char> left_out(shape->triangles.size() / 3, 0);
  for (std::size_t t = 0; t < left_out.size(); ++t) {
    const auto at = 3 * static_cast<std::size_t>(shape->triangles[3 * t]);
    left_out[t] = (Eigen::Map<const Eigen::Vector3f>(shape->points.data() + at) - middle).norm() > too_far;
  }
  return without_triangles(*shape, left_out);
}

SurfaceShapePtr without_triangles(const SurfaceShape& shape, const std::vector<char>& left_out) {
  std::vector<int> kept, number;
  for (std::size_t t = 0; t < shape.triangles.size() / 3; ++t)
    if (t >= left_out.size() || !left_out[t]) kept.push_back(static_cast<int>(t));
  return std::make_shared<SurfaceShape>(with_reduced(std::move(*with_triangles(shape, kept, number))));
}

}  // namespace loopmend
