// SPDX-License-Identifier: GPL-3.0-or-later
// How the relief is scanned: points as dense as a scanner's, a Delaunay mesh, noise, holes.
//
// The same bits everywhere: basic arithmetic and square roots only, exact predicates, triangles in a canonical order,
// and coordinates rounded to 2⁻¹² mm at the end, so that a last bit that a compiler's contraction changes is lost again.
#include "samples/sample_scan.h"

#include "core/random.h"
#include "samples/analytic_surfaces.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace loopmend {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;

constexpr double spacing = 0.86;   ///< mm, smallest distance of two samples before smoothing
constexpr double margin = 4;       ///< mm, sampled beyond the boundary, so that the boundary is no worse than the rest
constexpr double half_width = 60;  ///< mm, of the outline
constexpr double half_height = 76;
constexpr double noise = 0.011;            ///< mm, rms along the normal: about 1 % of the mean edge
constexpr double resolution = 1.0 / 4096;  ///< mm, what coordinates are rounded to
constexpr int candidates = 500000;
constexpr int smoothing_rounds = 2;

Vec3 on_relief(double x, double y) { return {x, y, sample_relief_height(x, y)}; }

/// > 0 inside. A face's oval, narrower at the chin, a little wavy like the edge of a scan.
double outline(double x, double y, double grow) {
  const double width = (half_width + grow) * (1 + 0.0012 * y);
  const double u = x / width;
  const double v = y / (half_height + grow);
  return 1 - u * u - v * v;
}

/// Accepts random candidates that keep their distance (in space, so that slopes get as many as flat parts).
Points scatter_samples(Random& random) {
  const double reach_x = half_width * 1.1 + margin;
  const double reach_y = half_height + margin;
  const int columns = static_cast<int>(2 * reach_x / spacing) + 1;
  const int rows = static_cast<int>(2 * reach_y / spacing) + 1;
  std::vector<std::vector<int>> cells(static_cast<std::size_t>(columns) * rows);
  Points samples;
  for (int n = 0; n < candidates; ++n) {
    const double x = random.uniform(-reach_x, reach_x);
    const double y = random.uniform(-reach_y, reach_y);
    if (outline(x, y, margin) < 0) continue;
    const Vec3 p = on_relief(x, y);
    const int column = static_cast<int>((x + reach_x) / spacing);
    const int row = static_cast<int>((y + reach_y) / spacing);
    bool is_free = true;
    for (int j = std::max(0, row - 1); is_free && j <= std::min(rows - 1, row + 1); ++j) {
      for (int i = std::max(0, column - 1); is_free && i <= std::min(columns - 1, column + 1); ++i) {
        for (const int other : cells[j * columns + i]) {
          is_free = is_free && (samples[other] - p).squaredNorm() >= spacing * spacing;
        }
      }
    }
    if (!is_free) continue;
    cells[row * columns + column].push_back(static_cast<int>(samples.size()));
    samples.push_back(p);
  }
  return samples;
}

/// Delaunay in the plane, counter-clockwise seen from +z, in an order that does not depend on how CGAL works.
Triangles triangulate(const Points& samples) {
  std::vector<std::pair<Kernel::Point_2, int>> sites;
  sites.reserve(samples.size());
  for (const Vec3& p : samples) sites.emplace_back(Kernel::Point_2(p.x(), p.y()), static_cast<int>(sites.size()));
  const Delaunay delaunay(sites.begin(), sites.end());
  Triangles triangles;
  for (const auto& face : delaunay.finite_face_handles()) {
    Triangle t = {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    triangles.push_back(t);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// Moves every sample half way to the middle of its neighbours: evens out the worst triangles, keeps the irregularity.
void smooth(Points& samples) {
  const Triangles triangles = triangulate(samples);
  Points sum(samples.size(), Vec3::Zero());
  std::vector<int> count(samples.size(), 0);
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) {
      sum[t[k]] += samples[t[(k + 1) % 3]] + samples[t[(k + 2) % 3]];
      count[t[k]] += 2;
    }
  }
  for (std::size_t v = 0; v < samples.size(); ++v) {
    if (count[v] == 0) continue;
    const Vec3 p = 0.5 * samples[v] + 0.5 / count[v] * sum[v];
    samples[v] = on_relief(p.x(), p.y());
  }
}

void add_noise(Points& samples, Random& random) {
  constexpr double h = 1.0 / 1024;
  for (Vec3& p : samples) {
    const double slope_x = (sample_relief_height(p.x() + h, p.y()) - sample_relief_height(p.x() - h, p.y())) / (2 * h);
    const double slope_y = (sample_relief_height(p.x(), p.y() + h) - sample_relief_height(p.x(), p.y() - h)) / (2 * h);
    p += noise * random.bell() * Vec3(-slope_x, -slope_y, 1).normalized();
    for (double& c : p) c = std::round(c / resolution) * resolution;
  }
}

bool in_ellipse(const Vec3& p, double x, double y, double radius_x, double radius_y, double cosine, double sine) {
  const double u = (cosine * (p.x() - x) + sine * (p.y() - y)) / radius_x;
  const double v = (cosine * (p.y() - y) - sine * (p.x() - x)) / radius_y;
  return u * u + v * v < 1;
}

/// Five arms: r < inner + depth·cos 5φ, with cos 5φ as a polynomial of cos φ.
bool in_star(const Vec3& p, double x, double y, double inner, double depth) {
  const double dx = p.x() - x;
  const double dy = p.y() - y;
  const double r = std::sqrt(dx * dx + dy * dy);
  if (r == 0) return true;
  const double c = dy / r;
  return r < inner + depth * c * (5 - c * c * (20 - 16 * c * c));
}

bool in_hole(const Vec3& p) {
  const bool disc = in_ellipse(p, -31, -16, 7, 7, 1, 0);                  // on the left cheek
  const bool ellipse = in_ellipse(p, 20, 47, 13, 6.5, 0.9, -0.43588989);  // on the forehead
  const bool star = in_star(p, 33, -22, 7.5, 3.2);                        // on the right cheek
  const bool slit = in_ellipse(p, -24, 34, 12, 1.6, 0.94, 0.34117444);    // above the left brow
  const bool big = in_ellipse(p, 0, -54.5, 14.5, 10.5, 1, 0);             // over the chin
  return disc || ellipse || star || slit || big;
}

}  // namespace

TriangleSoup make_complete_sample_scan() {
  Random random(2006);
  Points samples = scatter_samples(random);
  for (int i = 0; i < smoothing_rounds; ++i) smooth(samples);
  TriangleSoup soup;
  soup.triangles = triangulate(samples);
  soup.points = std::move(samples);
  soup = trim_boundaries(cut(soup, [](const Vec3& p) { return outline(p.x(), p.y(), 0) < 0; }));
  add_noise(soup.points, random);
  return soup;
}

TriangleSoup make_sample_scan() { return trim_boundaries(cut(make_complete_sample_scan(), in_hole)); }

}  // namespace loopmend
