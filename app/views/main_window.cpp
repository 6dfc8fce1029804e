// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/main_window.h"

#include "compare/compare_controller.h"
#include "core/memory.h"
#include "panels/banner.h"
#include "panels/candidates_panel.h"
#include "panels/decision_box.h"
#include "panels/fill_box.h"
#include "panels/flow_box.h"
#include "panels/holes_panel.h"
#include "panels/icons.h"
#include "panels/inspect_panel.h"
#include "panels/look_panel.h"
#include "panels/parts.h"
#include "panels/patch_panel.h"
#include "panels/scene_panel.h"
#include "panels/status_line.h"
#include "panels/welcome.h"
#include "panels/window_place.h"
#include "views/candidate_binder.h"
#include "views/docks.h"
#include "views/example_controller.h"
#include "views/file_controller.h"
#include "views/mesh_view.h"
#include "views/piece_menu.h"
#include "views/repair_preview.h"
#include "views/report_writer.h"
#include "views/tool_controller.h"
#include "views/window_actions.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QMenu>
#include <QMimeData>
#include <QRadioButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedLayout>
#include <QStatusBar>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace loopmend {
namespace {

/// A scroll bar is a slider to Qt, and gets the wheel from the panel that it scrolls.
bool is_value_slider(const QWidget* widget) {
  return qobject_cast<const QAbstractSlider*>(widget) && !qobject_cast<const QScrollBar*>(widget);
}

bool is_turned_by_wheel(const QWidget* widget) {
  return qobject_cast<const QComboBox*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
         is_value_slider(widget);
}

}  // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      visibility_(document_),
      controller_(document_, undo_),
      candidates_(document_, undo_, controller_),
      autosave_(document_, undo_),
      check_(document_, controller_),
      sides_(document_, controller_),
      actions_(new WindowActions(this)),
      docks_(new Docks(this)) {
  setObjectName(QStringLiteral("mainWindow"));
  setWindowIcon(application_icon());
  setAcceptDrops(true);
  const QSize first_size = QSize(1360, 860).boundedTo(largest_window());
  resize(first_size);
  build_centre();
  files_ = new FileController(document_, undo_, controller_, check_, visibility_, *banner_, this);
  report_ = new ReportWriter(document_, visibility_, *view_, this);
  compare_ = new CompareController(document_, selection_, controller_, this);
  build_docks();
  files_->ask_for_results_of(tools_->trial());
  examples_ = new ExampleController({document_, selection_, controller_, *tools_, *compare_, *view_, *banner_}, this);
  actions_->build_menus(docks_->toggles());
  actions_->build_toolbar();
  status_ = new StatusLine(document_, controller_, check_);
  statusBar()->setSizeGripEnabled(false);
  statusBar()->addWidget(status_, 1);
  connect_controller();
  connect_problems();
  connect_document();
  connect_sides();
  connect_recent();
  connect_leisure();
  connect_panels();
  connect_file_actions();
  connect_view_actions();
  connect_patch_actions();
  guard_buttons();
  apply(load_preferences());
  actions_->update_icons();
  welcome_->show_recent(recent_files());
  update_title();
  update_actions();
  put_docks_away();
  resize(first_size);  // again: with all docks one below the other it was taller than a small screen
}

MainWindow::~MainWindow() {
  // The undo stack speaks once more while it goes, after the controller has gone.
  undo_.disconnect(this);
}

void MainWindow::build_centre() {
  view_ = new MeshView(document_, visibility_, selection_);
  welcome_ = new Welcome;
  auto* middle = new QWidget;
  auto* column = make_layout<QVBoxLayout>(middle);
  auto* pages = new QWidget;
  // All at once, one over the other: the graphics start while the person still reads the welcome.
  centre_ = new QStackedLayout(pages);
  centre_->setStackingMode(QStackedLayout::StackAll);
  centre_->addWidget(welcome_);
  centre_->addWidget(view_);
  column->addWidget(pages);
  banner_ = new Banner(middle);
  connect(banner_, &Banner::covered, view_, &MeshView::set_covered);
  setCentralWidget(middle);
}

namespace {

QWidget* scrolled(QWidget* content) {
  auto* scroll = new QScrollArea;
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(content);
  scroll->setMinimumWidth(content->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());
  return scroll;
}

}  // namespace

