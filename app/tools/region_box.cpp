// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/region_box.h"

#include "document/labels.h"
#include "panels/parts.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSlider>

namespace loopmend {

RegionBox::RegionBox(RegionTool& tool, QWidget* parent)
    : QWidget(parent),
      tool_(tool),
      brush_(make_option<QRadioButton>("regionBrush", tr("Brush"), tr("Paint the region with the left button"))),
      lasso_(make_option<QRadioButton>("regionLasso", tr("Lasso"), tr("Draw an outline around the region"))),
      add_(make_option<QRadioButton>("regionAdd", tr("Add"), tr("What is painted joins the region; Ctrl takes away"))),
      erase_(make_option<QRadioButton>("regionErase", tr("Take away"),
                                       tr("What is painted leaves the region; Ctrl adds"))),
      radius_(new QSlider(Qt::Horizontal)),
      hidden_(make_option<QCheckBox>("regionHidden", tr("Also what is hidden"),
                                     tr("The lasso takes what lies behind the surface as well"))),
      radius_title_(new QLabel(tr("Width of the brush"))),
      count_(make_note("regionCount")),
      grow_(make_button("regionGrow", tr("Grow"), tr("One ring of triangles more"))),
      shrink_(make_button("regionShrink", tr("Shrink"), tr("One ring of triangles less"))),
      clear_(make_button("regionClear", tr("Clear"), tr("Begin the region anew"))),
      erase_faces_(make_button("regionEraseFaces", tr("Erase"),
                               tr("Take the painted faces away, as at a ragged boundary; Ctrl+Z brings them back"))),
      refill_(make_button("regionRefill", tr("Erase and fill"),
                          tr("Take the painted faces away, a spike or a bump, and fill and smooth the hole that this "
                             "makes; one Ctrl+Z brings them back"))) {
  for (QPushButton* button : {grow_, shrink_, clear_}) button->setMinimumWidth(40);
  auto* hint = make_note(
      "regionHint",
      tr("Paint what shall become smooth, or be erased; everything else is held. Drag beside the surface, or with "
         "Shift, to turn the picture."));
  radius_->setRange(4, 120);
  radius_->setValue(24);
  explain(radius_, "regionRadius", tr("Width of the brush"), tr("How wide the brush is on the screen"));
  auto* means = new QButtonGroup(this);
  means->addButton(brush_);
  means->addButton(lasso_);
  auto* effect = new QButtonGroup(this);
  effect->addButton(add_);
  effect->addButton(erase_);
  brush_->setChecked(true);
  add_->setChecked(true);
  auto* grid = make_layout<QGridLayout>(this);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(6);
  grid->addWidget(hint, 0, 0, 1, 6);
  grid->addWidget(brush_, 1, 0, 1, 3);
  grid->addWidget(lasso_, 1, 3, 1, 3);
  grid->addWidget(add_, 2, 0, 1, 3);
  grid->addWidget(erase_, 2, 3, 1, 3);
  grid->addWidget(radius_title_, 3, 0, 1, 3);
  grid->addWidget(radius_, 3, 3, 1, 3);
  grid->addWidget(hidden_, 4, 0, 1, 6);
  grid->addWidget(grow_, 5, 0, 1, 2);
  grid->addWidget(shrink_, 5, 2, 1, 2);
  grid->addWidget(clear_, 5, 4, 1, 2);
  grid->addWidget(count_, 6, 0, 1, 6);
  grid->addWidget(erase_faces_, 7, 0, 1, 2);
  grid->addWidget(refill_, 7, 2, 1, 4);
  connect(brush_, &QRadioButton::toggled, this, [this](bool on) {
    tool_.set_means(on ? RegionTool::Means::brush : RegionTool::Means::lasso);
    update_state();
  });
  connect(add_, &QRadioButton::toggled, this,
          [this](bool on) { tool_.set_effect(on ? RegionTool::Effect::add : RegionTool::Effect::erase); });
  connect(radius_, &QSlider::valueChanged, this, [this](int pixels) { tool_.set_radius(pixels); });
  connect(hidden_, &QCheckBox::toggled, this,
          [this](bool on) { tool_.set_hidden(on ? ScreenPoints::Hidden::taken : ScreenPoints::Hidden::left_out); });
  connect(grow_, &QPushButton::clicked, &tool_, &RegionTool::grow);
  connect(shrink_, &QPushButton::clicked, &tool_, &RegionTool::shrink);
  connect(clear_, &QPushButton::clicked, &tool_, &RegionTool::clear);
  connect(erase_faces_, &QPushButton::clicked, this, &RegionBox::erase_wanted);
  connect(refill_, &QPushButton::clicked, this, &RegionBox::erase_and_fill_wanted);
  connect(&tool_, &RegionTool::changed, this, &RegionBox::update_state);
  update_state();
}

void RegionBox::update_state() {
  const bool brush = brush_->isChecked(), some = tool_.count() > 0;
  radius_->setVisible(brush);
  radius_title_->setVisible(brush);
  hidden_->setVisible(!brush);
  for (QPushButton* button : {grow_, shrink_, clear_, erase_faces_, refill_}) button->setEnabled(some);
  count_->setText(some ? tr("%1 vertices").arg(labels::count(static_cast<std::size_t>(tool_.count())))
                       : tr("Nothing is painted yet."));
}

}  // namespace loopmend
