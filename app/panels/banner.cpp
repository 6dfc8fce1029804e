// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/banner.h"

#include "panels/icons.h"
#include "panels/parts.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QTextBoundaryFinder>
#include <QToolButton>

#include <algorithm>

namespace loopmend {
namespace {

constexpr int notice_ms = 6000;
constexpr int icon_px = 18;
constexpr int least_words_px = 260;  ///< beside answers
enum Place { sign_column, words_column, answers_column, close_column };

/// Each part between two places where a line may be broken, shortened in its middle where it is wider than `width`.
QString shortened(const QString& text, const QFontMetrics& letters, int width) {
  QString result;
  QTextBoundaryFinder finder(QTextBoundaryFinder::Line, text);
  for (int from = 0, to = finder.toNextBoundary(); to >= 0; from = to, to = finder.toNextBoundary()) {
    const QString part = text.mid(from, to - from);
    result +=
        letters.horizontalAdvance(part.trimmed()) <= width ? part : letters.elidedText(part, Qt::ElideMiddle, width);
  }
  return result;
}

}  // namespace

Banner::Banner(QWidget* parent)
    : QFrame(parent),
      sign_(new QLabel),
      words_(new QLabel),
      close_(new QToolButton),
      answer_row_(new QWidget) {
  setObjectName(QStringLiteral("banner"));
  words_->setObjectName(QStringLiteral("bannerText"));
  words_->setWordWrap(true);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  words_->setTextFormat(Qt::PlainText);
  close_->setAutoRaise(true);
  explain(close_, "bannerClose", tr("Close"), tr("Close this message (Esc)"));
  auto* answers = new QBoxLayout(QBoxLayout::LeftToRight, answer_row_);
  answers->setContentsMargins(0, 0, 0, 0);
  answers->addStretch(1);
  layout_ = new QGridLayout(this);
  layout_->setContentsMargins(12, 7, 6, 7);
  layout_->setSpacing(10);
  layout_->setColumnStretch(words_column, 1);
  layout_->addWidget(sign_, 0, sign_column, Qt::AlignVCenter);
  layout_->addWidget(words_, 0, words_column);
  layout_->addWidget(answer_row_, 0, answers_column, Qt::AlignVCenter);
  layout_->addWidget(close_, 0, close_column, Qt::AlignVCenter);
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

void Banner::showEvent(QShowEvent* event) {
  QFrame::showEvent(event);
  Q_EMIT covered(height());
}

void Banner::hideEvent(QHideEvent* event) {
  QFrame::hideEvent(event);
  Q_EMIT covered(0);
  Q_EMIT changed();
}

void Banner::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  if (isVisible()) Q_EMIT covered(height());
}

/// The answers lie beside the words, or below them where they would leave too little room.
void Banner::fit_words() {
  const QMargins margins = layout_->contentsMargins();
  static_cast<QBoxLayout*>(answer_row_->layout())->setDirection(QBoxLayout::LeftToRight);
  const int answers = answers_.empty() ? 0 : answer_row_->sizeHint().width() + layout_->spacing();
  const int room = parentWidget()->width() - margins.left() - margins.right() - 2 * layout_->spacing() -
                   sign_->sizeHint().width() - close_->sizeHint().width();
  const bool beside = room - answers >= std::max(answers, least_words_px);
  auto* row = static_cast<QBoxLayout*>(answer_row_->layout());
  row->setDirection(answers <= room ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  row->activate();
  layout_->removeWidget(answer_row_);
  if (beside)
    layout_->addWidget(answer_row_, 0, answers_column, Qt::AlignVCenter);
  else
    layout_->addWidget(answer_row_, 1, words_column, 1, -1);
  answer_row_->setVisible(!answers_.empty());
  const QString shown = shortened(text_, words_->fontMetrics(), std::max(1, beside ? room - answers : room));
  words_->setText(shown);
  words_->setToolTip(shown == text_ ? QString() : text_);
}

void Banner::settle() {
  const int width = parentWidget()->width();
  fit_words();
  layout_->invalidate();
  setGeometry(0, 0, width, layout_->hasHeightForWidth() ? layout_->totalHeightForWidth(width) : sizeHint().height());
  raise();
}

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
  add_answers(std::move(answers));
  answers_.front()->setFocus();
}

void Banner::offer(const QString& words, std::vector<Answer> answers) {
  show_words(words, Tone::notice);
  timer_.stop();
  add_answers(std::move(answers));
}

void Banner::add_answers(std::vector<Answer> answers) {
  for (Answer& answer : answers) {
    auto* button = make_button(answer.name, answer.text, {});
    button->setFocusPolicy(Qt::StrongFocus);
    connect(button, &QPushButton::clicked, this, [this, act = std::move(answer.act)] {
      hide();
      drop_answers();
      act();
    });
    answer_row_->layout()->addWidget(button);
    button->show();  // at once, so that its room is known
    button->ensurePolished();
    button->setMinimumWidth(button->sizeHint().width());
    answers_.push_back(button);
  }
  settle();
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
  text_ = words;
  show();
  settle();
  Q_EMIT changed();
}

}  // namespace loopmend
