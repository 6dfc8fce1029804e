// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/targets.h"

#include "document/sheet.h"

#include <gtest/gtest.h>

namespace loopmend::test {
namespace {

using Loops = std::set<int>;

TEST(Targets, FillTakesTheSelectedLoopsOrAllHoles) {
  SheetDocument document;
  HoleSelection selection;
  EXPECT_EQ(loops_to_fill(document, selection), (Loops{square, diamond}));
  document.set_outer_rims(OuterRims::include);
  EXPECT_EQ(loops_to_fill(document, selection), (Loops{boundary, square, diamond}));
  document.set_outer_rims(OuterRims::leave);
  selection.select({boundary, diamond});
  EXPECT_EQ(loops_to_fill(document, selection), (Loops{boundary, diamond})) << "who selects the outer rim means it";
  add_patch(document, {diamond}, state_at(PatchStatus::filled));
  EXPECT_EQ(loops_to_fill(document, selection), Loops{boundary}) << "no loop is filled twice";
}

TEST(Targets, AFlowMovesWhatIsNotAccepted) {
  SheetDocument document;
  const int first = add_patch(document, {square}, state_at(PatchStatus::filled));
  const int second = add_patch(document, {diamond}, state_at(PatchStatus::filled), Acceptance::accepted);
  HoleSelection selection;
  EXPECT_EQ(chosen_patches(document, selection), (std::set<int>{first, second}));
  EXPECT_EQ(patches_to_move(document, selection), std::set<int>{first});
  selection.select({diamond});
  EXPECT_EQ(chosen_patches(document, selection), std::set<int>{second});
  EXPECT_TRUE(patches_to_move(document, selection).empty());
  selection.select({boundary});
  EXPECT_TRUE(chosen_patches(document, selection).empty()) << "there is no patch in the outer rim";
}

TEST(Targets, APatchWithSeveralLoopsIsChosenByEach) {
  SheetDocument document;
  const int both = add_patch(document, {square, diamond}, state_at(PatchStatus::filled));
  HoleSelection selection;
  for (int loop : {square, diamond}) {
    selection.select({loop});
    EXPECT_EQ(chosen_patches(document, selection), std::set<int>{both});
  }
  EXPECT_EQ(loops_of(document, {both}), (Loops{square, diamond}));
  EXPECT_TRUE(loops_of(document, {both + 1}).empty()) << "no such patch";
}

TEST(Targets, SmallHolesAreThoseWithinTheLimit) {
  SheetDocument document;
  EXPECT_EQ(loops_up_to(document, SizeMeasure::edges, 3), Loops{});
  EXPECT_EQ(loops_up_to(document, SizeMeasure::edges, 4), Loops{diamond});
  EXPECT_EQ(loops_up_to(document, SizeMeasure::edges, 100), (Loops{square, diamond}));
  EXPECT_EQ(loops_up_to(document, SizeMeasure::diameter, 2.1), Loops{diamond});
  EXPECT_EQ(loops_up_to(document, SizeMeasure::diameter, 2.9), (Loops{square, diamond}));
  add_patch(document, {diamond}, state_at(PatchStatus::filled));
  EXPECT_EQ(loops_up_to(document, SizeMeasure::edges, 100), Loops{square});
}

}  // namespace
}  // namespace loopmend::test
