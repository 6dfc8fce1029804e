// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/player_bar.h"

#include "panels/parts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLocale>
#include <QPushButton>
#include <QSlider>

namespace loopmend {
namespace {

// A run has some ten states: two a second can be followed one by one.
constexpr double paces[] = {0.5, 1, 2, 4, 8, 16};
constexpr int usual_pace = 2;  // its place

}  // namespace

PlayerBar::PlayerBar(QSlider& timeline, QWidget* parent)
    : QWidget(parent),
      timeline_(timeline),
      play_(make_button("play", tr("Play"), {})),
      next_(
          make_button("nextState", tr("Next state"), tr("One recorded state further; after the last, the first (.)"))),
      pace_(new QComboBox),
      again_(new QCheckBox(tr("Again and again"))) {
  setObjectName(QStringLiteral("playerBar"));
  pace_->setObjectName(QStringLiteral("playPace"));
  for (const double pace : paces) pace_->addItem(tr("%1 a second").arg(QLocale().toString(pace)), pace);
  pace_->setCurrentIndex(usual_pace);
  explain(pace_, tr("Speed"), tr("How many recorded states are shown in a second"));
  again_->setObjectName(QStringLiteral("playAgain"));
  explain(again_, tr("Again and again"), tr("After the last state, go on with the first"));
  make_layout<QHBoxLayout>(this)->addWidget(play_);
  rest_ = new QWidget;
  auto* grid = make_layout<QGridLayout>(rest_);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(4);
  grid->addWidget(pace_, 0, 0);
  grid->addWidget(next_, 0, 1);
  grid->addWidget(again_, 1, 0, 1, 2);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  connect(play_, &QPushButton::clicked, this, &PlayerBar::play_or_pause);
  connect(next_, &QPushButton::clicked, this, &PlayerBar::next);
  connect(pace_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &PlayerBar::keep_pace);
  connect(&timer_, &QTimer::timeout, this, &PlayerBar::advance);
  timeline_.installEventFilter(this);
  keep_pace();
  update_state();
}

void PlayerBar::add_to_rest(QWidget* widget) {
  static_cast<QGridLayout*>(rest_->layout())->addWidget(widget, 2, 0, 1, 2);
}

bool PlayerBar::eventFilter(QObject* watched, QEvent* event) {
  // The key of Shift alone begins Shift+Space, which pauses by itself.
  const bool is_key = event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() != Qt::Key_Shift;
  if (event->type() == QEvent::MouseButtonPress || is_key) pause();
  return QWidget::eventFilter(watched, event);
}

void PlayerBar::keep_pace() { timer_.setInterval(static_cast<int>(1000 / pace_->currentData().toDouble())); }

void PlayerBar::play_or_pause() {
  if (is_playing()) {
    pause();
    return;
  }
  if (!play_->isEnabled()) return;
  timeline_.setSliderDown(true);
  timer_.start();
  if (timeline_.value() == timeline_.maximum()) timeline_.setValue(timeline_.minimum());
  update_state();
}

void PlayerBar::pause() {
  if (!is_playing()) return;
  timer_.stop();
  timeline_.setSliderDown(false);
  update_state();
}

void PlayerBar::next() {
  if (!next_->isEnabled()) return;
  pause();
  timeline_.setValue(timeline_.value() < timeline_.maximum() ? timeline_.value() + 1 : timeline_.minimum());
}

void PlayerBar::advance() {
  if (timeline_.value() < timeline_.maximum())
    timeline_.setValue(timeline_.value() + 1);
  else if (again_->isChecked())
    timeline_.setValue(timeline_.minimum());
  if (timeline_.value() == timeline_.maximum() && !again_->isChecked()) pause();
}

void PlayerBar::update_state() {
  const bool usable = timeline_.isEnabled();
  for (QWidget* part : {static_cast<QWidget*>(play_), static_cast<QWidget*>(next_), static_cast<QWidget*>(pace_),
                        static_cast<QWidget*>(again_)})
    part->setEnabled(usable);
  play_->setText(is_playing() ? tr("Pause") : tr("Play"));
  explain(play_, is_playing() ? tr("Pause") : tr("Play"),
          is_playing() ? tr("Stay at this state (Shift+Space)")
                       : tr("Show the recorded states one after another, from this one, or at the end from the first "
                            "(Shift+Space)"));
}

}  // namespace loopmend
