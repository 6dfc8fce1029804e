// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/candidates_panel.h"

#include "document/hole_selection.h"
#include "document/labels.h"
#include "document/message_words.h"
#include "document/targets.h"
#include "jobs/fill_controller.h"
#include "panels/candidate_card.h"
#include "panels/parts.h"
#include "panels/progress_bar.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

constexpr int columns = 2;

QString card_name(CandidateKind kind) { return QStringLiteral("candidate%1").arg(static_cast<int>(kind)); }

HoleState sign_of(Grade grade) {
  return grade == Grade::bad ? HoleState::bad : grade == Grade::look ? HoleState::look : HoleState::converged;
}

}  // namespace

CandidatesPanel::CandidatesPanel(const Document& document, const HoleSelection& selection,
                                 CandidateController& candidates, FillController& controller, QWidget* parent)
    : QWidget(parent),
      document_(document),
      selection_(selection),
      candidates_(candidates),
      controller_(controller) {
  setObjectName(QStringLiteral("candidatesPanel"));
  build();
  connect(compute_, &QPushButton::clicked, this, [this] {
    if (candidates_.busy())
      candidates_.cancel();
    else
      compute();
  });
  connect(&candidates_, &CandidateController::changed, this, &CandidatesPanel::update_cards);
  connect(&candidates_, &CandidateController::changed, this, &CandidatesPanel::update_state);
  for (auto signal : {&Document::opened, &Document::patches_changed, &Document::holes_changed})
    connect(&document_, signal, this, &CandidatesPanel::update_state);
  connect(&selection_, &HoleSelection::selection_changed, this, &CandidatesPanel::update_state);
  connect(&controller_, &FillController::activity_changed, this, &CandidatesPanel::update_state);
  update_state();
}

void CandidatesPanel::build() {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 6, 8, 8);
  layout->setSpacing(6);
  title_ = new QLabel;
  title_->setObjectName(QStringLiteral("candidatesTitle"));
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  compute_ = make_button("candidatesCompute", tr("Compute"),
                         tr("Compute other patches for the selected hole; nothing changes until you take one"));
  auto* head = new QHBoxLayout;
  head->addWidget(title_, 1);
  head->addWidget(compute_);
  layout->addLayout(head);
  bar_ = new ProgressBar;
  explain(bar_, "candidatesProgress", tr("Progress"), tr("How many of the other patches are ready"));
  QSizePolicy keep = bar_->sizePolicy();
  keep.setRetainSizeWhenHidden(true);
  bar_->setSizePolicy(keep);
  layout->addWidget(bar_);
  note_ = make_note("candidatesNote");
  layout->addWidget(note_);
  auto* content = new QWidget;
  auto* column = make_layout<QVBoxLayout>(content);
  grid_ = new QGridLayout;
  grid_->setSpacing(6);
  for (int k = 0; k < columns; ++k) grid_->setColumnStretch(k, 1);
  column->addLayout(grid_);
  refused_ = make_note("candidatesRefused");
  column->addWidget(refused_);
  column->addStretch(1);
  auto* scroll = new QScrollArea;
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(content);
  layout->addWidget(scroll, 1);
}

int CandidatesPanel::chosen_loop() const {
  const std::set<int> patches = patches_to_move(document_, selection_);
  return patches.size() == 1 ? document_.patch(*patches.begin())->loops.front() : no_loop;
}

void CandidatesPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  Q_EMIT cards_changed();
}

bool CandidatesPanel::can_compute() const { return chosen_loop() != no_loop && !controller_.busy(); }

bool CandidatesPanel::compute() {
  if (!can_compute()) return false;
  const int loop = chosen_loop();
  if (!candidates_.loops().contains(loop) || (candidates_.candidates().size() < 2 && !candidates_.busy()))
    candidates_.compute(loop);
  Q_EMIT begun(loop);
  return true;
}

CandidateCard* CandidatesPanel::card(CandidateKind kind) const {
  const auto found = cards_.find(kind);
  return found == cards_.end() ? nullptr : found->second;
}

int CandidatesPanel::looked_at() const {
  const std::vector<Candidate>& all = candidates_.candidates();
  for (std::size_t k = 0; k < all.size(); ++k)
    if (looked_at_ == all[k].kind) return static_cast<int>(k);
  return -1;
}

