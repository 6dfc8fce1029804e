// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/file_controller.h"
#include "jobs/problem_controller.h"

#include "dialogs/export_dialog.h"
#include "dialogs/session_dialog.h"
#include "document/labels.h"
#include "document/preferences.h"
#include "document/scene_visibility.h"
#include "panels/banner.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>

#include <algorithm>

namespace loopmend {

namespace {

constexpr int most_names_in_a_question = 3;  // a banner is one line

}  // namespace

FileController::FileController(Document& document, UndoHistory& undo, FillController& controller, PrintCheck& check,
                               const SceneVisibility& visibility, Banner& banner, QWidget* window)
    : QObject(window),
      document_(document),
      undo_(undo),
      controller_(controller),
      check_(check),
      visibility_(visibility),
      banner_(banner),
      window_(window) {
  connect(&controller_, &FillController::file_opened, this, [this](const QString& path) {
    session_path_.clear();
    keep_ = KeepScans::outside;
    add_recent_file(path);
    Q_EMIT recent_changed();
  });
  connect(&controller_, &FillController::session_saved, this, [this](const QString& path) {
    session_path_ = path;
    for (int scan : document_.scans())
      if (document_.scan(scan)->kept) keep_ = KeepScans::inside;
    add_recent_file(path);
    Q_EMIT recent_changed();
    if (auto act = std::exchange(after_saving_, nullptr)) act();
  });
  connect(&controller_, &FillController::scan_missing, this, &FileController::offer_to_locate);
  connect(&controller_, &FillController::failed, this, [this] { after_saving_ = nullptr; });
}

bool FileController::has_result() const { return problem_ && problem_->stage() == ProblemController::Stage::solved; }

bool FileController::has_unsaved_work() const { return !undo_.is_saved() && document_.has_work(); }

void FileController::act_when_safe(const std::vector<int>& scans, const QString& lose,
                                   const std::function<void()>& act) {
  if (!has_unsaved_work()) {
    if (has_result())
      ask_without_result(lose, act);
    else
      act();
    return;
  }
  QStringList names;
  for (int scan : scans) names << document_.scan(scan)->name;
  if (names.size() > most_names_in_a_question)
    names = names.mid(0, most_names_in_a_question) << QStringLiteral("\u2026");
  const QString words = tr("Work on %1 is neither saved nor exported.").arg(names.join(QStringLiteral(", ")));
  banner_.ask(words, {{tr("&Save session"), "answerSave",
                       [this, act] {
                         after_saving_ = act;
                         save_session();
                       }},
                      {lose, "answerLose", act},
                      {tr("&Cancel"), "answerCancel", [] {}}});
}

void FileController::open(const QStringList& paths, OpenMode mode) {
  QStringList files;
  for (const QString& path : paths) files << QFileInfo(path).absoluteFilePath();
  if (files.isEmpty()) return;
  const bool session = is_session_path(files.first());
  const auto act = [this, files, mode, session] {
    session ? controller_.open_session({files.first(), {}, {}}) : controller_.open(files, mode);
  };
  if (mode == OpenMode::add && !session) {
    act();
    return;
  }
  act_when_safe(document_.scans_with_work(), tr("&Open without saving"), act);
}

void FileController::open_sample() {
  when_safe([this] { controller_.open_sample(); });
}

void FileController::when_safe(const std::function<void()>& act) {
  act_when_safe(document_.scans_with_work(), tr("&Open without saving"), act);
}

void FileController::ask_open(OpenMode mode) {
  const QStringList paths = QFileDialog::getOpenFileNames(
      window_, mode == OpenMode::add ? tr("Add scans to the scene") : tr("Open"), {},
      tr("Scans and sessions (*.ply *.stl *.obj *.off *.glb *.gltf *.3mf *.vtp *.vtk *.gz *.loopmend "
         "*.PLY *.STL *.OBJ *.OFF *.GLB *.GLTF *.3MF *.VTP *.VTK);;All files (*)"));
  open(paths, mode);
}

QString FileController::proposal(const QString& ending) const {
  const OpenedScan& first = document_.first_scan();
  const QFileInfo scan(first.from == ScanOrigin::file     ? first.path
                       : !first.repaired_from.isEmpty()   ? first.repaired_from
                       : first.from == ScanOrigin::sample ? QStringLiteral("sample.ply")
                                                          : QStringLiteral("surface.ply"));
  return scan.dir().filePath(scan.completeBaseName() + ending);
}

void FileController::ask_export() {
  // In the scan's own format, which has room for all that the scan holds.
  const QStringList filters =
      tr("PLY (*.ply);;STL (*.stl);;OBJ (*.obj);;OFF (*.off);;glTF (*.glb);;glTF text (*.gltf);;3MF (*.3mf);;"
         "VTK polydata (*.vtp);;VTK legacy (*.vtk)")
          .split(QStringLiteral(";;"));
  const std::string own = document_.first_scan().import.format;
  const int format =
      std::max(0, static_cast<int>(QStringList{
                      QStringLiteral("PLY"), QStringLiteral("STL"), QStringLiteral("OBJ"), QStringLiteral("OFF"),
                      QStringLiteral("glTF"), QStringLiteral("glTF text"), QStringLiteral("3MF"), QStringLiteral("VTK")}
                                       .indexOf(QString::fromStdString(own))));
  const QString chosen = filters.value(format);
  const QString ending = chosen.section(QStringLiteral("*"), 1).chopped(1);
  ExportDialog dialog(check_, proposal(QStringLiteral("-filled") + ending), filters, chosen, window_);
  if (document_.scans().size() > 1) dialog.leave_out_labels();
  dialog.tell_of_hidden(visibility_.hidden_count());
  if (const std::string unit = document_.unit(); !unit.empty()) dialog.tell_unit(labels::unit_name(unit));
  if (dialog.exec() == QDialog::Accepted && !dialog.path().isEmpty()) export_to(dialog.path(), dialog.choice());
}

void FileController::export_to(const QString& path, const ExportChoice& choice) {
  std::set<int> initial;
  std::size_t holes = 0;
  for (const OpenPatch& patch : document_.patches()) {
    const bool movable = patch.acceptance == Acceptance::pending && patch.state->patch.free_count > 0;
    if (movable && patch.state->recipe.runs.empty() && initial.insert(patch.id).second) holes += patch.loops.size();
  }
  if (initial.empty()) {
    controller_.export_to(path, choice);
    return;
  }
  banner_.ask(
      tr("%Ln hole(s) closed by an initial patch: no flow has smoothed it yet.", nullptr, static_cast<int>(holes)),
      {{tr("&Smooth, then export"), "answerSmooth",
        [this, path, choice, initial] {
          if (controller_.busy()) return;
          Q_EMIT smoothing_wanted(initial);
          if (!controller_.busy()) return;  // these patches are gone or accepted by now
          const auto done = std::make_shared<QMetaObject::Connection>();
          *done = connect(&controller_, &FillController::flow_ended, this, [this, path, choice, done](RunEnd end) {
            disconnect(*done);
            if (end == RunEnd::complete) controller_.export_to(path, choice);
          });
        }},
       {tr("E&xport as they are"), "answerExport", [this, path, choice] { controller_.export_to(path, choice); }},
       {tr("&Cancel"), "answerCancel", [] {}}});
}

void FileController::close_scan(int scan) {
  const auto act = [this, scan] { controller_.close_scan(scan); };
  const std::vector<int> with_work = document_.scans_with_work();
  if (std::find(with_work.begin(), with_work.end(), scan) == with_work.end()) {
    act();
    return;
  }
  act_when_safe({scan}, tr("&Close without saving"), act);
}

void FileController::save_session() {
  session_path_.isEmpty() ? save_session_as() : controller_.save_session(session_path_, keep_);
}

void FileController::save_session_as() {
  SessionDialog dialog(proposal(QStringLiteral(".loopmend")), keep_, window_);
  if (dialog.exec() != QDialog::Accepted || dialog.path().isEmpty()) {
    after_saving_ = nullptr;
    return;
  }
  keep_ = dialog.keep();
  controller_.save_session(dialog.path(), keep_);
}

void FileController::ask_without_result(const QString& lose, const std::function<void()>& act) {
  banner_.ask(tr("The result of the tool was not accepted yet."),
              {{lose, "answerLose", act}, {tr("&Cancel"), "answerCancel", [] {}}});
}

bool FileController::may_close() {
  if (closing_ == Closing::agreed || (!has_unsaved_work() && !has_result())) return true;
  const auto close = [this] {
    closing_ = Closing::agreed;
    window_->close();
  };
  if (has_unsaved_work())
    act_when_safe(document_.scans_with_work(), tr("&Quit without saving"), close);
  else
    ask_without_result(tr("&Close without it"), close);
  return false;
}

void FileController::offer_recovery() {
  const std::vector<Leftover> found = Autosave::leftovers();
  if (found.empty()) return;
  const Leftover newest = found.front();
  recovery_is_open_ = true;
  banner_.ask(tr("Loopmend ended unexpectedly. Work was kept: %1.").arg(newest.words),
              {{tr("&Recover"), "answerRecover",
                [this, newest] {
                  recovery_is_open_ = false;
                  when_safe([this, newest] { recover(newest); });
                }},
               {tr("&Discard"), "answerDiscard",
                [this, newest] {
                  recovery_is_open_ = false;
                  Autosave::discard(newest);
                }},
               {tr("&Later"), "answerLater", [this] { recovery_is_open_ = false; }}});
}

void FileController::offer_recovery_again() {
  if (recovery_is_open_) offer_recovery();
}

void FileController::recover(const Leftover& leftover) {
  const auto done = std::make_shared<QMetaObject::Connection>();
  *done = connect(&controller_, &FillController::activity_changed, this, [this, leftover, done] {
    if (controller_.busy()) return;
    disconnect(*done);
    if (document_.has_work()) Q_EMIT recovered(leftover);
  });
  controller_.open_session({leftover.path, tr("recovered work"), {}});
}

void FileController::offer_to_locate(const SessionFile& session, const QString& scan) {
  const auto locate = [this, session, scan] {
    const QString place = QFileDialog::getOpenFileName(window_, tr("Where is %1?").arg(QFileInfo(scan).fileName()),
                                                       QFileInfo(session.path).path());
    if (place.isEmpty()) return;
    SessionFile found = session;
    found.moved[scan] = place;
    controller_.open_session(found);
  };
  banner_.ask(tr("%1 needs %2, which is not there any more.").arg(QFileInfo(session.path).fileName(), scan),
              {{tr("&Locate\u2026"), "answerLocate", locate}, {tr("&Cancel"), "answerCancel", [] {}}});
}

void FileController::show_recent(QMenu* menu) {
  menu->clear();
  int number = 1;
  for (const QString& path : recent_files()) {
    QAction* action = menu->addAction(tr("&%1  %2").arg(number++ % 10).arg(QFileInfo(path).fileName()));
    action->setToolTip(path);
    action->setStatusTip(path);
    connect(action, &QAction::triggered, this, [this, path] { open({path}, OpenMode::replace); });
  }
  if (menu->isEmpty()) {
    menu->addAction(tr("Nothing yet"))->setEnabled(false);
    return;
  }
  menu->addSeparator();
  connect(menu->addAction(tr("&Forget these")), &QAction::triggered, this, [this] {
    clear_recent_files();
    Q_EMIT recent_changed();
  });
}

void FileController::show_scans(QMenu* menu) {
  menu->clear();
  for (int index : document_.scans()) {
    const QString name = document_.scan(index)->name;
    connect(menu->addAction(name), &QAction::triggered, this, [this, index] { close_scan(index); });
  }
  if (menu->isEmpty()) menu->addAction(tr("Nothing is open"))->setEnabled(false);
}

}  // namespace loopmend
