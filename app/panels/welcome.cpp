// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/welcome.h"

#include "document/recent_pictures.h"
#include "panels/gallery.h"
#include "panels/icons.h"
#include "panels/parts.h"
#include "panels/quiet_label.h"

#include <QCommandLinkButton>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QVBoxLayout>

namespace loopmend {

Welcome::Welcome(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("welcome"));
  setAutoFillBackground(true);
  auto* picture = new QLabel;
  picture->setPixmap(application_icon().pixmap(64, 64));
  auto* title = new QLabel(tr("Open a scan, or drop one here"));
  QFont large = title->font();
  large.setPointSizeF(large.pointSizeF() * 1.6);
  title->setFont(large);
  auto* formats = new QuietLabel(tr("PLY, STL, OBJ, OFF, glTF, 3MF or VTK polydata; or a saved session"));
  for (QLabel* words : {title, static_cast<QLabel*>(formats)}) {
    words->setWordWrap(true);
    words->setAlignment(Qt::AlignHCenter);
  }
  auto* open = make_button("welcomeOpen", tr("Open\u2026"), tr("Choose a file (Ctrl+O)"));
  open->setDefault(true);
  auto* sample = make_button("welcomeSample", tr("Try the sample"), tr("A small made-up scan with five holes"));
  connect(open, &QPushButton::clicked, this, &Welcome::open_wanted);
  connect(sample, &QPushButton::clicked, this, &Welcome::sample_wanted);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(10);
  buttons->addStretch();
  for (QPushButton* button : {open, sample}) {
    button->setMinimumWidth(130);
    buttons->addWidget(button);
  }
  buttons->addStretch();
  gallery_ = new Gallery;
  connect(gallery_, &Gallery::example_wanted, this, &Welcome::example_wanted);
  auto* content = new QWidget;
  auto* scroll = new QScrollArea;  // small windows do not show all of it at once
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidgetResizable(true);
  scroll->setWidget(content);
  auto* all = make_layout<QVBoxLayout>(this);
  all->addWidget(scroll);
  auto* layout = new QVBoxLayout(content);
  layout->setSpacing(8);
  layout->addStretch(4);
  layout->addWidget(picture, 0, Qt::AlignHCenter);
  layout->addSpacing(10);
  layout->addWidget(title);
  layout->addWidget(formats);
  layout->addSpacing(14);
  layout->addLayout(buttons);
  layout->addSpacing(18);
  recent_ = new QWidget;
  recent_layout_ = new QVBoxLayout(recent_);
  recent_layout_->setContentsMargins(0, 0, 0, 0);
  recent_layout_->setSpacing(2);
  layout->addWidget(recent_, 0, Qt::AlignHCenter);
  layout->addSpacing(10);
  auto* examples = new QuietLabel(tr("Examples of the paper"));
  examples->setWordWrap(false);
  layout->addWidget(examples, 0, Qt::AlignHCenter);
  layout->addWidget(gallery_, 0, Qt::AlignHCenter);
  layout->addStretch(5);
}

void Welcome::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const int margins =
      2 * style()->pixelMetric(QStyle::PM_LayoutLeftMargin) + style()->pixelMetric(QStyle::PM_ScrollBarExtent);
  gallery_->lay_out(width() - margins);
}

void Welcome::show_recent(const QStringList& files) {
  constexpr int most = 3;
  while (QLayoutItem* item = recent_layout_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  if (files.isEmpty()) return;
  recent_layout_->addWidget(new QuietLabel(tr("Opened lately")));
  for (const QString& path : files.mid(0, most)) {
    auto* link = new QCommandLinkButton(QFileInfo(path).fileName(), QFileInfo(path).path());
    explain(link, QFileInfo(path).fileName(), tr("Open %1").arg(path));
    link->setMinimumWidth(320);
    if (const QImage picture = recent_picture(path); !picture.isNull()) {
      link->setIcon(QIcon(QPixmap::fromImage(picture)));
      link->setIconSize(picture.size() / 2);
    }
    link->setFocusPolicy(Qt::TabFocus);
    connect(link, &QCommandLinkButton::clicked, this, [this, path] { Q_EMIT file_wanted(path); });
    recent_layout_->addWidget(link);
  }
}

}  // namespace loopmend
