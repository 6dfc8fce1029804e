// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/analytic_surfaces.h"

#include "core/error.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace loopmend {
namespace {

constexpr double pi = std::numbers::pi;

void require(bool holds, const char* what) {
  if (!holds) throw InvalidArgument(verbatim(what));
}

TriangleSoup make_icosahedron() {
  const double t = std::numbers::phi;
  TriangleSoup soup;
  soup.points = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                 {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
  for (Vec3& p : soup.points) p.normalize();
  soup.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  return soup;
}

/// Every triangle into four; new points are pushed out to the unit sphere.
TriangleSoup split_sphere(TriangleSoup soup) {
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<int>(soup.points.size()));
    if (is_new) soup.points.push_back((soup.points[a] + soup.points[b]).normalized());
    return place->second;
  };
  Triangles split;
  split.reserve(4 * soup.triangles.size());
  for (const auto& [a, b, c] : soup.triangles) {
    const int ab = middle(a, b);
    const int bc = middle(b, c);
    const int ca = middle(c, a);
    split.insert(split.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  soup.triangles = std::move(split);
  return soup;
}

/// Quads of a columns × rows grid of points (point = row·columns + column), counter-clockwise when columns run to the
/// right and rows upwards, with diagonals that alternate like a chess board.
Triangles grid_triangles(int columns, int rows, bool wrap_columns, bool wrap_rows) {
  Triangles triangles;
  for (int j = 0; j < (wrap_rows ? rows : rows - 1); ++j) {
    for (int i = 0; i < (wrap_columns ? columns : columns - 1); ++i) {
      const int right = (i + 1) % columns;
      const int up = (j + 1) % rows;
      const int a = j * columns + i;
      const int b = j * columns + right;
      const int c = up * columns + right;
      const int d = up * columns + i;
      if ((i + j) % 2 == 0) {
        triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
      } else {
        triangles.insert(triangles.end(), {{a, b, d}, {b, c, d}});
      }
    }
  }
  return triangles;
}

}  // namespace

TriangleSoup make_icosphere(int level) {
  require(level >= 0 && level <= 8, "An icosphere's level must be 0 to 8.");
  TriangleSoup soup = make_icosahedron();
  for (int i = 0; i < level; ++i) soup = split_sphere(std::move(soup));
  return soup;
}

TriangleSoup make_cylinder(double height, int around) {
  require(height > 0, "A cylinder's height must be positive.");
  require(around >= 8, "A cylinder needs at least 8 vertices around.");
  const int rows = std::max(1, static_cast<int>(std::lround(height * around / (2 * pi))));
  return make_revolution([](double) { return 1.0; }, 0, height, around, rows);
}

TriangleSoup make_revolution(const std::function<double(double)>& radius, double z0, double z1, int around, int rows) {
  require(z1 > z0, "A surface of revolution needs z0 < z1.");
  require(around >= 8 && rows >= 1, "A surface of revolution needs at least 8 vertices around and 1 row.");
  TriangleSoup soup;
  for (int j = 0; j <= rows; ++j) {
    const double z = j == rows ? z1 : z0 + (z1 - z0) * j / rows;
    const double r = radius(z);
    require(r > 0, "The radius of a surface of revolution must be positive.");
    for (int i = 0; i < around; ++i) {
      const double u = 2 * pi * i / around;
      soup.points.emplace_back(r * std::cos(u), r * std::sin(u), z);
    }
  }
  soup.triangles = grid_triangles(around, rows + 1, true, false);
  return soup;
}

TriangleSoup make_torus(double major, double minor, int around_major, int around_minor) {
  require(minor > 0 && major > minor, "A torus needs major > minor > 0.");
  require(around_major >= 3 && around_minor >= 3, "A torus needs at least 3 vertices around each way.");
  TriangleSoup soup;
  for (int j = 0; j < around_minor; ++j) {
    const double v = 2 * pi * j / around_minor;
    const double r = major + minor * std::cos(v);
    for (int i = 0; i < around_major; ++i) {
      const double u = 2 * pi * i / around_major;
      soup.points.emplace_back(r * std::cos(u), r * std::sin(u), minor * std::sin(v));
    }
  }
  soup.triangles = grid_triangles(around_major, around_minor, true, true);
  return soup;
}

TriangleSoup make_graph(const std::function<double(double, double)>& height, double half, int cells) {
  require(half > 0 && cells >= 1, "A graph needs a positive half width and at least one cell.");
  TriangleSoup soup;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const double x = half * (2.0 * i / cells - 1);
      const double y = half * (2.0 * j / cells - 1);
      soup.points.emplace_back(x, y, height(x, y));
    }
  }
  soup.triangles = grid_triangles(cells + 1, cells + 1, false, false);
  return soup;
}

}  // namespace loopmend
