// SPDX-License-Identifier: GPL-3.0-or-later
#include "mirror/mirror_image.h"

#include "core/quantile.h"
#include "mesh/surface_tree.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace loopmend {

namespace {

constexpr double collar_reach = 0.7, image_reach = 2;  ///< diameters
constexpr int fit_steps = 25;
constexpr double fitted_share = 0.9;  ///< of the collar; the rest may have been changed on one side alone
constexpr double damping = 1e-3;      ///< of the largest entry: along these motions the image slides in itself
constexpr double least_motion = 1e-6;

/// Area-weighted, of the triangles outside the patch.
Points outside_normals(const Patch& patch) {
  Points normals(patch.vertex_count(), Vec3::Zero());
  for (std::size_t f = patch.patch_triangles; f < patch.triangles.size(); ++f) {
    const auto& [a, b, c] = patch.triangles[f];
    const Vec3 normal = (patch.positions[b] - patch.positions[a]).cross(patch.positions[c] - patch.positions[a]);
    for (int v : patch.triangles[f]) normals[v] += normal;
  }
  return normals;
}

/// The mirrored triangles near the hole, patch frame.
struct Cropped {
  Points points;
  Triangles triangles;
  int surface_triangles = 0;
};

Cropped mirrored_neighborhood(const SurfaceModel& model, const TriangleIndex& index, const Patch& patch,
                              const Vec3& center, double radius, const MirrorPlane& plane) {
  const Vec3 middle = plane.image_of(patch.to_mesh(center)), reach = Vec3::Constant(radius * patch.scale);
  Cropped cropped;
  std::unordered_map<int, int> number;
  for (int f : index.near_box(middle - reach, middle + reach)) {
    const Triangle& t = model.soup.triangles[f];
    const bool near = std::any_of(t.begin(), t.end(),
                                  [&](int v) { return (model.soup.points[v] - middle).norm() < radius * patch.scale; });
    if (!near) continue;
    Triangle own;
    for (int k = 0; k < 3; ++k) {
      const auto [entry, added] = number.try_emplace(t[k], static_cast<int>(cropped.points.size()));
      if (added) cropped.points.push_back(patch.to_frame(plane.image_of(model.soup.points[t[k]])));
      own[k] = entry->second;
    }
    std::swap(own[1], own[2]);  // an image is turned inside out
    cropped.triangles.push_back(own);
  }
  cropped.surface_triangles = static_cast<int>(cropped.triangles.size());
  return cropped;
}

void add_image_of_patch(const Patch& patch, const MirrorPlane& plane, Cropped& cropped) {
  const int first = static_cast<int>(cropped.points.size());
  for (const Vec3& p : patch.positions) cropped.points.push_back(patch.to_frame(plane.image_of(patch.to_mesh(p))));
  for (int f = 0; f < patch.patch_triangles; ++f) {
    const auto& [a, b, c] = patch.triangles[f];
    cropped.triangles.push_back({first + a, first + c, first + b});
  }
}

/// The vertices that have an image of the surface.
Collar with_image(const Collar& collar, const SurfaceTree& tree, const Patch& patch, int surface_triangles) {
  Collar known{{}, {}, collar.diameter};
  for (std::size_t i = 0; i < collar.vertices.size(); ++i) {
    const int v = collar.vertices[i];
    if (tree.closest(patch.positions[v]).triangle >= surface_triangles) continue;
    known.vertices.push_back(v);
    known.normals.push_back(collar.normals[i]);
  }
  return known;
}

/// Rigid, about a center.
struct Motion {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Vec3 center, shift = Vec3::Zero();

