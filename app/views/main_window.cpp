#include "views/main_window.h"

#include "panels/banner.h"
#include "panels/holes_panel.h"
#include "panels/icons.h"
#include "panels/patch_panel.h"
#include "panels/report_panel.h"
#include "panels/status_line.h"
#include "panels/welcome.h"
#include "views/mesh_view.h"

#include <QAbstractButton>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QMimeData>
#include <QStackedLayout>
#include <QStatusBar>
#include <QVBoxLayout>

namespace loopmend {

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent), workbench_(document_, undo_) {
  setObjectName(QStringLiteral("mainWindow"));
  setWindowTitle(tr("Loopmend"));
  setWindowIcon(application_icon());
  setAcceptDrops(true);
  resize(1360, 860);
  build_centre();
  build_docks();
  build_actions();
  build_menus();
  build_toolbar();
  auto* status = new StatusLine(document_, workbench_);
  statusBar()->setSizeGripEnabled(false);
  statusBar()->addWidget(status, 1);
  connect_parts();
  guard_buttons();
  update_icons();
  update_actions();
}

MainWindow::~MainWindow() {
  // The undo stack speaks once more while it goes, after the workbench has gone.
  undo_.disconnect(this);
}

void MainWindow::build_centre() {
  view_ = new MeshView(document_, selection_);
  welcome_ = new Welcome;
  banner_ = new Banner;
  auto* middle = new QWidget;
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(banner_);
  auto* pages = new QWidget;
  // All at once, one over the other: the graphics start while the person still reads the welcome.
  centre_ = new QStackedLayout(pages);
  centre_->setStackingMode(QStackedLayout::StackAll);
  centre_->addWidget(welcome_);
  centre_->addWidget(view_);
  column->addWidget(pages, 1);
  setCentralWidget(middle);
}

void MainWindow::build_docks() {
  setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowTabbedDocks);
  setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
  auto* holes = new HolesPanel(document_, selection_);
  connect(holes, &HolesPanel::fly_to, view_, &MeshView::fly_to);
  patch_ = new PatchPanel(document_, selection_, workbench_);
  report_ = new ReportPanel(document_, selection_);
  const auto dock = [this](const char* name, const QString& title, QWidget* content, Qt::DockWidgetArea area) {
    auto* made = new QDockWidget(title);
    made->setObjectName(QLatin1String(name));
    made->setWidget(content);
    addDockWidget(area, made);
    dock_toggles_ << made->toggleViewAction();
    return made;
  };
  QDockWidget* left = dock("holesDock", tr("Holes"), holes, Qt::LeftDockWidgetArea);
  QDockWidget* right = dock("patchDock", tr("Patch"), patch_, Qt::RightDockWidgetArea);
  QDockWidget* bottom = dock("reportDock", tr("Report"), report_, Qt::BottomDockWidgetArea);
  resizeDocks({left, right}, {446, 264}, Qt::Horizontal);
  resizeDocks({bottom}, {170}, Qt::Vertical);
}

void MainWindow::connect_parts() {
  connect(&workbench_, &Workbench::failed, banner_, &Banner::show_problem);
  connect(&workbench_, &Workbench::notice, banner_, &Banner::show_notice);
  connect(&workbench_, &Workbench::said, report_, &ReportPanel::log);
  connect(&workbench_, &Workbench::preview_ready, this, [this](auto shape) {
    welcome_->hide();
    centre_->setCurrentWidget(view_);
    view_->show_preview(shape);
  });
  connect(&workbench_, &Workbench::preview_dropped, this, [this] {
    view_->drop_preview();
    show_centre();
  });
  connect(&workbench_, &Workbench::activity_changed, this, &MainWindow::update_actions);
  connect(&document_, &Document::opened, this, [this] {
    selection_.clear();
    banner_->hide();
    const QFileInfo file(document_.scan().path);
    setWindowTitle(tr("%1 \u2013 Loopmend").arg(file.fileName()));
    setWindowFilePath(document_.scan().path);
    show_centre();
    update_actions();
  });
  connect(&document_, &Document::holes_changed, this, &MainWindow::update_actions);
  connect(&selection_, &HoleSelection::selection_changed, this, &MainWindow::update_actions);
  connect(&undo_, &QUndoStack::indexChanged, this, &MainWindow::update_actions);
  connect(welcome_, &Welcome::open_wanted, this, &MainWindow::ask_open);
  connect(welcome_, &Welcome::sample_wanted, this, &MainWindow::open_sample);
}

/// A button reached by Tab answers to Space and Return itself; a click leaves the focus, and so the shortcuts, alone.
void MainWindow::guard_buttons() {
  for (QAbstractButton* button : findChildren<QAbstractButton*>()) {
    button->setFocusPolicy(Qt::TabFocus);
    button->installEventFilter(this);
  }
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter) event->accept();
  }
  return QMainWindow::eventFilter(watched, event);
}

void MainWindow::show_centre() {
  welcome_->setVisible(!document_.has_scan());
  centre_->setCurrentWidget(document_.has_scan() ? static_cast<QWidget*>(view_) : welcome_);
}

void MainWindow::open(const QString& path) { workbench_.open(QFileInfo(path).absoluteFilePath()); }

void MainWindow::open_sample() { workbench_.open_sample(); }

void MainWindow::export_to(const QString& path) { workbench_.export_to(path); }

bool MainWindow::shut_down(std::chrono::milliseconds at_most) { return workbench_.shut_down(at_most); }

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (!urls.isEmpty() && urls.first().isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  open(event->mimeData()->urls().first().toLocalFile());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  workbench_.cancel();
  QMainWindow::closeEvent(event);
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) update_icons();
}

}  // namespace loopmend
