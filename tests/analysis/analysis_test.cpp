// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/curvature_field.h"
#include "analysis/seam_report.h"

#include "core/error.h"
#include "core/threads.h"
#include "support/patches.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

TEST(SeamReport, SeesNoJumpOnTheExactSphereAndTheUnitOfLength) {
  for (double unit : {1.0, 250.0}) {
    Patch patch = test::exact_sphere_patch(5, 0.9);
    patch.scale *= unit;
    patch.center *= unit;
    const SeamReport seam = seam_report(patch, 0);
    EXPECT_LT(seam.g1_max_deg, 0.05);
    EXPECT_LT(seam.h_jump_max * unit, 0.02);
    EXPECT_LT(seam.h_jump_rms_times_diameter, 0.01);
  }
}

TEST(SeamReport, MeasuresTheAngleAndTheJumpOfAFlatLid) {
  // A flat disc on the boundary z = 0.9 of a unit sphere: the normals differ by acos 0.9, H jumps from −1 to 0.
  const SurfaceModel model =
      make_surface_model(make_revolution([](double z) { return std::sqrt(1 - z * z); }, 0.5, 0.9, 80, 10));
  const BoundaryLoop loop = find_boundary_loops(model).at(1);
  const Patch patch = *make_initial_patch(model, {loop}, {}, {}).patch;
  const SeamReport seam = seam_report(patch, 0);
  EXPECT_NEAR(seam.g1_rms_deg, std::acos(0.9) * 180 / M_PI, 0.5);
  EXPECT_NEAR(seam.h_jump_rms, 1, 0.1);
  EXPECT_GE(seam.h_jump_max, seam.h_jump_rms);
  EXPECT_NEAR(seam.h_jump_rms_times_diameter, seam.h_jump_rms * loop.diameter, 1e-9);
}

TEST(SeamReport, ThereIsNoOtherLoop) {
  const Patch patch = test::exact_sphere_patch(3, 0.8);
  EXPECT_THROW(seam_report(patch, 1), InvalidArgument);
  EXPECT_THROW(seam_report(patch, -1), InvalidArgument);
}

TEST(CurvatureField, OfASphereOfRadiusFive) {
  TriangleSoup soup = make_icosphere(4);
  for (Vec3& p : soup.points) p *= 5;
  const SurfaceModel model = make_surface_model(soup);
  const CurvatureField all = curvature_field(model.mesh);
  const CurvatureField one = with_thread_budget(1, [&] { return curvature_field(model.mesh); });
  EXPECT_EQ(one.H, all.H);
  for (std::size_t i = 0; i < one.H.size(); ++i) {
    ASSERT_NEAR(one.H[i], -0.2, 1e-3);
    ASSERT_NEAR(one.K[i], 0.04, 5e-4);
    ASSERT_LT((one.normals[i] - soup.points[i].normalized()).norm(), 5e-3);
  }
}

TEST(CurvatureField, OfAPatchIsInMeshUnits) {
  const Patch patch = test::exact_sphere_patch(4, 0.8);
  const CurvatureField field = curvature_field(patch);
  for (int i = 0; i < patch.free_count; ++i) ASSERT_NEAR(field.H[i], -1, 0.01);
}

}  // namespace
}  // namespace loopmend
