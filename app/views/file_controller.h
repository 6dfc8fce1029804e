// SPDX-License-Identifier: GPL-3.0-or-later
// Everything about files: opening, sessions, exports, pictures, recent files, and the questions before work is lost.
// Questions are asked in place, by the banner; only choosing a file takes a dialog.
#pragma once

#include "jobs/autosave.h"
#include "jobs/fill_controller.h"
#include "jobs/print_check.h"

#include <QObject>
#include <QStringList>

class QMenu;
class QWidget;

namespace loopmend {

class ProblemController;

class Banner;
class SceneVisibility;

class FileController : public QObject {
  Q_OBJECT

 public:
  FileController(Document& document, UndoHistory& undo, FillController& controller, PrintCheck& check,
                 const SceneVisibility& visibility, Banner& banner, QWidget* window);

  /// Scans, or one session. Asks first when patches would be lost.
  void open(const QStringList& paths, OpenMode mode);
  void open_sample();
  /// Does it, after asking where work would be lost.
  void when_safe(const std::function<void()>& act);
  void ask_open(OpenMode mode);
  void ask_export();
  /// Asks first where some patches are initial patches still.
  void export_to(const QString& path, const ExportChoice& choice = {});
  /// Asks first where patches of this scan would be lost.
  void close_scan(int scan);
  void save_session();
  void save_session_as();
  /// Asks in place, and closes the window later if that is wanted. @returns whether it may close now.
  bool may_close();
  /// Offers work that another run left behind.
  void offer_recovery();
  /// The same while it is unanswered: a scan that was opened took its place.
  void offer_recovery_again();
  /// Its result is asked for as well before the window closes. @param problem  must outlive this
  void ask_for_results_of(const ProblemController& problem) { problem_ = &problem; }
  void show_recent(QMenu* menu);
  void show_scans(QMenu* menu);

  /// A name beside the first scan's.
  QString proposal(const QString& ending) const;
  bool has_unsaved_work() const;
  /// Of a tool, neither accepted nor discarded.
  bool has_result() const;
  const QString& session_path() const { return session_path_; }

 Q_SIGNALS:
  void recent_changed();
  /// A flow is to run on these patches, as it is chosen at present.
  void smoothing_wanted(const std::set<int>& patch_ids);
  /// The work in this copy is on the screen again.
  void recovered(const Leftover& leftover);

 private:
  /// Asks first where there is unsaved work. @param scans  that it would be lost of
  void act_when_safe(const std::vector<int>& scans, const QString& lose, const std::function<void()>& act);
  void ask_without_result(const QString& lose, const std::function<void()>& act);
  void recover(const Leftover& leftover);
  void offer_to_locate(const SessionFile& session, const QString& scan);

  Document& document_;
  UndoHistory& undo_;
  FillController& controller_;
  PrintCheck& check_;
  const SceneVisibility& visibility_;
  Banner& banner_;
  QWidget* window_;
  QString session_path_;
  KeepScans keep_ = KeepScans::outside;  ///< as the session was saved, or read
  std::function<void()> after_saving_;
  const ProblemController* problem_ = nullptr;
  bool recovery_is_open_ = false;  ///< offered, and not answered
  enum class Closing { not_asked, agreed } closing_ = Closing::not_asked;
};

}  // namespace loopmend
