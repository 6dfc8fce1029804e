// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/seam_sides.h"

#include "known_surfaces.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace loopmend {
namespace {

using bench::KnownSurface;
using bench::MeshKind;

struct SeenJump {
  double mean = 0, rms_off = 0;  ///< of |H_in − H_out|; rms about the true jump
  int vertices = 0;
};

/// Both sides of the seam between the triangles that are inside and the others, each by itself.
SeenJump seen_jump(const TriangleSoup& mesh, const std::function<bool(const Vec3&)>& inside, double truth) {
  Triangles in, out;
  std::vector<char> sides(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    const bool within = inside((mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3);
    for (int v : t) sides[v] |= within ? 1 : 2;
    (within ? in : out).push_back(t);
  }
  const int count = static_cast<int>(mesh.points.size());
  const Topology here(count, in), there(count, out);
  const Points normals = angle_weighted_normals(mesh.points, mesh.triangles);
  FitScratch scratch(count);
  PolynomialFit a, b;
  SeenJump seen;
  for (int v = 0; v < count; ++v) {
    if (sides[v] != 3) continue;
    const bool both = fit_polynomial(mesh.points, here, v, normals[v], one_sided_fit(), scratch, a) &&
                      fit_polynomial(mesh.points, there, v, normals[v], one_sided_fit(), scratch, b);
    EXPECT_TRUE(both);
    if (!both) continue;
    const double jump = std::abs(a.H - b.H);
    seen.mean += jump;
    seen.rms_off += (jump - truth) * (jump - truth);
    ++seen.vertices;
  }
  seen.mean /= seen.vertices;
  seen.rms_off = std::sqrt(seen.rms_off / seen.vertices);
  return seen;
}

/// What the fits see where nothing jumps is their own error: small on coarse meshes already, of second order.
TEST(OneSidedFit, SeesNextToNothingOnIrregularMeshesOfExactSurfaces) {
  const auto band = [](const Vec3& p) { return std::abs(p.z()) < 0.7; };
  for (bool unduloid : {false, true}) {
    std::vector<double> seen;
    for (int around : {48, 96}) {
      const KnownSurface surface = unduloid ? bench::known_unduloid(0.3, 3, around) : bench::known_cylinder(6, around);
      seen.push_back(seen_jump(with_mesh(surface, MeshKind::irregular, 5).mesh, band, 0).rms_off);
    }
    EXPECT_LT(seen[0], unduloid ? 0.010 : 0.005);
    EXPECT_LT(seen[1], 0.35 * seen[0]);
  }
  const TriangleSoup sphere = with_mesh(bench::known_sphere(10), MeshKind::irregular, 5).mesh;
  EXPECT_LT(seen_jump(
                sphere, [](const Vec3& p) { return p.z() > 0.5; }, 0)
                .rms_off,
            1e-3);
}

/// A cylinder that ends in half a sphere: tangents run through, H jumps from −1/2 to −1.
TEST(OneSidedFit, SeesTheJumpBetweenCylinderAndSphere) {
  for (int around : {24, 48}) {
    const double row = 2 * std::numbers::pi / around;
    const int up = static_cast<int>(1.2 / row), down = static_cast<int>(2 / row);
    TriangleSoup capsule = make_revolution([](double) { return 1.0; }, -down * row, up * row, around, up + down);
    for (Vec3& p : capsule.points)
      if (p.z() > 0) p = Vec3(p.x() * std::cos(p.z()), p.y() * std::cos(p.z()), std::sin(p.z()));
    const SeenJump seen = seen_jump(
        capsule, [](const Vec3& p) { return p.z() > 0; }, 0.5);
    EXPECT_EQ(seen.vertices, around);
    EXPECT_NEAR(seen.mean, 0.5, around == 24 ? 0.03 : 0.007);
  }
}

}  // namespace
}  // namespace loopmend
