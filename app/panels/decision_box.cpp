// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/decision_box.h"

#include "document/hole_selection.h"
#include "document/labels.h"
#include "document/problem_commands.h"
#include "document/targets.h"
#include "document/timeline.h"
#include "jobs/fill_controller.h"
#include "panels/parts.h"
#include "panels/player_bar.h"

#include <QApplication>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>

namespace loopmend {
namespace {

/// What is known of a state, in one line.
QString state_words(const PatchState& state) {
  if (state.steps == 0) return DecisionBox::tr("the initial patch");
  if (!(state.last_step.tau > 0)) return DecisionBox::tr("step %1").arg(state.steps);
  return DecisionBox::tr("step %1, \u03c3 %2").arg(state.steps).arg(labels::number(state.last_step.sigma));
}

}  // namespace

DecisionBox::DecisionBox(const Document& document, const HoleSelection& selection, FillController& controller,
                         QWidget* parent)
    : QGroupBox(tr("2  Review, decide"), parent),
      document_(document),
      selection_(selection),
      controller_(controller) {
  build();
  connect(timeline_, &QSlider::valueChanged, this, &DecisionBox::scrub);
  connect(timeline_, &QSlider::sliderReleased, &controller_, &FillController::end_scrub);
  // The second click of a double click would open again what the first one accepted.
  connect(accept_, &QPushButton::clicked, this, [this] {
    if (!clicked_.isValid() || clicked_.hasExpired(QApplication::doubleClickInterval())) accept_or_reopen();
    clicked_.start();
  });
  connect(reject_, &QPushButton::clicked, this, &DecisionBox::reject);
  connect(copy_, &QPushButton::clicked, this, &DecisionBox::copy_command);
  // What else is done begins at the state that is shown.
  connect(&selection_, &HoleSelection::selection_changed, player_, &PlayerBar::pause);
  for (auto signal : {&Document::patches_changed, &Document::scans_changed})
    connect(&document_, signal, player_, &PlayerBar::pause);
  connect(&controller_, &FillController::activity_changed, player_, [this] {
    if (controller_.busy()) player_->pause();
  });
  // Thousands of patches may move at once, and each update looks at all of them.
  soon_.setSingleShot(true);
  soon_.setInterval(0);
  connect(&soon_, &QTimer::timeout, this, &DecisionBox::update_timeline);
  for (auto signal : {&Document::patch_moved, &Document::timeline_changed})
    connect(&document_, signal, &soon_, QOverload<>::of(&QTimer::start));
}

void DecisionBox::build() {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(box_margins);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(4);
  timeline_ = new QSlider(Qt::Horizontal);
  timeline_->setPageStep(1);
  explain(timeline_, "timeline", tr("Timeline"),
          tr("Go back to any recorded state, from the initial patch on the left to the latest"));
  player_ = new PlayerBar(*timeline_);
  place_ = make_note("timelinePlace");
  place_->keep_room_for({tr("Recorded states appear here.")});
  accept_ = make_button("accept", tr("Accept"), tr("Keep this patch as it is; no flow moves it any more (A)"));
  reject_ = make_button("reject", tr("Discard"), tr("Throw this patch away; the hole is open again (Delete)"));
  copy_ = make_button("copyCommand", tr("Copy command line"),
                      tr("Copy the commands that fill these holes in just this way, for a terminal or a script"));
  grid->addWidget(accept_, 0, 0);
  grid->addWidget(reject_, 0, 1);
  auto* seam = make_button("showSeam", tr("Seam and plots"),
                           tr("Show or hide the seam in numbers, the energy of the run, a section, and the log"));
  connect(seam, &QPushButton::clicked, this, &DecisionBox::seam_wanted);
  others_ = make_button("otherPatches", tr("Other patches\u2026"),
                        tr("Compute other patches for this hole, see them side by side, take one (V)"));
  connect(others_, &QPushButton::clicked, this, &DecisionBox::candidates_wanted);
  grid->addWidget(others_, 1, 0);
  grid->addWidget(seam, 1, 1);
  states_ = new QWidget;
  auto* states = make_layout<QVBoxLayout>(states_);
  states->setSpacing(2);
  states->addWidget(place_);
  states->addWidget(timeline_);
  player_->add_to_rest(copy_);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
}

bool DecisionBox::all_accepted() const {
  const std::set<int> chosen = chosen_patches(document_, selection_);
  return !chosen.empty() && std::all_of(chosen.begin(), chosen.end(), [this](int id) {
    return document_.patch(id)->acceptance == Acceptance::accepted;
  });
}

void DecisionBox::accept_or_reopen() {
  if (!accept_->isEnabled()) return;
  player_->pause();
  controller_.set_acceptance(chosen_patches(document_, selection_),
                             all_accepted() ? Acceptance::pending : Acceptance::accepted);
}

void DecisionBox::reject() {
  player_->pause();
  if (reject_->isEnabled()) controller_.reject(chosen_patches(document_, selection_));
}

void DecisionBox::copy_command() {
  if (!copy_->isEnabled()) return;
  Q_EMIT notice(copy_to_clipboard(command_line(document_, chosen_patches(document_, selection_))));
}

void DecisionBox::scrub(int place) {
  if (syncing_) return;
  controller_.scrub_to(patches_to_move(document_, selection_), static_cast<std::size_t>(place));
  // Keys and clicks beside the handle have no release of their own.
  if (!timeline_->isSliderDown()) controller_.end_scrub();
}

void DecisionBox::update_timeline() {
  const QScopedValueRollback guard(syncing_, true);
  const OpenPatch* longest = nullptr;
  for (int id : patches_to_move(document_, selection_)) {
    const OpenPatch* patch = document_.patch(id);
    if (!longest || patch->timeline->size() > longest->timeline->size()) longest = patch;
  }
  const bool usable = longest && longest->timeline->size() > 1;
  if (controller_.busy()) timeline_->clearFocus();  // else the next control takes it, and the Space that would pause
  timeline_->setEnabled(usable && !controller_.busy());
  player_->update_state();
  if (!longest) {
    timeline_->setRange(0, 1);
    place_->setText(tr("Recorded states appear here."));
    Q_EMIT state_told(no_patch);
    return;
  }
  const int last = static_cast<int>(longest->timeline->size()) - 1;
  timeline_->setRange(0, std::max(1, last));
  const auto place = static_cast<int>(place_in(*longest->timeline, longest->state));
  if (!timeline_->isSliderDown()) timeline_->setValue(place);
  place_->setText(tr("State %1 of %2: %3").arg(place + 1).arg(last + 1).arg(state_words(*longest->state)));
  Q_EMIT state_told(longest->id);
}

void DecisionBox::update_state() {
  const bool usable = !controller_.busy() && !chosen_patches(document_, selection_).empty();
  for (QPushButton* button : {accept_, reject_, copy_}) button->setEnabled(usable);
  others_->setEnabled(usable && patches_to_move(document_, selection_).size() == 1);
  const bool reopen = all_accepted();
  accept_->setText(reopen ? tr("Open again") : tr("Accept"));
  explain(accept_, reopen ? tr("Open again") : tr("Accept"),
          reopen ? tr("Let a flow move this patch again (A)")
                 : tr("Keep this patch as it is; no flow moves it any more (A)"));
  update_timeline();
}

}  // namespace loopmend
