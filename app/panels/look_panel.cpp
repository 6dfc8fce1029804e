// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/look_panel.h"

#include "panels/choices.h"
#include "panels/parts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QPainter>
#include <QScopedValueRollback>
#include <QSlider>
#include <QVBoxLayout>

namespace loopmend {
namespace {

QIcon map_icon(ColorMap map) {
  constexpr int width = 72, height = 14;
  QPixmap picture(width, height);
  QPainter painter(&picture);
  for (int x = 0; x < width; ++x) {
    const Rgb c = color_at(map, static_cast<double>(x) / (width - 1));
    painter.setPen(QColor::fromRgbF(c[0], c[1], c[2]));
    painter.drawLine(x, 0, x, height);
  }
  return QIcon(picture);
}

QString shading_help(Shading shading) {
  switch (shading) {
    case Shading::curvature: return LookPanel::tr("Mean curvature H: a patch that fits continues the scan's colours.");
    case Shading::gaussian: return LookPanel::tr("Gaussian curvature K: domes and bowls against saddles.");
    case Shading::plain: return LookPanel::tr("One colour; patches in another, so that they are found.");
    case Shading::zebra:
      return LookPanel::tr("Reflected stripes: broken where tangents jump, kinked where the curvature jumps.");
    case Shading::isophotes:
      return LookPanel::tr("Bands of equal brightness: they stay when you move closer, and kink where tangents jump.");
    case Shading::scan:
      return LookPanel::tr(
          "The scan's own colours or texture. Patches continue the colours smoothly; the grain of a texture is painted "
          "on export.");
    case Shading::deviation:
      return LookPanel::tr(
          "How far each point of a patch is likely from what was there. Known after a fill with the default boundary; "
          "an "
          "estimate, calibrated on holes that were cut into whole models.");
    case Shading::difference: break;  // of comparisons
  }
  return {};
}

}  // namespace

QString color_map_name(ColorMap map) {
  switch (map) {
    case ColorMap::blue_orange: return LookPanel::tr("Blue, orange");
    case ColorMap::purple_green: return LookPanel::tr("Purple, green");
    case ColorMap::brown_teal: return LookPanel::tr("Brown, teal");
    case ColorMap::grey: return LookPanel::tr("Grey");
  }
  return {};
}

LookPanel::LookPanel(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("lookPanel"));
  build();
  show_look();
}

void LookPanel::build() {
  shading_ = make_shading_choice("shading", tr("How surfaces are shown (keys 1 to 7)"));
  shading_->addItem(tr("Scan colours"), static_cast<int>(Shading::scan));
  shading_->addItem(tr("Likely error"), static_cast<int>(Shading::deviation));
  help_ = make_note("shadingHelp");
  auto* shading_box = new QGroupBox(tr("Shading"));
  auto* shading_layout = new QVBoxLayout(shading_box);
  shading_layout->addWidget(shading_);
  shading_layout->addWidget(help_);

  stripes_ = new QSlider(Qt::Horizontal);
  stripes_->setRange(3, 40);
  explain(stripes_, "stripes", tr("Stripes"), tr("How many stripes or bands there are"));
  auto* striped = new QGroupBox(tr("Stripes"));
  auto* striped_layout = new QVBoxLayout(striped);
  striped_layout->addWidget(stripes_);
  striped_ = striped;

  edges_ = new QCheckBox(tr("Wireframe: the triangles' edges"));
  explain(edges_, "showEdges", tr("Wireframe"), tr("Draw the triangles' edges (W)"));
  seams_ = new QCheckBox(tr("Boundaries and seams as lines"));
  explain(seams_, "showSeams", tr("Boundaries and seams"),
          tr("Draw the boundaries of holes and the seams of patches (M)"));
  tint_ = new QCheckBox(tr("Tint on the patches"));
  explain(tint_, "showTint", tr("Tint on the patches"),
          tr("Draw patches greener than the scan; over the colours of curvature as a hatching (Shift+T)"));
  auto* overlays = new QGroupBox(tr("Drawn over it"));
  auto* overlay_layout = new QVBoxLayout(overlays);
  overlay_layout->addWidget(edges_);
  overlay_layout->addWidget(seams_);
  overlay_layout->addWidget(tint_);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 6, 8, 8);
  layout->setSpacing(8);
  layout->addWidget(shading_box);
  layout->addWidget(build_colors());
  layout->addWidget(striped_);
  layout->addWidget(overlays);
  clipping_ = new ClippingBox;
  layout->addWidget(clipping_);
  layout->addStretch(1);
  for (QComboBox* box : {shading_, map_, rule_})
    connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &LookPanel::change);
  for (QDoubleSpinBox* box : {percent_, half_width_})
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &LookPanel::change);
  for (QCheckBox* box : {edges_, seams_, tint_}) connect(box, &QCheckBox::toggled, this, &LookPanel::change);
  connect(stripes_, &QSlider::valueChanged, this, &LookPanel::change);
}

