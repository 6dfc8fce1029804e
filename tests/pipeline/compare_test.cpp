// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/compare.h"

#include "pipeline/initial_patch.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

Patch cap_patch() {
  const SurfaceModel model = make_surface_model(cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.8; }));
  return *make_initial_patch(model, find_boundary_loops(model), {}, {}).patch;
}

TEST(CompareFlows, FlowsOneByOneAreTheSameComparison) {
  const Patch start = cap_patch();
  const FlowComparison whole = compare_flows(start, {}, nullptr, {});
  FlowComparison parts;
  for (FlowKind flow : {FlowKind::mcf, FlowKind::sdf, FlowKind::wf, FlowKind::mmcvf})
    parts.runs.push_back(run_compared(start, flow, {}, nullptr, {}));
  add_profiles(parts);
  ASSERT_EQ(whole.runs.size(), parts.runs.size());
  EXPECT_EQ(whole.profile_edge, parts.profile_edge);
  for (std::size_t k = 0; k < parts.runs.size(); ++k) {
    EXPECT_EQ(whole.runs[k].outcome.steps, parts.runs[k].outcome.steps);
    EXPECT_NEAR(whole.runs[k].energies.variation, parts.runs[k].energies.variation,
                1e-6 * (1 + parts.runs[k].energies.variation));
    EXPECT_EQ(whole.profiles[k].size(), parts.profiles[k].size());
  }
}

TEST(CompareFlows, EveryAcceptedStepIsTold) {
  int told = 0;
  const ComparedFlow run =
      run_compared(cap_patch(), FlowKind::wf, {}, [&told](const Evolution&, const StepRecord&) { ++told; }, {});
  EXPECT_GT(told, 0);
  EXPECT_EQ(told, run.outcome.steps);
}

TEST(CompareFlows, APatchWithoutALoopHasNoProfile) {
  FlowComparison comparison;
  add_profiles(comparison);
  EXPECT_TRUE(comparison.profiles.empty());
}

}  // namespace
}  // namespace loopmend
