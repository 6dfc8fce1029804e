// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/inverted_shells.h"

#include "mesh/pieces.h"
#include "repair/inside_shell.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace loopmend {

namespace {

/// Openings of a shell that is still closed, as a part of its area.
constexpr double most_open = 0.05;
/// Vertices of a shell that must lie in another one for it to be inside.
constexpr std::size_t most_samples = 5;

struct Shell {
  std::vector<int> faces;  ///< soup triangles; only where find_faces() was asked for them
  Points covers;           ///< three corners after another: fans over its openings
  Eigen::AlignedBox3d box;
  double area = 0, volume = 0;
  double openings = 0;      ///< area of the fans
  double uncertainty = 0;   ///< of the volume: what covers as high as half balls would change
  bool has_sides = true;    ///< whether each edge has two faces, or one
  std::vector<int> around;  ///< the shells that it lies in

  bool is_certain() const { return has_sides && std::abs(volume) > uncertainty; }
  bool is_closed() const { return openings <= most_open * area; }
};

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
  shell.openings += area;
  shell.uncertainty += area * loop.diameter / 3;  // what a half ball over it would hold
}

std::vector<Shell> find_shells(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                               const std::vector<int>& shell_of, int count) {
  std::vector<Shell> shells(static_cast<std::size_t>(count));
  const Points& points = model.soup.points;
  std::vector<Vec3> origins(shells.size(),
                            Vec3::Zero());  // a point of each, so that far from the origin no digits are lost
  for_each_soup_triangle(model, [&](int f) {
    const Triangle& t = model.soup.triangles[static_cast<std::size_t>(f)];
    Shell& shell = shells[shell_of[t[0]]];
    Vec3& origin = origins[shell_of[t[0]]];
    if (shell.box.isEmpty()) origin = points[t[0]];
    const Vec3 a = points[t[0]] - origin, b = points[t[1]] - origin, c = points[t[2]] - origin;
    for (int v : t) shell.box.extend(points[v]);
    shell.area += (b - a).cross(c - a).norm() / 2;
    shell.volume += volume_over(a, b, c) / 6;
  });
  for (const BoundaryLoop& loop : loops) {
    const int s = shell_of[model.soup_vertex[loop.vertices.front()]];
    cover(shells[s], model, loop, origins[s]);
    if (loop.kind == LoopKind::cut) shells[s].has_sides = false;
  }
  for (Shell& shell : shells)
    if (!shell.box.isEmpty()) shell.uncertainty += 1e-12 * shell.area * shell.box.diagonal().norm();  // of rounding
  return shells;
}

/// Makes the lists of faces. @returns the shells that are certain alone.
std::vector<Shell> with_faces(const SurfaceModel& model, std::vector<Shell> shells, const std::vector<int>& shell_of) {
  for_each_soup_triangle(model, [&](int f) {
    Shell& shell = shells[shell_of[model.soup.triangles[static_cast<std::size_t>(f)][0]]];
    if (shell.is_certain()) shell.faces.push_back(f);
  });
  std::erase_if(shells, [](const Shell& shell) { return shell.faces.empty(); });
  return shells;
}

/// The surface of a shell with its covers, three corners after another.
Points corners_of(const SurfaceModel& model, const Shell& shell) {
  Points corners;
  for (int f : shell.faces)
    for (int v : model.soup.triangles[static_cast<std::size_t>(f)]) corners.push_back(model.soup.points[v]);
  corners.insert(corners.end(), shell.covers.begin(), shell.covers.end());
  return corners;
}

/// Whether some vertices of the shell all lie inside.
bool lies_in(const SurfaceModel& model, const Shell& shell, const InsideShell& other) {
  bool any = false;
  const std::size_t step = std::max<std::size_t>(1, shell.faces.size() / most_samples);
  for (std::size_t k = 0; k < shell.faces.size(); k += step) {
    const Vec3& p = model.soup.points[model.soup.triangles[static_cast<std::size_t>(shell.faces[k])][0]];
    const InsideShell::Place place = other.of(p);
    if (place == InsideShell::Place::outside) return false;
    any = any || place == InsideShell::Place::inside;
  }
  return any;
}

void find_nesting(const SurfaceModel& model, std::vector<Shell>& shells) {
  for (std::size_t outer = 0; outer < shells.size(); ++outer) {
    std::optional<InsideShell> inside;
    for (std::size_t inner = 0; inner < shells.size(); ++inner) {
      if (inner == outer || !shells[outer].box.contains(shells[inner].box)) continue;
      if (!inside) inside.emplace(corners_of(model, shells[outer]));
      if (lies_in(model, shells[inner], *inside)) shells[inner].around.push_back(static_cast<int>(outer));
    }
  }
}

/// For each shell whether it is inside out. What lies in an open one that is, stays as it is with that.
std::vector<char> inverted(const std::vector<Shell>& shells) {
  std::vector<char> result(shells.size(), 0);
  const auto is_body = [&](std::size_t s) { return shells[s].around.size() % 2 == 0; };
  for (std::size_t s = 0; s < shells.size(); ++s) result[s] = is_body(s) && shells[s].volume < 0;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    if (is_body(s)) continue;
    const std::vector<int>& around = shells[s].around;
    const int body = *std::max_element(around.begin(), around.end(),
                                       [&](int a, int b) { return shells[a].around.size() < shells[b].around.size(); });
    result[s] = result[body] && shells[s].volume > 0;
  }
  const std::vector<char> alone = result;
  for (std::size_t s = 0; s < shells.size(); ++s)
    if (std::any_of(shells[s].around.begin(), shells[s].around.end(),
                    [&](int outer) { return alone[outer] && !shells[outer].is_closed(); }))
      result[s] = 0;
  return result;
}

}  // namespace

InvertedShells find_inverted_shells(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  InvertedShells result;
  int count = 0;
  const std::vector<int> shell_of = parts_of_points(model, count);
  std::vector<Shell> shells = find_shells(model, loops, shell_of, count);
  const auto may_be_inverted = [](const Shell& shell) { return shell.is_certain() && shell.volume < 0; };
  if (std::none_of(shells.begin(), shells.end(), may_be_inverted)) return result;
  std::vector<Eigen::AlignedBox3d> of_others;  // that may be bodies or not
  for (const Shell& shell : shells)
    if (!shell.box.isEmpty() && !shell.is_certain()) of_others.push_back(shell.box);
  shells = with_faces(model, std::move(shells), shell_of);
  find_nesting(model, shells);
  const std::vector<char> is_inverted = inverted(shells);
  for (std::size_t s = 0; s < shells.size(); ++s) {
    const bool may_be_a_cavity = std::any_of(of_others.begin(), of_others.end(), [&](const Eigen::AlignedBox3d& box) {
      return box.contains(shells[s].box);
    });
    if (!is_inverted[s] || may_be_a_cavity) continue;
    ++(shells[s].is_closed() ? result.closed : result.open);
    if (!shells[s].is_closed()) continue;
    result.faces.resize(model.soup.triangles.size(), 0);
    result.face_count += shells[s].faces.size();
    for (int f : shells[s].faces) result.faces[f] = 1;
  }
  return result;
}

}  // namespace loopmend