CardText CandidatesPanel::text_of(const Candidate& candidate) const {
  CardText text;
  text.name = labels::candidate(candidate.kind);
  double likely = 0;
  std::optional<double> crease;  ///< none where an edge belongs there, as in the table
  std::optional<Verdict> worst;
  bool is_known = true, cuts = false;
  for (const OpenPatch& patch : candidate.patches) {
    const PatchState& state = *patch.state;
    for (const Verdict& verdict : state.verdicts) {
      if (verdict.crease_deg) crease = std::max(crease.value_or(0), *verdict.crease_deg);
      if (!worst || verdict.grade > worst->grade) worst = verdict;
    }
    is_known = is_known && !state.deviation.loops.empty();
    for (const ExpectedDeviation& expected : state.deviation.loops) {
      is_known = is_known && expected.is_known();
      likely = std::max(likely, expected.likely);
    }
    cuts = cuts || state.status == PatchStatus::invalid;
  }
  if (cuts || !worst) {
    text.state = cuts ? HoleState::cutting : HoleState::stepped;
    text.verdict = cuts ? labels::state(HoleState::cutting) : tr("not judged");
  } else {
    text.state = sign_of(worst->grade);
    text.verdict = worst->grade == Grade::good ? tr("good") : labels::state(text.state);
  }
  QStringList figures;
  if (worst) figures << (crease ? tr("crease %1\u00b0").arg(std::lround(*crease)) : tr("an edge at the seam"));
  if (is_known) figures << tr("off %1").arg(labels::length(document_, likely));
  text.figures = figures.join(QStringLiteral(", "));
  text.help = labels::candidate_help(candidate.kind);
  if (worst && worst->grade != Grade::good) text.help += QLatin1Char(' ') + labels::sentence_of(*worst);
  if (is_known)
    text.help +=
        QLatin1Char(' ') + tr("Likely within %1 of what was there (80 %).").arg(labels::length(document_, likely));
  return text;
}

QString CandidatesPanel::words_on_refused() const {
  QStringList lines;
  for (const auto& [kind, why] : candidates_.refused())
    lines << tr("%1: %2").arg(labels::candidate(kind), labels::in_words(why));
  return lines.join(QLatin1Char('\n'));
}

void CandidatesPanel::update_cards() {
  const std::vector<Candidate>& all = candidates_.candidates();
  std::map<CandidateKind, CandidateCard*> old = std::move(cards_);
  cards_.clear();
  bool changed = false;
  const int in_place = candidates_.in_place();
  for (std::size_t k = 0; k < all.size(); ++k) {
    const CandidateKind kind = all[k].kind;
    CandidateCard*& card = cards_[kind];
    if (const auto kept = old.extract(kind)) {
      card = kept.mapped();
      grid_->removeWidget(card);
    } else {
      changed = true;
      card = new CandidateCard(card_name(kind));
      connect(card, &QAbstractButton::clicked, this, [this, kind] {
        looked_at_ = kind;
        candidates_.take(looked_at());
      });
      connect(card, &CandidateCard::looked_at, this, [this, kind] {
        if (!cards_.at(kind)->isEnabled()) return;
        looked_at_ = kind;
        Q_EMIT look_changed();
      });
      connect(card, &CandidateCard::resized, this, &CandidatesPanel::cards_changed);
      connect(card, &CandidateCard::left, this, [this, kind] {
        if (looked_at_ != kind) return;
        looked_at_.reset();
        Q_EMIT look_changed();
      });
    }
    card->set_text(text_of(all[k]));
    card->set_place(static_cast<int>(k) == in_place ? CandidateCard::Place::in_place : CandidateCard::Place::offered);
    const int at = static_cast<int>(k);
    grid_->addWidget(card, at / columns, at % columns);
  }
  for (const auto& [kind, card] : old) {
    changed = true;
    card->hide();
    card->deleteLater();  // its own click may have made it superfluous
  }
  refused_->setText(words_on_refused());
  refused_->setVisible(!refused_->text().isEmpty());
  if (changed) {
    if (looked_at_ && !cards_.contains(*looked_at_)) looked_at_.reset();
    Q_EMIT cards_changed();
  }
  Q_EMIT look_changed();
}

void CandidatesPanel::update_state() {
  const bool busy = candidates_.busy(), shown = !candidates_.loops().empty();
  const int loop = chosen_loop();
  const bool of_shown = shown && candidates_.loops().contains(loop);
  const QString holes = shown ? labels::sentence(labels::holes(document_, candidates_.loops())) : QString();
  title_->setText(candidates_.loops().size() > 1 ? tr("%1, one patch").arg(holes) : holes);
  compute_->setText(busy ? tr("Cancel") : tr("Compute"));
  compute_->setEnabled(busy || (can_compute() && !(of_shown && candidates_.candidates().size() > 1)));
  bar_->setVisible(busy);
  bar_->setRange(0, std::max(1, candidates_.total()));
  bar_->setValue(candidates_.done());
  if (busy)
    note_->setText(tr("%1 of %2 are ready. The patch stays as it is until you take another.")
                       .arg(candidates_.done())
                       .arg(candidates_.total()));
  else if (shown && !of_shown && loop != no_loop)
    note_->setText(tr("Press Compute for %1.").arg(labels::holes(document_, {loop})));
  else if (of_shown)
    note_->setText(tr("Point at one to see it in the view; click to take it."));
  else
    note_->setText(loop == no_loop ? tr("Select one hole that is filled, and not accepted yet.")
                                   : tr("Press Compute for other patches: flat, tangent, robust and more."));
  // What a click takes is for the hole that is selected.
  const bool usable = of_shown && !controller_.busy();
  for (const auto& [kind, card] : cards_) card->setEnabled(usable);
  if (usable || !looked_at_) return;
  looked_at_.reset();
  Q_EMIT look_changed();
}

}  // namespace loopmend
