// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/inside_shell.h"

#define CGAL_NO_DEPRECATION_WARNINGS 1  // CGAL 6, of Debian 13, has AABB_traits_3 beside AABB_traits, CGAL 5 has not
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <optional>

namespace loopmend {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using ShellMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using ShellTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<ShellMesh>>>;

}  // namespace

struct InsideShell::Impl {
  ShellMesh mesh;  ///< its vertices are not shared, which the search for sides does not need
  ShellTree tree;
  std::optional<CGAL::Side_of_triangle_mesh<ShellMesh, Kernel>> side;
};

InsideShell::InsideShell(const Points& corners) : impl_(std::make_unique<Impl>()) {
  ShellMesh& mesh = impl_->mesh;
  const auto vertex = [&](const Vec3& p) { return mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z())); };
  for (std::size_t k = 0; k + 2 < corners.size(); k += 3)
    mesh.add_face(vertex(corners[k]), vertex(corners[k + 1]), vertex(corners[k + 2]));
  impl_->tree.rebuild(faces(mesh).first, faces(mesh).second, mesh);
  impl_->side.emplace(impl_->tree);
}

InsideShell::~InsideShell() = default;
InsideShell::InsideShell(InsideShell&&) noexcept = default;
InsideShell& InsideShell::operator=(InsideShell&&) noexcept = default;

InsideShell::Place InsideShell::of(const Vec3& p) const {
  switch ((*impl_->side)(Kernel::Point_3(p.x(), p.y(), p.z()))) {
    case CGAL::ON_BOUNDED_SIDE: return Place::inside;
    case CGAL::ON_UNBOUNDED_SIDE: return Place::outside;
    default: return Place::on_surface;
  }
}

}  // namespace loopmend
