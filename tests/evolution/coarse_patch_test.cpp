// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/coarse_patch.h"
#include "core/threads.h"
#include "evolution/evolution.h"
#include "mesh/quality.h"
#include "support/patches.h"

#include <gtest/gtest.h>

using namespace loopmend;

namespace {

/// Some 4 000 free vertices within a boundary of some 220 edges, all on the unit sphere.
const Patch& large_patch() {
  static const Patch patch = test::exact_sphere_patch(6, 0.8);
  return patch;
}

double farthest_from_sphere(const Patch& patch) {
  double farthest = 0;
  for (int i = 0; i < patch.free_count; ++i)
    farthest = std::max(farthest, std::abs(patch.to_mesh(patch.positions[i]).norm() - 1));
  return farthest;
}

Patch onto_sphere(Patch patch) {
  for (int i = 0; i < patch.free_count; ++i)
    patch.positions[i] = patch.to_frame(patch.to_mesh(patch.positions[i]).normalized());
  return patch;
}

double edge_length(const Patch& patch) {
  return mean_edge_length(patch.positions, patch.triangles, patch.patch_triangles);
}

int folds(const Patch& patch) { return count_folds(patch.positions, patch.triangles, patch.patch_triangles); }

/// Free vertices of a run to the steady state, and what came of it.
struct Outcome {
  PatchStatus status;
  std::size_t steps;
  double error;
  int free_count;
};

Outcome run_from_initial_patch(const EvolutionOptions& options) {
  static const SurfaceModel model = test::open_sphere(6, 0.8);
  Evolution evolution(test::start_of(model), options);
  const PatchStatus status = evolution.run(nullptr, CancelToken());
  return {status, evolution.history().size(), farthest_from_sphere(evolution.patch()), evolution.patch().free_count};
}

}  // namespace

TEST(CoarsePatch, SmallAndNarrowPatchesAreNotWorthIt) {
  EXPECT_TRUE(worth_coarsening(large_patch()));
  EXPECT_FALSE(worth_coarsening(test::exact_sphere_patch(4, 0.8)));
}

TEST(CoarsePatch, HasFewVerticesTheSameBoundaryAndNoFold) {
  const Patch coarse = coarsened(large_patch());
  EXPECT_LT(coarse.free_count, large_patch().free_count / 3);
  EXPECT_EQ(folds(coarse), 0);
  ASSERT_EQ(coarse.loops.size(), large_patch().loops.size());
  ASSERT_EQ(coarse.loops[0].size(), large_patch().loops[0].size());
  for (std::size_t k = 0; k < coarse.loops[0].size(); ++k)
    EXPECT_EQ(coarse.positions[coarse.loops[0][k]], large_patch().positions[large_patch().loops[0][k]]);
}

TEST(CoarsePatch, RefinedLiesOnTheSurfaceOfItsFormsWithTheDensityOfTheBoundary) {
  const EvolutionState coarse = make_state(onto_sphere(coarsened(large_patch())), {}, Stencil::two_ring_cubic);
  const Patch fine = refined(coarse, large_patch().grading);
  EXPECT_EQ(folds(fine), 0);
  EXPECT_NEAR(edge_length(fine), edge_length(large_patch()), 0.08 * edge_length(large_patch()));
  // A facet of the coarse patch is 3e-4 away in its middle: the forms, not the facets, are followed.
  EXPECT_LT(farthest_from_sphere(fine), 2e-5);
}

TEST(CoarsePatch, IsRefinedTheSameByAnyNumberOfThreads) {
  const EvolutionState coarse = make_state(coarsened(large_patch()), {}, Stencil::two_ring_cubic);
  const auto refined_by = [&](int threads) {
    return with_thread_budget(threads, [&] { return refined(coarse, large_patch().grading).positions; });
  };
  EXPECT_EQ(refined_by(1), refined_by(2));
}

TEST(CoarsePatch, ALargePatchReachesTheSteadyStateInTwoOrThreeSteps) {
  const Outcome coarse_first = run_from_initial_patch({});
  EXPECT_EQ(coarse_first.status, PatchStatus::converged);
  EXPECT_LE(coarse_first.steps, 3u);
  EXPECT_LT(coarse_first.error, 1e-7);
}

TEST(CoarsePatch, TrianglesThatAreToBeKeptAreKept) {
  EvolutionOptions kept;
  kept.triangles = PatchTriangles::kept;
  const Outcome run = run_from_initial_patch(kept);
  EXPECT_EQ(run.status, PatchStatus::converged);
  EXPECT_EQ(run.free_count, test::start_of(test::open_sphere(6, 0.8)).free_count);
}

TEST(CoarsePatch, ACancelledCoarseStartLeavesTheFiller) {
  const Patch initial_patch = test::start_of(test::open_sphere(6, 0.8));
  Evolution evolution(initial_patch, {});
  CancelToken cancel;
  cancel.cancel();
  EXPECT_EQ(evolution.run(nullptr, cancel), PatchStatus::cancelled);
  EXPECT_EQ(evolution.patch().positions, initial_patch.positions);
}
