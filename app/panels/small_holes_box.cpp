// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/small_holes_box.h"

#include "panels/parts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <cmath>

namespace loopmend {

SmallHolesBox::SmallHolesBox(Document& document, QWidget* parent) : QWidget(parent), document_(document) {
  build();
  connect(measure_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    propose_limit();
    update_state();
  });
  connect(limit_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &SmallHolesBox::update_state);
  connect(fill_, &QPushButton::clicked, this, [this] { Q_EMIT fill_wanted(meant()); });
  connect(outer_rims_, &QCheckBox::toggled, this,
          [this](bool on) { document_.set_outer_rims(on ? OuterRims::include : OuterRims::leave); });
  connect(&document_, &Document::scans_changed, this, [this] {
    propose_limit();
    update_state();
  });
  connect(&document_, &Document::opened, this, &SmallHolesBox::update_state);
  connect(&document_, &Document::holes_changed, this, &SmallHolesBox::update_state);
  connect(&document_, &Document::patches_changed, this, &SmallHolesBox::update_state);
  update_state();
}

void SmallHolesBox::build() {
  auto* grid = make_layout<QGridLayout>(this);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(6);
  auto* label = new QLabel(tr("Fill all up to"));
  limit_ = new QDoubleSpinBox;
  limit_->setRange(0, 1e9);
  limit_->setDecimals(0);
  limit_->setValue(100);
  explain(limit_, "sizeLimit", tr("Largest size"), tr("Holes up to this size are meant"));
  label->setBuddy(limit_);
  measure_ = new QComboBox;
  measure_->addItem(tr("edges"), static_cast<int>(SizeMeasure::edges));
  measure_->addItem(tr("diameter"), static_cast<int>(SizeMeasure::diameter));
  explain(measure_, "sizeMeasure", tr("Measure"),
          tr("What the size of a hole is: edges along its boundary, or its diameter in the scan's unit"));
  fill_ = make_button("fillUpTo", tr("Fill"), tr("Fill every open hole up to this size"));
  outer_rims_ = new QCheckBox;
  explain(outer_rims_, "includeRims", tr("Include outer rims"),
          tr("The outline of an open sheet looks like a hole to a program. It is left out unless you include it here, "
             "or select it yourself"));
  grid->addWidget(label, 0, 0);
  grid->addWidget(limit_, 0, 1);
  grid->addWidget(measure_, 0, 2);
  grid->addWidget(fill_, 1, 0, 1, 3);
  grid->addWidget(outer_rims_, 2, 0, 1, 3);
  grid->setColumnStretch(1, 1);
}

SizeMeasure SmallHolesBox::measure() const { return static_cast<SizeMeasure>(measure_->currentData().toInt()); }

std::set<int> SmallHolesBox::meant() const { return loops_up_to(document_, measure(), limit_->value()); }

/// The size of the largest hole, so that the first press fills all; a person turns it down from there.
void SmallHolesBox::propose_limit() {
  double largest = 0;
  for (int loop = 0; loop < document_.loop_count(); ++loop) {
    if (!document_.fillable(loop)) continue;
    const BoundaryLoop& l = document_.loop(loop);
    largest = std::max(largest, measure() == SizeMeasure::edges ? l.edges() : l.diameter);
  }
  if (measure() == SizeMeasure::edges) {
    limit_->setDecimals(0);
    limit_->setSingleStep(10);
    limit_->setValue(largest > 0 ? largest : 100);
    return;
  }
  const double decade = largest > 0 ? std::floor(std::log10(largest)) : 0;
  limit_->setDecimals(std::clamp(2 - static_cast<int>(decade), 0, 9));
  limit_->setSingleStep(std::pow(10.0, decade - 1));
  limit_->setValue(largest > 0 ? 1.005 * largest : 1);
}

void SmallHolesBox::set_use(Use use) {
  use_ = use;
  update_state();
}

void SmallHolesBox::update_state() {
  int outer_rims = 0, open = 0;
  for (int loop = 0; loop < document_.loop_count(); ++loop) {
    if (!document_.present(loop)) continue;
    outer_rims += document_.loop(loop).kind == LoopKind::outer_rim;
    open += document_.fillable(loop) && !document_.patch_of(loop);
  }
  const int count = static_cast<int>(meant().size());
  const bool idle = use_ == Use::possible;
  fill_->setText(open > 0 ? tr("Fill %L1 of %L2").arg(count).arg(open) : tr("Fill"));
  fill_->setEnabled(idle && count > 0);
  limit_->setEnabled(idle && open > 0);
  measure_->setEnabled(idle && open > 0);
  outer_rims_->setEnabled(idle && outer_rims > 0);
  outer_rims_->setText(outer_rims > 0 ? tr("Include outer rims of open sheets (%L1)").arg(outer_rims)
                                      : tr("Include outer rims of open sheets (none here)"));
  outer_rims_->setChecked(document_.outer_rims() == OuterRims::include);
}

}  // namespace loopmend
