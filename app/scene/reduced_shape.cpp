// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/surface_shape.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace loopmend {
namespace {

constexpr std::size_t large_triangles = 200'000;
constexpr std::size_t most_vertices = 30'000;
constexpr int finest_grid = 192;  ///< cells along the longest side

/// Cells of a grid around the points that hold some, numbered in the order in which they were met.
struct Clusters {
  std::vector<int> of_point;
  std::size_t count = 0;
};

Clusters clusters_of(const std::vector<float>& points, int cells) {
  Eigen::AlignedBox3f box;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) box.extend(Eigen::Map<const Eigen::Vector3f>(&points[i]));
  const float size = std::max(box.sizes().maxCoeff() / static_cast<float>(cells), 1e-30F);
  const Eigen::Vector3i n = (box.sizes() / size).cast<int>() + Eigen::Vector3i::Ones();
  std::vector<int> of_cell(
      static_cast<std::size_t>(n.x()) * static_cast<std::size_t>(n.y()) * static_cast<std::size_t>(n.z()), -1);
  Clusters clusters;
  clusters.of_point.reserve(points.size() / 3);
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    const Eigen::Vector3i at = ((Eigen::Map<const Eigen::Vector3f>(&points[i]) - box.min()) / size)
                                   .cast<int>()
                                   .cwiseMin(n - Eigen::Vector3i::Ones());
    int& cluster = of_cell[(static_cast<std::size_t>(at.z()) * static_cast<std::size_t>(n.y()) +
                            static_cast<std::size_t>(at.y())) *
                               static_cast<std::size_t>(n.x()) +
                           static_cast<std::size_t>(at.x())];
    if (cluster < 0) cluster = static_cast<int>(clusters.count++);
    clusters.of_point.push_back(cluster);
  }
  return clusters;
}

/// Of the known values in each cluster; not a number where there is none.
template <class T>
std::vector<T> means(const std::vector<T>& values, std::size_t components, const Clusters& clusters) {
  if (values.empty()) return {};
  std::vector<double> sums(components * clusters.count, 0);
  std::vector<int> counts(components * clusters.count, 0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = static_cast<double>(values[i]);
    if (!std::isfinite(value)) continue;
    const std::size_t at = components * static_cast<std::size_t>(clusters.of_point[i / components]) + i % components;
    sums[at] += value;
    ++counts[at];
  }
  std::vector<T> out(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i) out[i] = static_cast<T>(sums[i] / counts[i]);
  return out;
}

/// Of one vertex in each cluster: means of places in a picture would lie elsewhere in it.
std::vector<float> firsts(const std::vector<float>& values, std::size_t components, const Clusters& clusters) {
  if (values.empty()) return {};
  std::vector<float> out;
  for (std::size_t v = 0; v < clusters.of_point.size(); ++v)
    if (static_cast<std::size_t>(clusters.of_point[v]) * components == out.size())
      out.insert(out.end(), values.begin() + static_cast<std::ptrdiff_t>(components * v),
                 values.begin() + static_cast<std::ptrdiff_t>(components * (v + 1)));
  return out;
}

/// A number for each cell of a grid of 32 cells along each side, such that cells with near numbers are near each other: the
/// bits of the three coordinates, taken in turn (Morton 1966).
std::size_t z_order(const Eigen::Vector3i& cell) {
  std::size_t number = 0;
  for (int bit = 4; bit >= 0; --bit)
    for (int k = 0; k < 3; ++k) number = number << 1 | (static_cast<std::size_t>(cell[k]) >> bit & 1);
  return number;
}

/// Triangles that follow each other lie near each other: slices of them are compact, and those outside the view are not drawn.
/// Triangles in this order already are shared, not copied.
TriangleList in_z_order(const TriangleList& triangles, const std::vector<float>& points) {
  constexpr int cells = 32;
  Eigen::AlignedBox3f box;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) box.extend(Eigen::Map<const Eigen::Vector3f>(&points[i]));
  const float size = std::max(box.sizes().maxCoeff() / static_cast<float>(cells), 1e-30F);
  const auto place = [&](std::size_t t) {
    const Eigen::Map<const Eigen::Vector3f> p(&points[3 * static_cast<std::size_t>(triangles[t])]);
    const Eigen::Vector3i cell = ((p - box.min()) / size).cast<int>();
    return z_order(cell.cwiseMin(Eigen::Vector3i::Constant(cells - 1)));
  };
  std::vector<std::size_t> begin(static_cast<std::size_t>(cells * cells * cells) + 1, 0);
  bool ordered = true;
  for (std::size_t t = 0, last = 0; t < triangles.size(); t += 3) {
    const std::size_t at = place(t);
    ordered = ordered && last <= at;
    last = at;
    begin[at + 1] += 3;
  }
  if (ordered) return triangles;
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<int> sorted(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    std::size_t& to = begin[place(t)];
    for (std::size_t k = 0; k < 3; ++k) sorted[to++] = triangles[t + k];
  }
  return sorted;
}

}  // namespace

SurfaceShapePtr reduced_shape(const SurfaceShape& shape) {
  if (shape.triangles.size() / 3 < large_triangles) return nullptr;
  int cells = finest_grid;
  Clusters clusters = clusters_of(shape.points, cells);
  while (clusters.count > most_vertices && cells > 1) {
    cells =
        static_cast<int>(cells * std::sqrt(static_cast<double>(most_vertices) / static_cast<double>(clusters.count)));
    clusters = clusters_of(shape.points, cells);
  }
  auto reduced = std::make_shared<SurfaceShape>();
  reduced->points = means(shape.points, 3, clusters);
  reduced->normals = means(shape.normals, 3, clusters);
  for (std::size_t i = 0; i + 2 < reduced->normals.size(); i += 3) {
    Eigen::Map<Eigen::Vector3f> n(&reduced->normals[i]);
    const float length = n.norm();
    n = length > 0 ? Eigen::Vector3f(n / length) : Eigen::Vector3f::UnitZ();
  }
  reduced->H = means(shape.H, 1, clusters);
  reduced->K = means(shape.K, 1, clusters);
  reduced->colors = means(shape.colors, 3, clusters);
  reduced->texture = firsts(shape.texture, 2, clusters);
  reduced->picture = shape.picture;
  std::vector<int> corners;
  for (std::size_t t = 0; t + 2 < shape.triangles.size(); t += 3) {
    const auto cluster = [&](std::size_t k) { return clusters.of_point[shape.triangles[t + k]]; };
    const int a = cluster(0), b = cluster(1), c = cluster(2);
    if (a != b && b != c && c != a) corners.insert(corners.end(), {a, b, c});
  }
  reduced->triangles = std::move(corners);
  reduced->own_triangles = static_cast<int>(reduced->triangles.size() / 3);
  return reduced;
}

SurfaceShape with_reduced(SurfaceShape shape) {
  shape.reduced = reduced_shape(shape);
  if (shape.reduced) shape.triangles = in_z_order(shape.triangles, shape.points);
  return shape;
}

}  // namespace loopmend