void MainWindow::build_docks() {
  setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowTabbedDocks);
  setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  holes_ = new HolesPanel(document_, selection_);
  patch_ = new PatchPanel(document_, selection_, controller_);
  others_ = new CandidatesPanel(document_, selection_, candidates_, controller_);
  look_ = new LookPanel;
  scene_ = new ScenePanel(document_, visibility_);
  pieces_ = new PieceMenu(document_, visibility_, selection_, *view_, this);
  inspect_ = new InspectPanel(document_, selection_);
  tools_ = new ToolController(document_, visibility_, selection_, controller_, *view_, this);
  const auto dock = [this](const char* name, const QString& title, QWidget* content, Qt::DockWidgetArea area) {
    return docks_->add(name, title, content, area);
  };
  QDockWidget* holes = dock("holesDock", tr("Holes"), holes_, Qt::RightDockWidgetArea);
  compare_->keep_in_sight(holes_);
  QDockWidget* scene = dock("sceneDock", tr("Scene"), scene_, Qt::RightDockWidgetArea);
  QDockWidget* right = dock("patchDock", tr("Patch"), patch_, Qt::RightDockWidgetArea);
  QDockWidget* look = dock("lookDock", tr("Display"), scrolled(look_), Qt::RightDockWidgetArea);
  QDockWidget* bottom = dock("inspectDock", tr("Inspect"), inspect_, Qt::BottomDockWidgetArea);
  QDockWidget* tools = dock("toolsDock", tr("Tools"), tools_->panel(), Qt::RightDockWidgetArea);
  QDockWidget* others = dock("candidatesDock", tr("Other patches"), others_, Qt::RightDockWidgetArea);
  splitDockWidget(holes, right, Qt::Vertical);
  tabifyDockWidget(holes, scene);
  tabifyDockWidget(right, tools);
  tabifyDockWidget(tools, look);
  tabifyDockWidget(look, others);
  others->hide();
  new CandidateBinder(document_, candidates_, *others_, *view_, this);
  connect(tools_, &ToolController::tool_changed, tools, [this, tools](Tool tool) {
    if (tool != Tool::none) tools->raise();
    update_actions();
  });
  connect(tools, &QDockWidget::visibilityChanged, this, [this](bool visible) {
    if (!visible && isVisible() && !isMinimized()) tools_->take(Tool::none);
  });
  holes->raise();
  right->raise();
  bottom->hide();  // plots and log, until a person asks for them
  connect(&patch_->decision_box(), &DecisionBox::seam_wanted, bottom,
          [bottom] { bottom->setVisible(bottom->isHidden()); });
  resizeDocks({holes}, {370}, Qt::Horizontal);
  resizeDocks({holes, right}, {330, 440}, Qt::Vertical);
  resizeDocks({bottom}, {214}, Qt::Vertical);
}

void MainWindow::connect_controller() {
  connect(&controller_, &FillController::failed, banner_, &Banner::show_problem);
  connect(&controller_, &FillController::notice, banner_, &Banner::show_notice);
  connect(&controller_, &FillController::repaired, banner_, &Banner::show_notice);
  connect(&controller_, &FillController::repair_questioned, this, &MainWindow::ask_about);
  connect(&controller_, &FillController::repair_proposed, new RepairPreview(document_, *banner_, *view_, this),
          &RepairPreview::show);
  connect(&controller_, &FillController::holes_made, &selection_, &HoleSelection::select);
  connect(&controller_, &FillController::logged, inspect_, &InspectPanel::log);
  connect(&autosave_, &Autosave::failed, banner_, &Banner::show_problem);
  connect(&controller_, &FillController::preview_ready, this, [this](auto shape) {
    welcome_->hide();
    centre_->setCurrentWidget(view_);
    view_->show_preview(shape);
  });
  connect(&controller_, &FillController::preview_dropped, this, [this] {
    view_->drop_preview();
    show_centre();
  });
  connect(&controller_, &FillController::ghosts_changed, view_, &MeshView::show_ghosts);
  connect(&controller_, &FillController::activity_changed, this, &MainWindow::update_actions);
  connect(&controller_, &FillController::activity_changed, this, &MainWindow::put_docks_away);
  const ViewSource view = [this] { return SessionView{view_->viewpoint(), look_->look()}; };
  controller_.set_view_source(view);
  autosave_.set_view_source(view);
  connect(&controller_, &FillController::view_restored, this, [this](const SessionView& seen) {
    Look look = seen.look;
    look.tint = look_->look().tint;  // no session keeps it
    if (look.shading == Shading::scan && !has_scan_colors_) look.shading = Shading::curvature;
    look_->set_look(look);
    view_->set_viewpoint(seen.from);
  });
  // After the controller of files, which knows by then what the session is called.
  for (auto signal : {&FillController::session_saved, &FillController::file_opened})
    connect(&controller_, signal, this, &MainWindow::update_title);
}

