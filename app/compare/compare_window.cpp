// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/compare_window.h"

#include "compare/compare_numbers.h"
#include "compare/flow_canvas.h"
#include "compare/flow_view.h"
#include "compare/legend_strip.h"
#include "compare/patch_facing.h"
#include "compare/picture_clock.h"
#include "core/error.h"
#include "document/labels.h"
#include "document/message_words.h"
#include "jobs/remaining_time.h"
#include "panels/banner.h"
#include "panels/choices.h"
#include "panels/parts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QSplitter>
#include <QStackedWidget>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

constexpr int most_views = 4;
constexpr int ticks_per_decade = 10;

QFrame* divider() {
  auto* line = new QFrame;
  line->setFrameShape(QFrame::VLine);
  line->setFrameShadow(QFrame::Sunken);
  return line;
}

/// The scan's own colours show nothing of flows, and the states of a flow have no estimate of their error.
Look comparable(Look look) {
  if (look.shading == Shading::scan || look.shading == Shading::deviation) look.shading = Shading::curvature;
  return look;
}

/// They stay where they are, whatever the flows do.
std::vector<LoopLine> seams_of(const ComparedRun& start) {
  std::vector<LoopLine> lines;
  for (const std::vector<int>& loop : start.patch.loops) {
    LoopLine line{{}, LoopStyle::filled};
    for (const int v : loop) {
      const auto first = start.shape->points.begin() + 3 * v;
      line.points.insert(line.points.end(), first, first + 3);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

CompareWindow::CompareWindow(ComparisonController& flow_comparison, CompareTask task, const Look& look, QWidget* parent)
    : QWidget(parent, Qt::Window),
      flow_comparison_(flow_comparison),
      task_(std::move(task)),
      look_(comparable(look)),
      clock_(new PictureClock(this)) {
  setObjectName(QStringLiteral("compareWindow"));
  setWindowTitle(tr("Compare flows: %1").arg(flow_comparison_.title()));
  resize(QSize(1280, 840).boundedTo(largest_window()));
  numbers_ = new CompareNumbers(flow_comparison_, task_.unit, task_.filled);
  auto* left = new QWidget;
  auto* views = make_layout<QVBoxLayout>(left);
  views->setSpacing(6);
  views->addWidget(build_views(), 1);
  views->addWidget(&numbers_->table());
  auto* splitter = new QSplitter(Qt::Horizontal);
  splitter->addWidget(left);
  splitter->addWidget(numbers_);
  splitter->setStretchFactor(0, 2);
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({840, 420});
  splitter->setChildrenCollapsible(false);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(6);
  column->addWidget(build_run_bar());
  column->addWidget(build_look_bar());
  column->addWidget(build_wipe_bar());
  column->addWidget(splitter, 1);
  banner_ = new Banner(this);
  wire();
  arrange();
  apply_look();
  update_all();
}

QWidget* CompareWindow::build_run_bar() {
  run_ = make_button("compareRun", tr("&Run all"), tr("All flows from the same start, side by side (Space)"));
  stop_ = make_button("compareStop", tr("&Stop"), tr("Stop at once; what was reached stays (Esc)"));
  count_ = new QComboBox;
  explain(count_, "compareCount", tr("Number of views"), tr("How many flows are compared"));
  for (int n = 2; n <= most_views; ++n) count_->addItem(tr("%1 views").arg(n), n);
  count_->setCurrentIndex(flow_comparison_.flow_runs() - 2);
  mode_ = new QComboBox;
  mode_->addItem(tr("To the steady state"), static_cast<int>(EvolutionMode::steady));
  mode_->addItem(tr("Step by step"), static_cast<int>(EvolutionMode::steps));
  explain(mode_, "compareMode", tr("How"),
          tr("Straight to where each flow converges, or in time steps, as in the paper"));
  sigma_ = new QSlider(Qt::Horizontal);
  sigma_->setRange(-2 * ticks_per_decade, 5 * ticks_per_decade);
  sigma_->setValue(ticks_per_decade);
  sigma_->setFixedWidth(120);
  explain(sigma_, "compareSigma", tr("Time step"), tr("Time step \u03c3, without a unit; the same for all flows"));
  sigma_value_ = new QLabel;
  sigma_value_->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("\u03c3 = 0.0100")));
  wait_ = make_note("compareWait");
  wait_->setWordWrap(false);
  auto* bar = new QWidget;
  auto* row = make_layout<QHBoxLayout>(bar);
  row->setSpacing(8);
  for (QWidget* part : std::initializer_list<QWidget*>{run_, stop_, divider(), count_, mode_, sigma_, sigma_value_})
    row->addWidget(part);
  row->addWidget(wait_, 1);
  return bar;
}

QWidget* CompareWindow::build_look_bar() {
  shading_ = make_shading_choice("compareShading", tr("How all views are shown (keys 1 to 6)"));
  shading_->addItem(tr("Distance"), static_cast<int>(Shading::difference));
  shading_->setCurrentIndex(static_cast<int>(look_.shading));
  build_from();
  edges_ = make_option<QCheckBox>("compareEdges", tr("&Wireframe"), tr("Draw the triangles' edges"));
  edges_->setChecked(look_.edges == Edges::shown);
  seams_ = make_option<QCheckBox>("compareSeams", tr("Seam lines"), tr("Draw the boundary between patch and scan"));
  seams_->setChecked(look_.seams == Seams::shown);
  own_range_ = new QCheckBox(tr("C&olours \u00b1"));
  explain(own_range_, "compareOwnRange", tr("Own range of colours"),
          tr("A colour range of your own, instead of that of the neighborhood"));
  half_width_ = new QDoubleSpinBox;
  half_width_->setRange(1e-6, 1e9);
  half_width_->setDecimals(4);
  half_width_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  half_width_->setKeyboardTracking(false);
  explain(half_width_, "compareRange", tr("Range"), tr("The value at the ends of the colours"));
  linked_ = make_option<QCheckBox>("compareLinked", tr("&Link views"), tr("Turning one view turns all"));
  linked_->setChecked(true);
  auto* framing = make_button("compareFrame", tr("&Frame"), tr("See the whole patch in every view (F)"));
  connect(framing, &QPushButton::clicked, this, &CompareWindow::frame);
  auto* bar = new QWidget;
  auto* row = make_layout<QHBoxLayout>(bar);
  row->setSpacing(8);
  for (QWidget* part : std::initializer_list<QWidget*>{shading_, from_, edges_, seams_, own_range_, half_width_,
                                                       divider(), linked_, framing})
    row->addWidget(part);
  row->addStretch(1);
  return bar;
}

QWidget* CompareWindow::build_wipe_bar() {
  wiping_ = new QCheckBox(tr("Wip&e between"));
  explain(wiping_, "compareWipe", tr("Wipe"),
          tr("One large picture of two flows, with a line between them that can be drawn"));
  for (QComboBox** box : {&left_, &right_}) *box = new QComboBox;
  explain(left_, "compareWipeLeft", tr("Left of the line"), tr("Which flow, or the start, is left of the line"));
  explain(right_, "compareWipeRight", tr("Right of the line"), tr("Which flow, or the start, is right of the line"));
  save_picture_ =
      make_button("comparePicture", tr("Save &picture\u2026"), tr("All views as one PNG of a size you choose"));
  save_numbers_ = make_button("compareNumbers", tr("Save &numbers\u2026"),
                              tr("Table, energies and profiles as CSV, as loopmend compare writes them"));
  copy_ = make_button("compareCopy", tr("Copy co&mmand line"), tr("Copy the commands that do the same"));
  auto* bar = new QWidget;
  auto* row = make_layout<QHBoxLayout>(bar);
  row->setSpacing(8);
  for (QWidget* part : std::initializer_list<QWidget*>{wiping_, left_, right_}) row->addWidget(part);
  row->addStretch(1);
  for (QWidget* part : std::initializer_list<QWidget*>{copy_, save_picture_, save_numbers_}) row->addWidget(part);
  return bar;
}

QWidget* CompareWindow::build_views() {
  auto* grid = new QWidget;
  grid_ = new QGridLayout(grid);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setSpacing(6);
  for (int number = 0; number < most_views; ++number) flow_views_.push_back(new FlowView(number, *clock_));
  wipe_ = new FlowCanvas("compareWipeView", FlowCanvas::Sides::two, *clock_);
  pages_ = new QStackedWidget;
  pages_->addWidget(grid);
  pages_->addWidget(wipe_);
  legend_ = new LegendStrip;
  auto* views = new QWidget;
  auto* row = make_layout<QHBoxLayout>(views);
  row->setSpacing(2);
  row->addWidget(pages_, 1);
  row->addWidget(legend_);
  return views;
}

void CompareWindow::wire() {
  connect(run_, &QPushButton::clicked, this, &CompareWindow::run);
  connect(stop_, &QPushButton::clicked, &flow_comparison_, &ComparisonController::stop);
  connect(save_picture_, &QPushButton::clicked, this, &CompareWindow::ask_picture);
  connect(save_numbers_, &QPushButton::clicked, this, &CompareWindow::ask_numbers);
  connect(copy_, &QPushButton::clicked, this, &CompareWindow::copy_command);
  connect(count_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this] { set_view_count(count_->currentData().toInt()); });
  connect(mode_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &CompareWindow::update_use);
  connect(sigma_, &QSlider::valueChanged, this, &CompareWindow::update_use);
  connect(shading_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &CompareWindow::apply_look);
  connect(from_, QOverload<int>::of(&QComboBox::activated), this, &CompareWindow::choose_from);
  for (QCheckBox* box : {edges_, seams_}) connect(box, &QCheckBox::toggled, this, &CompareWindow::apply_look);
  connect(own_range_, &QCheckBox::toggled, this, &CompareWindow::update_range);
  connect(half_width_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this] {
    if (own_range_->isChecked()) update_range();
  });
  connect(linked_, &QCheckBox::toggled, this, [this](bool on) {
    if (on) follow(flow_views_.front()->canvas());
  });
  connect(wiping_, &QCheckBox::toggled, this, [this](bool on) {
    if (on) wipe_->set_pose(flow_views_.front()->canvas().pose());
    pages_->setCurrentIndex(on ? 1 : 0);
    update_wipe();
    update_use();
  });
  for (QComboBox* box : {left_, right_})
    connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &CompareWindow::update_wipe);
  for (int flow_run = 0; flow_run < most_views; ++flow_run) {
    FlowView* flow_view = flow_views_[flow_run];
    connect(flow_view, &FlowView::flow_chosen, this, [this, flow_run](FlowKind flow) { choose_flow(flow_run, flow); });
    connect(flow_view, &FlowView::accept_wanted, this, [this, flow_run] { accept(flow_run); });
  }
  for (FlowCanvas* canvas : canvases())
    connect(canvas, &FlowCanvas::turned, this, [this, canvas] {
      if (linked_->isChecked()) follow(*canvas);
    });
  connect(&flow_comparison_, &ComparisonController::stage_changed, this, &CompareWindow::update_all);
  connect(&flow_comparison_, &ComparisonController::flow_run_moved, this, &CompareWindow::update_flow_run);
  connect(&flow_comparison_, &ComparisonController::measured, this, &CompareWindow::update_all);
  connect(&flow_comparison_, &ComparisonController::failed, banner_, &Banner::show_problem);
}

