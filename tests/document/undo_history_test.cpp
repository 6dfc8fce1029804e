// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/undo_history.h"

#include "document/sheet.h"

#include <gtest/gtest.h>

namespace loopmend::test {
namespace {

/// Writes down what happens to it.
class Noted : public Change {
 public:
  Noted(QString& log, const QString& name, std::size_t bytes, const void* shared = nullptr)
      : Change(name),
        log_(log),
        bytes_(bytes),
        holds_(shared ? shared : this) {}
  void undo() override { log_ += QLatin1Char('-') + text(); }
  void redo() override { log_ += QLatin1Char('+') + text(); }
  std::size_t held_bytes(std::set<const void*>& seen) const override { return seen.insert(holds_).second ? bytes_ : 0; }
  void forget() override { bytes_ = 0, forgotten_ = true; }
  bool forgotten() const override { return forgotten_; }

 private:
  QString& log_;
  std::size_t bytes_;
  const void* holds_;
  bool forgotten_ = false;
};

struct UndoHistoryTest : testing::Test {
  void push(const char* name, std::size_t bytes = 0, const void* shared = nullptr) {
    history.push(std::make_unique<Noted>(log, QString::fromLatin1(name), bytes, shared));
  }
  /// How often one can undo; takes it all back.
  int undo_all() {
    int count = 0;
    for (; history.can_undo(); ++count) history.undo();
    return count;
  }
  QString log;
  UndoHistory history;
};

TEST_F(UndoHistoryTest, DoesUndoesAndRedoesInOrder) {
  EXPECT_FALSE(history.can_undo());
  push("a");
  push("b");
  EXPECT_EQ(history.undo_text(), QStringLiteral("b"));
  history.undo();
  EXPECT_EQ(history.redo_text(), QStringLiteral("b"));
  history.undo();
  history.undo();  // nothing left
  history.redo();
  EXPECT_EQ(log, QStringLiteral("+a+b-b-a+a"));
  push("c");
  EXPECT_FALSE(history.can_redo()) << "another future";
  EXPECT_EQ(undo_all(), 2);
}

TEST_F(UndoHistoryTest, ForgetsTheOldestBeyondItsBudget) {
  history.set_budget(250);
  for (const char* name : {"a", "b", "c"}) push(name, 100);
  EXPECT_EQ(history.held_bytes(), 200u);
  EXPECT_EQ(undo_all(), 2);
  EXPECT_EQ(log, QStringLiteral("+a+b+c-c-b"));
}

TEST_F(UndoHistoryTest, KeepsTheLatestWhateverItsSize) {
  history.set_budget(10);
  push("a", 5);
  push("b", 1000);
  EXPECT_EQ(undo_all(), 1);
  history.redo();
  EXPECT_EQ(log, QStringLiteral("+a+b-b+b"));
}

TEST_F(UndoHistoryTest, DoesNotForgetWhatCanBeRedone) {
  for (const char* name : {"a", "b", "c"}) push(name, 100);
  history.undo();
  history.undo();
  history.set_budget(0);
  history.redo();
  history.redo();
  EXPECT_EQ(log, QStringLiteral("+a+b+c-c-b+b+c"));
}

TEST_F(UndoHistoryTest, CountsSharedMemoryOnce) {
  const int shared = 0;
  push("a", 100, &shared);
  push("b", 100, &shared);
  EXPECT_EQ(history.held_bytes(), 100u);
}

TEST_F(UndoHistoryTest, IsSavedWhereItWasSaved) {
  EXPECT_TRUE(history.is_saved());
  push("a");
  EXPECT_FALSE(history.is_saved());
  history.mark_saved();
  push("b");
  EXPECT_FALSE(history.is_saved());
  history.undo();
  EXPECT_TRUE(history.is_saved());
  history.mark_unsaved();
  EXPECT_FALSE(history.is_saved());
  history.redo();
  history.undo();
  EXPECT_FALSE(history.is_saved());
}

TEST_F(UndoHistoryTest, PatchesComeAndGoWithTheirChange) {
  SheetDocument document;
  const PatchStatePtr initial = state_at(PatchStatus::filled), moved = state_at(PatchStatus::converged);
  OpenPatch before{document.next_patch_id(), 0, {square}, initial, std::make_shared<Timeline>(Timeline{initial}), {}};
  OpenPatch after = before;
  after.state = moved;
  history.push(std::make_unique<PatchChange>(document, std::vector<PatchChange::Pair>{{{}, before}}, QString()));
  history.push(std::make_unique<PatchChange>(document, std::vector<PatchChange::Pair>{{before, after}}, QString()));
  EXPECT_EQ(document.patch_of(square)->state, moved);
  history.undo();
  EXPECT_EQ(document.patch_of(square)->state, initial);
  history.undo();
  EXPECT_EQ(document.patch_of(square), nullptr);
  history.redo();
  EXPECT_EQ(document.patch_of(square)->state, initial);
}

TEST_F(UndoHistoryTest, AClosedScanComesBackWithItsPatches) {
  SheetDocument document;
  const int id = add_patch(document, {diamond}, state_at(PatchStatus::filled));
  const auto scan = document.scan(0);
  history.push(std::make_unique<CloseScan>(document, 0, QString()));
  EXPECT_FALSE(document.has_scan());
  EXPECT_TRUE(document.patches().empty());
  EXPECT_GT(history.held_bytes(), scan->model->soup.points.size() * sizeof(Vec3)) << "only the history holds it now";
  history.undo();
  EXPECT_EQ(document.scan(0), scan);
  EXPECT_EQ(document.patch_of(diamond)->id, id);
  EXPECT_EQ(history.held_bytes(), 0u) << "the document has it again";
}

TEST_F(UndoHistoryTest, AGroupIsUndoneBackwards) {
  std::vector<std::unique_ptr<Change>> parts;
  for (const char* name : {"a", "b"}) parts.push_back(std::make_unique<Noted>(log, QString::fromLatin1(name), 7));
  history.push(std::make_unique<ChangeGroup>(std::move(parts), QString()));
  EXPECT_EQ(history.held_bytes(), 14u);
  history.undo();
  EXPECT_EQ(log, QStringLiteral("+a+b-b-a"));
}

}  // namespace
}  // namespace loopmend::test
