// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/clipping_box.h"

#include "panels/parts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QSlider>
#include <QVBoxLayout>

namespace loopmend {

ClippingBox::ClippingBox(QWidget* parent)
    : QGroupBox(tr("Clipping plane"), parent),
      across_(new QComboBox),
      place_(new QSlider(Qt::Horizontal)),
      near_(make_option<QCheckBox>("clipNear", tr("Show the other side"),
                                   tr("Draw what lies before the plane in place of what lies behind it"))) {
  using Across = Clipping::Across;
  for (const auto& [text, across] : {std::pair{tr("Off"), Across::nothing},
                                     {tr("Across the line of sight"), Across::line_of_sight},
                                     {tr("Across x"), Across::x},
                                     {tr("Across y"), Across::y},
                                     {tr("Across z"), Across::z}})
    across_->addItem(text, static_cast<int>(across));
  explain(across_, "clipAcross", tr("Clipping plane"),
          tr("Cut the surfaces open, to see them from inside (X). Nothing is removed from the scan"));
  place_->setRange(0, 200);
  place_->setValue(100);
  explain(place_, "clipPlace", tr("Place of the plane"), tr("How far into the scene the plane lies"));
  auto* layout = new QVBoxLayout(this);
  for (QWidget* widget : {static_cast<QWidget*>(across_), static_cast<QWidget*>(place_), static_cast<QWidget*>(near_)})
    layout->addWidget(widget);
  // Chosen once more, the line of sight is that of now.
  connect(across_, QOverload<int>::of(&QComboBox::activated), this, &ClippingBox::change);
  connect(place_, &QSlider::valueChanged, this, &ClippingBox::change);
  connect(near_, &QCheckBox::toggled, this, &ClippingBox::change);
  change();
}

void ClippingBox::toggle() {
  const bool off = clipping_.across == Clipping::Across::nothing;
  across_->setCurrentIndex(static_cast<int>(off ? Clipping::Across::line_of_sight : Clipping::Across::nothing));
  change();
}

void ClippingBox::turn_off() {
  if (clipping_.across != Clipping::Across::nothing) toggle();
}

void ClippingBox::change() {
  clipping_.across = static_cast<Clipping::Across>(across_->currentData().toInt());
  clipping_.place = static_cast<double>(place_->value()) / place_->maximum();
  clipping_.drawn = near_->isChecked() ? Clipping::Side::in_front : Clipping::Side::behind;
  const bool on = clipping_.across != Clipping::Across::nothing;
  place_->setVisible(on);
  near_->setVisible(on);
  Q_EMIT clipping_changed(clipping_);
}

}  // namespace loopmend
