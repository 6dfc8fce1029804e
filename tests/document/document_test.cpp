// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/sheet.h"

#include <gtest/gtest.h>

#include <cmath>

namespace loopmend::test {
namespace {

TEST(Document, KnowsTheLoopsOfItsScans) {
  SheetDocument document;
  ASSERT_EQ(document.loop_count(), 3);
  EXPECT_EQ(document.loop(boundary).kind, LoopKind::outer_rim);
  EXPECT_EQ(document.loop(boundary).edges(), 40);
  EXPECT_EQ(document.loop(square).edges(), 8);
  EXPECT_DOUBLE_EQ(document.loop(square).diameter, 2 * std::sqrt(2.0));
  EXPECT_EQ(document.loop(diamond).edges(), 4);
  EXPECT_DOUBLE_EQ(document.loop(diamond).perimeter, 4 * std::sqrt(2.0));
  const int second = document.add_scan(scan_from(QStringLiteral("/scans/other.ply")));
  EXPECT_EQ(document.first_loop_of(second), 3);
  EXPECT_EQ(document.scan_of(4), second);
  document.take_scan(0);
  EXPECT_FALSE(document.present(square));
  EXPECT_FALSE(document.fillable(square));
  EXPECT_EQ(document.scans(), std::vector<int>{second});
  EXPECT_EQ(document.loop_count(), 6) << "indices stay";
}

/// A selection may still name the loops of a scene that was set aside.
TEST(Document, HasNoLoopsWhileTheyAreSetAside) {
  SheetDocument document;
  add_patch(document, {square}, state_at(PatchStatus::filled));
  document.set_aside();
  EXPECT_FALSE(document.has_scan());
  EXPECT_FALSE(document.present(square));
  EXPECT_FALSE(document.fillable(square));
  EXPECT_EQ(document.patch_of(square), nullptr);
  document.bring_back();
  EXPECT_TRUE(document.present(square));
  EXPECT_EQ(document.state(square), HoleState::filled);
}

TEST(Document, TellsTheStateOfEveryLoop) {
  SheetDocument document;
  EXPECT_EQ(document.state(boundary), HoleState::left_out);
  EXPECT_EQ(document.state(square), HoleState::open);
  document.set_outer_rims(OuterRims::include);
  EXPECT_EQ(document.state(boundary), HoleState::open);
  document.add_failures({{diamond, verbatim("no room")}});
  EXPECT_EQ(document.state(diamond), HoleState::failed);
  EXPECT_EQ(document.message(diamond).english(), "no room");
  document.forget_failures({diamond});
  EXPECT_EQ(document.state(diamond), HoleState::open);

  const int id = add_patch(document, {square}, state_at(PatchStatus::filled));
  EXPECT_TRUE(document.has_work());
  const std::pair<PatchStatus, HoleState> pairs[] = {
      {PatchStatus::filled, HoleState::filled},       {PatchStatus::ready, HoleState::stepped},
      {PatchStatus::converged, HoleState::converged}, {PatchStatus::stalled, HoleState::stalled},
      {PatchStatus::invalid, HoleState::cutting},     {PatchStatus::faired, HoleState::faired}};
  for (const auto& [stage, state] : pairs) {
    document.set_states({{id, state_at(stage)}});
    EXPECT_EQ(document.state(square), state);
  }
  for (const auto& [grade, state] : {std::pair(Grade::good, HoleState::converged),
                                     std::pair(Grade::look, HoleState::look), std::pair(Grade::bad, HoleState::bad)}) {
    auto judged = std::make_shared<PatchState>(*state_at(PatchStatus::converged));
    judged->verdicts.resize(1);
    judged->verdicts[0].grade = grade;
    document.set_states({{id, judged}});
    EXPECT_EQ(document.state(square), state);
    EXPECT_EQ(document.verdict(square)->grade, grade);
  }
  document.set_running({id});
  EXPECT_EQ(document.state(square), HoleState::running);
  document.replace({id}, {});
  EXPECT_EQ(document.state(square), HoleState::open);
  EXPECT_FALSE(document.is_running(id));
  add_patch(document, {square}, state_at(PatchStatus::converged), Acceptance::accepted);
  EXPECT_EQ(document.state(square), HoleState::accepted);
}

TEST(Document, SaysWhatChangedAndNothingElse) {
  SheetDocument document;
  const int id = add_patch(document, {square}, state_at(PatchStatus::ready));
  int moved = 0, holes = 0, patches = 0;
  QObject::connect(&document, &Document::patch_moved, [&] { ++moved; });
  QObject::connect(&document, &Document::holes_changed, [&] { ++holes; });
  QObject::connect(&document, &Document::patches_changed, [&] { ++patches; });
  document.set_states({{id, document.patch(id)->state}});
  EXPECT_EQ(moved, 0) << "the same state";
  document.set_states({{id, state_at(PatchStatus::ready)}});
  EXPECT_EQ(moved, 1);
  EXPECT_EQ(holes, 0) << "the stage has the same name";
  document.set_states({{id, state_at(PatchStatus::converged)}});
  EXPECT_EQ(moved, 2);
  EXPECT_EQ(holes, 1);
  EXPECT_EQ(patches, 0);
  document.replace({id}, {});
  EXPECT_EQ(patches, 1);
}

}  // namespace
}  // namespace loopmend::test
