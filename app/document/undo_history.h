// SPDX-License-Identifier: GPL-3.0-or-later
// What can be taken back: an undo stack that keeps within a memory budget by forgetting its oldest changes.
#pragma once

#include "document/changes.h"

#include <QUndoStack>

namespace loopmend {

class UndoHistory : public QObject {
  Q_OBJECT

 public:
  explicit UndoHistory(QObject* parent = nullptr);

  /// Does the change, and keeps it.
  void push(std::unique_ptr<Change> change);
  void undo();
  void redo();
  void clear();

  bool can_undo() const;
  bool can_redo() const { return stack_.canRedo(); }
  QString undo_text() const { return stack_.undoText(); }
  QString redo_text() const { return stack_.redoText(); }

  /// Whether everything is in some file: nothing changed since mark_saved().
  bool is_saved() const { return stack_.isClean(); }
  void mark_saved() { stack_.setClean(); }
  /// There is something that is in no file, whatever the stack says.
  void mark_unsaved() { stack_.resetClean(); }

  /// Bytes; at least the latest change is always kept.
  void set_budget(std::size_t bytes);
  std::size_t budget() const { return budget_; }
  std::size_t held_bytes() const;

 Q_SIGNALS:
  void changed();

 private:
  const Change* change(int index) const { return static_cast<const Change*>(stack_.command(index)); }
  void keep_within_budget();

  QUndoStack stack_;
  std::size_t budget_ = std::size_t{512} << 20;
};

}  // namespace loopmend
