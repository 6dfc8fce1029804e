// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface_tree.h"

#define CGAL_NO_DEPRECATION_WARNINGS 1  // CGAL 6, of Debian 13, has AABB_traits_3 beside AABB_traits, CGAL 5 has not
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <Eigen/Geometry>

#include <vector>

namespace loopmend {

namespace {

using TreeKernel = CGAL::Simple_cartesian<double>;
using TreeTriangles = std::vector<TreeKernel::Triangle_3>;
using TreeTraits =
    CGAL::AABB_traits<TreeKernel, CGAL::AABB_triangle_primitive<TreeKernel, TreeTriangles::const_iterator>>;

}  // namespace

struct SurfaceTree::Impl {
  TreeTriangles triangles;
  std::vector<int> number;  ///< of each: its place in those given
  CGAL::AABB_tree<TreeTraits> tree;
};

SurfaceTree::SurfaceTree(const Points& points, const Triangles& triangles) : impl_(std::make_unique<Impl>()) {
  const auto at = [&](int v) { return TreeKernel::Point_3(points[v].x(), points[v].y(), points[v].z()); };
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const auto& [a, b, c] = triangles[f];
    if ((points[b] - points[a]).cross(points[c] - points[a]).isZero(0)) continue;
    impl_->triangles.emplace_back(at(a), at(b), at(c));
    impl_->number.push_back(static_cast<int>(f));
  }
  if (impl_->triangles.empty()) return;
  impl_->tree.insert(impl_->triangles.cbegin(), impl_->triangles.cend());
  impl_->tree.build();
  impl_->tree.accelerate_distance_queries();
}

SurfaceTree::~SurfaceTree() = default;
SurfaceTree::SurfaceTree(SurfaceTree&&) noexcept = default;
SurfaceTree& SurfaceTree::operator=(SurfaceTree&&) noexcept = default;

SurfacePoint SurfaceTree::closest(const Vec3& p) const {
  if (impl_->triangles.empty()) return {p, -1};
  const auto found = impl_->tree.closest_point_and_primitive({p.x(), p.y(), p.z()});
  const auto place = static_cast<std::size_t>(found.second - impl_->triangles.cbegin());
  return {Vec3(found.first.x(), found.first.y(), found.first.z()), impl_->number[place]};
}

}  // namespace loopmend
