// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/ring_bridge.h"

#include "core/quantile.h"
#include "mesh/triangulate_polygon.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace loopmend {

namespace {

using PlaneKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using PlanePoints = std::vector<PlaneKernel::Point_2>;

constexpr double steep = 0.5;       ///< sine of the angle between surface and plane
constexpr double torn_share = 0.1;  ///< of a loop where it need not be steep
/// Curvature of the walls in that of a half circle through both loops: 0 straight walls, 1 halves of a torus.
constexpr double least_of_a_torus = 0.6, most_of_a_torus = 1.4;
constexpr double reach_behind =
    0.35;  ///< of the walls behind the loops, in widths of the ring: an eighth of that circle
constexpr int fewest_samples = 12;
constexpr std::size_t most_starts = 64;  ///< places of a loop behind which its wall is sampled

Vec3 center_of(const Points& points) {
  return std::accumulate(points.begin(), points.end(), Vec3(Vec3::Zero())) / static_cast<double>(points.size());
}

PlanePoints seen_along(const Vec3& axis, const Points& points) {
  const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
  PlanePoints seen;
  for (const Vec3& p : points) seen.emplace_back(u.dot(p), v.dot(p));
  return seen;
}

bool lies_within(const PlanePoints& inner, const PlanePoints& outer) {
  return CGAL::is_simple_2(outer.begin(), outer.end(), PlaneKernel()) &&
         std::all_of(inner.begin(), inner.end(), [&](const PlaneKernel::Point_2& p) {
           return CGAL::bounded_side_2(outer.begin(), outer.end(), p, PlaneKernel()) == CGAL::ON_BOUNDED_SIDE;
         });
}

/// Unit, the way on from the first wall. Walls that meet the plane from its other side count the other way round.
Vec3 common_axis(const std::vector<BridgeEnd>& ends) {
  Vec3 sum = Vec3::Zero();
  for (const BridgeEnd& end : ends) sum += end.onward.dot(ends[0].onward) < 0 ? Vec3(-end.onward) : end.onward;
  return sum.normalized();
}

bool is_steep(const BridgeEnd& end, const Vec3& axis) {
  const double side = end.onward.dot(axis) < 0 ? -1 : 1;
  const auto is_flat = [&](const Vec3& conormal) { return !(side * conormal.dot(axis) > steep); };
  const auto flat = std::count_if(end.conormals.begin(), end.conormals.end(), is_flat);
  return static_cast<double>(flat) <= torn_share * static_cast<double>(end.conormals.size());
}

std::size_t nearest(const Points& points, const Vec3& p) {
  const auto closer = [&](const Vec3& q, const Vec3& r) { return (q - p).squaredNorm() < (r - p).squaredNorm(); };
  return static_cast<std::size_t>(std::min_element(points.begin(), points.end(), closer) - points.begin());
}

/// How far each wall has moved sideways, towards the other loop, over how far behind its own loop: (back, aside) of all vertices behind
/// up to `reach`, from places spread evenly over the loop.
std::vector<Eigen::Vector2d> samples_behind(const TriMesh& mesh, const BoundaryLoop& loop, const Points& others,
                                            const Vec3& axis, double reach) {
  std::vector<Eigen::Vector2d> samples;
  const std::size_t stride = std::max<std::size_t>(1, loop.vertices.size() / most_starts);
  for (std::size_t k = 0; k < loop.vertices.size(); k += stride) {
    const int start = loop.vertices[k];
    const Vec3 p = mesh.point(TriMesh::VertexHandle(start));
    Vec3 aside = others[nearest(others, p)] - p;
    aside = (aside - axis.dot(aside) * axis).normalized();
    const Vec3 along = axis.cross(aside);
    std::vector<int> queue{start};
    std::set<int> seen{start};
    for (std::size_t q = 0; q < queue.size(); ++q)
      for (const auto w : mesh.vv_range(TriMesh::VertexHandle(queue[q]))) {
        const Vec3 d = mesh.point(w) - p;
        if (d.norm() > reach || !seen.insert(w.idx()).second) continue;
        queue.push_back(w.idx());
        if (std::abs(d.dot(along)) <= -0.5 * d.dot(axis)) samples.emplace_back(-d.dot(axis), d.dot(aside));
      }
  }
  return samples;
}

/// Of a parabola through the samples; 0 where there are too few. Positive towards the other loop on the way to the own one.
double curvature_of(const std::vector<Eigen::Vector2d>& samples) {
  if (static_cast<int>(samples.size()) < fewest_samples) return 0;
  const double scale =
      std::max_element(samples.begin(), samples.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); })->x();
  Eigen::MatrixXd rows(samples.size(), 3);
  Eigen::VectorXd heights(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = samples[i].x() / scale;
    rows.row(static_cast<Eigen::Index>(i)) << 1, t, t * t;
    heights[static_cast<Eigen::Index>(i)] = samples[i].y();
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(rows);
  if (qr.rank() < 3) return 0;
  const Eigen::Vector3d c = qr.solve(heights);
  const double slope = c[1] / scale;
  return 2 * c[2] / (scale * scale) / std::pow(1 + slope * slope, 1.5);
}