  Vec3 of(const Vec3& p) const { return turn * (p - center) + center + shift; }
  Vec3 back(const Vec3& p) const { return turn.transpose() * (p - center - shift) + center; }
};

Points nearest_points(const SurfaceTree& image, const Motion& motion, const Patch& patch, const Collar& collar) {
  Points nearest;
  for (int v : collar.vertices) nearest.push_back(motion.of(image.closest(motion.back(patch.positions[v])).place));
  return nearest;
}

/// One step of ICP, from points to the collar's planes. @returns the displacement of a point one diameter away, in diameters.
double improve(Motion& motion, const Patch& patch, const Collar& collar, const Points& nearest) {
  const std::size_t count = nearest.size();
  std::vector<double> heights, sizes;
  for (std::size_t i = 0; i < count; ++i) {
    heights.push_back((patch.positions[collar.vertices[i]] - nearest[i]).dot(collar.normals[i]));
    sizes.push_back(std::abs(heights.back()));
  }
  const double limit = quantile(sizes, fitted_share);
  Eigen::Matrix<double, 6, 6> form = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
  double largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (sizes[i] > limit) continue;
    Eigen::Matrix<double, 6, 1> row;
    row << (nearest[i] - motion.center).cross(collar.normals[i]) / collar.diameter, collar.normals[i];
    form += row * row.transpose();
    right += row * heights[i];
    largest = std::max(largest, row.cwiseAbs().maxCoeff());
  }
  form.diagonal().array() += std::pow(damping * largest, 2) + 1e-300;
  const Eigen::Matrix<double, 6, 1> step = form.ldlt().solve(right);
  if (!step.allFinite()) return 0;
  const Vec3 turn = step.head<3>() / collar.diameter;
  const double angle = turn.norm();
  if (angle > 0) {
    const Eigen::Matrix3d next = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
    motion.turn = next * motion.turn;
    motion.shift = next * motion.shift;
  }
  motion.shift += step.tail<3>();
  return angle + step.tail<3>().norm() / collar.diameter;
}

}  // namespace

Collar collar_of(const Patch& patch) {
  Collar collar;
  collar.diameter = loop_diameter(patch, 0);
  const Points normals = outside_normals(patch);
  for (int v = patch.free_count; v < patch.vertex_count(); ++v) {
    const bool near = patch.ring[v] == 1 || std::any_of(patch.loops[0].begin(), patch.loops[0].end(), [&](int w) {
                        return (patch.positions[w] - patch.positions[v]).norm() < collar_reach * collar.diameter;
                      });
    if (!near || !(normals[v].norm() > 0)) continue;
    collar.vertices.push_back(v);
    collar.normals.push_back(normals[v].normalized());
  }
  return collar;
}

MirrorImage mirror_image(const SurfaceModel& model, const TriangleIndex& index, const Patch& patch,
                         const Collar& collar, const MirrorPlane& plane, MirrorOf what, const CancelToken& cancel) {
  constexpr std::size_t fewest_triangles = 20, fewest_vertices = 6;
  MirrorImage image;
  Motion motion;
  motion.center = Vec3::Zero();
  for (int v : patch.loops[0]) motion.center += patch.positions[v] / static_cast<double>(patch.loops[0].size());
  Cropped cropped = mirrored_neighborhood(model, index, patch, motion.center, image_reach * collar.diameter, plane);
  if (cropped.triangles.size() < fewest_triangles) return image;
  if (what == MirrorOf::closed_surface) add_image_of_patch(patch, plane, cropped);
  const SurfaceTree tree(cropped.points, cropped.triangles);
  image.collar = with_image(collar, tree, patch, cropped.surface_triangles);
  if (image.collar.vertices.size() < fewest_vertices) return image;
  for (int k = 0; k < fit_steps; ++k) {
    if (cancel.cancelled()) return image;
    if (improve(motion, patch, image.collar, nearest_points(tree, motion, patch, image.collar)) < least_motion) break;
  }
  image.nearest = nearest_points(tree, motion, patch, image.collar);
  double sum = 0;
  for (std::size_t i = 0; i < image.nearest.size(); ++i)
    sum += (patch.positions[image.collar.vertices[i]] - image.nearest[i]).squaredNorm();
  image.misfit = std::sqrt(sum / static_cast<double>(image.nearest.size())) / collar.diameter;
  for (Vec3& p : cropped.points) p = motion.of(p);
  image.points = std::move(cropped.points);
  image.triangles = std::move(cropped.triangles);
  image.surface_triangles = cropped.surface_triangles;
  return image;
}

}  // namespace loopmend