QWidget* LookPanel::build_colors() {
  map_ = new QComboBox;
  map_->setIconSize(QSize(72, 14));
  for (ColorMap map : all_color_maps) map_->addItem(map_icon(map), color_map_name(map), static_cast<int>(map));
  explain(map_, "colorMap", tr("Colours"), tr("Each is distinct for every kind of colour vision"));
  rule_ = new QComboBox;
  rule_->setObjectName(QStringLiteral("rangeRule"));
  rule_->addItem(tr("Percentile, all scans alike"), static_cast<int>(ColorRange::Rule::percentile));
  rule_->addItem(tr("Percentile of each scan"), static_cast<int>(ColorRange::Rule::percentile_each));
  rule_->addItem(tr("Own range"), static_cast<int>(ColorRange::Rule::own));
  explain(
      rule_, tr("Range"),
      tr("How far the colours reach. The range is symmetric about 0 and comes from the scans alone, so it stays the "
         "same while a flow runs. Several scans share the widest range, or each has its own; the legend then shows "
         "that of the selected hole's scan"));
  percent_ = new QDoubleSpinBox;
  percent_->setRange(50, 100);
  percent_->setDecimals(1);
  percent_->setSuffix(QStringLiteral(" %"));
  percent_->setKeyboardTracking(false);
  explain(percent_, "percentile", tr("Percentile"), tr("This share of the scan's values lies within the range"));
  half_width_ = new QDoubleSpinBox;
  half_width_->setRange(1e-6, 1e9);
  half_width_->setDecimals(4);
  half_width_->setPrefix(QStringLiteral("\u00b1 "));
  half_width_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  half_width_->setKeyboardTracking(false);
  explain(half_width_, "ownRange", tr("Own range"), tr("The curvature at the ends of the colours"));
  auto* box = new QGroupBox(tr("Colours"));
  auto* form = new QVBoxLayout(box);
  for (QWidget* widget : {static_cast<QWidget*>(map_), static_cast<QWidget*>(rule_), static_cast<QWidget*>(percent_),
                          static_cast<QWidget*>(half_width_)})
    form->addWidget(widget);
  colors_ = box;
  return box;
}

void LookPanel::show_look() {
  const QScopedValueRollback guard(syncing_, true);
  const bool colored = is_colored(look_.shading);
  const bool own = look_.range().rule == ColorRange::Rule::own;
  shading_->setCurrentIndex(shading_->findData(static_cast<int>(look_.shading)));
  help_->setText(shading_help(look_.shading));
  map_->setCurrentIndex(map_->findData(static_cast<int>(look_.map)));
  rule_->setCurrentIndex(rule_->findData(static_cast<int>(look_.range().rule)));
  percent_->setValue(look_.range().percent);
  half_width_->setValue(look_.range().half_width);
  const bool has_sign = !begins_at_zero(look_.shading);
  rule_->setVisible(has_sign);
  percent_->setVisible(has_sign && !own);
  half_width_->setVisible(has_sign && own);
  edges_->setChecked(look_.edges == Edges::shown);
  seams_->setChecked(look_.seams == Seams::shown);
  tint_->setChecked(look_.tint == Tint::patches);
  tint_->setEnabled(!colors_patches_alone(look_.shading));
  stripes_->setValue(look_.stripes);
  colors_->setVisible(colored);
  striped_->setVisible(look_.shading == Shading::zebra || look_.shading == Shading::isophotes);
}

void LookPanel::change() {
  if (syncing_) return;
  const bool was_own = look_.range().rule == ColorRange::Rule::own;
  look_.shading = static_cast<Shading>(shading_->currentData().toInt());
  if (sender() != shading_) {
    look_.range().rule = static_cast<ColorRange::Rule>(rule_->currentData().toInt());
    look_.range().percent = percent_->value();
    look_.range().half_width = half_width_->value();
    if (look_.range().rule == ColorRange::Rule::own && !was_own) look_.range().half_width = range_in_force_;
  }
  look_.map = static_cast<ColorMap>(map_->currentData().toInt());
  look_.edges = edges_->isChecked() ? Edges::shown : Edges::hidden;
  look_.seams = seams_->isChecked() ? Seams::shown : Seams::hidden;
  look_.tint = tint_->isChecked() ? Tint::patches : Tint::none;
  look_.stripes = stripes_->value();
  show_look();
  Q_EMIT look_changed(look_);
}

void LookPanel::set_look(const Look& look) {
  look_ = look;
  show_look();
  Q_EMIT look_changed(look_);
}

void LookPanel::know_range(double half_width) { range_in_force_ = half_width; }

}  // namespace loopmend