/// Rms distance of a loop from its own plane square to the axis.
double unevenness(const Points& points, const Vec3& axis) {
  const double height = center_of(points).dot(axis);
  double sum = 0;
  for (const Vec3& p : points) sum += std::pow(p.dot(axis) - height, 2);
  return std::sqrt(sum / static_cast<double>(points.size()));
}

Triangles triangulated_ring(const std::vector<BridgeEnd>& ends) {
  Points points;
  std::vector<std::vector<int>> curves;
  for (const BridgeEnd& end : ends) {
    curves.emplace_back(end.points.size());
    std::iota(curves.back().begin(), curves.back().end(), static_cast<int>(points.size()));
    points.insert(points.end(), end.points.begin(), end.points.end());
  }
  return triangulate_seen_flat(points, curves);
}

}  // namespace

std::optional<std::size_t> outline_of_a_ring(const std::vector<BridgeEnd>& ends) {
  const auto share_a_side = [&](const BridgeEnd& end) { return end.onward.dot(ends[0].onward) > 0; };
  if (!std::ranges::all_of(ends, share_a_side) && !lie_in_one_plane(ends)) return std::nullopt;
  const Vec3 axis = common_axis(ends);
  if (!std::ranges::all_of(ends, [&](const BridgeEnd& end) { return is_steep(end, axis); })) return std::nullopt;
  std::vector<PlanePoints> seen;
  for (const BridgeEnd& end : ends) seen.push_back(seen_along(axis, end.points));
  const auto holds = [&](std::size_t outer, std::size_t inner) {
    return outer != inner && lies_within(seen[inner], seen[outer]);
  };
  std::optional<std::size_t> outline;
  for (std::size_t outer = 0; outer < ends.size(); ++outer) {
    std::size_t inner = 0;
    for (std::size_t k = 0; k < ends.size(); ++k) inner += holds(outer, k);
    if (inner == 0) continue;
    if (inner + 1 < ends.size()) return std::nullopt;
    outline = outer;
  }
  return outline;
}

bool lie_in_one_plane(const std::vector<BridgeEnd>& ends) {
  // Largest rms distance from the plane, over that along it: noise of 1 % of the size has 0.03, the holes of a skull 0.1.
  constexpr double most_uneven = 0.05;
  Points points;
  for (const BridgeEnd& end : ends) points.insert(points.end(), end.points.begin(), end.points.end());
  const Vec3 center = center_of(points);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) spread += (p - center) * (p - center).transpose();
  const Vec3 squares = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread, Eigen::EigenvaluesOnly).eigenvalues();
  return squares[0] <= most_uneven * most_uneven * squares[2];
}

bool bend_towards_each_other(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                             const std::vector<BridgeEnd>& ends) {
  const Vec3 axis = common_axis(ends);
  std::vector<double> widths;
  for (const Vec3& p : ends[0].points) widths.push_back((ends[1].points[nearest(ends[1].points, p)] - p).norm());
  const double width = median(widths);
  for (std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    const double bend =
        curvature_of(samples_behind(model.mesh, loops[k], ends[1 - k].points, axis, reach_behind * width)) * width / 2;
    if (bend < least_of_a_torus || bend > most_of_a_torus) return false;
  }
  return true;
}

std::vector<SweptBridge> bridges_by_ring(const std::vector<BridgeEnd>& ends, double step) {
  std::vector<SweptBridge> bridges;
  if (Triangles triangles = triangulated_ring(ends); !triangles.empty()) bridges.push_back({{}, std::move(triangles)});
  if (ends.size() > 2) return bridges;
  const BridgeEnd &a = ends[0], &b = ends[1];
  const Vec3 axis = common_axis(ends);
  const double height = std::abs(axis.dot(center_of(a.points) - center_of(b.points)));
  const double size = (a.points.front() - center_of(a.points)).norm();
  const double noise = std::max({unevenness(a.points, axis), unevenness(b.points, axis), 1e-9 * size});
  bridges.push_back(bridge_by_sweep(a, b, step, SweepShape::straight));
  if (height > 2 * noise) std::reverse(bridges.begin(), bridges.end());
  return bridges;
}

}  // namespace loopmend
