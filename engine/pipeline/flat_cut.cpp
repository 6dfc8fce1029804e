// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/flat_cut.h"

#include "core/quantile.h"
#include "mesh/loop_facing.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace loopmend {

namespace {

constexpr int fewest_edges = 4;
constexpr double plane = 0.003;  ///< rms distance from the plane, in diameters
constexpr double steep = 0.5;    ///< sine of the angle between surface and plane
/// Of the curvature of a ball that meets the plane at this angle: below, the surface runs straight on; above, it is an edge that
/// is rounded, as of a plinth.
constexpr double least_of_a_dome = 0.5, most_of_a_dome = 1.5;
constexpr double reach_of_fit = 0.3;  ///< in loop radii; at least so many boundary edges:
constexpr double edges_of_fit = 4;
constexpr std::size_t most_fits = 200;

/// Normal curvature of the surface across the boundary at v, from a parabola through what lies behind v; positive where the
/// surface bends towards its inside. NaN where too little lies there.
double curvature_across(const TriMesh& mesh, int v, const Vec3& conormal, double reach) {
  const Vec3 p = mesh.point(TriMesh::VertexHandle(v));
  std::vector<int> queue{v};
  std::set<int> seen{v};
  Vec3 normal = Vec3::Zero();
  for (const auto face : mesh.vf_range(TriMesh::VertexHandle(v))) normal += mesh.calc_face_normal(face);
  normal = (normal - conormal.dot(normal) * conormal).normalized();
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  int count = 0;
  for (std::size_t q = 0; q < queue.size(); ++q)
    for (const auto w : mesh.vv_range(TriMesh::VertexHandle(queue[q]))) {
      const Vec3 d = mesh.point(w) - p;
      if (d.norm() > reach || !seen.insert(w.idx()).second) continue;
      queue.push_back(w.idx());
      const double back = -conormal.dot(d) / reach, height = normal.dot(d) / reach;
      const double aside = std::sqrt(std::max(0.0, d.squaredNorm() / (reach * reach) - back * back - height * height));
      if (back <= 0 || aside > back) continue;  // within 45 degrees of straight back
      const Eigen::Vector2d row(back, back * back);
      matrix += row * row.transpose();
      right += row * height;
      ++count;
    }
  if (count < 4) return std::nan("");
  return -2 * matrix.ldlt().solve(right)[1] / reach;
}

bool is_plane(const BoundaryLoop& loop) {
  return loop.edges() >= fewest_edges && loop.diameter > 0 && loop.planarity <= plane;
}

double steepness_of(const LoopFacing& facing) { return std::abs(facing.onward.dot(facing.axis)); }

double reach_of(const BoundaryLoop& loop, const LoopFacing& facing) {
  return std::max(reach_of_fit * facing.radius, edges_of_fit * loop.perimeter / loop.edges());
}

}  // namespace

double reach_of_flat_cut(const SurfaceModel& model, const BoundaryLoop& loop) {
  if (!is_plane(loop)) return 0;
  const LoopFacing facing = loop_facing(model, loop);
  return steepness_of(facing) < steep ? 0 : reach_of(loop, facing);
}

bool is_flat_cut(const SurfaceModel& model, const BoundaryLoop& loop) {
  if (!is_plane(loop)) return false;
  const LoopFacing facing = loop_facing(model, loop);
  const double steepness = steepness_of(facing);
  if (steepness < steep) return false;
  const double reach = reach_of(loop, facing);
  std::vector<double> curvatures;
  const std::size_t stride = 1 + loop.vertices.size() / most_fits;
  for (std::size_t k = 0; k < loop.vertices.size(); k += stride) {
    const double curvature = curvature_across(model.mesh, loop.vertices[k], facing.conormals[k], reach);
    if (std::isfinite(curvature)) curvatures.push_back(curvature);
  }
  if (curvatures.empty()) return steepness > 0.9;  // a coarse box: its walls tell nothing but that they are steep
  const double share = median(std::move(curvatures)) * facing.radius / steepness;
  return share < least_of_a_dome || share > most_of_a_dome;
}

}  // namespace loopmend
