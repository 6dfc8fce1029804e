// SPDX-License-Identifier: GPL-3.0-or-later
#include "dialogs/navigation_sheet.h"

#include "document/navigation.h"
#include "document/preferences.h"
#include "panels/parts.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace loopmend {
namespace {

QLabel* cell(const QString& text, QFont::Weight weight) {
  auto* label = new QLabel(text.isEmpty() ? QStringLiteral("\u2013") : text);
  label->setTextFormat(Qt::PlainText);
  QFont letters = label->font();
  letters.setWeight(weight);
  label->setFont(letters);
  return label;
}

}  // namespace

NavigationSheet::NavigationSheet(QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("navigationSheet"));
  setWindowTitle(tr("Navigation styles"));
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(24);
  grid->setVerticalSpacing(8);
  const std::pair<Motion, QString> motions[] = {{Motion::turn, tr("Turn")},
                                                {Motion::slide, tr("Move sideways")},
                                                {Motion::zoom, tr("Closer, further away")},
                                                {Motion::roll, tr("Roll")}};
  int row = 1;
  for (const auto& [motion, words] : motions) grid->addWidget(cell(words, QFont::DemiBold), row++, 0);
  grid->addWidget(cell(tr("Turning"), QFont::DemiBold), row, 0);
  const NavigationStyle now = load_navigation();
  int column = 1;
  for (NavigationStyle style : all_navigation_styles) {
    const QString name = style == now ? tr("%1 (chosen)").arg(name_of(style)) : name_of(style);
    grid->addWidget(cell(name, QFont::Bold), 0, column);
    row = 1;
    for (const auto& [motion, words] : motions) {
      QLabel* drags = cell(drags_for(style, motion).replace(QStringLiteral(", "), QStringLiteral("\n")), QFont::Normal);
      drags->setAlignment(Qt::AlignLeft | Qt::AlignTop);
      grid->addWidget(drags, row++, column);
    }
    const bool upright = navigation(style).turning == Turning::about_up;
    grid->addWidget(cell(upright ? tr("about the up axis") : tr("freely"), QFont::Normal), row, column);
    ++column;
  }
  auto* alike =
      new QLabel(tr("The same in every style: the wheel zooms to the cursor. A click with the left button selects a "
                    "boundary, with Ctrl it "
                    "adds one; a click with the right button opens the menu. Tools take the left button; Shift and the "
                    "left button turn "
                    "the picture with a tool in hand. \"Turn\" and the like are drags with this button held."));
  alike->setWordWrap(true);
  auto* buttons = make_dialog_buttons(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(22, 18, 22, 14);
  layout->setSpacing(16);
  layout->addLayout(grid);
  layout->addWidget(alike);
  layout->addWidget(buttons);
}

}  // namespace loopmend
