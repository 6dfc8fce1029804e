// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/rounded_polyhedron.h"

#include "filling/fairing.h"
#include "filling/sphere_cap.h"
#include "mesh/quality.h"
#include "remeshing/patch_remesh.h"

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <cmath>

namespace loopmend {

namespace {

constexpr int rounds = 6;         ///< that spread the vertices on the sphere
constexpr double deepest = 0.99;  ///< distance of the middle from the sphere's centre, in radii
constexpr double roundest = 1e3;  ///< radius of the sphere, in those of the patch's frame: beyond, it is a plane

Vec3 nearest_on(const Sphere& sphere, const Vec3& p) {
  return sphere.center + sphere.radius * (p - sphere.center).normalized();
}

/// Where the ray from a point within through another one leaves.
Vec3 leaves_at(const Sphere& sphere, const Vec3& from, const Vec3& through) {
  const Vec3 along = (through - from).normalized(), d = from - sphere.center;
  const double t = along.dot(d);
  return from + (std::sqrt(t * t - d.squaredNorm() + sphere.radius * sphere.radius) - t) * along;
}

/// Least squares of ‖p‖² = 2⟨c, p⟩ + (R² − ‖c‖²).
Sphere fitted_sphere(const Points& points, int begin) {
  const Eigen::Index count = static_cast<Eigen::Index>(points.size()) - begin;
  Eigen::MatrixX4d A(count, 4);
  Eigen::VectorXd b(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vec3& p = points[begin + i];
    A.row(i) << 2 * p.transpose(), 1;
    b[i] = p.squaredNorm();
  }
  const Eigen::Vector4d x = A.colPivHouseholderQr().solve(b);
  const Vec3 center = x.head<3>();
  return {center, std::sqrt(x[3] + center.squaredNorm())};
}

/// Of the surface.
Vec3 center_of_area(const Patch& patch) {
  Vec3 sum = Vec3::Zero();
  double total = 0;
  for (const Triangle& t : patch.triangles) {
    const Vec3 &a = patch.positions[t[0]], &b = patch.positions[t[1]], &c = patch.positions[t[2]];
    const double area = (b - a).cross(c - a).norm();
    sum += area * (a + b + c) / 3;
    total += area;
  }
  return sum / total;
}

/// Vertices spread more evenly over the sphere, unless that folds it.
Patch spread(const Sphere& sphere, const Patch& patch) {
  Patch even = patch;
  for (int round = 0; round < rounds; ++round) {
    ConstrainedRemesher mesh = open_for_remeshing(even);
    mesh.flip_to_delaunay();
    mesh.smooth_tangentially();
    even = with_interior(even, mesh);
    for (int i = 0; i < even.free_count; ++i) even.positions[i] = nearest_on(sphere, even.positions[i]);
  }
  const auto folds = [](const Patch& p) { return count_folds(p.positions, p.triangles, p.patch_triangles); };
  return folds(even) > folds(patch) ? patch : even;
}

}  // namespace

std::optional<Patch> rounded_polyhedron(const PolyhedronPatch& polyhedron) {
  Patch patch = polyhedron.patch;
  const Sphere sphere = fitted_sphere(patch.positions, patch.free_count);
  const Vec3 middle = center_of_area(patch);
  if (!(sphere.radius < roundest) || !((middle - sphere.center).norm() < deepest * sphere.radius)) return std::nullopt;
  for (Vec3& p : patch.positions) p = leaves_at(sphere, middle, p);
  patch = spread(sphere, patch);
  std::vector<char> fixed(patch.positions.size(), 0);
  Points way(patch.positions.size(), Vec3::Zero());
  for (int i = patch.free_count; i < patch.vertex_count(); ++i) {
    fixed[i] = 1;
    way[i] = polyhedron.patch.positions[i] - patch.positions[i];
  }
  extend_evenly(patch.triangles, fixed, way);
  for (int i = 0; i < patch.free_count; ++i) {
    patch.positions[i] += way[i];
    if (!patch.positions[i].allFinite()) return std::nullopt;
  }
  for (int i = patch.free_count; i < patch.vertex_count(); ++i) patch.positions[i] = polyhedron.patch.positions[i];
  return patch;
}

}  // namespace loopmend
