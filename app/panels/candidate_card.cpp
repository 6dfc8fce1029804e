// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/candidate_card.h"

#include "panels/hole_delegate.h"
#include "panels/parts.h"

#include <QKeyEvent>
#include <QPainter>

#include <utility>

namespace loopmend {
namespace {

constexpr int frame_px = 5, sign_px = 16, card_width = 158;
constexpr double picture_share = 0.66;  ///< height of the picture, in its width

}  // namespace

CandidateCard::CandidateCard(const QString& name, QWidget* parent) : QAbstractButton(parent) {
  setObjectName(name);
  setFocusPolicy(Qt::TabFocus);
  setAttribute(Qt::WA_Hover);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void CandidateCard::set_text(const CardText& text) {
  if (text == text_) return;
  text_ = text;
  setText(text.name);
  explain(this,
          text.figures.isEmpty() ? tr("%1: %2").arg(text.name, text.verdict)
                                 : tr("%1: %2, %3").arg(text.name, text.verdict, text.figures),
          text.help);
  update();
}

void CandidateCard::set_picture(const QImage& picture) {
  picture_ = picture;
  update();
}

void CandidateCard::set_place(Place place) {
  if (std::exchange(place_, place) != place) update();
}

QRect CandidateCard::picture_rect() const {
  const int across = width() - 2 * frame_px;
  return {frame_px, frame_px, across, static_cast<int>(picture_share * across)};
}

QSize CandidateCard::picture_size() const { return picture_rect().size() * devicePixelRatioF(); }

QSize CandidateCard::sizeHint() const {
  const int picture = static_cast<int>(picture_share * (card_width - 2 * frame_px));
  return {card_width, frame_px + picture + 3 * fontMetrics().lineSpacing() + 4 * frame_px};
}

bool CandidateCard::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::Enter:
    case QEvent::FocusIn: Q_EMIT looked_at(); break;
    case QEvent::Leave:
    case QEvent::FocusOut: Q_EMIT left(); break;
    case QEvent::ShortcutOverride: {  // with the focus it answers to these keys itself
      const int key = static_cast<QKeyEvent*>(event)->key();
      if (key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter) event->accept();
      break;
    }
    case QEvent::KeyPress: {
      const int key = static_cast<QKeyEvent*>(event)->key();
      if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        click();
        return true;
      }
      break;
    }
    default: break;
  }
  return QAbstractButton::event(event);
}

void CandidateCard::resizeEvent(QResizeEvent* event) {
  QAbstractButton::resizeEvent(event);
  if (event->oldSize().width() != event->size().width()) Q_EMIT resized();
}

void CandidateCard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const bool lit = isEnabled() && (underMouse() || hasFocus()), here = place_ == Place::in_place;
  const QColor accent = palette().color(QPalette::Highlight);
  QColor ground = here ? accent : palette().color(QPalette::Base);
  if (here) ground.setAlphaF(0.14);
  const QColor edge = here || lit ? accent : palette().color(QPalette::Mid);
  painter.setPen(QPen(edge, here ? 2 : 1));
  painter.setBrush(ground);
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
  const QRect picture = picture_rect();
  painter.setOpacity(isEnabled() ? 1 : 0.35);
  if (picture_.isNull())
    painter.fillRect(picture, palette().color(QPalette::AlternateBase));
  else
    painter.drawImage(picture, picture_);
  painter.setOpacity(1);
  const QColor ink = palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::Text);
  const int line = fontMetrics().lineSpacing(), wide = picture.width();
  int top = picture.bottom() + frame_px;
  painter.setPen(ink);
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  painter.drawText(QRect(frame_px, top, wide, line), Qt::AlignLeft | Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(text_.name, Qt::ElideRight, wide));
  painter.setFont(font());
  top += line;
  painter.save();
  painter.translate(frame_px + sign_px / 2.0, top + line / 2.0);
  paint_sign(&painter, text_.state, sign_color(text_.state));
  painter.restore();
  painter.setPen(ink);
  const auto write = [&](int left, const QString& words) {
    painter.drawText(QRect(left, top, wide - left + frame_px, line), Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(words, Qt::ElideRight, wide - left + frame_px));
  };
  write(frame_px + sign_px + 2, text_.verdict);
  top += line;
  write(frame_px, text_.figures);
}

}  // namespace loopmend
