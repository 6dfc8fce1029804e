// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/timeline.h"

#include <gtest/gtest.h>

namespace loopmend::test {
namespace {

/// All of the same size.
Timeline states(int count) {
  Timeline timeline;
  for (int i = 0; i < count; ++i) {
    auto state = std::make_shared<PatchState>();
    state->patch.positions.resize(1000);
    timeline.push_back(state);
  }
  return timeline;
}

constexpr std::size_t plenty = std::size_t{1} << 30;

TEST(Timeline, BeginsWithOneState) {
  const PatchStatePtr first = states(1)[0];
  EXPECT_EQ(*start_timeline(first), Timeline{first});
}

TEST(Timeline, FindsAStateOrStandsAtTheEnd) {
  const Timeline all = states(4);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(place_in(all, all[i]), i);
  EXPECT_EQ(place_in(all, states(1)[0]), 3u);
}

TEST(Timeline, GoingOnFromAnEarlierStateDropsTheLaterOnes) {
  const Timeline all = states(4), more = states(2);
  EXPECT_EQ(*extended(all, all[1], more, plenty), (Timeline{all[0], all[1], more[0], more[1]}));
  EXPECT_EQ(all.size(), 4u) << "undo keeps the old one";
}

TEST(Timeline, StaysWithinItsBudgetByForgettingEverySecondState) {
  const Timeline all = states(9);
  const std::size_t each = size_of(*all[0]);
  const auto kept_by = [&](std::size_t budget) {
    return *extended(Timeline{all[0]}, all[0], {all.begin() + 1, all.end()}, budget);
  };
  EXPECT_EQ(kept_by(9 * each), all);
  EXPECT_EQ(kept_by(9 * each - 1), (Timeline{all[0], all[2], all[4], all[6], all[8]}));
  EXPECT_EQ(kept_by(4 * each), (Timeline{all[0], all[4], all[8]}));
  EXPECT_EQ(kept_by(0), (Timeline{all[0], all[8]})) << "the first and the last stay";
}

TEST(Timeline, AStateIsAsLargeAsWhatItHolds) {
  const PatchState empty;
  PatchState state;
  state.patch.positions.assign(1000, Vec3::Zero());
  state.patch.positions.shrink_to_fit();
  EXPECT_EQ(size_of(state) - size_of(empty), 1000 * sizeof(Vec3));
  auto shape = std::make_shared<SurfaceShape>();
  shape->points.resize(3000);
  shape->points.shrink_to_fit();
  state.shape = shape;
  EXPECT_EQ(size_of(state) - size_of(empty), 1000 * sizeof(Vec3) + 3000 * sizeof(float));
}

}  // namespace
}  // namespace loopmend::test
