// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/fill_loops.h"
#include "mesh/mesh_arrays.h"
#include "samples/random.h"
#include "support/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>

namespace loopmend {
namespace {

/// A sphere with relief of scans and white noise, without its cap.
SurfaceModel rough_open_sphere(double relief, double noise) {
  TriangleSoup soup = make_icosphere(5);
  Random random(7);
  for (Vec3& p : soup.points)
    p *= 1 + noise * random.bell() +
         relief * (0.01 * std::sin(17 * p.x()) * std::sin(19 * p.y()) + 0.004 * std::sin(43 * p.x() + 7 * p.z()) +
                   0.002 * std::cos(71 * p.y() - 23 * p.x()));
  return make_surface_model(trim_rims(cut(soup, [](const Vec3& p) { return p.z() > 0.85; })));
}

/// Of the filled surface's new vertices: mean and rms distance from the unit sphere, and the largest outwards; and what the
/// rim was taken for. The largest inwards still jumps from smooth to rough: by 0.0021, 5.6 % of an edge.
struct Shape {
  std::array<double, 3> figures{};
  RimRoughness rim;
};

Shape filled(SurfaceModel model) {
  const std::size_t old = model.soup.points.size();
  Shape shape;
  for (const LoopResult& result : fill_loops(model, find_boundary_loops(model), {}, nullptr, {})) {
    EXPECT_EQ(result.status, LoopStatus::converged) << result.message;
    shape.rim = result.rim.roughness;
  }
  double count = 0;
  for (std::size_t v = old; v < model.soup.points.size(); ++v) {
    const double r = model.soup.points[v].norm() - 1;
    shape.figures[0] += r;
    shape.figures[1] += r * r;
    shape.figures[2] = std::max(shape.figures[2], r);
    ++count;
  }
  shape.figures[0] /= count;
  shape.figures[1] = std::sqrt(shape.figures[1] / count);
  return shape;
}

double change(const Shape& a, const Shape& b) {
  double most = 0;
  for (int k = 0; k < 3; ++k) most = std::max(most, std::abs(a.figures[k] - b.figures[k]));
  return most;
}

/// Where the patch changes most over a family of surfaces, t = 0..1, the interval is halved again and again: a jump stays.
/// @returns what is left of the change over 1/1000 of the family or less.
double steepest(const std::function<SurfaceModel(double)>& surface, int intervals) {
  std::vector<Shape> shapes;
  for (int k = 0; k <= intervals; ++k) shapes.push_back(filled(surface(static_cast<double>(k) / intervals)));
  double left = 0;
  for (int k = 0; k < intervals; ++k) {
    // All changes of kind, and the largest change of shape.
    Shape a = shapes[k], b = shapes[k + 1];
    bool widest = true;
    for (int j = 0; j < intervals; ++j) widest = widest && change(shapes[j], shapes[j + 1]) <= change(a, b);
    if (!widest && a.rim.kind == b.rim.kind) continue;
    double from = static_cast<double>(k) / intervals, to = static_cast<double>(k + 1) / intervals;
    while (to - from > 1e-3) {
      const double middle = (from + to) / 2;
      const Shape m = filled(surface(middle));
      if (change(a, m) > change(m, b)) {
        b = m;
        to = middle;
      } else {
        a = m;
        from = middle;
      }
    }
    left = std::max(left, change(a, b));
  }
  return left;
}

constexpr double edge = 0.038;  // mean, of the icosphere
/// Of the change over 1/1000 of a family, jumps among it. Measured: 0.006 of an edge from smooth to rough, 0.014 from rough
/// to noisy, less from smooth to noisy; the filler's triangulation, which changes with the rim, is part of it.
constexpr double tolerance = 0.02 * edge;

TEST(PassageOfKinds, FromSmoothToRoughWithoutAJump) {
  EXPECT_LT(steepest([](double t) { return rough_open_sphere(t, 0); }, 8), tolerance);
}

TEST(PassageOfKinds, FromSmoothToNoisyWithoutAJump) {
  EXPECT_LT(steepest([](double t) { return rough_open_sphere(0, 0.01 * edge * t); }, 8), tolerance);
}

TEST(PassageOfKinds, FromRoughToNoisyWithoutAJump) {
  EXPECT_LT(steepest([](double t) { return rough_open_sphere(0.3, 0.05 * edge * t); }, 8), tolerance);
}

}  // namespace
}  // namespace loopmend
