// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/undo_history.h"

namespace loopmend {

UndoHistory::UndoHistory(QObject* parent) : QObject(parent) {
  connect(&stack_, &QUndoStack::indexChanged, this, &UndoHistory::changed);
  connect(&stack_, &QUndoStack::cleanChanged, this, &UndoHistory::changed);
}

void UndoHistory::push(std::unique_ptr<Change> change) {
  stack_.push(change.release());
  keep_within_budget();
}

void UndoHistory::undo() {
  if (can_undo()) stack_.undo();
}

void UndoHistory::redo() { stack_.redo(); }

void UndoHistory::clear() { stack_.clear(); }

bool UndoHistory::can_undo() const { return stack_.canUndo() && !change(stack_.index() - 1)->forgotten(); }

void UndoHistory::set_budget(std::size_t bytes) {
  budget_ = bytes;
  keep_within_budget();
}

std::size_t UndoHistory::held_bytes() const {
  std::set<const void*> seen;
  std::size_t sum = 0;
  for (int i = 0; i < stack_.count(); ++i) sum += change(i)->held_bytes(seen);
  return sum;
}

/// From the newest to the oldest: what no longer fits is forgotten, with all that came before it.
void UndoHistory::keep_within_budget() {
  std::set<const void*> seen;
  std::size_t sum = 0;
  bool forgot = false;
  for (int i = stack_.count() - 1; i >= 0; --i) {
    sum += change(i)->held_bytes(seen);
    if (sum <= budget_ || i + 1 >= stack_.index() || change(i)->forgotten()) continue;
    // Qt hands out its commands as const; they are ours, and only their memory goes.
    const_cast<Change*>(change(i))->forget();
    forgot = true;
  }
  if (forgot) Q_EMIT changed();
}

}  // namespace loopmend
