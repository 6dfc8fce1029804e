// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cut_box.h"

#include "panels/parts.h"
#include "repair/plane_cut.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace loopmend {

CutBox::CutBox(CutGuide& guide, FillController& controller, QWidget* parent)
    : QWidget(parent),
      guide_(guide),
      controller_(controller) {
  auto* layout = make_layout<QVBoxLayout>(this);
  layout->addWidget(make_note("cutHint", tr("What lies on the side of the orange arrow goes, and the section is closed "
                                            "flat. Drag the blue dot to move the plane, a white one to turn it.")));
  auto* grid = new QGridLayout;
  layout->addLayout(grid);
  const char* names[] = {"cutX", "cutY", "cutZ"};
  const QString texts[] = {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
  for (int axis = 0; axis < 3; ++axis) {
    auto* button = make_button(names[axis], tr("Across %1").arg(texts[axis]),
                               tr("Put the plane square to this axis, through the middle of the scan"));
    connect(button, &QPushButton::clicked, this, [this, axis] { guide_.place_across(axis); });
    grid->addWidget(button, 0, axis);
    buttons_.push_back(button);
  }
  auto* turn = make_button("cutTurn", tr("Other side"), tr("Remove the other side, and keep this one"));
  connect(turn, &QPushButton::clicked, &guide_, &CutGuide::turn);
  auto* cut = make_button("cutApply", tr("Cut"), tr("Remove this side and close the section; Ctrl+Z takes it back"));
  connect(cut, &QPushButton::clicked, this, [this] {
    controller_.cut_by_plane(guide_.scan(), make_cut_plane(guide_.plane()->point, guide_.plane()->normal));
  });
  grid->addWidget(turn, 1, 0);
  grid->addWidget(cut, 1, 1, 1, 2);
  buttons_.insert(buttons_.end(), {turn, cut});
  connect(&guide_, &CutGuide::changed, this, &CutBox::follow);
  connect(&controller_, &FillController::activity_changed, this, &CutBox::follow);
  follow();
}

void CutBox::follow() {
  for (QPushButton* button : buttons_) button->setEnabled(guide_.plane() && !controller_.busy());
}

}  // namespace loopmend
