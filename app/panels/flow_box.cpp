// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/flow_box.h"

#include "document/labels.h"
#include "document/targets.h"
#include "jobs/fill_controller.h"
#include "panels/choices.h"
#include "panels/decision_box.h"
#include "panels/parts.h"
#include "panels/player_bar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>

#include <cmath>

namespace loopmend {
namespace {

// The slider runs over powers of ten, a tenth of a decade per tick.
constexpr int ticks_per_decade = 10;
constexpr int sigma_low = -2 * ticks_per_decade;
constexpr int sigma_high = 5 * ticks_per_decade;
constexpr int sigma_start = 1 * ticks_per_decade;

}  // namespace

FlowBox::FlowBox(const Document& document, const HoleSelection& selection, FillController& controller, QWidget* parent)
    : QGroupBox(tr("3  Flow"), parent),
      document_(document),
      selection_(selection),
      controller_(controller) {
  build();
  connect(step_, &QPushButton::clicked, this, &FlowBox::step);
  connect(steps_, &QPushButton::clicked, this, [this] { evolve(Pace::time_steps); });
  connect(run_, &QPushButton::clicked, this, &FlowBox::run_or_pause);
  connect(compare_, &QPushButton::clicked, this, &FlowBox::compare_wanted);
  connect(flow_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &FlowBox::update_state);
  connect(sigma_, &QSlider::valueChanged, this, &FlowBox::update_state);
}

void FlowBox::build() {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(box_margins);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(4);
  target_ = make_note("flowTarget");
  target_->keep_room_for({QStringLiteral("1")});  // nothing moves under the mouse
  flow_ = make_flow_choice("flow", tr("Which geometric flow moves the patch, and so how far the seam is matched"));
  help_ = make_note("flowHelp");
  help_->keep_room_for({labels::flow_help(FlowKind::mcf), labels::flow_help(FlowKind::sdf),
                        labels::flow_help(FlowKind::wf), labels::flow_help(FlowKind::mmcvf)});
  boundary_ = make_boundary_choice("boundary");
  continuity_ = make_continuity_choice("continuity");
  auto* boundary_label = new QLabel(tr("Boundary"));
  boundary_label->setBuddy(boundary_);
  auto* continuity_label = new QLabel(tr("Continuity"));
  continuity_label->setBuddy(continuity_);
  relief_ = make_option<QCheckBox>(
      "relief", tr("Continue relief"),
      tr("When the patch is done, it gets random relief as strong as that of the scan around the hole. Off: it "
         "continues the smooth surface under the scan."));
  edges_ = make_option<QCheckBox>(
      "edges", tr("Sharp edges"),
      tr("Sharp edges that end at the hole run on across it, where both sides say how. Off: one smooth patch."));
  edges_->setChecked(true);
  sigma_ = new QSlider(Qt::Horizontal);
  sigma_->setRange(sigma_low, sigma_high);
  sigma_->setValue(sigma_start);
  sigma_->setPageStep(ticks_per_decade);
  explain(sigma_, "sigma", tr("Time step"),
          tr("Time step \u03c3 of Step and Run steps, without a unit: 1 is one decay time of the slowest wave on this "
             "patch"));
  sigma_value_ = new QLabel;
  sigma_value_->setObjectName(QStringLiteral("sigmaValue"));
  sigma_value_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  auto* sigma_label = new QLabel(tr("Time step"));
  sigma_label->setBuddy(sigma_);
  step_ = make_button("step", tr("Step"),
                      tr("One time step of the flow itself, the boundary taken literally: on rough scans it may lead "
                         "away from the surface (S)"));
  steps_ =
      make_button("runSteps", tr("Run steps"),
                  tr("Such steps one after another, as in the paper, until nothing moves; Pause (Space) ends them"));
  run_ = make_button("run", tr("Run"), tr("The same as Smooth, every step shown for a moment; again: pause (Space)"));
  compare_ = make_button("compareFlows", tr("Compare flows\u2026"),
                         tr("Two to four flows from one start, side by side, in a window of their own (C)"));
  auto* more = new QWidget;
  auto* head = new QHBoxLayout;
  head->addWidget(target_, 1);
  head->addWidget(make_fold("moreOfFlow", tr("More options"), more), 0, Qt::AlignTop);
  grid->addLayout(head, 0, 0, 1, 2);
  grid->addWidget(run_, 2, 1);
  rest_ = make_layout<QGridLayout>(more);
  rest_->addWidget(sigma_label, 1, 0);
  rest_->addWidget(sigma_value_, 1, 1);
  rest_->addWidget(sigma_, 2, 0);
  rest_->addWidget(step_, 2, 1);
  rest_->addWidget(compare_, 3, 0);
  rest_->addWidget(steps_, 3, 1);
  rest_->setColumnStretch(0, 1);
  rest_->setColumnStretch(1, 1);
  options_ = new QWidget;
  auto* before = make_layout<QGridLayout>(options_);
  before->setVerticalSpacing(4);
  before->addWidget(flow_, 0, 0, 1, 2);
  before->addWidget(help_, 1, 0, 1, 2);
  before->addWidget(boundary_label, 2, 0);
  before->addWidget(boundary_, 2, 1);
  before->addWidget(continuity_label, 3, 0);
  before->addWidget(continuity_, 3, 1);
  before->addWidget(relief_, 4, 0);
  before->addWidget(edges_, 4, 1);
  before->setColumnStretch(0, 1);
  before->setColumnStretch(1, 1);
  grid->addWidget(more, 4, 0, 1, 2);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
}

void FlowBox::add_states(DecisionBox& of) {
  auto* grid = static_cast<QGridLayout*>(layout());
  grid->addWidget(of.states(), 1, 0, 1, 2);
  grid->addWidget(&of.player(), 2, 0);
  rest_->addWidget(of.player().rest(), 0, 0, 1, 2);
}

void FlowBox::step() {
  if (step_->isEnabled()) evolve(Pace::time_step);
}

void FlowBox::run_or_pause() {
  if (!run_->isEnabled()) return;
  const Activity now = controller_.activity();
  now == Activity::running || now == Activity::solving ? controller_.pause() : evolve(Pace::watched);
}

void FlowBox::evolve(Pace pace) { controller_.evolve(patches_to_move(document_, selection_), options(), pace); }

EvolutionOptions FlowBox::options() const {
  EvolutionOptions options;
  options.flow = static_cast<FlowKind>(flow_->currentData().toInt());
  options.sigma = sigma();
  options.boundary = static_cast<BoundaryTrust>(boundary_->currentData().toInt());
  options.continuity = static_cast<SeamContinuity>(continuity_->currentData().toInt());
  if (relief_->isChecked()) options.relief.kind = ReliefChoice::Kind::continued;
  options.edges = edges_->isChecked() ? SharpEdges::continued : SharpEdges::rounded;
  return options;
}

double FlowBox::sigma() const { return std::pow(10.0, static_cast<double>(sigma_->value()) / ticks_per_decade); }

void FlowBox::update_state() {
  const Activity now = controller_.activity();
  const bool idle = now == Activity::idle;
  const bool can_pause = now == Activity::running || now == Activity::solving;
  const std::set<int> to_move = patches_to_move(document_, selection_);
  const bool chosen = !selection_.selected().empty();
  if (!to_move.empty()) {
    target_->setText(labels::sentence(labels::holes(document_, loops_of(document_, to_move))));
  } else if (!chosen_patches(document_, selection_).empty()) {
    target_->setText(tr("Accepted; open it to go on."));
  } else {
    target_->setText(chosen ? tr("The selection is not filled yet.") : tr("Nothing is filled yet."));
  }
  help_->setText(labels::flow_help(options().flow));
  sigma_value_->setText(tr("\u03c3 = %1").arg(labels::number(sigma())));
  flow_->setEnabled(idle);
  const bool of_mmcvf = idle && options().flow == FlowKind::mmcvf;
  boundary_->setEnabled(of_mmcvf);
  continuity_->setEnabled(of_mmcvf);
  relief_->setEnabled(idle);
  edges_->setEnabled(of_mmcvf);
  if (!idle) sigma_->clearFocus();  // else the next control takes it, and the Space that would pause
  sigma_->setEnabled(idle);
  for (QPushButton* button : {step_, steps_}) button->setEnabled(idle && !to_move.empty());
  compare_->setEnabled(document_.has_scan());
  run_->setEnabled(can_pause || (idle && !to_move.empty()));
  run_->setText(can_pause ? tr("Pause") : now == Activity::pausing ? tr("Pausing\u2026") : tr("Run"));
}

}  // namespace loopmend
