// SPDX-License-Identifier: GPL-3.0-or-later
// Small polyhedra with openings: the corners where surfaces have too few vertices for what smooth surfaces take for granted.
#pragma once

#include "samples/analytic_surfaces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace loopmend::test {

struct NamedMesh {
  std::string name;
  TriangleSoup soup;
};

/// Polygons as corner lists, cut into fans.
inline TriangleSoup fans(Points points, const std::vector<std::vector<int>>& polygons) {
  TriangleSoup soup;
  soup.points = std::move(points);
  for (const auto& polygon : polygons)
    for (std::size_t k = 2; k < polygon.size(); ++k) soup.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
  return soup;
}

/// A regular n-gon, height 1. Polygon 0 is the bottom, 1 the top.
inline NamedMesh prism(int n) {
  Points points;
  std::vector<std::vector<int>> polygons(2);
  for (int i = 0; i < 2 * n; ++i) {
    const double a = 2 * std::numbers::pi * (i % n) / n;
    points.emplace_back(std::cos(a), std::sin(a), i < n ? 0 : 1);
  }
  for (int i = 0; i < n; ++i) {
    polygons[0].push_back(n - 1 - i);
    polygons[1].push_back(n + i);
    polygons.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  return {"prism" + std::to_string(n), fans(std::move(points), polygons)};
}

inline NamedMesh pyramid(int n) {
  Points points;
  std::vector<std::vector<int>> polygons(1);
  for (int i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * i / n;
    points.emplace_back(std::cos(a), std::sin(a), 0);
    polygons[0].push_back(n - 1 - i);
    polygons.push_back({i, (i + 1) % n, n});
  }
  points.emplace_back(0, 0, 1);
  return {"pyramid" + std::to_string(n), fans(std::move(points), polygons)};
}

/// The unit cube, n by n squares to a side.
inline NamedMesh box(int n) {
  Points points;
  std::map<std::array<int, 3>, int> number;
  std::vector<std::vector<int>> polygons;
  const auto corner = [&](const std::array<int, 3>& at) {
    const auto [entry, added] = number.try_emplace(at, static_cast<int>(points.size()));
    if (added) points.push_back(Vec3(at[0], at[1], at[2]) / n);
    return entry->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int side : {0, n})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          std::vector<int> square;
          for (const auto& [di, dj] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
            std::array<int, 3> at{};
            at[axis] = side;
            at[(axis + 1) % 3] = i + di;
            at[(axis + 2) % 3] = j + dj;
            square.push_back(corner(at));
          }
          if (side == 0) std::reverse(square.begin(), square.end());
          polygons.push_back(square);
        }
  return {"box" + std::to_string(n), fans(std::move(points), polygons)};
}

/// Without the triangles that a test picks; points stay.
template <class Drop>
NamedMesh without(const NamedMesh& mesh, const std::string& what, const Drop& drop) {
  NamedMesh result{mesh.name + " without " + what, mesh.soup};
  std::erase_if(result.soup.triangles, drop);
  return result;
}

/// The mesh whole; without one triangle, two neighbouring ones, the fan of a vertex, all within one plane, two fans far apart.
inline std::vector<NamedMesh> openings_of(const NamedMesh& mesh) {
  std::vector<NamedMesh> result{mesh};
  const Points& points = mesh.soup.points;
  const Triangle first = mesh.soup.triangles.front();
  const Vec3 normal = (points[first[1]] - points[first[0]]).cross(points[first[2]] - points[first[0]]).normalized();
  const auto has = [](const Triangle& t, int v) { return t[0] == v || t[1] == v || t[2] == v; };
  const int last = static_cast<int>(points.size()) - 1;
  result.push_back(without(mesh, "a triangle", [&](const Triangle& t) { return t == first; }));
  result.push_back(without(mesh, "an edge", [&](const Triangle& t) { return has(t, first[0]) && has(t, first[1]); }));
  result.push_back(without(mesh, "a fan", [&](const Triangle& t) { return has(t, first[0]); }));
  result.push_back(without(mesh, "the last fan", [&](const Triangle& t) { return has(t, last); }));
  result.push_back(without(mesh, "two fans", [&](const Triangle& t) { return has(t, first[0]) || has(t, last); }));
  result.push_back(without(mesh, "a side", [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](int v) { return std::abs(normal.dot(points[v] - points[first[0]])) < 1e-9; });
  }));
  result.push_back(without(mesh, "all but a side", [&](const Triangle& t) {
    return !std::all_of(t.begin(), t.end(),
                        [&](int v) { return std::abs(normal.dot(points[v] - points[first[0]])) < 1e-9; });
  }));
  std::erase_if(result, [](const NamedMesh& m) { return m.soup.triangles.empty(); });
  return result;
}

/// Prisms, pyramids, boxes, icosahedra, each whole and with openings.
inline std::vector<NamedMesh> small_polyhedra() {
  std::vector<NamedMesh> solids;
  for (int n = 3; n <= 8; ++n) solids.push_back(prism(n));
  for (int n = 3; n <= 8; ++n) solids.push_back(pyramid(n));
  for (int n = 1; n <= 8; ++n) solids.push_back(box(n));
  for (int level = 0; level <= 2; ++level)
    solids.push_back({"icosphere" + std::to_string(level), make_icosphere(level)});
  std::vector<NamedMesh> result;
  for (const NamedMesh& solid : solids)
    for (NamedMesh& open : openings_of(solid)) result.push_back(std::move(open));
  return result;
}

}  // namespace loopmend::test
