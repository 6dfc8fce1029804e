// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/document_run.h"

#include "document/sheet.h"

#include <gtest/gtest.h>

namespace loopmend::test {
namespace {

constexpr std::size_t no_limit = std::size_t{1} << 30;

std::shared_ptr<PatchState> state_of(const std::set<int>& loops) {
  auto state = state_at(PatchStatus::ready);
  for (int loop : loops) state->patch.loop_numbers.push_back(loop + 1);
  return state;
}

TEST(DocumentRun, PartsOfAPatchComeInItsPlaceWhenOneMoves) {
  SheetDocument document;
  const int whole = add_patch(document, {square, diamond}, state_of({square, diamond}));
  DocumentRun run(document, no_limit);
  RunRecorder recorder(nullptr);
  const PatchStatePtr first = state_of({square}), other = state_of({diamond}), moved = state_of({square});
  recorder.start({square}, first);
  recorder.start({diamond}, other);
  run.place(recorder.take());
  EXPECT_TRUE(run.changes().empty());
  EXPECT_NE(document.patch(whole), nullptr);
  recorder.record({square}, moved);
  run.place(recorder.take());
  EXPECT_EQ(document.patch(whole), nullptr);
  EXPECT_EQ(document.patch_of(square)->state, moved);
  EXPECT_EQ(*document.patch_of(square)->timeline, (Timeline{first, moved}));
  EXPECT_EQ(document.patch_of(diamond)->state, other);
  EXPECT_EQ(run.changes().size(), 3u);
}

TEST(DocumentRun, APatchStaysUntilAllItsHolesAreClosedByOthers) {
  SheetDocument document;
  const int whole = add_patch(document, {square, diamond}, state_of({square, diamond}));
  DocumentRun run(document, no_limit);
  RunRecorder recorder(nullptr);
  recorder.record({square}, state_of({square}));
  run.place(recorder.take());
  EXPECT_NE(document.patch(whole), nullptr) << "cancelled now, the other hole would be open";
  run.place_rest();
  EXPECT_NE(document.patch_of(square), nullptr);
  EXPECT_EQ(document.patch_of(diamond), nullptr);
}

TEST(DocumentRun, AnotherAttemptTakesThePlaceOfTheOneBefore) {
  SheetDocument document;
  const PatchStatePtr before = state_of({diamond});
  const int known = add_patch(document, {diamond}, before);
  DocumentRun run(document, no_limit);
  RunRecorder recorder(nullptr);
  for (int attempt = 0; attempt < 2; ++attempt) {
    recorder.restart({diamond});
    const PatchStatePtr step = state_of({diamond});
    recorder.record({diamond}, step);
    run.place(recorder.take());
    EXPECT_EQ(*document.patch(known)->timeline, (Timeline{before, step}));
  }
  ASSERT_EQ(run.changes().size(), 1u);
  EXPECT_EQ(run.changes().front().before->state, before);
}

}  // namespace
}  // namespace loopmend::test
