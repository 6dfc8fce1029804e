// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/gallery.h"

#include "panels/parts.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QIcon>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace loopmend {
namespace {

constexpr int most_columns = 5;
constexpr int spacing = 4;
const QSize picture_size(102, 72);

// So that the translations know them: the examples themselves know no Qt.
[[maybe_unused]] const char* const words[] = {
    QT_TRANSLATE_NOOP("loopmend::Gallery", "Cylinder"),
    QT_TRANSLATE_NOOP("loopmend::Gallery", "Sphere"),
    QT_TRANSLATE_NOOP("loopmend::Gallery", "Three tubes"),
    QT_TRANSLATE_NOOP("loopmend::Gallery", "Six tubes"),
    QT_TRANSLATE_NOOP("loopmend::Gallery", "T piece"),
    QT_TRANSLATE_NOOP("loopmend::Gallery", "Head"),
    QT_TRANSLATE_NOOP("loopmend::Gallery", "Dodecahedron"),
    QT_TRANSLATE_NOOP("loopmend::Gallery", "Flows, tubes"),
    QT_TRANSLATE_NOOP("loopmend::Gallery", "Flows, graph"),
    QT_TRANSLATE_NOOP("loopmend::Gallery", "A cylinder with parts missing"),
    QT_TRANSLATE_NOOP("loopmend::Gallery", "A wire-frame of a sphere with eight openings"),
    QT_TRANSLATE_NOOP("loopmend::Gallery", "Three tubes that form a T"),
    QT_TRANSLATE_NOOP("loopmend::Gallery", "A head-like mesh with holes in nose, face and jaw"),
    QT_TRANSLATE_NOOP("loopmend::Gallery", "A dodecahedron"),
    QT_TRANSLATE_NOOP("loopmend::Gallery", "MMCVF, SDF and WF on the six tubes"),
    QT_TRANSLATE_NOOP("loopmend::Gallery", "The graph of a function: MCF, SDF, WF and MMCVF"),
};

}  // namespace

QString example_name(const PaperExample& example) {
  return QCoreApplication::translate("loopmend::Gallery", example.short_name);
}

QString example_title(const PaperExample& example) {
  return QCoreApplication::translate("loopmend::Gallery", example.title);
}

Gallery::Gallery(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("gallery"));
  grid_ = new QGridLayout(this);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setSpacing(spacing);
  for (const PaperExample& example : paper_examples()) {
    const QString id = QString::fromLatin1(example.id);
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("example_") + id);
    button->setText(example_name(example));
    button->setIcon(QIcon(QStringLiteral(":/gallery/%1.png").arg(id)));
    button->setIconSize(picture_size);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setAutoRaise(true);
    button->setFixedWidth(picture_size.width() + 10);
    explain(button, example_title(example),
            tr("%1. A click opens it, a second one runs it").arg(example_title(example)));
    connect(button, &QToolButton::clicked, this, [this, id] { Q_EMIT example_wanted(id); });
    buttons_ << button;
  }
  place(most_columns);
}

void Gallery::lay_out(int width) {
  const int each = buttons_.front()->minimumWidth() + spacing;
  place(std::clamp((width + spacing) / each, 1, most_columns));
}

void Gallery::place(int columns) {
  if (std::exchange(columns_, columns) == columns) return;
  for (int k = 0; k < buttons_.size(); ++k) grid_->addWidget(buttons_[k], k / columns, k % columns);
}

}  // namespace loopmend
