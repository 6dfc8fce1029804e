// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/sphere_cap.h"

#include "filling/plane_patch.h"
#include "remeshing/patch_remesh.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <span>

namespace loopmend {

namespace {

constexpr double on_sphere = 1e-4;     ///< largest distance, in radii
constexpr double longest_edge = 0.7;   ///< in radii; below that of an icosahedron (1.05) and a dodecahedron (0.71)
constexpr double largest_radius = 10;  ///< in diameters of the loop: flatter ones are as good as planes
constexpr double least_off_others = 1e-5, misfits_off_others = 3;
constexpr int fewest_vertices = 12;
constexpr int remeshings = 6;

std::optional<Sphere> best_sphere(const Patch& patch) {
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  Eigen::Vector4d b = Eigen::Vector4d::Zero();
  for (int v = patch.free_count; v < patch.vertex_count(); ++v) {
    const Vec3& p = patch.positions[v];
    const Eigen::Vector4d row(2 * p.x(), 2 * p.y(), 2 * p.z(), 1);
    A += row * row.transpose();
    b += row * p.squaredNorm();
  }
  const Eigen::Vector4d x = A.ldlt().solve(b);
  const double radius2 = x.head<3>().squaredNorm() + x[3];
  if (!(radius2 > 0) || !std::isfinite(radius2)) return std::nullopt;
  return Sphere{x.head<3>(), std::sqrt(radius2)};
}

/// How far, rms, the fixed vertices are off every quadric but the one that they are nearest to, in units of their spread: 0 for the
/// corners of one row of a wall, which lie on a sphere, and on many other quadrics, too.
double off_other_quadrics(const Patch& patch) {
  const auto fixed = std::span(patch.positions).subspan(patch.free_count);
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : fixed) mean += p / static_cast<double>(fixed.size());
  double spread = 0;
  for (const Vec3& p : fixed) spread += (p - mean).squaredNorm() / static_cast<double>(fixed.size());
  Eigen::Matrix<double, 10, 10> sums = Eigen::Matrix<double, 10, 10>::Zero();
  for (const Vec3& p : fixed) {
    const Vec3 q = (p - mean) / std::sqrt(spread);
    Eigen::Vector<double, 10> row;
    row << 1, q.x(), q.y(), q.z(), q.x() * q.x(), q.y() * q.y(), q.z() * q.z(), q.x() * q.y(), q.y() * q.z(),
        q.z() * q.x();
    sums += row * row.transpose() / static_cast<double>(fixed.size());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 10, 10>> quadrics(sums, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, quadrics.eigenvalues()[1]));
}

/// Twice the vector area of the loop about the sphere's center: it points to the middle of the missing part, or away from it where the
/// surface is inside out.
Vec3 area_of(const Patch& patch, const Sphere& sphere) {
  const std::vector<int>& loop = patch.loops.front();
  Vec3 area = Vec3::Zero();
  for (std::size_t k = 0; k < loop.size(); ++k)
    area +=
        (patch.positions[loop[k]] - sphere.center).cross(patch.positions[loop[(k + 1) % loop.size()]] - sphere.center);
  return area;
}

/// 1 where the faces around look away from the sphere's center, -1 where they look to it.
double side_of(const Patch& patch, const Sphere& sphere) {
  double outward = 0;
  for (std::size_t f = patch.patch_triangles; f < patch.triangles.size(); ++f) {
    const auto& t = patch.triangles[f];
    const Vec3 &a = patch.positions[t[0]], &b = patch.positions[t[1]], &c = patch.positions[t[2]];
    outward += (b - a).cross(c - a).dot(a - sphere.center);
  }
  return outward < 0 ? -1 : 1;
}

void put_on(const Sphere& sphere, Patch& patch) {
  for (int v = 0; v < patch.free_count; ++v) {
    const Vec3 from_center = patch.positions[v] - sphere.center;
    patch.positions[v] = sphere.center + sphere.radius * from_center.normalized();
  }
}

}  // namespace

