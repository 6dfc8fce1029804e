#include "panels/patch_panel.h"

#include "document/hole_selection.h"
#include "document/words.h"
#include "panels/quiet_label.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>

#include <cmath>

namespace loopmend {
namespace {

// The slider runs over powers of ten, a tenth of a decade per tick.
constexpr int ticks_per_decade = 10;
constexpr int sigma_low = -2 * ticks_per_decade;
constexpr int sigma_high = 5 * ticks_per_decade;
constexpr int sigma_start = 1 * ticks_per_decade;

QLabel* quiet_label(const char* name) {
  auto* label = new QuietLabel;
  label->setObjectName(QLatin1String(name));
  return label;
}

QString first_upper(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace

PatchPanel::PatchPanel(const Document& document, const HoleSelection& selection, Workbench& workbench, QWidget* parent)
    : QWidget(parent),
      document_(document),
      selection_(selection),
      workbench_(workbench) {
  setObjectName(QStringLiteral("patchPanel"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 6, 8, 8);
  layout->setSpacing(10);
  layout->addWidget(build_fill());
  layout->addWidget(build_flow());
  layout->addWidget(build_progress());
  layout->addStretch(1);
  connect_parts();
  update_state();
}

QWidget* PatchPanel::build_fill() {
  auto* box = new QGroupBox(tr("1  Fill"));
  auto* grid = new QGridLayout(box);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(8);
  fill_target_ = quiet_label("fillTarget");
  density_ = new QDoubleSpinBox;
  density_->setObjectName(QStringLiteral("density"));
  density_->setRange(0.25, 4);
  density_->setSingleStep(0.25);
  density_->setDecimals(2);
  density_->setValue(1);
  density_->setPrefix(QStringLiteral("\u00d7 "));
  density_->setToolTip(tr("Density of the patch relative to the scan around it; 2 halves the edge length"));
  auto* density_label = new QLabel(tr("&Density"));
  density_label->setBuddy(density_);
  fill_ = new QPushButton(tr("Fill"));
  fill_->setObjectName(QStringLiteral("fill"));
  fill_->setToolTip(tr("Close the selected holes, or all holes when none is selected, with a first patch"));
  grid->addWidget(fill_target_, 0, 0, 1, 2);
  grid->addWidget(density_label, 1, 0);
  grid->addWidget(density_, 1, 1);
  grid->addWidget(fill_, 2, 0, 1, 2);
  grid->setColumnStretch(1, 1);
  return box;
}

QWidget* PatchPanel::build_flow() {
  auto* box = new QGroupBox(tr("2  Smooth by a flow"));
  auto* grid = new QGridLayout(box);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(8);
  flow_target_ = quiet_label("flowTarget");
  flow_ = new QComboBox;
  flow_->setObjectName(QStringLiteral("flow"));
  flow_->setToolTip(tr("Which geometric flow moves the patch"));
  for (FlowKind kind : {FlowKind::mmcvf, FlowKind::wf, FlowKind::sdf, FlowKind::mcf}) {
    flow_->addItem(words::flow(kind), static_cast<int>(kind));
    flow_->setItemData(flow_->count() - 1, words::flow_help(kind), Qt::ToolTipRole);
  }
  flow_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  flow_->setMinimumContentsLength(18);
  flow_help_ = quiet_label("flowHelp");
  steady_ = new QPushButton(tr("To steady state"));
  steady_->setObjectName(QStringLiteral("steady"));
  steady_->setToolTip(tr("Go straight to where the flow comes to rest (T)"));
  sigma_ = new QSlider(Qt::Horizontal);
  sigma_->setObjectName(QStringLiteral("sigma"));
  sigma_->setRange(sigma_low, sigma_high);
  sigma_->setValue(sigma_start);
  sigma_->setPageStep(ticks_per_decade);
  sigma_->setToolTip(tr("Time step \u03c3, without a unit: 1 is one decay time of the slowest wave on this patch"));
  sigma_value_ = new QLabel;
  sigma_value_->setObjectName(QStringLiteral("sigmaValue"));
  sigma_value_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  sigma_value_->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("\u03c3 = 100000")));
  auto* sigma_label = new QLabel(tr("&Time step"));
  sigma_label->setBuddy(sigma_);
  step_ = new QPushButton(tr("Step"));
  step_->setObjectName(QStringLiteral("step"));
  step_->setToolTip(tr("Take one time step (S)"));
  run_ = new QPushButton(tr("Run"));
  run_->setObjectName(QStringLiteral("run"));
  run_->setToolTip(tr("Take one time step after another until the patch is at rest (Space)"));
  grid->addWidget(flow_target_, 0, 0, 1, 2);
  grid->addWidget(flow_, 1, 0, 1, 2);
  grid->addWidget(flow_help_, 2, 0, 1, 2);
  grid->addWidget(steady_, 3, 0, 1, 2);
  grid->addWidget(sigma_label, 4, 0);
  grid->addWidget(sigma_value_, 4, 1);
  grid->addWidget(sigma_, 5, 0, 1, 2);
  grid->addWidget(step_, 6, 0);
  grid->addWidget(run_, 6, 1);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  return box;
}

QWidget* PatchPanel::build_progress() {
  auto* box = new QWidget;
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(2, 0, 2, 0);
  layout->setSpacing(6);
  stage_ = quiet_label("stage");
  stage_->setText(tr("Nothing is running."));
  bar_ = new QProgressBar;
  bar_->setObjectName(QStringLiteral("progress"));
  bar_->setTextVisible(false);
  bar_->setMaximumHeight(8);
  cancel_ = new QPushButton(tr("Cancel"));
  cancel_->setObjectName(QStringLiteral("cancel"));
  cancel_->setToolTip(tr("Stop at once; what was accepted so far is kept (Esc)"));
  figures_ = quiet_label("figures");
  QSizePolicy keep = bar_->sizePolicy();
  keep.setRetainSizeWhenHidden(true);
  bar_->setSizePolicy(keep);
  layout->addWidget(stage_);
  layout->addWidget(bar_);
  layout->addWidget(cancel_);
  layout->addWidget(figures_);
  return box;
}

void PatchPanel::connect_parts() {
  connect(fill_, &QPushButton::clicked, this, &PatchPanel::fill);
  connect(step_, &QPushButton::clicked, this, &PatchPanel::step);
  connect(run_, &QPushButton::clicked, this, &PatchPanel::run_or_pause);
  connect(steady_, &QPushButton::clicked, this, &PatchPanel::to_steady_state);
  connect(cancel_, &QPushButton::clicked, &workbench_, &Workbench::cancel);
  connect(flow_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &PatchPanel::update_state);
  connect(sigma_, &QSlider::valueChanged, this, &PatchPanel::update_state);
  connect(&workbench_, &Workbench::activity_changed, this, &PatchPanel::update_state);
  connect(&workbench_, &Workbench::stage_changed, this,
          [this](const QString& words) { stage_->setText(words.isEmpty() ? tr("Nothing is running.") : words); });
  connect(&workbench_, &Workbench::progress_changed, this, &PatchPanel::show_progress);
  connect(&selection_, &HoleSelection::selection_changed, this, &PatchPanel::update_state);
  connect(&document_, &Document::opened, this, &PatchPanel::update_state);
  connect(&document_, &Document::patches_changed, this, &PatchPanel::update_state);
  connect(&document_, &Document::holes_changed, this, &PatchPanel::update_state);
  connect(&document_, &Document::patch_moved, this, &PatchPanel::update_live_figures);
}

void PatchPanel::fill() {
  if (fill_->isEnabled()) workbench_.fill(loops_to_fill(), density_->value());
}

void PatchPanel::step() {
  if (step_->isEnabled()) evolve(Pace::one_step);
}

void PatchPanel::run_or_pause() {
  if (!run_->isEnabled()) return;
  if (workbench_.activity() == Activity::running || workbench_.activity() == Activity::solving) {
    workbench_.pause();
  } else {
    evolve(Pace::run);
  }
}

void PatchPanel::to_steady_state() {
  if (steady_->isEnabled()) evolve(Pace::steady);
}

void PatchPanel::evolve(Pace pace) { workbench_.evolve(patches_to_move(), flow(), sigma(), pace); }

FlowKind PatchPanel::flow() const { return static_cast<FlowKind>(flow_->currentData().toInt()); }

double PatchPanel::sigma() const { return std::pow(10.0, static_cast<double>(sigma_->value()) / ticks_per_decade); }

std::set<int> PatchPanel::loops_to_fill() const {
  std::set<int> loops;
  const bool chosen = !selection_.selected().empty();
  for (int loop = 0; loop < static_cast<int>(document_.loops().size()); ++loop) {
    const bool wanted = chosen ? selection_.selected().contains(loop) : document_.fillable(loop);
    const bool possible = document_.loops()[static_cast<std::size_t>(loop)].kind != LoopKind::cut;
    if (wanted && possible && !document_.patch_of(loop)) loops.insert(loop);
  }
  return loops;
}

std::set<int> PatchPanel::patches_to_move() const {
  std::set<int> ids;
  const std::set<int>& chosen = selection_.selected();
  for (const OpenPatch& patch : document_.patches()) {
    const bool wanted = chosen.empty() || std::any_of(patch.loops.begin(), patch.loops.end(),
                                                      [&](int loop) { return chosen.contains(loop); });
    if (wanted) ids.insert(patch.id);
  }
  return ids;
}

void PatchPanel::update_state() {
  const Activity now = workbench_.activity();
  const bool idle = now == Activity::idle;
  const bool can_pause = now == Activity::running || now == Activity::solving;
  const std::set<int> to_fill = loops_to_fill(), to_move = patches_to_move();
  const bool chosen = !selection_.selected().empty();

  bool left_out = false;
  for (int loop = 0; loop < static_cast<int>(document_.loops().size()) && !left_out; ++loop)
    left_out = document_.state(loop) == HoleState::left_out;
  if (!document_.has_scan()) {
    fill_target_->setText(tr("Open a scan first."));
  } else if (to_fill.empty()) {
    fill_target_->setText(chosen     ? tr("The selection is filled already.")
                          : left_out ? tr("No open hole is left. To fill a loop that is left out, select it.")
                                     : tr("No open hole is left."));
  } else {
    fill_target_->setText(chosen ? first_upper(words::holes(document_, to_fill)) + tr(", selected")
                                 : tr("All open holes (%1)").arg(to_fill.size()));
  }
  std::set<int> moving_loops;
  for (int id : to_move)
    if (const OpenPatch* patch = document_.patch(id)) moving_loops.insert(patch->loops.begin(), patch->loops.end());
  flow_target_->setText(to_move.empty()
                            ? (chosen ? tr("The selection is not filled yet.") : tr("Nothing is filled yet."))
                            : first_upper(words::holes(document_, moving_loops)));
  flow_help_->setText(words::flow_help(flow()));
  sigma_value_->setText(tr("\u03c3 = %1").arg(words::number(sigma())));

  fill_->setEnabled(idle && !to_fill.empty());
  density_->setEnabled(idle && document_.has_scan());
  flow_->setEnabled(idle);
  sigma_->setEnabled(idle);
  step_->setEnabled(idle && !to_move.empty());
  steady_->setEnabled(idle && !to_move.empty());
  run_->setEnabled(can_pause || (idle && !to_move.empty()));
  run_->setText(can_pause ? tr("Pause") : now == Activity::pausing ? tr("Pausing\u2026") : tr("Run"));
  cancel_->setEnabled(!idle);
  bar_->setVisible(!idle);
  fill_->setDefault(idle && !to_fill.empty() && to_move.empty());
  update_live_figures();
}

void PatchPanel::update_live_figures(int moved_id) {
  const OpenPatch* shown = document_.patch(moved_id);
  if (!shown)
    for (int id : patches_to_move())
      if (const OpenPatch* patch = document_.patch(id); patch->state->steps > 0) shown = patch;
  if (shown && shown->state->steps == 0) shown = nullptr;
  if (!shown) {
    figures_->clear();
    return;
  }
  const PatchState& state = *shown->state;
  figures_->setText(tr("%1, %2: step %3, energy %4 (from %5)")
                        .arg(first_upper(words::holes(document_, {shown->loops.begin(), shown->loops.end()})),
                             words::flow_name(state.flow))
                        .arg(state.steps)
                        .arg(words::number(state.last_step.energy), words::number(state.initial_energy)));
}

void PatchPanel::show_progress(int done, int total) {
  bar_->setRange(0, total);
  bar_->setValue(done);
}

}  // namespace loopmend
