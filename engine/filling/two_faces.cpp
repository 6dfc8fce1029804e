// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/two_faces.h"

#include "filling/plane_patch.h"
#include "mesh/loop_facing.h"
#include "mesh/point_diameter.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

constexpr double off_plane = 2e-3;    ///< rms, in diameters of the loop
constexpr double least_width = 0.05;  ///< of a face, rms across its longest direction, in the same unit
constexpr double corner_deg = 20, least_dihedral_deg = 15;
constexpr double steep = 0.5, least_walls = 0.8;  ///< sine against a face's plane, share of the loop's edges
/// Two straight sides always lie in a plane, and the sides of a coarse loop nearly so.
constexpr std::size_t fewest_inner_corners = 2, coarse = 24;
constexpr double exactly_plane = 1e-5;
constexpr std::size_t most_corners = 64, most_edges = 5000;  ///< all pairs of corners are tried

/// The part of a loop from one vertex to another one, both included.
struct Part {
  double planarity = 0, width = 0;  ///< rms, mesh units
  Vec3 normal = Vec3::Zero();       ///< unit: closed by the chord it runs counter-clockwise about it
};

Points points_of_part(const Points& loop, std::size_t from, std::size_t to) {
  Points points;
  for (std::size_t k = from;; k = (k + 1) % loop.size()) {
    points.push_back(loop[k]);
    if (k == to) return points;
  }
}

Part measured(const Points& points) {
  Vec3 center = Vec3::Zero();
  for (const Vec3& p : points) center += p / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  Vec3 area = Vec3::Zero();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec3 d = points[k] - center;
    spread += d * d.transpose() / static_cast<double>(points.size());
    area += d.cross(points[(k + 1) % points.size()] - center);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  const Vec3 squares = axes.eigenvalues().cwiseMax(0.0);
  Vec3 normal = axes.eigenvectors().col(0);
  if (normal.dot(area) < 0) normal = -normal;
  return {std::sqrt(squares[0]), std::sqrt(squares[1]), normal};
}

/// Edges at which the surface leaves the plane of their part of the loop: the face there is missing as a whole.
std::size_t walls_of(const Part& part, const Points& edge_conormals, std::size_t from, std::size_t to) {
  std::size_t walls = 0;
  for (std::size_t k = from; k != to; k = (k + 1) % edge_conormals.size())
    walls += std::abs(edge_conormals[k].dot(part.normal)) > steep;
  return walls;
}

std::vector<std::size_t> corners_of(const Points& loop) {
  const std::size_t n = loop.size();
  std::vector<std::size_t> corners;
  for (std::size_t k = 0; k < n; ++k) {
    const Vec3 to = loop[k] - loop[(k + n - 1) % n], from = loop[(k + 1) % n] - loop[k];
    if (std::atan2(to.cross(from).norm(), to.dot(from)) * 180 / std::numbers::pi >= corner_deg) corners.push_back(k);
  }
  return corners;
}

/// The corners between which the loop's parts are the most plane; equal ones where there are none.
std::pair<std::size_t, std::size_t> ends_of_edge(const Points& loop, const Points& edge_conormals,
                                                 const CancelToken& cancel) {
  const double diameter = diameter_of(loop);
  const std::vector<std::size_t> corners = corners_of(loop);
  std::pair<std::size_t, std::size_t> best{0, 0};
  double least = (loop.size() < coarse ? exactly_plane : off_plane) * diameter;
  if (corners.size() > most_corners || loop.size() > most_edges) return best;
  for (std::size_t a = 0; a < corners.size() && !cancel.cancelled(); ++a)
    for (std::size_t b = a + 1; b < corners.size(); ++b) {
      const std::size_t inner = b - a - 1;
      if (std::min(inner, corners.size() - inner - 2) < fewest_inner_corners) continue;
      const Part one = measured(points_of_part(loop, corners[a], corners[b])),
                 other = measured(points_of_part(loop, corners[b], corners[a]));
      const double off = std::max(one.planarity, other.planarity);
      if (off > least || std::min(one.width, other.width) < least_width * diameter) continue;
      if (std::abs(one.normal.dot(other.normal)) > std::cos(least_dihedral_deg * std::numbers::pi / 180)) continue;
      const std::size_t walls = walls_of(one, edge_conormals, corners[a], corners[b]) +
                                walls_of(other, edge_conormals, corners[b], corners[a]);
      if (static_cast<double>(walls) < least_walls * static_cast<double>(loop.size())) continue;
      least = off;
      best = {corners[a], corners[b]};
    }
  return best;
}

}  // namespace

std::optional<LoopPatch> two_plane_faces(const SurfaceModel& model, const BoundaryLoop& boundary,
                                         const InitialPatchOptions& options, const CancelToken& cancel) {
  Points loop;
  for (const int v : boundary.vertices) loop.push_back(model.mesh.point(TriMesh::VertexHandle(v)));
  const auto [first, second] = ends_of_edge(loop, loop_facing(model, boundary).edge_conormals, cancel);
  if (first == second) return std::nullopt;
  const int n = static_cast<int>(loop.size());
  const Vec3 edge = loop[second] - loop[first];
  const int pieces = std::max(1, static_cast<int>(std::lround(edge.norm() * n / boundary.perimeter * options.density)));
  LoopPatch patch{loop, {}};
  for (int k = 1; k < pieces; ++k) patch.points.emplace_back(loop[first] + edge * (static_cast<double>(k) / pieces));
  for (const bool back : {true, false}) {
    const std::size_t from = back ? first : second, to = back ? second : first;
    Points outline = points_of_part(loop, from, to);
    std::vector<int> numbers;
    for (std::size_t k = 0; k < outline.size(); ++k) numbers.push_back(static_cast<int>((from + k) % loop.size()));
    const Vec3 normal = measured(outline).normal;
    for (int k = 1; k < pieces; ++k) {
      numbers.push_back(n + (back ? pieces - k : k) - 1);
      outline.push_back(patch.points[static_cast<std::size_t>(numbers.back())]);
    }
    const std::optional<LoopPatch> face = plane_patch(outline, normal, options, cancel);
    if (!face) return std::nullopt;
    for (std::size_t v = outline.size(); v < face->points.size(); ++v) {
      numbers.push_back(static_cast<int>(patch.points.size()));
      patch.points.push_back(face->points[v]);
    }
    for (const Triangle& t : face->triangles)
      patch.triangles.push_back({numbers[static_cast<std::size_t>(t[0])], numbers[static_cast<std::size_t>(t[1])],
                                 numbers[static_cast<std::size_t>(t[2])]});
  }
  return patch;
}

}  // namespace loopmend
