// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's claims (section 5). Inputs are those of samples/paper_inputs.h.
#include "filling/bridge_loops.h"
#include "filling/subdivide_polyhedron.h"
#include "mesh/region.h"
#include "pipeline/compare.h"
#include "pipeline/evolve_patch.h"
#include "pipeline/fill_holes.h"
#include "samples/paper_inputs.h"
#include "support/tubes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace loopmend {
namespace {

Patch initial_patch_of(const SurfaceModel& model) {
  std::vector<BoundaryLoop> holes;
  for (const BoundaryLoop& loop : find_boundary_loops(model))
    if (loop.turning < -0.3) holes.push_back(loop);
  return *make_initial_patch(model, holes, {}, {}).patch;
}

template <class Distance>
double rms(const Patch& patch, const Distance& distance) {
  double sum = 0;
  for (int i = 0; i < patch.free_count; ++i) sum += std::pow(distance(patch.to_mesh(patch.positions[i])), 2);
  return std::sqrt(sum / patch.free_count);
}

EvolutionOptions scheme_with(double sigma) {
  EvolutionOptions options;
  options.mode = EvolutionMode::steps;
  options.sigma = sigma;
  return options;
}

Patch six_tube_start(int around) {
  const std::vector<TubeShape> tubes = six_tubes(around);
  const SurfaceModel model = test::tubes_model(tubes);
  return bridge_loops(model, test::inner_boundaries(model, tubes), {}, {}).bridge->start;
}

/// Fig. 5.1, and the remark on time steps: the same surface comes back whatever the step.
TEST(PaperClaims, TheCylinderComesBackWithSmallAndLargeSteps) {
  const Patch start = initial_patch_of(make_surface_model(make_pierced_cylinder()));
  for (double sigma : {10.0, 1e4}) {
    const PatchResult evolved = evolve_patch(start, scheme_with(sigma), nullptr, {});
    EXPECT_EQ(evolved.status, PatchStatus::converged) << sigma;
    EXPECT_TRUE(evolved.validity.is_clean());
    EXPECT_LT(rms(evolved.patch, [](const Vec3& p) { return std::hypot(p.x(), p.y()) - 1; }), 1e-4) << sigma;
  }
}

TEST(PaperClaims, TheSphereComesBackFromItsWireFrame) {
  const SurfaceModel model = make_surface_model(make_sphere_wireframe());
  EXPECT_EQ(find_boundary_loops(model).size(), 8u);
  const PatchResult evolved = evolve_patch(initial_patch_of(model), scheme_with(10), nullptr, {});
  EXPECT_EQ(evolved.status, PatchStatus::converged);
  EXPECT_LT(rms(evolved.patch, [](const Vec3& p) { return p.norm() - 1; }), 1e-5);
}

/// Fig. 5.3: G² against the G⁰ initial patch.
TEST(PaperClaims, TheHeadsHolesAreFilledWithoutAJumpOfH) {
  const Patch start = initial_patch_of(make_surface_model(make_holed_head()));
  const PatchResult evolved = evolve_patch(start, {}, nullptr, {});
  EXPECT_EQ(evolved.status, PatchStatus::converged);
  const std::vector<SeamReport> before = seam_reports(start), after = seam_reports(evolved.patch);
  ASSERT_EQ(after.size(), 3u);
  for (std::size_t k = 0; k < after.size(); ++k) EXPECT_LT(after[k].h_jump_rms, 0.15 * before[k].h_jump_rms);
}

/// Fig. 5.4: by the paper's scheme from the flat faces. The answer is the sphere through the vertices.
TEST(PaperClaims, TheFlatFacesOfTheDodecahedronBecomeASphere) {
  const PolyhedronPatch polyhedron = subdivide_polyhedron(make_surface_model(make_dodecahedron()), {});
  EvolutionOptions options = scheme_with(10);
  options.triangles = PatchTriangles::kept;
  const PatchResult evolved = evolve_patch(polyhedron.patch, options, nullptr, {});
  EXPECT_EQ(evolved.status, PatchStatus::converged);
  EXPECT_TRUE(evolved.validity.is_clean());
  for (const Vec3& p : polyhedron_surface(polyhedron, evolved.patch).points) EXPECT_NEAR(p.norm(), 1, 1e-3);
}

/// Fig. 5.5: the jump falls with the triangles for MMCVF; for SDF and WF it belongs to the surface.
TEST(PaperClaims, OnSixTubesTheJumpFallsUnderRefinementForMmcvfAlone) {
  std::map<FlowKind, std::vector<double>> wide, close;
  for (int around : {28, 56}) {
    const Patch start = six_tube_start(around);
    for (FlowKind flow : {FlowKind::sdf, FlowKind::wf, FlowKind::mmcvf}) {
      EvolutionOptions options;
      options.flow = flow;
      const PatchResult evolved = evolve_patch(start, options, nullptr, {});
      EXPECT_EQ(evolved.status, PatchStatus::converged);
      EXPECT_TRUE(evolved.validity.is_clean());
      wide[flow].push_back(wide_curvature_jump(evolved.patch));
      double sum = 0;
      for (const SeamReport& seam : seam_reports(evolved.patch)) sum += seam.h_jump_rms * seam.h_jump_rms / 6;
      close[flow].push_back(std::sqrt(sum));
    }
  }
  EXPECT_LT(close[FlowKind::mmcvf][1], 0.7 * close[FlowKind::mmcvf][0]);
  EXPECT_GT(wide[FlowKind::sdf][1], 0.9 * wide[FlowKind::sdf][0]);
  EXPECT_GT(wide[FlowKind::wf][1], 0.9 * wide[FlowKind::wf][0]);
  EXPECT_LT(wide[FlowKind::mmcvf][1], wide[FlowKind::sdf][1]);
  EXPECT_LT(wide[FlowKind::mmcvf][1], wide[FlowKind::wf][1]);
}

/// Fig. 5.6: MMCVF < SDF, WF < MCF.
TEST(PaperClaims, OnTheBumpsTheJumpsHaveThePapersOrder) {
  const SurfaceModel model = make_surface_model(make_bumps());
  std::vector<int> vertices;
  for (std::size_t i = 0; i < model.soup.points.size(); ++i)
    if (model.soup.points[i].z() > bumps_threshold) vertices.push_back(static_cast<int>(i));
  const FlowComparison comparison = compare_flows(make_region(model, vertices).patch, {}, nullptr, {});
  ASSERT_EQ(comparison.runs.size(), 4u);
  std::map<FlowKind, double> jump, angle;
  for (const ComparedFlow& run : comparison.runs) {
    EXPECT_EQ(run.outcome.validity.folds, 0);
    jump[run.outcome.flow] = run.outcome.seams.front().h_jump_rms;
    angle[run.outcome.flow] = run.outcome.seams.front().g1_rms_deg;
  }
  EXPECT_LT(jump[FlowKind::mmcvf], 0.3 * jump[FlowKind::sdf]);
  EXPECT_LT(jump[FlowKind::mmcvf], 0.3 * jump[FlowKind::wf]);
  EXPECT_LT(jump[FlowKind::sdf], 0.5 * jump[FlowKind::mcf]);
  EXPECT_LT(jump[FlowKind::wf], 0.5 * jump[FlowKind::mcf]);
  EXPECT_GT(angle[FlowKind::mcf], 20);  // MCF is not even tangent
  EXPECT_LT(angle[FlowKind::mmcvf], 2);
  ASSERT_EQ(comparison.profiles.size(), 4u);
  for (const auto& profile : comparison.profiles) EXPECT_GT(profile.size(), 10u);
}

}  // namespace
}  // namespace loopmend
