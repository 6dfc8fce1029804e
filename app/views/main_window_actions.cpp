// SPDX-License-Identifier: GPL-3.0-or-later
// What the window's actions do, and when they can be done.
#include "views/main_window.h"

#include "compare/compare_controller.h"
#include "dialogs/about.h"
#include "dialogs/base_dialog.h"
#include "dialogs/batch_dialog.h"
#include "dialogs/command_palette.h"
#include "dialogs/help_window.h"
#include "dialogs/navigation_sheet.h"
#include "dialogs/picture_dialog.h"
#include "dialogs/preferences_dialog.h"
#include "dialogs/repair_dialog.h"
#include "dialogs/shortcut_sheet.h"
#include "document/recent_pictures.h"
#include "document/targets.h"
#include "jobs/change_surface.h"
#include "panels/banner.h"
#include "panels/candidates_panel.h"
#include "panels/decision_box.h"
#include "panels/fill_box.h"
#include "panels/flow_box.h"
#include "panels/holes_panel.h"
#include "panels/inspect_panel.h"
#include "panels/look_panel.h"
#include "panels/patch_panel.h"
#include "panels/player_bar.h"
#include "panels/small_holes_box.h"
#include "panels/theme.h"
#include "panels/welcome.h"
#include "views/docks.h"
#include "views/file_controller.h"
#include "views/film_source.h"
#include "views/mesh_view.h"
#include "views/piece_menu.h"
#include "views/report_writer.h"
#include "views/tool_controller.h"
#include "views/window_actions.h"

#include <QApplication>
#include <QDockWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include <utility>

