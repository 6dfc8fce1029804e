// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/measure_box.h"

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

MeasureBox::MeasureBox(MeasureTool& tool, QWidget* parent)
    : QWidget(parent),
      tool_(tool),
      distance_(new QLabel),
      parts_(make_note("measureParts")),
      copy_(make_button("measureCopy", tr("&Copy"), tr("Copy the distance to the clipboard"))) {
  auto* hint = make_note("measureHint");
  hint->setText(tr(
      "Click two points of a surface: the nearest vertices are taken. Drag beside the surface, or with Shift, to turn "
      "the picture. Esc begins anew."));
  distance_->setObjectName(QStringLiteral("measureDistance"));
  distance_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  distance_->setAccessibleName(tr("Distance"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(hint);
  layout->addWidget(distance_);
  layout->addWidget(parts_);
  layout->addWidget(copy_, 0, Qt::AlignLeft);
  connect(&tool_, &MeasureTool::changed, this, &MeasureBox::show_result);
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
  distance_->setText(tr("Distance: <b>%1</b>").arg(in_words(way->norm())));
  parts_->setText(tr("Along x %1, y %2, z %3; in the units of the scan.")
                      .arg(in_words(way->x()), in_words(way->y()), in_words(way->z())));
}

}  // namespace loopmend