std::optional<Sphere> sphere_around(const Patch& patch) {
  if (patch.loops.size() != 1 || patch.vertex_count() - patch.free_count < fewest_vertices) return std::nullopt;
  const std::optional<Sphere> sphere = best_sphere(patch);
  if (!sphere || sphere->radius > largest_radius * loop_diameter(patch, 0)) return std::nullopt;
  double misfit = 0;
  for (int v = patch.free_count; v < patch.vertex_count(); ++v)
    misfit = std::max(misfit, std::abs((patch.positions[v] - sphere->center).norm() - sphere->radius) / sphere->radius);
  if (misfit > on_sphere || off_other_quadrics(patch) < std::max(least_off_others, misfits_off_others * misfit))
    return std::nullopt;
  for (std::size_t f = patch.patch_triangles; f < patch.triangles.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const Vec3& p = patch.positions[patch.triangles[f][k]];
      if ((patch.positions[patch.triangles[f][(k + 1) % 3]] - p).norm() > longest_edge * sphere->radius)
        return std::nullopt;
    }
  return sphere;
}

double distance_from(const Sphere& sphere, const Patch& patch) {
  double largest = 0;
  for (int v = 0; v < patch.free_count; ++v)
    largest = std::max(largest, std::abs((patch.positions[v] - sphere.center).norm() - sphere.radius));
  return largest / sphere.radius;
}

std::optional<Patch> sphere_cap(const SurfaceModel& model, const BoundaryLoop& loop, const Patch& initial,
                                const Sphere& sphere, const CancelToken& cancel) {
  const double side = side_of(initial, sphere);
  const Vec3 middle = side * area_of(initial, sphere).normalized(), x = middle.unitOrthogonal();
  const Vec3 y = side * middle.cross(x);  // counter-clockwise, seen from the side to which the faces look
  const auto unrolled = [&](const Vec3& p) {
    const Vec3 unit = (p - sphere.center).normalized();
    const double a = unit.dot(x), b = unit.dot(y), aside = std::hypot(a, b);
    const double scale = aside > 0 ? sphere.radius * std::atan2(aside, unit.dot(middle)) / aside : 0;
    return Vec3(scale * a, scale * b, 0);
  };
  const auto rolled = [&](const Vec3& q) {
    const double length = q.head<2>().norm(), angle = length / sphere.radius;
    const Vec3 aside = length > 0 ? Vec3((q.x() * x + q.y() * y) / length) : Vec3::Zero();
    return Vec3(sphere.center + sphere.radius * (std::cos(angle) * middle + std::sin(angle) * aside));
  };
  Points outline;
  for (const int v : loop.vertices)
    outline.push_back(unrolled(initial.to_frame(model.mesh.point(TriMesh::VertexHandle(v)))));
  std::optional<LoopPatch> cap = plane_patch(outline, Vec3::UnitZ(), {initial.grading.density}, cancel);
  if (!cap) return std::nullopt;
  for (std::size_t p = 0; p < cap->points.size(); ++p)
    cap->points[p] = p < outline.size() ? model.mesh.point(TriMesh::VertexHandle(loop.vertices[p]))
                                        : initial.to_mesh(rolled(cap->points[p]));
  Patch patch = make_patch(model, {loop}, {*cap});
  patch.grading = initial.grading;
  const Sphere in_frame{patch.to_frame(initial.to_mesh(sphere.center)), sphere.radius * initial.scale / patch.scale};
  for (int k = 0; k < remeshings; ++k) {
    if (cancel.cancelled()) return std::nullopt;
    ConstrainedRemesher mesh = open_for_remeshing(patch);
    const bool changed = remesh_once(mesh);
    patch = with_interior(patch, mesh);
    put_on(in_frame, patch);
    if (!changed) break;
  }
  return patch;
}

}  // namespace loopmend