std::vector<FlowCanvas*> CompareWindow::canvases() const {
  std::vector<FlowCanvas*> all;
  for (FlowView* flow_view : flow_views_) all.push_back(&flow_view->canvas());
  all.push_back(wipe_);
  return all;
}

void CompareWindow::follow(FlowCanvas& leader) {
  const CameraPose pose = leader.pose();
  for (FlowCanvas* canvas : canvases())
    if (canvas != &leader) canvas->set_pose(pose);
}

EvolutionOptions CompareWindow::options() const {
  EvolutionOptions options;
  options.mode = static_cast<EvolutionMode>(mode_->currentData().toInt());
  options.sigma = std::pow(10.0, static_cast<double>(sigma_->value()) / ticks_per_decade);
  return options;
}

void CompareWindow::run() {
  if (flow_comparison_.stage() != ComparisonController::Stage::ready) return;
  banner_->hide();  // its message is on the last run
  running_.start();
  flow_comparison_.run(options());
  for (FlowCanvas* canvas : canvases()) canvas->expect_news();
}

void CompareWindow::run_when_ready() {
  run_soon_ = flow_comparison_.stage() == ComparisonController::Stage::preparing;
  if (!run_soon_) run();
}

void CompareWindow::set_view_count(int count) {
  std::vector<FlowKind> flows;
  for (int flow_run = 0; flow_run < flow_comparison_.flow_runs(); ++flow_run)
    flows.push_back(flow_comparison_.flow(flow_run));
  // The fairest flows first in, the fairest last out.
  if (static_cast<int>(flows.size()) > count) flows.erase(flows.begin(), flows.end() - count);
  for (FlowKind flow : {FlowKind::mmcvf, FlowKind::wf, FlowKind::sdf, FlowKind::mcf})
    if (static_cast<int>(flows.size()) < count && std::find(flows.begin(), flows.end(), flow) == flows.end())
      flows.insert(flows.begin(), flow);
  flow_comparison_.set_flows(flows);
  arrange();
}

