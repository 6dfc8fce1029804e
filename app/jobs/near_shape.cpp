// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/near_shape.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace loopmend {
namespace {

constexpr int small_enough = 60000;  ///< triangles that four views draw without effort
constexpr double reach = 1.5;        ///< patch sizes around the patch's middle

}  // namespace

std::shared_ptr<const SurfaceShape> near_shape(const std::shared_ptr<const SurfaceShape>& shape, const Patch& patch,
                                               const Vec3& origin) {
  if (static_cast<int>(shape->triangles.size() / 3) <= small_enough || patch.free_count == 0) return shape;
  Eigen::AlignedBox3d box;
  for (int i = 0; i < patch.vertex_count(); ++i)
    if (patch.ring[static_cast<std::size_t>(i)] <= 1)
      box.extend(Vec3(patch.to_mesh(patch.positions[static_cast<std::size_t>(i)]) - origin));
  const Eigen::Vector3f middle = box.center().cast<float>();
  const auto far = static_cast<float>(reach * box.diagonal().norm());
  std::vector<char> left_out(shape->triangles.size() / 3, 0);
  for (std::size_t t = 0; t < left_out.size(); ++t) {
    const auto at = 3 * static_cast<std::size_t>(shape->triangles[3 * t]);
    left_out[t] = (Eigen::Map<const Eigen::Vector3f>(shape->points.data() + at) - middle).norm() > far;
  }
  return without_triangles(*shape, left_out);
}

std::shared_ptr<const SurfaceShape> without_triangles(const SurfaceShape& shape, const std::vector<char>& left_out) {
  auto rest = std::make_shared<SurfaceShape>();
  rest->picture = shape.picture;
  std::vector<int> number(shape.points.size() / 3, -1);
  const auto keep = [&](int v) {
    int& n = number[static_cast<std::size_t>(v)];
    if (n >= 0) return n;
    n = static_cast<int>(rest->points.size() / 3);
    const auto at = 3 * static_cast<std::size_t>(v);
    for (std::size_t k = 0; k < 3; ++k) {
      rest->points.push_back(shape.points[at + k]);
      rest->normals.push_back(shape.normals[at + k]);
    }
    if (!shape.colors.empty())
      for (std::size_t k = 0; k < 3; ++k) rest->colors.push_back(shape.colors[at + k]);
    if (!shape.texture.empty())
      for (std::size_t k = 0; k < 2; ++k) rest->texture.push_back(shape.texture[2 * static_cast<std::size_t>(v) + k]);
    if (!shape.H.empty()) rest->H.push_back(shape.H[static_cast<std::size_t>(v)]);
    if (!shape.K.empty()) rest->K.push_back(shape.K[static_cast<std::size_t>(v)]);
    return n;
  };
  for (std::size_t t = 0; t < shape.triangles.size() / 3; ++t) {
    if (t < left_out.size() && left_out[t]) continue;
    for (std::size_t k = 0; k < 3; ++k) rest->triangles.push_back(keep(shape.triangles[3 * t + k]));
    if (static_cast<int>(t) < shape.own_triangles) ++rest->own_triangles;
  }
  return rest;
}

}  // namespace loopmend
