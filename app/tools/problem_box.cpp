// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/problem_box.h"

#include "document/labels.h"
#include "panels/choices.h"
#include "panels/parts.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace loopmend {

ProblemBox::ProblemBox(const ProblemController& trial, QWidget* parent)
    : QGroupBox(tr("Try it, decide"), parent),
      trial_(trial),
      flow_(make_flow_choice("trialFlow", tr("Which flow works on it"))),
      boundary_(make_boundary_choice("trialBoundary")),
      continuity_(make_continuity_choice("trialContinuity")),
      words_(make_note("trialWords")),
      preview_(make_button("trialPreview", tr("Preview"), tr("Show the start, before any flow"))),
      evolve_(make_button("trialEvolve", tr("Evolve"), tr("Let the flow work on it until it converges"))),
      compare_(make_button("trialCompare", tr("Compare flows\u2026"),
                           tr("Several flows from this start, side by side, in a window of their own"))),
      cancel_(make_button("trialCancel", tr("Cancel"), tr("Stop at once; the start is shown again (Esc)"))),
      accept_(make_button("trialAccept", tr("Accept"), tr("The result comes into the document; can be undone"))),
      discard_(make_button("trialDiscard", tr("Discard"), tr("Give it up; the document is as it was"))),
      copy_(make_button("trialCopy", tr("Copy command line"), tr("Copy the commands that do the same"))) {
  auto* grid = new QGridLayout(this);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(6);
  grid->addWidget(flow_, 0, 0, 1, 2);
  auto* boundary_label = new QLabel(tr("Boundary"));
  auto* continuity_label = new QLabel(tr("Continuity"));
  boundary_label->setBuddy(boundary_);
  continuity_label->setBuddy(continuity_);
  grid->addWidget(boundary_label, 1, 0);
  grid->addWidget(boundary_, 1, 1);
  grid->addWidget(continuity_label, 2, 0);
  grid->addWidget(continuity_, 2, 1);
  grid->addWidget(preview_, 3, 0);
  grid->addWidget(evolve_, 3, 1);
  grid->addWidget(compare_, 4, 0, 1, 2);
  grid->addWidget(words_, 5, 0, 1, 2);
  grid->addWidget(cancel_, 6, 0, 1, 2);
  grid->addWidget(accept_, 7, 0);
  grid->addWidget(discard_, 7, 1);
  grid->addWidget(copy_, 8, 0, 1, 2);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  connect(preview_, &QPushButton::clicked, this, &ProblemBox::preview_wanted);
  connect(evolve_, &QPushButton::clicked, this, &ProblemBox::evolve_wanted);
  connect(compare_, &QPushButton::clicked, this, &ProblemBox::compare_wanted);
  connect(cancel_, &QPushButton::clicked, this, &ProblemBox::cancel_wanted);
  connect(accept_, &QPushButton::clicked, this, &ProblemBox::accept_wanted);
  connect(discard_, &QPushButton::clicked, this, &ProblemBox::discard_wanted);
  connect(copy_, &QPushButton::clicked, this, &ProblemBox::copy_wanted);
  connect(&trial_, &ProblemController::stage_changed, this, &ProblemBox::update_state);
  update_state();
}

EvolutionOptions ProblemBox::options() const {
  EvolutionOptions options;
  options.flow = static_cast<FlowKind>(flow_->currentData().toInt());
  options.boundary = static_cast<BoundaryTrust>(boundary_->currentData().toInt());
  options.continuity = static_cast<SeamContinuity>(continuity_->currentData().toInt());
  return options;
}

void ProblemBox::set_wanting(const QString& wanting) {
  wanting_ = wanting;
  update_state();
}

void ProblemBox::update_state() {
  const bool busy = trial_.busy(), possible = wanting_.isEmpty() && !busy;
  for (QPushButton* button : {preview_, evolve_, compare_}) button->setEnabled(possible);
  for (QComboBox* choice : {flow_, boundary_, continuity_}) choice->setEnabled(!busy);
  copy_->setEnabled(wanting_.isEmpty());
  cancel_->setVisible(busy);
  const bool posed =
      trial_.stage() == ProblemController::Stage::posed || trial_.stage() == ProblemController::Stage::solved;
  accept_->setVisible(!busy);
  discard_->setVisible(!busy);
  accept_->setEnabled(trial_.stage() == ProblemController::Stage::solved);
  discard_->setEnabled(posed);
  const QString words = trial_.words().isEmpty() ? wanting_ : trial_.words();
  words_->setText(words);
  words_->setVisible(!words.isEmpty());
}

}  // namespace loopmend
