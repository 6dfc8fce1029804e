// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/hole_filter.h"

#include "document/hole_table.h"
#include "document/sheet.h"

#include <gtest/gtest.h>

namespace loopmend::test {
namespace {

struct HoleFilterTest : testing::Test {
  HoleFilterTest() { filter.setSourceModel(&table); }
  std::vector<int> shown() const {
    std::vector<int> loops;
    for (int row = 0; row < filter.rowCount(); ++row) loops.push_back(filter.mapToSource(filter.index(row, 0)).row());
    return loops;
  }
  std::vector<int> shown(HoleGroup group) {
    filter.set_group(group);
    return shown();
  }
  using Loops = std::vector<int>;
  SheetDocument document;
  HoleTable table{document};
  HoleFilter filter{document};
};

TEST_F(HoleFilterTest, ShowsTheGroupThatIsAskedFor) {
  EXPECT_EQ(shown(), (Loops{boundary, square, diamond}));
  EXPECT_FALSE(filter.narrowed());
  document.add_failures({{diamond, verbatim("no room")}});
  const int id = add_patch(document, {square}, state_at(PatchStatus::stalled));
  EXPECT_EQ(shown(HoleGroup::left_out), Loops{boundary});
  EXPECT_EQ(shown(HoleGroup::to_do), Loops{diamond});
  EXPECT_EQ(shown(HoleGroup::filled), Loops{square});
  EXPECT_EQ(shown(HoleGroup::fault), (Loops{square, diamond}));
  EXPECT_EQ(shown(HoleGroup::accepted), Loops{});
  EXPECT_TRUE(filter.narrowed());
  document.replace({id}, {});
  EXPECT_EQ(shown(HoleGroup::to_do), (Loops{square, diamond}));
}

TEST_F(HoleFilterTest, FollowsTheStatesWithinAGroup) {
  const int id = add_patch(document, {square}, state_at(PatchStatus::filled));
  EXPECT_EQ(shown(HoleGroup::fault), Loops{});
  document.set_states({{id, state_at(PatchStatus::invalid)}});
  EXPECT_EQ(shown(), Loops{square});
}

TEST_F(HoleFilterTest, FindsNumbersAndWords) {
  filter.set_words(QStringLiteral("3"));
  EXPECT_EQ(shown(), Loops{diamond});
  filter.set_words(QStringLiteral("SHEET"));
  EXPECT_EQ(shown().size(), 3u) << "the name of the scan, whatever the case";
  filter.set_words(QStringLiteral("sheet 2"));
  EXPECT_EQ(shown(), Loops{square}) << "all words at once";
  filter.set_words(QStringLiteral("rim"));
  EXPECT_EQ(shown(), Loops{boundary});
  filter.set_words(QStringLiteral("nowhere"));
  EXPECT_EQ(shown(), Loops{});
  filter.set_words(QStringLiteral("  "));
  EXPECT_FALSE(filter.narrowed());
}

TEST_F(HoleFilterTest, SortsByTheNumbersBehindTheCells) {
  filter.sort(HoleTable::edges, Qt::AscendingOrder);
  EXPECT_EQ(shown(), (Loops{diamond, square, boundary})) << "4, 8, 40: as text 40 would come before 8";
  filter.sort(HoleTable::diameter, Qt::DescendingOrder);
  EXPECT_EQ(shown(), (Loops{boundary, square, diamond}));
}

TEST_F(HoleFilterTest, SortsWhatAPersonShouldLookAtToTheTop) {
  const auto with_verdict = [](PatchStatus status, Grade grade, double crease_deg) {
    auto state = std::make_shared<PatchState>(*state_at(status));
    Verdict& verdict = state->verdicts.emplace_back();
    verdict.grade = grade;
    verdict.crease_deg = crease_deg;
    return state;
  };
  add_patch(document, {square}, with_verdict(PatchStatus::converged, Grade::good, 2.4));
  const int doubtful = add_patch(document, {diamond}, with_verdict(PatchStatus::converged, Grade::look, 31.6));
  filter.sort(HoleTable::state, Qt::AscendingOrder);
  EXPECT_EQ(shown(), (Loops{diamond, square, boundary}));
  EXPECT_TRUE(document.to_look_at(diamond));
  EXPECT_FALSE(document.to_look_at(square));
  const auto cell = [&](int loop, int column) {
    return table.data(table.index(loop, column), Qt::DisplayRole).toString();
  };
  EXPECT_EQ(cell(square, HoleTable::state), QStringLiteral("good")) << "the verdict, not how the solver ended";
  EXPECT_EQ(cell(diamond, HoleTable::state), QStringLiteral("look"));
  EXPECT_EQ(cell(boundary, HoleTable::state), QStringLiteral("outer rim")) << "why it is left out";
  EXPECT_EQ(cell(diamond, HoleTable::crease), QStringLiteral("32\u00b0"));
  document.replace({doubtful}, {});
  EXPECT_EQ(cell(diamond, HoleTable::crease), QString());
}

TEST_F(HoleFilterTest, LeavesOutTheLoopsOfAScanThatWasTakenAway) {
  document.add_scan(scan_from(QStringLiteral("/scans/other.ply")));
  document.take_scan(0);
  filter.invalidate();
  EXPECT_EQ(shown(), (Loops{3, 4, 5}));
}

}  // namespace
}  // namespace loopmend::test