/// A flow that another view has already changes places with it.
void CompareWindow::choose_flow(int flow_run, FlowKind flow) {
  std::vector<FlowKind> flows;
  for (int k = 0; k < flow_comparison_.flow_runs(); ++k) flows.push_back(flow_comparison_.flow(k));
  const auto other = std::find(flows.begin(), flows.end(), flow);
  if (other != flows.end()) *other = flows[flow_run];
  flows[flow_run] = flow;
  flow_comparison_.set_flows(flows);
}

void CompareWindow::arrange() {
  const int columns = flow_comparison_.flow_runs() == 4 ? 2 : flow_comparison_.flow_runs();
  for (int flow_run = 0; flow_run < most_views; ++flow_run) {
    FlowView* flow_view = flow_views_[flow_run];
    grid_->removeWidget(flow_view);
    if (flow_run < flow_comparison_.flow_runs()) grid_->addWidget(flow_view, flow_run / columns, flow_run % columns);
    flow_view->setVisible(flow_run < flow_comparison_.flow_runs());
  }
}

void CompareWindow::update_all() {
  const bool there = flow_comparison_.start() != nullptr;
  {
    const QSignalBlocker quiet_left(left_), quiet_right(right_);
    const int old_left = std::max(0, left_->currentIndex()), old_right = right_->currentIndex();
    for (QComboBox* box : {left_, right_}) {
      box->clear();
      box->addItem(tr("Start"));
      for (int flow_run = 0; flow_run < flow_comparison_.flow_runs(); ++flow_run)
        box->addItem(labels::flow_name(flow_comparison_.flow(flow_run)));
      if (task_.filled) box->addItem(tr("As filled"));
    }
    left_->setCurrentIndex(std::min(old_left, left_->count() - 1));
    right_->setCurrentIndex(old_right < 0 ? flow_comparison_.flow_runs() : std::min(old_right, right_->count() - 1));
  }
  if (there) {
    const std::vector<LoopLine> seams = seams_of(*flow_comparison_.start());
    for (FlowCanvas* canvas : canvases()) {
      canvas->set_neighborhood(flow_comparison_.neighborhood());
      canvas->set_seams(seams);
    }
    for (int flow_run = 0; flow_run < flow_comparison_.flow_runs(); ++flow_run) {
      flow_views_[flow_run]->show_flow(flow_comparison_.flow(flow_run));
      flow_views_[flow_run]->show_flow_run(*flow_comparison_.flow_run(flow_run), task_.accept_help);
    }
    if (flow_comparison_.stage() != ComparisonController::Stage::running) update_range();
    if (isVisible() && !std::exchange(faced_, true)) face_patch();
  }
  numbers_->update_all();
  update_wipe();
  update_use();
  if (flow_comparison_.stage() == ComparisonController::Stage::ready && std::exchange(run_soon_, false)) run();
}

