// SPDX-License-Identifier: GPL-3.0-or-later
#include "hole_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loopmend::bench {

namespace {

constexpr double pi = std::numbers::pi;

/// Radius of the star in direction `angle`: lobes between 0.5 and 1.
double star_radius(int lobes, double angle) { return 0.75 + 0.25 * std::cos(lobes * angle); }

double polygon_radius(const std::vector<double>& radii, double angle) {
  const double sector = 2 * pi / static_cast<double>(radii.size());
  const double turn = angle < 0 ? angle + 2 * pi : angle;
  const std::size_t k = std::min(static_cast<std::size_t>(turn / sector), radii.size() - 1);
  const double a = radii[k], b = radii[(k + 1) % radii.size()], rest = turn - static_cast<double>(k) * sector;
  // The straight line between two corners, in polar coordinates.
  return a * b * std::sin(sector) / (a * std::sin(rest) + b * std::sin(sector - rest));
}

}  // namespace

const char* to_string(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::disc: return "disc";
    case ShapeKind::ellipse: return "ellipse";
    case ShapeKind::star: return "star";
    case ShapeKind::slit: return "slit";
    case ShapeKind::concave_polygon: return "concave polygon";
  }
  return "";
}

bool HoleShape::contains(double u, double v) const {
  const double radius = std::hypot(u, v), angle = std::atan2(v, u);
  switch (kind) {
    case ShapeKind::disc: return radius < 1;
    case ShapeKind::ellipse: return std::hypot(u, v / aspect) < 1;
    case ShapeKind::star: return radius < star_radius(lobes, angle);
    case ShapeKind::slit: return std::hypot(std::max(std::abs(u) - (1 - aspect), 0.0), v) < aspect;
    case ShapeKind::concave_polygon: return radius < polygon_radius(radii, angle);
  }
  return false;
}

double HoleShape::area() const {
  constexpr int cells = 200;
  int inside = 0;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      if (contains((2.0 * i + 1) / cells - 1, (2.0 * j + 1) / cells - 1)) ++inside;
  return 4.0 * inside / (cells * cells);
}

HoleShape random_shape(ShapeKind kind, Random& random) {
  HoleShape shape;
  shape.kind = kind;
  if (kind == ShapeKind::ellipse) shape.aspect = random.uniform(0.35, 0.8);
  if (kind == ShapeKind::slit) shape.aspect = random.uniform(0.08, 0.25);
  if (kind == ShapeKind::star) shape.lobes = 3 + static_cast<int>(random.next() % 4);
  if (kind == ShapeKind::concave_polygon) {
    shape.radii.resize(6 + random.next() % 4);
    for (std::size_t k = 0; k < shape.radii.size(); ++k)
      shape.radii[k] = k % 2 == 0 ? random.uniform(0.7, 1) : random.uniform(0.35, 0.7);
    shape.radii.front() = 1;
  }
  return shape;
}

}  // namespace loopmend::bench
