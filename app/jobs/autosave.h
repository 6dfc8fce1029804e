// SPDX-License-Identifier: GPL-3.0-or-later
// A copy of the session that survives a crash: written a while after each change, removed when the window closes well.
#pragma once

#include "document/document.h"
#include "document/session.h"
#include "document/undo_history.h"
#include "jobs/task_runner.h"

#include <QLockFile>
#include <QObject>
#include <QTimer>

#include <memory>

namespace loopmend {

/// What another run of the program left behind when it ended badly.
struct Leftover {
  QString path;   ///< of the copy
  QString words;  ///< what is in it: "bunny.ply, 2 patches, 12:41"
};

class Autosave : public QObject {
  Q_OBJECT

 public:
  Autosave(const Document& document, const UndoHistory& undo, QObject* parent = nullptr);

  void set_delay(int seconds);
  /// How the scene is looked at, for the copy.
  void set_view_source(ViewSource view) { view_ = std::move(view); }
  /// The folder of the copies.
  static QString place();
  /// Copies whose program is gone; they stay where they are until discard().
  static std::vector<Leftover> leftovers();
  static void discard(const Leftover& leftover);
  /// What is open now came from this copy: once it is written again, that one goes.
  void take_over(const Leftover& leftover);
  /// The window closes as it should: the copy is not needed any more.
  void finish();
  QString path() const { return path_; }

 Q_SIGNALS:
  void written();
  void failed(const QString& words);

 private:
  void change_soon();
  void write();

  const Document& document_;
  const UndoHistory& undo_;
  QString path_;
  ViewSource view_;
  std::unique_ptr<QLockFile> lock_;
  QTimer timer_;
  WriteTurns writing_;
  TaskRunner tasks_;
  std::shared_ptr<Job> job_;
  std::vector<Leftover> taken_over_;
  bool failure_told_ = false;
};

}  // namespace loopmend
