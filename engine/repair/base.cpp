// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/base.h"

#include "core/error.h"
#include "mesh/loop_facing.h"
#include "mesh/pieces.h"
#include "mesh/self_intersections.h"
#include "mesh/triangulate_polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace loopmend {

namespace {

constexpr int most_base_rows = 1000;

/// How far the connected surface of the loop reaches in a direction.
double reach_of_part(const SurfaceModel& model, const BoundaryLoop& loop, const Vec3& direction) {
  int count = 0;
  const std::vector<int> part = parts_of_points(model, count);
  const int own = part[model.soup_vertex[loop.vertices.front()]];
  double reach = -std::numeric_limits<double>::infinity();
  for (std::size_t v = 0; v < part.size(); ++v)
    if (part[v] == own) reach = std::max(reach, model.soup.points[v].dot(direction));
  return reach;
}

void check_cuts(const TriangleSoup& soup, std::size_t given, const Message& name) {
  Triangles triangles(soup.triangles.begin() + static_cast<std::ptrdiff_t>(given), soup.triangles.end());
  const int made = static_cast<int>(triangles.size());
  triangles.insert(triangles.end(), soup.triangles.begin(),
                   soup.triangles.begin() + static_cast<std::ptrdiff_t>(given));
  const std::size_t cuts = self_intersections(soup.points, triangles, made).size();
  if (cuts > 0)
    throw InvalidArgument(say("%1: a straight wall would cut the surface, or itself, in %2 places", name, cuts));
}

}  // namespace

TriangleSoup with_base(const SurfaceModel& model, const BoundaryLoop& loop, double distance) {
  const Message name = say("base of loop %1", loop.number);
  if (!(distance > 0) || !std::isfinite(distance))
    throw InvalidArgument(say("%1: its distance must be a length above 0", name));
  const Vec3 down = loop_facing(model, loop).axis;  // what closes the loop faces away from the surface's back
  if (down.isZero()) throw InvalidArgument(say("%1: the loop encloses no area", name));
  TriangleSoup soup = model.soup;
  std::vector<int> above;
  for (int v : loop.vertices) above.push_back(model.soup_vertex[v]);
  const double plane = reach_of_part(model, loop, down) + distance, mean = loop.center.dot(down);
  const int rows =
      std::clamp(static_cast<int>(std::lround((plane - mean) * loop.edges() / std::max(loop.perimeter, 1e-300))), 1,
                 most_base_rows);
  const std::vector<int> top = above;
  const std::size_t n = top.size();
  for (int row = 1; row <= rows; ++row) {
    std::vector<int> below;
    for (int v : top) {
      const Vec3 p = soup.points[v];
      below.push_back(static_cast<int>(soup.points.size()));
      soup.points.push_back(p + (plane - p.dot(down)) * row / rows * down);
      if (!soup.colors.empty()) soup.colors.push_back(Color(soup.colors[v]));
    }
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t next = (k + 1) % n;
      soup.triangles.push_back({above[k], above[next], below[next]});
      soup.triangles.push_back({above[k], below[next], below[k]});
    }
    above = std::move(below);
  }
  const Triangles cap = triangulate_seen_flat(soup.points, above);
  if (cap.empty())
    throw InvalidArgument(say("%1: the loop overlaps itself seen from below: no straight wall fits", name));
  soup.triangles.insert(soup.triangles.end(), cap.begin(), cap.end());
  check_cuts(soup, model.soup.triangles.size(), name);
  return soup;
}

}  // namespace loopmend
