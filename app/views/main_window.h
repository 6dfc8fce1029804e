// The one window. It only wires: parts live in panels, views, jobs and document.
#pragma once

#include "document/document.h"
#include "document/hole_selection.h"
#include "jobs/workbench.h"
#include "scene/shading.h"

#include <QMainWindow>
#include <QUndoStack>

class QAction;
class QActionGroup;
class QStackedLayout;

namespace loopmend {

class Banner;
class MeshView;
class PatchPanel;
class ReportPanel;
class Welcome;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  void open(const QString& path);
  void open_sample();
  void export_to(const QString& path);
  /// Once the window is closed: @returns whether every worker has ended.
  bool shut_down(std::chrono::milliseconds at_most);

  const Document& document() const { return document_; }
  HoleSelection& selection() { return selection_; }
  Workbench& workbench() { return workbench_; }
  MeshView& view() { return *view_; }

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void build_centre();
  void build_docks();
  void build_actions();
  void build_edit_actions();
  void build_view_actions();
  void build_run_actions();
  void build_menus();
  void build_toolbar();
  void connect_parts();
  void guard_buttons();
  QAction* add_action(const char* name, const QString& text, const QString& help, const QKeySequence& keys);
  QAction* named(const char* name) const;

  void ask_open();
  void ask_export();
  void ask_screenshot();
  void show_about();
  void update_actions();
  void update_icons();
  void show_centre();

  Document document_;
  HoleSelection selection_;
  QUndoStack undo_;
  Workbench workbench_;
  MeshView* view_ = nullptr;
  Welcome* welcome_ = nullptr;
  Banner* banner_ = nullptr;
  PatchPanel* patch_ = nullptr;
  ReportPanel* report_ = nullptr;
  QStackedLayout* centre_ = nullptr;
  QActionGroup* shadings_ = nullptr;
  QList<QAction*> dock_toggles_;
};

}  // namespace loopmend
