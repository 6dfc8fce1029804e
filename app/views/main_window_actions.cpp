#include "views/main_window.h"

#include "panels/banner.h"
#include "panels/icons.h"
#include "panels/patch_panel.h"
#include "panels/report_panel.h"
#include "views/about.h"
#include "views/mesh_view.h"

#include <QAction>
#include <QActionGroup>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

namespace loopmend {

QAction* MainWindow::add_action(const char* name, const QString& text, const QString& help, const QKeySequence& keys) {
  auto* action = new QAction(text, this);
  action->setObjectName(QLatin1String(name));
  action->setShortcut(keys);
  const QString shown = keys.toString(QKeySequence::NativeText);
  action->setToolTip(shown.isEmpty() ? help : tr("%1 (%2)").arg(help, shown));
  addAction(action);
  return action;
}

QAction* MainWindow::named(const char* name) const { return findChild<QAction*>(QLatin1String(name)); }

void MainWindow::build_actions() {
  connect(add_action("open", tr("&Open\u2026"), tr("Open a scan"), QKeySequence::Open), &QAction::triggered, this,
          &MainWindow::ask_open);
  connect(add_action("sample", tr("Open the &sample"), tr("Open a small made-up scan with five holes"), {}),
          &QAction::triggered, this, &MainWindow::open_sample);
  connect(add_action("export", tr("&Export\u2026"), tr("Write scan and patches to a file"), QKeySequence::Save),
          &QAction::triggered, this, &MainWindow::ask_export);
  connect(add_action("screenshot", tr("S&creenshot\u2026"), tr("Write the picture to a PNG file"), Qt::Key_F12),
          &QAction::triggered, this, &MainWindow::ask_screenshot);
  connect(add_action("quit", tr("&Quit"), tr("Close the window"), QKeySequence::Quit), &QAction::triggered, this,
          &QWidget::close);
  connect(add_action("about", tr("&About Loopmend"), tr("Version and licence"), {}), &QAction::triggered, this,
          &MainWindow::show_about);
  build_edit_actions();
  build_view_actions();
  build_run_actions();
}

void MainWindow::build_edit_actions() {
  QAction* undo = add_action("undo", tr("&Undo"), tr("Take back the last change"), QKeySequence::Undo);
  QAction* redo = add_action("redo", tr("&Redo"), tr("Do it again"), QStringLiteral("Ctrl+Y"));
  redo->setShortcuts({QKeySequence(QStringLiteral("Ctrl+Y")), QKeySequence(QStringLiteral("Ctrl+Shift+Z"))});
  connect(undo, &QAction::triggered, &undo_, &QUndoStack::undo);
  connect(redo, &QAction::triggered, &undo_, &QUndoStack::redo);
}

void MainWindow::build_view_actions() {
  connect(add_action("frame", tr("&Frame everything"), tr("See the whole scan"), Qt::Key_F), &QAction::triggered, view_,
          &MeshView::frame);
  shadings_ = new QActionGroup(this);
  const auto shade = [this](const char* name, const QString& text, const QString& help, Qt::Key key, Shading shading) {
    QAction* action = add_action(name, text, help, key);
    action->setCheckable(true);
    action->setChecked(shading == view_->shading());
    shadings_->addAction(action);
    connect(action, &QAction::triggered, this, [this, shading] { view_->set_shading(shading); });
  };
  shade("curvature", tr("&Curvature"), tr("Colour by mean curvature H"), Qt::Key_1, Shading::curvature);
  shade("plain", tr("&Plain"), tr("One colour; patches in another"), Qt::Key_2, Shading::plain);
  shade("zebra", tr("&Zebra"), tr("Reflected stripes: kinks show where tangents or curvature jump"), Qt::Key_3,
        Shading::zebra);
  QAction* wire = add_action("wireframe", tr("&Wireframe"), tr("Draw the triangles' edges"), Qt::Key_W);
  wire->setCheckable(true);
  connect(wire, &QAction::toggled, this, [this](bool on) { view_->set_edges(on ? Edges::shown : Edges::hidden); });
}

void MainWindow::build_run_actions() {
  connect(add_action("fillAction", tr("&Fill"), tr("Close the selected holes, or all"), QStringLiteral("Ctrl+F")),
          &QAction::triggered, patch_, &PatchPanel::fill);
  connect(add_action("stepAction", tr("&Step"), tr("Take one time step"), Qt::Key_S), &QAction::triggered, patch_,
          &PatchPanel::step);
  connect(add_action("runAction", tr("&Run or pause"), tr("Step after step until at rest"), Qt::Key_Space),
          &QAction::triggered, patch_, &PatchPanel::run_or_pause);
  connect(add_action("steadyAction", tr("&To steady state"), tr("Straight to where the flow comes to rest"), Qt::Key_T),
          &QAction::triggered, patch_, &PatchPanel::to_steady_state);
  connect(add_action("cancelAction", tr("&Cancel"), tr("Stop at once"), Qt::Key_Escape), &QAction::triggered, this,
          [this] {
            if (workbench_.busy()) {
              workbench_.cancel();
            } else if (banner_->isVisible()) {
              banner_->hide();
            } else {
              selection_.select({});
            }
          });
}

void MainWindow::build_menus() {
  const auto menu = [this](const QString& title, std::initializer_list<const char*> names) {
    QMenu* made = menuBar()->addMenu(title);
    for (const char* name : names) {
      if (*name == '-') {
        made->addSeparator();
      } else {
        made->addAction(named(name));
      }
    }
    return made;
  };
  menu(tr("&File"), {"open", "sample", "-", "export", "screenshot", "-", "quit"});
  menu(tr("&Edit"), {"undo", "redo"});
  QMenu* view = menu(tr("&View"), {"curvature", "plain", "zebra", "-", "wireframe", "-", "frame", "-"});
  view->addActions(dock_toggles_);
  menu(tr("&Patch"), {"fillAction", "-", "stepAction", "runAction", "steadyAction", "-", "cancelAction"});
  menu(tr("&Help"), {"about"});
}

void MainWindow::build_toolbar() {
  QToolBar* bar = addToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("tools"));
  bar->setMovable(false);
  bar->setIconSize(QSize(20, 20));
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  const auto group = [this, bar](std::initializer_list<const char*> names, Qt::ToolButtonStyle style) {
    for (const char* name : names) {
      bar->addAction(named(name));
      auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(named(name)));
      button->setObjectName(QLatin1String(name) + QStringLiteral("Button"));
      button->setToolButtonStyle(style);
      button->setFocusPolicy(Qt::TabFocus);
    }
    bar->addSeparator();
  };
  group({"open", "export"}, Qt::ToolButtonTextBesideIcon);
  group({"undo", "redo"}, Qt::ToolButtonIconOnly);
  group({"curvature", "plain", "zebra", "wireframe"}, Qt::ToolButtonTextBesideIcon);
  group({"frame", "screenshot"}, Qt::ToolButtonIconOnly);
}

