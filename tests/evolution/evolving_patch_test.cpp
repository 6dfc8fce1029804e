// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/evolving_patch.h"

#include "support/patches.h"

#include <gtest/gtest.h>

#include <limits>

namespace loopmend {
namespace {

TEST(EvolvingPatch, RefusesWhatRisesFoldsLosesFitsOrLeavesTheRoom) {
  EvolvingPatch patch(test::exact_sphere_patch(4, 0.8));
  patch.begin({}, {});
  const double limit = patch.state.measure;
  ASSERT_GT(limit, 0);
  EXPECT_TRUE(patch.acceptable(patch.state, limit));
  EXPECT_FALSE(patch.acceptable(patch.state, 0.99 * limit));
  const auto refused = [&](const auto& change) {
    EvolutionState next = patch.state;
    change(next);
    return !patch.acceptable(next, limit);
  };
  EXPECT_TRUE(refused([](EvolutionState& next) { next.measure = std::numeric_limits<double>::quiet_NaN(); }));
  EXPECT_TRUE(refused([](EvolutionState& next) { ++next.unfitted; }));
  EXPECT_TRUE(refused([&](EvolutionState& next) { next.folds = patch.allowed_folds + 1; }));
  EXPECT_FALSE(refused([&](EvolutionState& next) { next.folds = patch.allowed_folds; }));
  EXPECT_TRUE(refused([&](EvolutionState& next) { next.patch.positions[0] = 1.01 * patch.room.max(); }));
}

TEST(EvolvingPatch, StopsWhereTheNeighborhoodTellsNoCurvature) {
  EvolvingPatch patch(test::exact_sphere_patch(4, 0.8));
  EXPECT_TRUE(patch.require_fits());
  EXPECT_EQ(patch.status, PatchStatus::ready);
  for (int v : patch.state.patch.loops[0]) patch.state.ops.valid[v] = 0;
  EXPECT_FALSE(patch.require_fits());
  EXPECT_EQ(patch.status, PatchStatus::stalled);
  EXPECT_NE(patch.message.english().find("too few vertices"), std::string::npos);
}

}  // namespace
}  // namespace loopmend