void CompareWindow::update_flow_run(int flow_run) {
  flow_views_[flow_run]->show_flow_run(*flow_comparison_.flow_run(flow_run), task_.accept_help);
  numbers_->update_flow_run(flow_run);
  update_wait();
  if (wiping_->isChecked()) update_wipe();
}

void CompareWindow::update_use() {
  const ComparisonController::Stage stage = flow_comparison_.stage();
  const bool ready = stage == ComparisonController::Stage::ready;
  run_->setEnabled(ready);
  if (ready && !std::exchange(was_ready_, true)) run_->setFocus();  // Qt takes it off a disabled button
  stop_->setEnabled(stage == ComparisonController::Stage::running);
  for (QWidget* part : std::initializer_list<QWidget*>{count_, mode_, save_numbers_}) part->setEnabled(ready);
  save_picture_->setEnabled(flow_comparison_.start() != nullptr);
  const bool steps = mode_->currentData().toInt() == static_cast<int>(EvolutionMode::steps);
  sigma_->setVisible(steps);
  sigma_value_->setVisible(steps);
  sigma_->setEnabled(ready);
  sigma_value_->setText(tr("\u03c3 = %1").arg(labels::number(options().sigma)));
  for (QComboBox* box : {left_, right_}) box->setEnabled(wiping_->isChecked());
  half_width_->setEnabled(own_range_->isChecked());
  for (FlowView* flow_view : flow_views_) flow_view->set_use(ready ? FlowView::Use::open : FlowView::Use::running);
  update_wait();
}

