// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/banner.h"

#include "panels/icons.h"
#include "panels/parts.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

namespace loopmend {
namespace {

constexpr int notice_ms = 6000;
constexpr int icon_px = 18;

}  // namespace

Banner::Banner(QWidget* parent) : QFrame(parent), sign_(new QLabel), words_(new QLabel), close_(new QToolButton) {
  setObjectName(QStringLiteral("banner"));
  words_->setObjectName(QStringLiteral("bannerText"));
  words_->setWordWrap(true);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  words_->setTextFormat(Qt::PlainText);
  close_->setObjectName(QStringLiteral("bannerClose"));
  close_->setAutoRaise(true);
  explain(close_, tr("Close"), tr("Close this message (Esc)"));
  layout_ = new QHBoxLayout(this);
  layout_->setContentsMargins(12, 7, 6, 7);
  layout_->setSpacing(10);
  layout_->addWidget(sign_, 0, Qt::AlignVCenter);
  layout_->addWidget(words_, 1);
  layout_->addWidget(close_, 0, Qt::AlignVCenter);
  parent->installEventFilter(this);
  timer_.setSingleShot(true);
  connect(close_, &QToolButton::clicked, this, &QWidget::hide);
  connect(&timer_, &QTimer::timeout, this, &QWidget::hide);
  hide();
}

bool Banner::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parent() && event->type() == QEvent::Resize) settle();
  return QFrame::eventFilter(watched, event);
}

void Banner::settle() {
  const int width = parentWidget()->width();
  layout_->invalidate();
  setGeometry(0, 0, width, layout_->hasHeightForWidth() ? layout_->totalHeightForWidth(width) : sizeHint().height());
  raise();
}

QString Banner::text() const { return words_->text(); }

void Banner::show_problem(const QString& words) {
  show_words(words, Tone::problem);
  timer_.stop();
}

void Banner::show_notice(const QString& words) {
  show_words(words, Tone::notice);
  timer_.start(notice_ms);
}

void Banner::drop_answers() {
  for (QPushButton* button : std::exchange(answers_, {})) {
    button->hide();
    button->deleteLater();
  }
}

void Banner::ask(const QString& words, std::vector<Answer> answers) {
  show_words(words, Tone::question);
  timer_.stop();
  for (Answer& answer : answers) {
    auto* button = make_button(answer.name, answer.text, {});
    button->setFocusPolicy(Qt::StrongFocus);
    connect(button, &QPushButton::clicked, this, [this, act = std::move(answer.act)] {
      hide();
      drop_answers();
      act();
    });
    layout_->insertWidget(layout_->count() - 1, button, 0, Qt::AlignVCenter);
    answers_.push_back(button);
  }
  settle();
  answers_.front()->setFocus();
}

void Banner::show_words(const QString& words, Tone tone) {
  drop_answers();
  const bool problem = tone == Tone::problem, question = tone == Tone::question;
  const QColor ink = problem    ? QColor(0x6b, 0x1d, 0x12)
                     : question ? QColor(0x4a, 0x38, 0x06)
                                : QColor(0x14, 0x42, 0x3c);
  const QColor ground = problem    ? QColor(0xfb, 0xe3, 0xdc)
                        : question ? QColor(0xfb, 0xf0, 0xcc)
                                   : QColor(0xdb, 0xef, 0xea);
  setStyleSheet(QStringLiteral("#banner { background: %1; border: 0; border-bottom: 1px solid %2; }"
                               "#bannerText { color: %3; } #bannerClose { border: 0; padding: 1px; }")
                    .arg(ground.name(), ground.darker(115).name(), ink.name()));
  sign_->setPixmap(icon(problem ? "warning" : "info", ink).pixmap(icon_px, icon_px));
  close_->setIcon(icon("close", ink));
  words_->setText(words);
  show();
  settle();
}

}  // namespace loopmend
