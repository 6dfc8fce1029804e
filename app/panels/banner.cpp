#include "panels/banner.h"

#include "panels/icons.h"

#include <QHBoxLayout>
#include <QLabel>
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
  close_->setToolTip(tr("Close this message"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 7, 6, 7);
  layout->setSpacing(10);
  layout->addWidget(sign_, 0, Qt::AlignTop);
  layout->addWidget(words_, 1);
  layout->addWidget(close_, 0, Qt::AlignTop);
  timer_.setSingleShot(true);
  connect(close_, &QToolButton::clicked, this, &QWidget::hide);
  connect(&timer_, &QTimer::timeout, this, &QWidget::hide);
  hide();
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

void Banner::show_words(const QString& words, Tone tone) {
  const bool problem = tone == Tone::problem;
  const QColor ink = problem ? QColor(0x6b, 0x1d, 0x12) : QColor(0x14, 0x42, 0x3c);
  const QColor ground = problem ? QColor(0xfb, 0xe3, 0xdc) : QColor(0xdb, 0xef, 0xea);
  setStyleSheet(QStringLiteral("#banner { background: %1; border: 0; border-bottom: 1px solid %2; }"
                               "#bannerText { color: %3; } #bannerClose { border: 0; padding: 1px; }")
                    .arg(ground.name(), ground.darker(115).name(), ink.name()));
  sign_->setPixmap(icon(problem ? "warning" : "info", ink).pixmap(icon_px, icon_px));
  close_->setIcon(icon("close", ink));
  words_->setText(words);
  show();
}

}  // namespace loopmend