/// What runs, and how long the slowest flow still takes on its course to the steady state.
void CompareWindow::update_wait() {
  const ComparisonController::Stage stage = flow_comparison_.stage();
  QString words;
  if (stage == ComparisonController::Stage::preparing) words = tr("Making the start\u2026");
  if (stage == ComparisonController::Stage::ready && flow_comparison_.start())
    words =
        tr("%1 free vertices").arg(labels::count(static_cast<std::size_t>(flow_comparison_.start()->patch.free_count)));
  if (stage == ComparisonController::Stage::running) {
    words = tr("Running\u2026");
    const double seconds = 1e-3 * static_cast<double>(running_.elapsed());
    double left = 0;
    for (int k = 0; k < flow_comparison_.flow_runs(); ++k) {
      const ComparedRun& run = *flow_comparison_.flow_run(k);
      // MCF takes up to the limit of steps, the others as many as a fill.
      const bool is_alike = flow_comparison_.flow(k) != FlowKind::mcf && run.stage == ComparedRun::Stage::moving;
      if (is_alike && run.steps > 0) left = std::max(left, steps_left(run.steps) * seconds / run.steps);
    }
    const bool is_known = options().mode == EvolutionMode::steady && seconds > least_seconds_shown;
    if (is_known && left >= 1) words += QLatin1Char(' ') + labels::time_left(left);
  }
  wait_->setText(words);
}

