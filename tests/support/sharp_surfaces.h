// SPDX-License-Identifier: GPL-3.0-or-later
// Closed surfaces with sharp edges.
#pragma once

#include "mesh/triangle_soup.h"

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <tuple>

namespace loopmend::test {

/// Grids of quads, joined where their points coincide.
class GridSurface {
 public:
  /// Points place(x, y) for x and y from 0 to 1; the normal is ∂x × ∂y.
  void add(int columns, int rows, const std::function<Vec3(double, double)>& place) {
    std::vector<int> number;
    for (int i = 0; i <= columns; ++i)
      for (int k = 0; k <= rows; ++k)
        number.push_back(point(place(static_cast<double>(i) / columns, static_cast<double>(k) / rows)));
    for (int i = 0; i < columns; ++i)
      for (int k = 0; k < rows; ++k) {
        const int a = number[i * (rows + 1) + k], b = number[(i + 1) * (rows + 1) + k],
                  c = number[(i + 1) * (rows + 1) + k + 1], d = number[i * (rows + 1) + k + 1];
        if ((i + k) % 2 == 0) {
          triangle(a, b, c);
          triangle(a, c, d);
        } else {
          triangle(a, b, d);
          triangle(b, c, d);
        }
      }
  }
  TriangleSoup soup;

 private:
  int point(const Vec3& p) {
    const auto key = std::tuple(std::llround(p.x() * 1e9), std::llround(p.y() * 1e9), std::llround(p.z() * 1e9));
    const auto [entry, is_new] = numbers_.emplace(key, static_cast<int>(soup.points.size()));
    if (is_new) soup.points.push_back(p);
    return entry->second;
  }
  void triangle(int a, int b, int c) {
    if (a != b && b != c && c != a) soup.triangles.push_back({a, b, c});
  }
  std::map<std::tuple<long long, long long, long long>, int> numbers_;
};

/// [0, 1]³ with outward normals. @param cells  quads along an edge
inline TriangleSoup make_cube(int cells) {
  GridSurface cube;
  for (int axis = 0; axis < 3; ++axis)
    for (const int end : {0, 1})
      cube.add(cells, cells, [&](double x, double y) {
        Vec3 p;
        p[axis] = end;
        p[(axis + 1) % 3] = end == 1 ? x : y;
        p[(axis + 2) % 3] = end == 1 ? y : x;
        return p;
      });
  return std::move(cube.soup);
}

/// Radius 1 about z, −1 ≤ z ≤ 1, with both lids and outward normals. @param around  vertices on a circle
/// @param rows  of quads in the wall; 0: as long as wide
inline TriangleSoup make_closed_cylinder(int around, int rows = 0) {
  const auto turn = [](double x) { return 2 * std::numbers::pi * x; };
  GridSurface cylinder;
  cylinder.add(around, rows > 0 ? rows : around / 3,
               [&](double x, double y) { return Vec3(std::cos(turn(x)), std::sin(turn(x)), 2 * y - 1); });
  for (const int end : {-1, 1})
    cylinder.add(around, around / 6, [&](double x, double y) {
      return Vec3((1 - y) * std::cos(end * turn(x)), (1 - y) * std::sin(end * turn(x)), end);
    });
  return std::move(cylinder.soup);
}

/// A closed cylinder of radius 1 with a window in its wall from lid to lid, at the positive x axis.
inline TriangleSoup make_windowed_cylinder(int around, int rows, double height, double half_angle_deg) {
  TriangleSoup soup = make_closed_cylinder(around, rows);
  for (Vec3& p : soup.points) p.z() *= height / 2;
  std::erase_if(soup.triangles, [&](const Triangle& t) {
    const Vec3 middle = (soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]]) / 3;
    return std::abs(middle.z()) < 0.49 * height &&
           std::abs(std::atan2(middle.y(), middle.x())) < half_angle_deg * std::numbers::pi / 180;
  });
  return soup;
}

}  // namespace loopmend::test
