// SPDX-License-Identifier: GPL-3.0-or-later
// Constant-mean-curvature surfaces come back exactly, up to the discretisation, however large the opening.
#include "bench/problems/known_surfaces.h"
#include "mesh/quality.h"
#include "support/patches.h"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

namespace loopmend {
namespace {

using bench::KnownSurface;
using bench::MeshKind;

struct Problem {
  const char* name;
  std::function<KnownSurface()> surface;
  std::function<bool(const Vec3&)> missing;
  double bound;  ///< rms distance of the new vertices to the surface, in diameters of the hole
};

struct Filled {
  double rms = 0;  ///< in diameters of the hole
  HoleResult result;
  int new_vertices = 0;
  double min_angle = 0;  ///< degrees
};

/// The hole nearest to where the points are missing, filled by default settings.
Filled fill(const Problem& problem, MeshKind kind, double density = 1) {
  const KnownSurface surface = with_mesh(problem.surface(), kind, 5);
  SurfaceModel model = make_surface_model(trim_boundaries(cut(surface.mesh, problem.missing)));
  const auto loops = find_boundary_loops(model);
  const auto at_ends = [&](const BoundaryLoop& loop) {
    const Vec3 first = model.mesh.point(TriMesh::VertexHandle(loop.vertices.front()));
    double low = first.z(), high = first.z();
    for (int v : loop.vertices) {
      low = std::min(low, model.mesh.point(TriMesh::VertexHandle(v)).z());
      high = std::max(high, model.mesh.point(TriMesh::VertexHandle(v)).z());
    }
    return std::abs(low) > 1.4 && high - low < 0.5;  // the open ends of the tubes
  };
  std::vector<BoundaryLoop> holes;
  for (const BoundaryLoop& loop : loops)
    if (!at_ends(loop)) holes.push_back(loop);
  EXPECT_EQ(holes.size(), 1U);
  const std::size_t before = model.soup.points.size(), triangles = model.soup.triangles.size();
  FillOptions options;
  options.initial.density = density;
  Filled filled;
  filled.result = fill_holes(model, {holes.front()}, options, nullptr, {}).front();
  const std::size_t after = model.soup.points.size();
  double sum = 0;
  for (std::size_t i = before; i < after; ++i) sum += std::pow(surface.distance(model.soup.points[i]), 2);
  filled.new_vertices = static_cast<int>(after - before);
  filled.rms = std::sqrt(sum / filled.new_vertices) / filled.result.loop.diameter;
  const Triangles added(model.soup.triangles.begin() + static_cast<std::ptrdiff_t>(triangles),
                        model.soup.triangles.end());
  filled.min_angle = min_angle_deg(model.soup.points, added, static_cast<int>(added.size()));
  return filled;
}

double angle_about_z(const Vec3& p) { return std::abs(std::atan2(p.y(), p.x())); }

Problem unduloid_problem() {
  return {"unduloid", [] { return bench::known_unduloid(0.4, 3, 64); },
          [](const Vec3& p) { return (p - Vec3(1, 0, 0)).norm() < 0.6; }, 3e-5};
}

/// Issue 3 asks for 3e-5, 1e-3, 5e-3, 5e-5, 1e-4, 5e-5; the bounds here are what was measured, doubled at least.
std::vector<Problem> problems() {
  return {
      {"sphere_30_percent", [] { return bench::known_sphere(32); },
       [](const Vec3& p) { return p.z() > std::sqrt(1 - 0.09); }, 1e-6},
      {"half_a_sphere", [] { return bench::known_sphere(20); }, [](const Vec3& p) { return p.z() > 0.01; }, 1e-5},
      {"three_quarters_of_a_sphere", [] { return bench::known_sphere(20); }, [](const Vec3& p) { return p.z() > -0.5; },
       1e-4},
      {"cylinder_240_degrees", [] { return bench::known_cylinder(6, 60); },
       [](const Vec3& p) { return angle_about_z(p) < 2 * std::numbers::pi / 3 && std::abs(p.z()) < 1; }, 5e-5},
      unduloid_problem(),
      {"catenoid", [] { return bench::known_catenoid(2.5, 80); },
       [](const Vec3& p) { return (p - Vec3(1, 0, 0.2)).norm() < 0.6; }, 3e-5},
  };
}

using Case = std::tuple<int, MeshKind>;
class ComesBack : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Problems, ComesBack,
                         testing::Combine(testing::Range(0, 6),
                                          testing::Values(MeshKind::regular, MeshKind::irregular)),
                         [](const testing::TestParamInfo<Case>& tested) {
                           return std::string(problems()[std::get<0>(tested.param)].name) + "_" +
                                  to_string(std::get<1>(tested.param));
                         });

TEST_P(ComesBack, OnTheExactSurface) {
  const Problem problem = problems()[std::get<0>(GetParam())];
  const Filled filled = fill(problem, std::get<1>(GetParam()));
  EXPECT_EQ(filled.result.status, PatchStatus::converged) << filled.result.message;
  EXPECT_LT(filled.rms, problem.bound);
  EXPECT_LT(filled.result.outcome().energy.final, 1e-2 * filled.result.outcome().energy.initial);
  EXPECT_GT(filled.min_angle, 5);
  RecordProperty("rms_in_diameters", std::to_string(filled.rms));
  std::printf("%s: %.2e of %.0e, %d vertices, %d steps, %.1f degrees\n", problem.name, filled.rms, problem.bound,
              filled.new_vertices, filled.result.steps(), filled.min_angle);
}

TEST(Density, HalfToFourTimesTheVerticesGiveTheSameSurface) {
  const Problem problem = unduloid_problem();
  int fewer = 0;
  for (double density : {0.5, 1.0, 2.0, 4.0}) {
    const Filled filled = fill(problem, MeshKind::irregular, density);
    EXPECT_EQ(filled.result.status, PatchStatus::converged);
    EXPECT_GT(filled.new_vertices, 2 * fewer) << "a density that changes nothing proves nothing";
    EXPECT_LT(filled.rms, 1e-4) << density;  // each within 1e-4 of the truth: within 2e-4 of one another
    std::printf("density %g: %.2e, %d vertices\n", density, filled.rms, filled.new_vertices);
    fewer = filled.new_vertices;
  }
}

}  // namespace
}  // namespace loopmend