/// From the neighborhood's curvature, as in the main window; where none is known, from the last view.
void CompareWindow::update_range() {
  half_width_->setEnabled(own_range_->isChecked());
  if (own_range_->isChecked()) {
    range_ = half_width_->value();
  } else if (look_.shading == Shading::difference && flow_comparison_.start()) {
    if (const double widest = range_of_distances(); widest > 0) range_ = widest;
    const QSignalBlocker quiet(half_width_);
    half_width_->setValue(range_);
  } else if (flow_comparison_.start()) {
    const bool mean = look_.shading != Shading::gaussian;
    const auto& neighborhood = flow_comparison_.neighborhood();
    const SurfaceShape& shape = neighborhood && !neighborhood->H.empty()
                                    ? *neighborhood
                                    : *flow_comparison_.flow_run(flow_comparison_.flow_runs() - 1)->shape;
    const std::vector<float>& values = mean ? shape.H : shape.K;
    if (!values.empty()) range_ = symmetric_range(values, mean ? look_.H.percent : look_.K.percent);
    const QSignalBlocker quiet(half_width_);
    half_width_->setValue(range_);
  }
  for (FlowCanvas* canvas : canvases()) canvas->set_look(look_, range_);
  legend_->show_range(look_, range_);
}

void CompareWindow::apply_look() {
  look_.shading = static_cast<Shading>(shading_->currentData().toInt());
  look_.edges = edges_->isChecked() ? Edges::shown : Edges::hidden;
  look_.seams = seams_->isChecked() ? Seams::shown : Seams::hidden;
  if (sender() == shading_) own_range_->setChecked(false);  // H and K do not share their numbers
  measure();
  update_range();
}

void CompareWindow::face_patch() {
  const PatchFacing facing = facing_of(*flow_comparison_.start()->shape);
  Eigen::Vector3d eye = facing.outward;
  if (eye.isZero()) eye = Eigen::Vector3d(0.55, -0.75, 0.45).normalized();
  // A little from the side, so that shapes read.
  const Eigen::Vector3d side = eye.unitOrthogonal();
  eye = (eye + 0.28 * side + 0.28 * eye.cross(side)).normalized();
  for (FlowCanvas* canvas : canvases()) canvas->look_at(facing.middle, 1.25 * facing.radius, eye);
}

void CompareWindow::frame() {
  if (!flow_comparison_.start()) return;
  const PatchFacing facing = facing_of(*flow_comparison_.start()->shape);
  for (FlowCanvas* canvas : canvases()) canvas->look_at(facing.middle, 1.25 * facing.radius, Eigen::Vector3d::Zero());
}

void CompareWindow::update_wipe() {
  if (!flow_comparison_.start() || !wiping_->isChecked()) return;
  int side = 0;
  for (const QComboBox* box : {left_, right_}) {
    const int at = box->currentIndex() - 1;
    const bool is_run = at >= 0 && at < flow_comparison_.flow_runs();
    const ComparedRunPtr& other = at > 0 && task_.filled ? task_.filled : flow_comparison_.start();
    const ComparedRunPtr& shown = is_run ? flow_comparison_.flow_run(at) : other;
    wipe_->show_patch(side++, shown->shape, arrival_of(*shown));
  }
}

void CompareWindow::accept(int flow_run) {
  if (!task_.accept) return;
  try {
    banner_->show_notice(task_.accept(*flow_comparison_.start(), *flow_comparison_.flow_run(flow_run)));
  } catch (const std::exception& error) {
    banner_->show_problem(labels::in_words(message_of(error)));
  }
}

void CompareWindow::closeEvent(QCloseEvent* event) {
  keep_place();
  QWidget::closeEvent(event);
}

void CompareWindow::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Escape:
      flow_comparison_.stage() == ComparisonController::Stage::running ? flow_comparison_.stop() : banner_->hide();
      break;
    case Qt::Key_Space: run(); break;
    case Qt::Key_F: frame(); break;
    case Qt::Key_1:
    case Qt::Key_2:
    case Qt::Key_3:
    case Qt::Key_4:
    case Qt::Key_5:
    case Qt::Key_6: shading_->setCurrentIndex(event->key() - Qt::Key_1); break;
    default: QWidget::keyPressEvent(event);
  }
}

void CompareWindow::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (flow_comparison_.start() && !std::exchange(faced_, true)) face_patch();
}

}  // namespace loopmend
