// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/shells.h"

#include "mesh/no_data.h"
#include "mesh/pieces.h"
#include "repair/inside_shell.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>

namespace loopmend {

namespace {

/// Openings of a shell that is still closed, as a part of its area.
constexpr double most_open = 0.05;
/// Vertices of a shell that are looked for in another one first.
constexpr std::size_t samples = 5;

/// Of a tetrahedron over the origin, six times.
double volume_over(const Vec3& a, const Vec3& b, const Vec3& c) { return a.dot(b.cross(c)); }

/// Flat fans over a loop, and what they leave uncertain.
void cover(Shell& shell, const SurfaceModel& model, const BoundaryLoop& loop, const Vec3& origin) {
  const auto at = [&](std::size_t k) -> const Vec3& {
    return model.soup.points[model.soup_vertex[loop.vertices[k % loop.vertices.size()]]];
  };
  double area = 0;
  for (std::size_t k = 0; k < loop.vertices.size(); ++k) {
    const Vec3 &a = at(k), &b = at(k + 1);  // the hole lies to their left
    shell.covers.insert(shell.covers.end(), {a, b, loop.center});
    area += (b - a).cross(loop.center - a).norm() / 2;
    shell.volume += volume_over(a - origin, b - origin, loop.center - origin) / 6;
  }
  shell.is_open = true;
  shell.has_opening = shell.has_opening || loop.kind == LoopKind::hole || loop.kind == LoopKind::outer_rim;
  shell.openings += area;
  shell.uncertainty += area * loop.diameter / 3;  // what a half ball over it would hold
}

double begin_of(const Shell& shell) { return shell.box.min().x(); }

/// So that of many shells only those are compared that are side by side.
std::vector<int> by_begin(const std::vector<Shell>& shells) {
  std::vector<int> order(shells.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return begin_of(shells[a]) < begin_of(shells[b]); });
  return order;
}

/// Whether some vertices of the shell all lie inside; where all of these lie on the other, others decide.
bool lies_in(const SurfaceModel& model, const Shell& shell, const InsideShell& other) {
  const std::size_t corners = 3 * shell.faces.size(), step = std::max<std::size_t>(1, corners / samples);
  bool any = false;
  for (std::size_t first = 0; first < step && !any; ++first)
    for (std::size_t k = first; k < corners; k += step) {
      const Triangle& t = model.soup.triangles[static_cast<std::size_t>(shell.faces[k / 3])];
      const InsideShell::Place place = other.of(model.soup.points[t[k % 3]]);
      if (place == InsideShell::Place::outside) return false;
      any = any || place == InsideShell::Place::inside;
    }
  return any;
}

}  // namespace

bool Shell::is_certain() const { return has_sides && std::abs(volume) > uncertainty; }

bool Shell::is_nearly_closed() const { return openings <= most_open * area && !may_be_a_room; }

Shells find_shells(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  Shells shells;
  int count = 0;
  shells.of_point = parts_of_points(model, count);
  shells.all.resize(static_cast<std::size_t>(count));
  const Points& points = model.soup.points;
  std::vector<Vec3> origins(shells.all.size(),
                            Vec3::Zero());  // a point of each, so that far from the origin no digits are lost
  for_each_soup_triangle(model, [&](int f) {
    const Triangle& t = model.soup.triangles[static_cast<std::size_t>(f)];
    Shell& shell = shells.all[shells.of_point[t[0]]];
    Vec3& origin = origins[shells.of_point[t[0]]];
    if (shell.box.isEmpty()) origin = points[t[0]];
    const Vec3 a = points[t[0]] - origin, b = points[t[1]] - origin, c = points[t[2]] - origin;
    for (int v : t) shell.box.extend(points[v]);
    shell.area += (b - a).cross(c - a).norm() / 2;
    shell.volume += volume_over(a, b, c) / 6;
  });
  for (const BoundaryLoop& loop : loops) {
    const int s = shells.of_point[model.soup_vertex[loop.vertices.front()]];
    cover(shells.all[s], model, loop, origins[s]);
    if (loop.kind == LoopKind::cut) shells.all[s].has_sides = false;
  }
  for (const int v : find_no_data(points).vertices)  // spikes of a sheet, which has no inside
    if (shells.of_point[v] >= 0) shells.all[shells.of_point[v]].has_sides = false;
  for (Shell& shell : shells.all) shell.uncertainty += 1e-12 * shell.area * shell.box.diagonal().norm();  // of rounding
  return shells;
}

void list_faces(const SurfaceModel& model, Shells& shells) {
  for_each_soup_triangle(model, [&](int f) {
    shells.all[shells.of_point[model.soup.triangles[static_cast<std::size_t>(f)][0]]].faces.push_back(f);
  });
}

Points corners_of(const SurfaceModel& model, const Shell& shell) {
  Points corners;
  for (int f : shell.faces)
    for (int v : model.soup.triangles[static_cast<std::size_t>(f)]) corners.push_back(model.soup.points[v]);
  corners.insert(corners.end(), shell.covers.begin(), shell.covers.end());
  return corners;
}

bool some_boxes_meet(const std::vector<Shell>& shells) {
  const std::vector<int> order = by_begin(shells);
  for (auto a = order.begin(); a != order.end(); ++a)
    for (auto b = a + 1; b != order.end() && begin_of(shells[*b]) <= shells[*a].box.max().x(); ++b)
      if (shells[*a].box.intersects(shells[*b].box)) return true;
  return false;
}

void find_nesting(const SurfaceModel& model, std::vector<Shell>& shells) {
  const std::vector<int> order = by_begin(shells);
  for (int outer = 0; outer < static_cast<int>(shells.size()); ++outer) {
    const Eigen::AlignedBox3d& box = shells[outer].box;
    std::optional<InsideShell> inside;
    auto inner =
        std::partition_point(order.begin(), order.end(), [&](int s) { return begin_of(shells[s]) < box.min().x(); });
    for (; inner != order.end() && begin_of(shells[*inner]) <= box.max().x(); ++inner) {
      if (*inner == outer || !box.contains(shells[*inner].box) || shells[*inner].crosses.contains(outer)) continue;
      if (!inside) inside.emplace(corners_of(model, shells[outer]));
      if (lies_in(model, shells[*inner], *inside)) shells[*inner].around.push_back(outer);
    }
  }
}

}  // namespace loopmend