void MainWindow::update_icons() {
  const QColor ink = palette().color(QPalette::ButtonText);
  for (const auto& [action, picture] : {std::pair{"open", "open"},
                                        {"export", "export"},
                                        {"screenshot", "camera"},
                                        {"undo", "undo"},
                                        {"redo", "redo"},
                                        {"curvature", "curvature"},
                                        {"plain", "plain"},
                                        {"zebra", "zebra"},
                                        {"wireframe", "wireframe"},
                                        {"frame", "frame"}})
    named(action)->setIcon(icon(picture, ink));
}

void MainWindow::update_actions() {
  const bool idle = !workbench_.busy(), scan = document_.has_scan();
  named("undo")->setEnabled(idle && undo_.canUndo());
  named("redo")->setEnabled(idle && undo_.canRedo());
  named("undo")->setText(undo_.canUndo() ? tr("&Undo: %1").arg(undo_.undoText()) : tr("&Undo"));
  named("redo")->setText(undo_.canRedo() ? tr("&Redo: %1").arg(undo_.redoText()) : tr("&Redo"));
  named("export")->setEnabled(idle && scan);
  for (const char* name : {"screenshot", "frame", "wireframe", "curvature", "plain", "zebra"})
    named(name)->setEnabled(scan);
  const auto follow = [this](const char* action, const char* button) {
    named(action)->setEnabled(patch_->findChild<QWidget*>(QLatin1String(button))->isEnabledTo(patch_));
  };
  follow("fillAction", "fill");
  follow("stepAction", "step");
  follow("runAction", "run");
  follow("steadyAction", "steady");
}

void MainWindow::ask_open() {
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Open a scan"), {}, tr("Scans (*.ply *.stl *.obj *.off *.PLY *.STL *.OBJ *.OFF);;All files (*)"));
  if (!path.isEmpty()) open(path);
}

void MainWindow::ask_export() {
  const QFileInfo scan(document_.scan().path);
  const QString proposal = scan.dir().filePath(scan.completeBaseName() + QStringLiteral("-filled.ply"));
  QString chosen;
  QString path = QFileDialog::getSaveFileName(this, tr("Export"), proposal,
                                              tr("PLY, exact (*.ply);;STL (*.stl);;OBJ (*.obj);;OFF (*.off)"), &chosen);
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += chosen.section(QStringLiteral("*"), 1).chopped(1);
  export_to(path);
}

void MainWindow::ask_screenshot() {
  const QImage picture = view_->picture();
  const QString path =
      QFileDialog::getSaveFileName(this, tr("Screenshot"), QStringLiteral("loopmend.png"), tr("PNG (*.png)"));
  if (path.isEmpty()) return;
  if (picture.save(path, "PNG")) {
    report_->log(tr("Wrote %1.").arg(QDir::toNativeSeparators(path)));
  } else {
    banner_->show_problem(tr("%1 cannot be written. Choose another folder, or check how much space is left.")
                              .arg(QDir::toNativeSeparators(path)));
  }
}

void MainWindow::show_about() {
  auto* dialog = new About(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
}

}  // namespace loopmend