/// Between the steps of a flow memory is kept; after undo or close it goes back, as soon as no work waits.
void MainWindow::connect_leisure() {
  constexpr int leisure_ms = 1500;
  auto* leisure = new QTimer(this);
  leisure->setSingleShot(true);
  leisure->setInterval(leisure_ms);
  connect(leisure, &QTimer::timeout, this, [this] {
    if (!controller_.busy()) give_back_freed_memory();
  });
  connect(&controller_, &FillController::activity_changed, leisure, qOverload<>(&QTimer::start));
  connect(&undo_, &UndoHistory::changed, leisure, qOverload<>(&QTimer::start));
  connect(&document_, &Document::shape_changed, leisure, qOverload<>(&QTimer::start));
}

void MainWindow::connect_document() {
  connect(&document_, &Document::opened, this, [this] {
    has_scan_colors_ = false;
    if (look_->look().shading == Shading::scan) look_->set_shading(Shading::curvature);
    selection_.clear();
    banner_->hide();
    bring_fill_to_front();
    files_->offer_recovery_again();
  });
  connect(&document_, &Document::scans_changed, this, [this] {
    follow_scan_colors();
    show_centre();
    update_title();
    update_actions();
  });
  // Later, so that whoever puts another scan in the place of one can say first what is selected on it.
  connect(
      &document_, &Document::scans_changed, this,
      [this] {
        std::set<int> selected = selection_.selected();
        std::erase_if(selected,
                      [this](int loop) { return loop >= document_.loop_count() || !document_.present(loop); });
        selection_.select(selected);
      },
      Qt::QueuedConnection);
  connect(&document_, &Document::shape_changed, this, [this] { look_->know_range(view_->range()); });
  connect(&undo_, &UndoHistory::changed, this, [this] {
    update_actions();
    update_title();
  });
}

