#include "panels/welcome.h"

#include "panels/icons.h"
#include "panels/quiet_label.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace loopmend {

Welcome::Welcome(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("welcome"));
  setAutoFillBackground(true);
  auto* picture = new QLabel;
  picture->setPixmap(application_icon().pixmap(96, 96));
  auto* title = new QLabel(tr("Open a scan, or drop one here"));
  QFont large = title->font();
  large.setPointSizeF(large.pointSizeF() * 1.6);
  title->setFont(large);
  auto* formats = new QuietLabel(tr("PLY, STL, OBJ or OFF"));
  auto* open = new QPushButton(tr("Open\u2026"));
  open->setObjectName(QStringLiteral("welcomeOpen"));
  open->setToolTip(tr("Choose a file (Ctrl+O)"));
  open->setDefault(true);
  auto* sample = new QPushButton(tr("Try the sample"));
  sample->setObjectName(QStringLiteral("welcomeSample"));
  sample->setToolTip(tr("A small made-up scan with five holes"));
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
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(8);
  layout->addStretch(4);
  layout->addWidget(picture, 0, Qt::AlignHCenter);
  layout->addSpacing(10);
  layout->addWidget(title, 0, Qt::AlignHCenter);
  layout->addWidget(formats, 0, Qt::AlignHCenter);
  layout->addSpacing(14);
  layout->addLayout(buttons);
  layout->addStretch(5);
}

}  // namespace loopmend
