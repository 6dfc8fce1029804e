// SPDX-License-Identifier: GPL-3.0-or-later
// The one window. It only wires: parts live in panels, views, dialogs, jobs and document.
#pragma once

#include "document/document.h"
#include "document/hole_selection.h"
#include "document/preferences.h"
#include "document/scene_visibility.h"
#include "document/undo_history.h"
#include "jobs/autosave.h"
#include "jobs/batch_controller.h"
#include "jobs/candidate_controller.h"
#include "jobs/fill_controller.h"
#include "jobs/print_check.h"
#include "jobs/side_check.h"

#include <QMainWindow>

class QStackedLayout;

namespace loopmend {

class Banner;
class CandidateBinder;
class CandidatesPanel;
class CompareController;
class Docks;
class ExampleController;
class FileController;
class HolesPanel;
class InspectPanel;
class LookPanel;
class MeshView;
class PatchPanel;
class PieceMenu;
class ReportWriter;
class ScenePanel;
class StatusLine;
class ToolController;
class Welcome;
class WindowActions;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  void open(const QStringList& paths, OpenMode mode = OpenMode::replace);
  void open(const QString& path) { open(QStringList(path)); }
  void open_sample();
  /// Offers work that another run left behind; for the start of the program.
  /// As it was when the program ended last; what no longer fits the screens is moved onto them.
  void restore_layout();
  void keep_layout() const;
  void offer_recovery();
  /// Once the window is closed: @returns whether every worker has ended.
  bool shut_down(std::chrono::milliseconds at_most);

  const Document& document() const { return document_; }
  HoleSelection& selection() { return selection_; }
  SceneVisibility& visibility() { return visibility_; }
  FillController& controller() { return controller_; }
  UndoHistory& undo() { return undo_; }
  Autosave& autosave() { return autosave_; }
  BatchController& batch() { return batch_; }
  PrintCheck& print_check() { return check_; }
  CandidateController& candidates() { return candidates_; }
  MeshView& view() { return *view_; }
  CompareController& comparisons() { return *compare_; }
  ToolController& tools() { return *tools_; }
  ReportWriter& report() { return *report_; }

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void build_centre();
  void build_docks();
  void connect_controller();
  void connect_document();
  void connect_sides();
  void connect_recent();
  void connect_leisure();
  void connect_panels();
  void connect_file_actions();
  void connect_view_actions();
  void connect_patch_actions();
  void guard_buttons();

  void apply(const Preferences& preferences);
  void ask_preferences();
  void show_repair_dialog();
  void show_picture_dialog();
  void show_film_dialog();
  void show_batch_dialog();
  void show_written(const QString& path);
  void show_candidates();
  void step_back();
  void update_actions();
  void ask_about(const RepairQuestion& question);
  void connect_close_as();
  void update_close_as();
  void connect_problems();
  /// A scan that brings its own colours is shown in them.
  void follow_scan_colors();
  void update_title();
  void show_centre();
  void put_docks_away();
  void bring_fill_to_front();

  Document document_;
  SceneVisibility visibility_;
  HoleSelection selection_;
  UndoHistory undo_;
  FillController controller_;
  CandidateController candidates_;
  Autosave autosave_;
  PrintCheck check_;
  SideCheck sides_;
  BatchController batch_;
  QString to_be_pictured_;  ///< the file that was opened or saved last
  WindowActions* actions_;
  Docks* docks_;
  MeshView* view_ = nullptr;
  Welcome* welcome_ = nullptr;
  Banner* banner_ = nullptr;
  QString left_open_;  ///< the banner's words on holes that could not be filled
  bool has_scan_colors_ = false;
  CompareController* compare_ = nullptr;
  ExampleController* examples_ = nullptr;
  FileController* files_ = nullptr;
  HolesPanel* holes_ = nullptr;
  PatchPanel* patch_ = nullptr;
  CandidatesPanel* others_ = nullptr;
  LookPanel* look_ = nullptr;
  ScenePanel* scene_ = nullptr;
  PieceMenu* pieces_ = nullptr;
  InspectPanel* inspect_ = nullptr;
  StatusLine* status_ = nullptr;
  ReportWriter* report_ = nullptr;
  ToolController* tools_ = nullptr;
  QStackedLayout* centre_ = nullptr;
};

}  // namespace loopmend