void MainWindow::connect_panels() {
  connect(holes_, &HolesPanel::fly_to, view_, &MeshView::fly_to);
  connect(&controller_, &FillController::filled, view_, &MeshView::fly_to_unseen);
  connect(holes_, &HolesPanel::fill_wanted, &patch_->fill_box(),
          qOverload<const std::set<int>&>(&FillBox::fill_and_smooth));
  connect(patch_, &PatchPanel::updated, this, &MainWindow::update_actions);
  connect(&patch_->decision_box(), &DecisionBox::candidates_wanted, this, &MainWindow::show_candidates);
  connect(others_, &CandidatesPanel::begun, view_, [this](int loop) { view_->fly_to_unseen({loop}); });
  connect(&candidates_, &CandidateController::taken, inspect_, &InspectPanel::log);
  connect(&patch_->decision_box(), &DecisionBox::notice, banner_, &Banner::show_notice);
  connect(&patch_->decision_box(), &DecisionBox::state_told, status_, &StatusLine::show_figures);
  connect(&patch_->decision_box(), &DecisionBox::state_told, inspect_, &InspectPanel::follow_run);
  connect(look_, &LookPanel::look_changed, view_, &MeshView::set_look);
  connect(&look_->clipping(), &ClippingBox::clipping_changed, this, [this](const Clipping& clipping) {
    view_->set_clipping(clipping);
    (*actions_)["clip"]->setChecked(clipping.across != Clipping::Across::nothing);
  });
  connect(&document_, &Document::opened, &look_->clipping(), &ClippingBox::turn_off);
  connect(look_, &LookPanel::look_changed, this, [this] {
    look_->know_range(view_->range());
    update_actions();
  });
  const auto show_hole_menu = [this](const QPoint& at) {
    QMenu* menu = actions_->make_hole_menu();
    pieces_->add_entries(menu, pieces_->of_selected_holes());
    menu->popup(at);
  };
  connect(view_, &MeshView::hole_menu_wanted, this, show_hole_menu);
  connect(holes_, &HolesPanel::hole_menu_wanted, this, show_hole_menu);
  connect(view_, &MeshView::piece_menu_wanted, pieces_, &PieceMenu::show);
  connect(scene_, &ScenePanel::unit_chosen, &controller_, &FillController::choose_unit);
  connect(scene_, &ScenePanel::menu_wanted, pieces_, &PieceMenu::show_for);
  connect(pieces_, &PieceMenu::notice, banner_, &Banner::show_notice);
  connect(view_, &MeshView::probed, status_, &StatusLine::say);
  connect(&patch_->flow_box(), &FlowBox::compare_wanted, (*actions_)["compare"], &QAction::trigger);
  connect(compare_, &CompareController::failed, banner_, &Banner::show_problem);
  connect(tools_, &ToolController::failed, banner_, &Banner::show_problem);
  connect(tools_, &ToolController::result_would_go, this, [this](const std::function<void()>& act) {
    banner_->ask(tr("The result of the tool was not accepted yet."), {{tr("&Accept it"), "answerAccept",
                                                                       [this, act] {
                                                                         tools_->trial().accept();
                                                                         if (!tools_->has_result()) act();
                                                                       }},
                                                                      {tr("&Discard it"), "answerLose", act},
                                                                      {tr("&Cancel"), "answerCancel", [] {}}});
  });
  connect(&tools_->trial(), &ProblemController::stage_changed, this, &MainWindow::update_title);
  connect(tools_, &ToolController::notice, banner_, &Banner::show_notice);
  connect(tools_, &ToolController::notice, inspect_, &InspectPanel::log);
  const auto as_chosen = [this] { return FillAndSmooth{patch_->fill_box().choice(), patch_->flow_box().options()}; };
  connect(tools_, &ToolController::part_wanted, this,
          [this, as_chosen](const HolePart& part) { controller_.fill_part(part, as_chosen()); });
  connect(tools_, &ToolController::refill_wanted, this, [this, as_chosen](int scan, const std::vector<int>& points) {
    controller_.erase(scan, points, as_chosen());
  });
  connect(tools_, &ToolController::compare_wanted, this,
          [this] { compare_->compare_trial(tools_->trial(), look_->look()); });
  connect(welcome_, &Welcome::open_wanted, this, [this] { files_->ask_open(OpenMode::replace); });
  connect(welcome_, &Welcome::sample_wanted, this, &MainWindow::open_sample);
  connect(welcome_, &Welcome::example_wanted, this,
          [this](const QString& id) { files_->when_safe([this, id] { examples_->open(id); }); });
  connect(welcome_, &Welcome::file_wanted, this, [this](const QString& path) { open(path); });
  connect(files_, &FileController::recovered, &autosave_, &Autosave::take_over);
  connect(files_, &FileController::smoothing_wanted, this, [this](const std::set<int>& patch_ids) {
    controller_.evolve(patch_ids, patch_->flow_box().options(), Pace::steady);
  });
  connect(files_, &FileController::recent_changed, this, [this] { welcome_->show_recent(recent_files()); });
}

/// A button reached by Tab answers to Space and Return itself; a click leaves the focus, and so the shortcuts, alone. What can be
/// ticked takes the focus, so that Space ticks it again.
void MainWindow::guard_buttons() {
  for (QAbstractButton* button : findChildren<QAbstractButton*>()) {
    const bool ticks = qobject_cast<QCheckBox*>(button) || qobject_cast<QRadioButton*>(button);
    button->setFocusPolicy(ticks ? Qt::StrongFocus : Qt::TabFocus);
    button->installEventFilter(this);
  }
  // Space opens a list, and ticks a box in one. The table of holes and the sliders have no use for it: there it runs.
  for (QWidget* widget : findChildren<QWidget*>())
    if (qobject_cast<QComboBox*>(widget) || qobject_cast<QTreeWidget*>(widget)) widget->installEventFilter(this);
  // The wheel scrolls the panel that it is over; it turns a value only where that has the focus.
  for (QWidget* widget : findChildren<QWidget*>())
    if (is_turned_by_wheel(widget)) {
      widget->setFocusPolicy(Qt::StrongFocus);
      widget->installEventFilter(this);
    }
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Wheel) {
    const auto* widget = qobject_cast<QWidget*>(watched);
    if (is_turned_by_wheel(widget) && !widget->hasFocus()) {
      event->ignore();
      return true;
    }
  }
  if (event->type() == QEvent::ShortcutOverride && !qobject_cast<QAbstractSpinBox*>(watched) &&
      !is_value_slider(qobject_cast<QWidget*>(watched))) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter) event->accept();
  }
  return QMainWindow::eventFilter(watched, event);
}

