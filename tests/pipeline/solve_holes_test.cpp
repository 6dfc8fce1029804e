// SPDX-License-Identifier: GPL-3.0-or-later
// What a caller sees of a fill, and from where it may set out.
#include "pipeline/fill_holes.h"
#include "pipeline/initial_patch.h"
#include "support/patches.h"

#include <gtest/gtest.h>

#include <map>
#include <mutex>

namespace loopmend {
namespace {

/// Four holes of which two lie side by side.
SurfaceModel sphere_with_four_holes() {
  return make_surface_model(cut(make_icosphere(4), [](const Vec3& p) {
    for (const Vec3& c : {Vec3(0, 0, 1), Vec3(0.6, 0, 0.8), Vec3(0, -1, 0), Vec3(-1, 0, 0)})
      if ((p - c).norm() < 0.2) return true;
    return false;
  }));
}

struct SeenPatch {
  int starts = 0, ends = 0;
  Points first, last;
};

TEST(SolveHoles, AnObserverSeesEachPatchStartMoveAndEnd) {
  const SurfaceModel model = sphere_with_four_holes();
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  ASSERT_EQ(loops.size(), 4u);
  std::mutex mutex;
  std::map<std::vector<int>, SeenPatch> seen;
  SolveObserver observer;
  observer.on_start = [&](const StartPatch& start) {
    const std::lock_guard lock(mutex);
    SeenPatch& patch = seen[start.patch.loop_numbers];
    EXPECT_EQ(start.kind, StartPatch::Kind::holes);
    ++patch.starts;
    patch.first = start.patch.positions;
  };
  observer.on_step = [&](const Evolution& evolution, const StepRecord&) {
    const std::lock_guard lock(mutex);
    SeenPatch& patch = seen[evolution.patch().loop_numbers];
    EXPECT_EQ(patch.starts, 1);
    EXPECT_EQ(patch.ends, 0);
    patch.last = evolution.patch().positions;
  };
  int holes_done = 0;
  observer.on_done = [&](const GroupResult& result) {
    const std::lock_guard lock(mutex);
    holes_done += static_cast<int>(result.holes.size());
    for (const auto& patch : result.patches) {
      SeenPatch& before = seen[patch->patch.loop_numbers];
      ++before.ends;
      EXPECT_EQ(patch->status, PatchStatus::converged);
      EXPECT_EQ(patch->patch.positions, before.last);
      EXPECT_NE(patch->patch.positions, before.first);
    }
  };
  const std::vector<GroupResult> groups = solve_holes(ScanIndex(model), {loops}, {}, observer, nullptr, {});
  EXPECT_EQ(groups.size(), 3u);
  EXPECT_EQ(holes_done, 4);
  EXPECT_EQ(seen.size(), 3u);
  for (const auto& [numbers, patch] : seen) {
    EXPECT_EQ(patch.starts, 1);
    EXPECT_EQ(patch.ends, 1);
  }
}

TEST(SolveHoles, APatchThatAFlowHasMovedGoesOnFromThere) {
  const SurfaceModel model = test::open_sphere(4, 0.8);
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  EvolutionOptions steps;
  steps.mode = EvolutionMode::steps;
  Evolution evolution(test::start_of(model), steps);
  evolution.step({});
  InitialPatch moved;
  moved.origin = InitialPatch::Origin::evolved;
  moved.loops = loops;
  moved.patch = evolution.patch();
  SolveObserver observer;
  observer.on_start = [](const StartPatch&) { ADD_FAILURE() << "it had started before"; };
  FillOptions options;
  options.evolution = steps;
  options.evolution->max_steps = 1;
  std::vector<GroupResult> groups = solve_holes(ScanIndex(model), {{}, {moved}}, options, observer, nullptr, {});
  ASSERT_EQ(groups.size(), 1u);
  Evolution from_there(*moved.patch, steps);
  from_there.step({});
  EXPECT_EQ(groups[0].patches.at(0)->patch.positions, from_there.patch().positions);

  options.most_memory_mb = 1e-3;
  groups = solve_holes(ScanIndex(model), {{}, {moved}}, options, observer, nullptr, {});
  EXPECT_TRUE(groups.at(0).patches.empty());
  EXPECT_NE(groups[0].holes.at(0).message.english().find("are allowed: the patch stays as it is"), std::string::npos);
}

TEST(SolveHoles, PartsOfAPatchShareItsSeconds) {
  const SurfaceModel model = sphere_with_four_holes();
  InitialPatch initial = make_initial_patch(model, find_boundary_loops(model), {}, {});
  initial.seconds = 4;
  double sum = 0;
  for (int k = 0; k < 4; ++k) {
    sum += part_of(model, initial, {k}, {}).seconds;
    EXPECT_LT(sum, k < 3 ? 4.0 : 5.0);
  }
  EXPECT_NEAR(sum, 4, 1e-12);
}

TEST(SolveHoles, AnIslandThatHasAPatchIsNotJoined) {
  const SurfaceModel model = make_surface_model(cut(make_icosphere(5), [](const Vec3& p) {
    return p.z() > 0.7 && (p - Vec3(0.2, 0, 0.98).normalized()).norm() > 0.15;
  }));
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  ASSERT_EQ(loops.size(), 2u);
  const ScanIndex scan(model);
  FillOptions options;
  options.evolution.reset();
  SolveObserver observer;
  std::vector<StartPatch::Kind> kinds;
  observer.on_start = [&](const StartPatch& start) { kinds.push_back(start.kind); };
  std::vector<GroupResult> groups = solve_holes(scan, {{loops[0]}}, options, observer, nullptr, {});
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].patches.at(0)->patch.loop_numbers.size(), 2u);
  groups = solve_holes(scan, {{loops[0]}, {}, {loops[1].number}}, options, observer, nullptr, {});
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].patches.at(0)->patch.loop_numbers, std::vector<int>{loops[0].number});
  EXPECT_EQ(kinds, (std::vector{StartPatch::Kind::bridge, StartPatch::Kind::holes}));
}

}  // namespace
}  // namespace loopmend
