// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth_mesh.h"

#define CGAL_NO_DEPRECATION_WARNINGS 1  // CGAL 6, of Debian 13, has AABB_traits_3 beside AABB_traits, CGAL 5 has not
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>

namespace loopmend::bench {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Faces = std::vector<Kernel::Triangle_3>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Faces::const_iterator>>>;

Faces to_faces(const TriangleSoup& soup) {
  const auto point = [&](int v) { return Kernel::Point_3(soup.points[v].x(), soup.points[v].y(), soup.points[v].z()); };
  Faces faces;
  for (const auto& [a, b, c] : soup.triangles) {
    const Kernel::Triangle_3 face(point(a), point(b), point(c));
    if (!face.is_degenerate()) faces.push_back(face);
  }
  return faces;
}

}  // namespace

struct TruthMesh::Impl {
  explicit Impl(const TriangleSoup& soup) : faces(to_faces(soup)), tree(faces.begin(), faces.end()) {
    tree.build();
    tree.accelerate_distance_queries();
  }
  Faces faces;
  Tree tree;
};

TruthMesh::TruthMesh(const TriangleSoup& soup) : impl_(std::make_shared<const Impl>(soup)) {}

double TruthMesh::distance(const Vec3& p) const {
  return std::sqrt(impl_->tree.squared_distance({p.x(), p.y(), p.z()}));
}

}  // namespace loopmend::bench