namespace loopmend {
namespace {

constexpr std::pair<const char*, NamedView> sides[] = {
    {"lookFront", NamedView::front}, {"lookBack", NamedView::back}, {"lookLeft", NamedView::left},
    {"lookRight", NamedView::right}, {"lookTop", NamedView::top},   {"lookBottom", NamedView::bottom}};
constexpr std::pair<const char*, UpAxis> up_axes[] = {
    {"upByShape", UpAxis::by_shape}, {"upX", UpAxis::x}, {"upMinusX", UpAxis::minus_x}, {"upY", UpAxis::y},
    {"upMinusY", UpAxis::minus_y},   {"upZ", UpAxis::z}, {"upMinusZ", UpAxis::minus_z}};
constexpr std::pair<const char*, NavigationStyle> navigation_styles[] = {
    {"navigateLoopmend", NavigationStyle::loopmend},
    {"navigateBlender", NavigationStyle::blender},
    {"navigateMeshLab", NavigationStyle::meshlab},
    {"navigateCad", NavigationStyle::cad}};
constexpr std::pair<const char*, Shading> shadings[] = {
    {"scanColors", Shading::scan},    {"curvature", Shading::curvature}, {"gaussian", Shading::gaussian},
    {"plain", Shading::plain},        {"zebra", Shading::zebra},         {"isophotes", Shading::isophotes},
    {"deviation", Shading::deviation}};

constexpr std::pair<const char*, std::optional<SeamContinuity>> close_as[] = {
    {"closeAsAutomatic", std::nullopt},
    {"closeAsTangent", SeamContinuity::tangent},
    {"closeAsFlat", SeamContinuity::position}};

/// A window of its own that goes when it is closed.
template <class Dialog, class... Arguments>
Dialog* show_beside(QWidget* window, Arguments&&... arguments) {
  auto* dialog = new Dialog(std::forward<Arguments>(arguments)..., window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
  return dialog;
}

}  // namespace

void MainWindow::connect_file_actions() {
  const WindowActions& a = *actions_;
  a.on("open", this, [this] { files_->ask_open(OpenMode::replace); });
  a.on("add", this, [this] { files_->ask_open(OpenMode::add); });
  a.on("sample", this, &MainWindow::open_sample);
  a.on("saveSession", files_, &FileController::save_session);
  a.on("saveSessionAs", files_, &FileController::save_session_as);
  a.on("export", files_, &FileController::ask_export);
  a.on("screenshot", this, &MainWindow::show_picture_dialog);
  a.on("film", this, &MainWindow::show_film_dialog);
  a.on("report", this, [this] { report_->ask(files_->proposal(QStringLiteral("-report.html"))); });
  connect(report_, &ReportWriter::written, this, &MainWindow::show_written);
  connect(report_, &ReportWriter::failed, banner_, &Banner::show_notice);
  a.on("batch", this, &MainWindow::show_batch_dialog);
  a.on("quit", this, &QWidget::close);
  a.on("preferences", this, &MainWindow::ask_preferences);
  a.on("help", this, [this] { show_beside<HelpWindow>(this); });
  a.on("shortcuts", this, [this] {
    std::vector<ShortcutSheet::Group> groups;
    for (const WindowActions::Group& group : actions_->groups()) groups.push_back({group.title, group.actions});
    show_beside<ShortcutSheet>(this, groups);
  });
  a.on("palette", this, [this] {
    std::vector<CommandPalette::Group> groups;
    for (const WindowActions::Group& group : actions_->groups()) groups.push_back({group.title, group.actions});
    groups.push_back({tr("View"), docks_->toggles()});
    show_beside<CommandPalette>(this, groups);
  });
  a.on("about", this, [this] { show_beside<About>(this); });
  connect(a.recent_menu(), &QMenu::aboutToShow, files_, [this] { files_->show_recent(actions_->recent_menu()); });
  connect(a.close_menu(), &QMenu::aboutToShow, files_, [this] { files_->show_scans(actions_->close_menu()); });
}

void MainWindow::connect_view_actions() {
  const WindowActions& a = *actions_;
  for (const auto& [name, shading] : shadings)
    a.on(name, this, [this, wanted = shading] { look_->set_shading(wanted); });
  a.on("wireframe", this, [this](bool on) { look_->set_edges(on ? Edges::shown : Edges::hidden); });
  a.on("clip", &look_->clipping(), &ClippingBox::toggle);
  a.on("seams", this, [this](bool on) { look_->set_seams(on ? Seams::shown : Seams::hidden); });
  a.on("tint", this, [this](bool on) { look_->set_tint(on ? Tint::patches : Tint::none); });
  a.on("frame", view_, &MeshView::frame);
  a.on("orthographic", this, [this](bool on) {
    view_->set_projection(on ? MeshView::Projection::orthographic : MeshView::Projection::perspective);
  });
  for (const auto& [name, side] : sides) a.on(name, this, [this, from = side] { view_->look_from(from); });
  for (const auto& [name, up] : up_axes) a.on(name, this, [this, wanted = up] { look_->set_up(wanted); });
  for (const auto& [name, style] : navigation_styles)
    a.on(name, this, [this, wanted = style] {
      save_navigation(wanted);
      view_->set_navigation(wanted);
    });
  view_->set_navigation(load_navigation());
  for (const auto& [name, style] : navigation_styles)
    if (style == load_navigation()) a[name]->setChecked(true);
  a.on("navigationSheet", this, [this] { show_beside<NavigationSheet>(this); });
  a.on("probe", view_, &MeshView::probe_middle);
  a.on("hidePiece", pieces_, &PieceMenu::hide);
  a.on("isolatePiece", pieces_, &PieceMenu::isolate);
  a.on("showPieces", &visibility_, &SceneVisibility::show_all);
  connect(&visibility_, &SceneVisibility::changed, this, &MainWindow::update_actions);
  const auto stop_playing = [this] { patch_->decision_box().player().pause(); };
  a.on("undo", this, [this, stop_playing] {
    stop_playing();
    undo_.undo();
  });
  a.on("redo", this, [this, stop_playing] {
    stop_playing();
    undo_.redo();
  });
  a.on("nextHole", this, [this] { holes_->go(HolesPanel::Way::next); });
  a.on("nextToLookAt", this, [this] { holes_->go(HolesPanel::Way::next_to_look_at); });
  a.on("previousHole", this, [this] { holes_->go(HolesPanel::Way::previous); });
  a.on("filter", holes_, &HolesPanel::focus_filter);
  a.on("selectAll", holes_, &HolesPanel::select_all_holes);
}

/// No question: the scan can be filled as it is, and a room scanned from within is right.
void MainWindow::connect_sides() {
  connect(&sides_, &SideCheck::open_body_looks_inward, this, [this](int scan) {
    banner_->offer(tr("%1: the faces look inward, so that the outside is drawn as an inside. Of a room scanned from "
                      "within that is right; else turn them around.")
                       .arg(document_.scan(scan)->name),
                   {{tr("&Turn around"), "answerTurnAround", [this, scan] { controller_.turn_around(scan); }}});
  });
  connect(&sides_, &SideCheck::bodies_are_inside_out, this, [this](int scan, int count) {
    banner_->offer(tr("%1: %Ln bodies or cavities are inside out. Repair turns them.", nullptr, count)
                       .arg(document_.scan(scan)->name),
                   {{tr("&Repair\u2026"), "answerRepair", [this] { show_repair_dialog(); }}});
  });
}

/// A picture of what was opened or saved, once it is drawn as a whole and nothing else is to be done.
void MainWindow::connect_recent() {
  constexpr int leisure_ms = 1500;
  auto* leisure = new QTimer(this);
  leisure->setSingleShot(true);
  leisure->setInterval(leisure_ms);
  for (auto signal : {&FillController::file_opened, &FillController::session_saved})
    connect(&controller_, signal, this, [this, leisure](const QString& path) {
      to_be_pictured_ = path;
      leisure->start();
    });
  connect(leisure, &QTimer::timeout, this, [this, leisure] {
    if (to_be_pictured_.isEmpty() || !document_.has_scan()) return;
    if (controller_.busy() || view_->is_rough() || view_->is_flying()) return leisure->start();
    save_recent_picture(std::exchange(to_be_pictured_, QString()), view_->picture());
    welcome_->show_recent(recent_files());
  });
}

void MainWindow::connect_patch_actions() {
  const WindowActions& a = *actions_;
  a.on("fillAction", &patch_->fill_box(), [box = &patch_->fill_box()] { box->fill_and_smooth(); });
  a.on("initialAction", &patch_->fill_box(), &FillBox::fill);
  for (const auto& [name, what] : {std::pair{"trimAction", ScanRepair::trim},
                                   {"trimCrossingAction", ScanRepair::trim_crossing},
                                   {"stitchAction", ScanRepair::stitch},
                                   {"prepareAction", ScanRepair::prepare},
                                   {"turnAroundAction", ScanRepair::turn_around}})
    a.on(name, this, [this, repair = what] { patch_->fill_box().repair_scans(repair); });
  a.on("eraseRingAction", this, [this] { controller_.repair_scans(ScanRepair::erase, selection_.selected()); });
  a.on("partAction", this, [this] { controller_.repair_scans(ScanRepair::part, selection_.selected()); });
  a.on("repairAction", this, &MainWindow::show_repair_dialog);
  connect(&patch_->fill_box(), &FillBox::repair_wanted, this, &MainWindow::show_repair_dialog);
  a.on("stepAction", &patch_->flow_box(), &FlowBox::step);
  PlayerBar* player = &patch_->decision_box().player();
  a.on("runAction", this,
       [this, player] { player->is_playing() ? player->pause() : patch_->flow_box().run_or_pause(); });
  a.on("playAction", player, &PlayerBar::play_or_pause);
  a.on("nextStateAction", player, &PlayerBar::next);
  a.on("acceptAction", &patch_->decision_box(), &DecisionBox::accept_or_reopen);
  a.on("rejectAction", this, [this] {
    // A key alone does not throw everything away; the button says what it is about.
    if (!selection_.selected().empty()) patch_->decision_box().reject();
  });
  a.on("candidatesAction", this, &MainWindow::show_candidates);
  a.on("copyAction", &patch_->decision_box(), &DecisionBox::copy_command);
  for (const auto& [name, tool] : {std::pair{"toolRegionAction", Tool::region},
                                   {"toolPointsAction", Tool::points},
                                   {"toolBlendAction", Tool::blend},
                                   {"toolBridgeAction", Tool::bridge},
                                   {"toolFillPartAction", Tool::fill_part},
                                   {"toolEdgesAction", Tool::edges},
                                   {"toolMirrorAction", Tool::mirror},
                                   {"toolCutAction", Tool::cut},
                                   {"toolMeasureAction", Tool::measure}})
    a.on(name, this, [this, wanted = tool] {
      findChild<QDockWidget*>(QStringLiteral("toolsDock"))->show();
      tools_->take(tools_->panel()->tool() == wanted ? Tool::none : wanted);
    });
  connect_close_as();
  a.on("compare", this, [this] { compare_->compare_holes(look_->look()); });
  a.on("cancelAction", this, &MainWindow::step_back);
}

void MainWindow::connect_close_as() {
  for (const auto& [name, shape] : close_as)
    actions_->on(name, this, [this, wanted = shape] {
      controller_.choose_shape(selection_.selected(), wanted);
      update_actions();  // an action that was checked already must stay so
    });
  actions_->on("closeAsBase", this, [this] { ask_base(*selection_.selected().begin(), document_, controller_, this); });
}

void MainWindow::update_close_as() {
  const std::set<int>& selected = selection_.selected();
  const bool is_asked = !controller_.busy() && !selected.empty();
  const auto has = [&](int loop) { return document_.present(loop) && document_.loop(loop).kind != LoopKind::cut; };
  const bool possible = is_asked && std::all_of(selected.begin(), selected.end(), has);
  for (const auto& [name, shape] : close_as) {
    QAction* action = (*actions_)[name];
    action->setEnabled(possible);
    action->setChecked(possible && std::all_of(selected.begin(), selected.end(), [&, wanted = shape](int loop) {
                         return document_.chosen_shape(loop) == wanted;
                       }));
  }
  (*actions_)["closeAsBase"]->setEnabled(possible && selected.size() == 1 && !document_.patch_of(*selected.begin()));
}

/// Names the holes that could not be filled, until the next fill or until one of them is filled or gone.
void MainWindow::connect_problems() {
  connect(&controller_, &FillController::left_open, this, [this](const QString& words) {
    left_open_ = words;
    banner_->show_problem(words);
    inspect_->log(words);
  });
  const auto drop = [this] {
    if (!left_open_.isEmpty() && banner_->text() == left_open_) banner_->hide();
    left_open_.clear();
  };
  connect(&undo_, &UndoHistory::changed, this, drop);
  connect(&document_, &Document::scans_changed, this, drop);
  connect(&controller_, &FillController::activity_changed, this, [this, drop] {
    if (controller_.busy()) drop();
  });
}

/// Over whatever window asked for the repair.
void MainWindow::ask_about(const RepairQuestion& question) {
  QWidget* over = QApplication::activeWindow();
  auto* dialog = new QMessageBox(over ? over : this);
  dialog->setObjectName(QStringLiteral("repairQuestion"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setIcon(QMessageBox::Question);
  dialog->setWindowTitle(tr("Loopmend"));
  QStringList costs;
  if (question.patches > 0)
    costs << tr("%Ln patch(es) of this scan would go: the holes are open again, or other holes.", nullptr,
                question.patches);
  if (question.loops > question.loops_before)
    costs
        << tr("The scan would have %L1 boundary loops in place of %L2.").arg(question.loops).arg(question.loops_before);
  dialog->setText(costs.join(QLatin1Char('\n')));
  dialog->setInformativeText(tr("What it does: %1").arg(question.done));
  QPushButton* apply = dialog->addButton(tr("&Apply"), QMessageBox::AcceptRole);
  apply->setObjectName(QStringLiteral("repairApply"));
  QPushButton* keep = dialog->addButton(tr("&Leave it as it is"), QMessageBox::RejectRole);
  keep->setObjectName(QStringLiteral("repairKeep"));
  dialog->setDefaultButton(keep);
  dialog->setEscapeButton(keep);
  connect(apply, &QPushButton::clicked, this, [act = question.apply] { act(); });
  dialog->setWindowModality(Qt::ApplicationModal);
  dialog->show();
}

/// Esc: the first of these that there is.
void MainWindow::step_back() {
  if (controller_.busy()) {
    controller_.cancel();
  } else if (patch_->decision_box().player().is_playing()) {
    patch_->decision_box().player().pause();
  } else if (candidates_.busy()) {
    candidates_.cancel();
  } else if (tools_->trial().busy()) {
    tools_->step_back();
  } else if (banner_->isVisible()) {
    banner_->hide();
  } else if (!tools_->step_back()) {
    view_->drop_probe();
    selection_.select({});
  }
}

void MainWindow::update_actions() {
  const WindowActions& a = *actions_;
  const bool idle = !controller_.busy(), scan = document_.has_scan();
  a["undo"]->setEnabled(idle && undo_.can_undo());
  a["redo"]->setEnabled(idle && undo_.can_redo());
  a["undo"]->setText(undo_.can_undo() ? tr("&Undo: %1").arg(undo_.undo_text()) : tr("&Undo"));
  a["redo"]->setText(undo_.can_redo() ? tr("&Redo: %1").arg(undo_.redo_text()) : tr("&Redo"));
  for (QAction* action : a.all("export saveSession saveSessionAs")) action->setEnabled(idle && scan);
  for (QAction* action :
       a.all("add compare toolRegionAction toolPointsAction toolBlendAction toolBridgeAction "
             "toolFillPartAction toolEdgesAction toolMirrorAction toolCutAction toolMeasureAction clip screenshot "
             "frame orthographic hidePiece isolatePiece probe wireframe seams tint selectAll nextHole "
             "previousHole curvature gaussian plain zebra isophotes"))
    action->setEnabled(scan);
  a["film"]->setEnabled(idle && has_film(document_, chosen_patches(document_, selection_)));
  a["report"]->setEnabled(idle && !document_.patches().empty());
  a["scanColors"]->setEnabled(has_scan_colors_);
  const std::vector<OpenPatch>& patches = document_.patches();
  a["deviation"]->setEnabled(std::any_of(
      patches.begin(), patches.end(), [](const OpenPatch& patch) { return !patch.state->shape->deviation.empty(); }));
  a["showPieces"]->setEnabled(visibility_.hidden_count() > 0);
  for (const auto& [name, side] : sides) a[name]->setEnabled(scan);
  const auto follow = [this](const char* action, const char* button) {
    (*actions_)[action]->setEnabled(patch_->findChild<QWidget*>(QLatin1String(button))->isEnabledTo(patch_));
  };
  follow("fillAction", "fillAndSmooth");
  follow("initialAction", "fill");
  follow("trimAction", "trim");
  follow("trimCrossingAction", "trim");
  follow("stitchAction", "stitch");
  const int cracks = cracks_left(document_);
  a["stitchAction"]->setText(cracks > 0 ? tr("Stitc&h %Ln crack(s)", nullptr, cracks) : tr("Stitc&h cracks"));
  follow("repairAction", "repair");
  follow("prepareAction", "prepare");
  update_close_as();
  follow("turnAroundAction", "repair");
  const auto touches = [this](int loop) { return document_.present(loop) && touches_itself(document_.loop(loop)); };
  a["eraseRingAction"]->setEnabled(idle && !loops_to_fill(document_, selection_).empty() &&
                                   !selection_.selected().empty());
  a["partAction"]->setEnabled(idle && std::any_of(selection_.selected().begin(), selection_.selected().end(), touches));
  follow("stepAction", "step");
  follow("runAction", "run");
  follow("playAction", "play");
  follow("nextStateAction", "nextState");
  follow("acceptAction", "accept");
  follow("rejectAction", "reject");
  follow("copyAction", "copyCommand");
  follow("candidatesAction", "otherPatches");
  const Look& look = look_->look();
  for (const auto& [name, shading] : shadings)
    if (shading == look.shading) a[name]->setChecked(true);
  for (const auto& [name, up] : up_axes)
    if (up == look.up) a[name]->setChecked(true);
  a["wireframe"]->setChecked(look.edges == Edges::shown);
  a["seams"]->setChecked(look.seams == Seams::shown);
  a["tint"]->setChecked(look.tint == Tint::patches);
  a["tint"]->setEnabled(scan && !colors_patches_alone(look.shading));
  holes_->small_holes().set_use(idle ? SmallHolesBox::Use::possible : SmallHolesBox::Use::busy);
}

void MainWindow::apply(const Preferences& preferences) {
  undo_.set_budget(static_cast<std::size_t>(preferences.undo_megabytes) << 20);
  controller_.set_timeline_budget(static_cast<std::size_t>(preferences.timeline_megabytes) << 20);
  autosave_.set_delay(preferences.autosave_seconds);
  apply_theme(preferences.theme);
  const ColorMap map = color_map_named(preferences.color_map.toStdString());
  if (map != look_->look().map) look_->set_color_map(map);
}

void MainWindow::ask_preferences() {
  auto* dialog = show_beside<PreferencesDialog>(this, load_preferences());
  connect(dialog, &PreferencesDialog::chosen, this, [this](const Preferences& preferences) {
    save_preferences(preferences);
    apply(preferences);
  });
}

void MainWindow::show_repair_dialog() {
  if (auto* open = findChild<RepairDialog*>()) return open->raise();
  auto* dialog = show_beside<RepairDialog>(this, document_, controller_);
  dialog->move(mapToGlobal(QPoint(width() - dialog->width() - 8, 96)));  // what it shows in the view is seen
  connect(dialog, &RepairDialog::marked, view_, &MeshView::show_marked);
  connect(dialog, &RepairDialog::place_wanted, view_,
          [this](const DefectPlace& place) { view_->fly_to_place(place.center, place.radius, place.direction); });
}

void MainWindow::show_batch_dialog() {
  if (auto* open = findChild<BatchDialog*>()) return open->raise();
  const auto* dialog = show_beside<BatchDialog>(this, batch_);
  connect(dialog, &BatchDialog::scan_wanted, this, [this](const QString& path) { open(path); });
}

void MainWindow::show_candidates() {
  auto* dock = findChild<QDockWidget*>(QStringLiteral("candidatesDock"));
  dock->show();
  dock->raise();
  others_->compute();
}

void MainWindow::show_picture_dialog() {
  auto* dialog = show_beside<PictureDialog>(this, *view_);
  connect(dialog, &PictureDialog::saved, this, [this](const QString& path) {
    const QString words = tr("Wrote %1.").arg(path);
    inspect_->log(words);
    banner_->show_notice(words);
  });
}

void MainWindow::show_film_dialog() {
  auto* dialog = show_beside<FilmDialog>(this, film_of(*view_, document_, chosen_patches(document_, selection_)));
  connect(dialog, &FilmDialog::saved, this, &MainWindow::show_written);
}

void MainWindow::show_written(const QString& path) {
  const QString text = tr("Wrote %1.").arg(path);
  inspect_->log(text);
  banner_->show_notice(text);
}

}  // namespace loopmend