void MainWindow::show_centre() {
  welcome_->setVisible(!document_.has_scan());
  put_docks_away();
  centre_->setCurrentWidget(document_.has_scan() ? static_cast<QWidget*>(view_) : welcome_);
}

/// While a first scan is read its progress is seen, and can be cancelled.
void MainWindow::put_docks_away() {
  const bool were_away = docks_->are_away();
  docks_->put_away(!document_.has_scan() && !controller_.busy());
  if (were_away && !docks_->are_away()) bring_fill_to_front();
}

/// The table of holes, and the button that fills them with its progress, whatever dock was in front for the last file.
void MainWindow::bring_fill_to_front() {
  for (const char* name : {"holesDock", "patchDock"}) findChild<QDockWidget*>(QLatin1String(name))->raise();
}

void MainWindow::follow_scan_colors() {
  const std::vector<int> scans = document_.scans();
  const bool now =
      std::any_of(scans.begin(), scans.end(), [this](int index) { return document_.scan(index)->colors != nullptr; });
  if (std::exchange(has_scan_colors_, now) == now) return;
  if (now)
    look_->set_shading(Shading::scan);
  else if (look_->look().shading == Shading::scan)
    look_->set_shading(Shading::curvature);
}

void MainWindow::update_title() {
  QStringList names;
  for (int index : document_.scans()) names << document_.scan(index)->name;
  if (!names.isEmpty() && !files_->session_path().isEmpty())
    names = QStringList(QFileInfo(files_->session_path()).fileName());
  const QString what = names.size() > 2 ? tr("%1 and %2 more").arg(names.first()).arg(names.size() - 1)
                                        : names.join(QStringLiteral(", "));
  setWindowTitle(what.isEmpty() ? tr("Loopmend") : tr("%1[*] \u2013 Loopmend").arg(what));
  setWindowModified(!what.isEmpty() && (files_->has_unsaved_work() || files_->has_result()));
}

void MainWindow::open(const QStringList& paths, OpenMode mode) { files_->open(paths, mode); }

void MainWindow::open_sample() { files_->open_sample(); }

void MainWindow::restore_layout() {
  const WindowLayout layout = load_window_layout();
  // Qt leaves a window as large as it was, and takes a corner on the screen for enough.
  if (restoreGeometry(layout.geometry) && !isMaximized() && !isFullScreen()) setGeometry(onto_screen(geometry()));
  docks_->restore(layout.docks);
  Look look = load_look();
  look.map = look_->look().map;
  look_->set_look(look);
}

void MainWindow::keep_layout() const {
  save_window_layout({saveGeometry(), docks_->state()});
  save_look(look_->look());
}

void MainWindow::offer_recovery() { files_->offer_recovery(); }

bool MainWindow::shut_down(std::chrono::milliseconds at_most) {
  const bool compared = compare_->shut_down(at_most), tried = tools_->shut_down(at_most);
  const bool checked = check_.shut_down(at_most) && sides_.shut_down(at_most), reported = report_->shut_down(at_most);
  const bool proposed = candidates_.shut_down(at_most), summed_up = batch_.shut_down(at_most);
  return controller_.shut_down(at_most) && compared && tried && checked && reported && proposed && summed_up;
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (!urls.isEmpty() && urls.first().isLocalFile()) event->acceptProposedAction();
}

/// What is dropped comes beside what is open: nothing gets lost by a drop.
void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) paths << url.toLocalFile();
  open(paths, OpenMode::add);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!files_->may_close()) {
    event->ignore();
    return;
  }
  if (batch_.busy() && !batch_.is_stopping()) {
    event->ignore();
    banner_->ask(tr("A folder is being filled. What is done stays, and the next run goes on there."),
                 {{tr("&Stop and close"), "answerStop",
                   [this] {
                     batch_.stop();
                     close();
                   }},
                  {tr("&Cancel"), "answerCancel", [] {}}});
    return;
  }
  controller_.cancel();
  autosave_.finish();
  QMainWindow::closeEvent(event);
}

void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) actions_->update_icons();
}

}  // namespace loopmend
