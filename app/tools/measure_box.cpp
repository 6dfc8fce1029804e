// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/measure_box.h"

#include "document/labels.h"
#include "panels/parts.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace loopmend {
namespace {

QString in_words(double length) { return QLocale().toString(length, 'g', 6); }

}  // namespace

MeasureBox::MeasureBox(const Document& document, MeasureTool& tool, QWidget* parent)
    : QWidget(parent),
      document_(document),
      tool_(tool),
      distance_(new QLabel),
      parts_(make_note("measureParts")),
      copy_(make_button("measureCopy", tr("Copy"), tr("Copy the distance to the clipboard"))) {
  auto* hint = make_note("measureHint", tr("Click two points of a surface: the nearest vertices are taken. Drag beside "
                                           "the surface, or with Shift, to turn "
                                           "the picture. Esc starts again."));
  distance_->setObjectName(QStringLiteral("measureDistance"));
  distance_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  distance_->setAccessibleName(tr("Distance"));
  auto* layout = make_layout<QVBoxLayout>(this);
  layout->addWidget(hint);
  layout->addWidget(distance_);
  layout->addWidget(parts_);
  layout->addWidget(copy_, 0, Qt::AlignLeft);
  connect(&tool_, &MeasureTool::changed, this, &MeasureBox::show_result);
  connect(&document_, &Document::units_changed, this, &MeasureBox::show_result);
  connect(copy_, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(QLocale::c().toString(tool_.way()->norm(), 'g', 17)); });
  show_result();
}

void MeasureBox::show_result() {
  const std::optional<Vec3> way = tool_.way();
  copy_->setEnabled(way.has_value());
  if (!way) {
    distance_->setText(tr("Distance: not known yet"));
    parts_->setText(QString());
    return;
  }
  const std::string unit = document_.unit();
  distance_->setText(
      tr("Distance: <b>%1</b>").arg((in_words(way->norm()) + QLatin1Char(' ') + labels::unit_symbol(unit)).trimmed()));
  const QString along = tr("Along x %1, y %2, z %3").arg(in_words(way->x()), in_words(way->y()), in_words(way->z()));
  parts_->setText(unit.empty() ? tr("%1; in the units of the scan.").arg(along)
                               : tr("%1; in %2.").arg(along, labels::unit_name(unit)));
}

}  // namespace loopmend
