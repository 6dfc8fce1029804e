// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/inside_shell.h"

#define CGAL_NO_DEPRECATION_WARNINGS 1  // CGAL 6, of Debian 13, has AABB_traits_3 beside AABB_traits, CGAL 5 has not
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using ShellMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using ShellTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<ShellMesh>>>;

/// Faces by the cells of a grid that they meet, seen along a direction: a ray in it meets faces of one cell only.
class RayGrid {
 public:
  explicit RayGrid(const Points& corners)
      : corners_(corners),
        origin_(corners.empty() ? Vec3::Zero().eval() : corners.front()) {
    for (const Vec3& p : corners) {
      size_.extend(p);
      seen_.extend(seen(p));
    }
    for (cells_ = std::clamp(static_cast<int>(std::sqrt(face_count())), 1, most_cells); cells_ > 1; cells_ /= 2)
      if (entries() <= most_entries * corners.size()) break;
    begin_.assign(static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_) + 1, 0);
    for_each_entry([this](std::size_t cell, int) { ++begin_[cell + 1]; });
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    face_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for_each_entry([&](std::size_t cell, int face) { face_[next[cell]++] = face; });
  }

  /// By the parity of crossings. @returns nothing where the ray comes so near to an edge, or the point to a face, that
  /// rounding might decide.
  std::optional<bool> is_inside(const Vec3& p) const {
    const Eigen::Vector2d q = seen(p);
    if (!seen_.contains(q)) return false;
    constexpr double error_of_share = 1e-5;  // where the ray is `tiny` off the edge
    const double tiny = 1e-10 * size_.diagonal().norm();
    const std::size_t cell = cell_of(q.y(), 1) * static_cast<std::size_t>(cells_) + cell_of(q.x(), 0);
    bool inside = false;
    for (std::size_t k = begin_[cell]; k < begin_[cell + 1]; ++k) {
      double share[3];  // of the triangle's area, towards its corners
      bool left = false, right = false, near_an_edge = false;
      for (int side = 0; side < 3; ++side) {
        const Eigen::Vector2d a = seen(corner(face_[k], side)), along = seen(corner(face_[k], side + 1)) - a;
        share[side] = along.x() * (q - a).y() - along.y() * (q - a).x();
        near_an_edge = near_an_edge || !(std::abs(share[side]) > tiny * along.norm());
        left = left || share[side] > tiny * along.norm();
        right = right || share[side] < -tiny * along.norm();
      }
      if (left && right) continue;
      if (near_an_edge) return std::nullopt;
      const Vec3 z(corner(face_[k], 0).z(), corner(face_[k], 1).z(), corner(face_[k], 2).z());
      const double sum = share[0] + share[1] + share[2];
      const double height = (share[1] * z[0] + share[2] * z[1] + share[0] * z[2]) / sum - p.z();
      if (!(std::abs(height) > tiny + error_of_share * (z.maxCoeff() - z.minCoeff()))) return std::nullopt;
      if (height > 0) inside = !inside;
    }
    return inside;
  }

 private:
  static constexpr int most_cells = 1024;         ///< along each side
  static constexpr std::size_t most_entries = 4;  ///< in the mean for each corner

  /// Along (0.3713, 0.2917, 1), which no row of points of a regular grid follows.
  Eigen::Vector2d seen(const Vec3& p) const {
    const Vec3 d = p - origin_;
    return {d.x() - 0.3713 * d.z(), d.y() - 0.2917 * d.z()};
  }
  const Vec3& corner(int face, int k) const {
    return corners_[3 * static_cast<std::size_t>(face) + static_cast<std::size_t>(k % 3)];
  }
  int face_count() const { return static_cast<int>(corners_.size() / 3); }
  std::size_t cell_of(double at, int axis) const {
    const double width = seen_.sizes()[axis];
    const double share = width > 0 ? (at - seen_.min()[axis]) / width : 0;
    return static_cast<std::size_t>(std::clamp(static_cast<int>(share * cells_), 0, cells_ - 1));
  }
  struct Cells {
    std::size_t left, right, bottom, top;
  };
  Cells cells_of(int face) const {
    Eigen::AlignedBox2d box(seen(corner(face, 0)));
    box.extend(seen(corner(face, 1))).extend(seen(corner(face, 2)));
    return {cell_of(box.min().x(), 0), cell_of(box.max().x(), 0), cell_of(box.min().y(), 1), cell_of(box.max().y(), 1)};
  }
  std::size_t entries() const {
    std::size_t sum = 0;
    for (int f = 0; f < face_count(); ++f) {
      const Cells cells = cells_of(f);
      sum += (cells.right - cells.left + 1) * (cells.top - cells.bottom + 1);
    }
    return sum;
  }
  void for_each_entry(const auto& act) const {
    for (int f = 0; f < face_count(); ++f) {
      const Cells cells = cells_of(f);
      for (std::size_t y = cells.bottom; y <= cells.top; ++y)
        for (std::size_t x = cells.left; x <= cells.right; ++x) act(y * static_cast<std::size_t>(cells_) + x, f);
    }
  }

  const Points& corners_;
  Vec3 origin_;  ///< so that far from that of the file no digits are lost
  Eigen::AlignedBox3d size_;
  Eigen::AlignedBox2d seen_;
  int cells_ = 1;
  std::vector<std::size_t> begin_;  ///< of each cell in face_
  std::vector<int> face_;
};

/// CGAL's search with exact predicates, for points that the grid leaves undecided.
struct ExactSides {
  explicit ExactSides(const Points& corners) {
    const auto vertex = [&](const Vec3& p) { return mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z())); };
    for (std::size_t k = 0; k + 2 < corners.size(); k += 3)
      mesh.add_face(vertex(corners[k]), vertex(corners[k + 1]), vertex(corners[k + 2]));
    tree.rebuild(faces(mesh).first, faces(mesh).second, mesh);
    side.emplace(tree);
  }

  ShellMesh mesh;  ///< its vertices are not shared, which the search for sides does not need
  ShellTree tree;
  std::optional<CGAL::Side_of_triangle_mesh<ShellMesh, Kernel>> side;
};

}  // namespace

struct InsideShell::Impl {
  explicit Impl(Points from) : corners(std::move(from)), grid(corners) {}

  Points corners;
  RayGrid grid;
  std::once_flag asked;
  std::unique_ptr<ExactSides> exact;  ///< made when it is first needed: it takes twenty times as long as the grid
};

InsideShell::InsideShell(Points corners) : impl_(std::make_unique<Impl>(std::move(corners))) {}

InsideShell::~InsideShell() = default;
InsideShell::InsideShell(InsideShell&&) noexcept = default;
InsideShell& InsideShell::operator=(InsideShell&&) noexcept = default;

InsideShell::Place InsideShell::of(const Vec3& p) const {
  if (const std::optional<bool> inside = impl_->grid.is_inside(p)) return *inside ? Place::inside : Place::outside;
  std::call_once(impl_->asked, [this] { impl_->exact = std::make_unique<ExactSides>(impl_->corners); });
  switch ((*impl_->exact->side)(Kernel::Point_3(p.x(), p.y(), p.z()))) {
    case CGAL::ON_BOUNDED_SIDE: return Place::inside;
    case CGAL::ON_UNBOUNDED_SIDE: return Place::outside;
    default: return Place::on_surface;
  }
}

}  // namespace loopmend
