// SPDX-License-Identifier: GPL-3.0-or-later
#include "dialogs/shortcut_sheet.h"

#include "document/navigation.h"
#include "document/preferences.h"
#include "panels/parts.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

namespace loopmend {
namespace {

QString keys_of(const QAction& action) {
  QStringList keys;
  for (const QKeySequence& key : action.shortcuts()) keys << key.toString(QKeySequence::NativeText);
  return keys.join(ShortcutSheet::tr(" or "));
}

/// What works in the picture and the table without an action of its own.
QList<QPair<QString, QString>> gestures() {
  const NavigationStyle style = load_navigation();
  const auto drag = [style](Motion motion) { return ShortcutSheet::tr("Drag: %1").arg(drags_for(style, motion)); };
  return {{drag(Motion::turn), ShortcutSheet::tr("Turn")},
          {drag(Motion::slide), ShortcutSheet::tr("Move sideways")},
          {ShortcutSheet::tr("Wheel, +, \u2212"), ShortcutSheet::tr("Closer, further away")},
          {ShortcutSheet::tr("Arrow keys"), ShortcutSheet::tr("Turn by ten degrees")},
          {ShortcutSheet::tr("Shift+arrow keys"), ShortcutSheet::tr("Move sideways")},
          {ShortcutSheet::tr("Click on a boundary"), ShortcutSheet::tr("Select; with Ctrl, add")},
          {ShortcutSheet::tr("Double click on a boundary or row"), ShortcutSheet::tr("Fly there")},
          {ShortcutSheet::tr("Click on a surface"), ShortcutSheet::tr("Show the values at this point")},
          {ShortcutSheet::tr("Tab"), ShortcutSheet::tr("From control to control")},
          {ShortcutSheet::tr("Return in the table"), ShortcutSheet::tr("Fly to the hole")},
          {ShortcutSheet::tr("Menu key in the table"), ShortcutSheet::tr("Sort, choose columns")}};
}

QGridLayout* table(const QString& title, const QList<QPair<QString, QString>>& rows) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(16);
  grid->setVerticalSpacing(3);
  auto* heading = new QLabel(title);
  QFont bold = heading->font();
  bold.setBold(true);
  heading->setFont(bold);
  grid->addWidget(heading, 0, 0, 1, 2);
  int row = 1;
  for (const auto& [keys, what] : rows) {
    auto* key = new QLabel(keys);
    key->setTextFormat(Qt::PlainText);
    QFont strong = key->font();
    strong.setWeight(QFont::DemiBold);
    key->setFont(strong);
    grid->addWidget(key, row, 0);
    auto* words = new QLabel(what);
    words->setWordWrap(true);
    grid->addWidget(words, row++, 1);
  }
  grid->setColumnMinimumWidth(0, 120);
  grid->setColumnStretch(1, 1);
  return grid;
}

}  // namespace

ShortcutSheet::ShortcutSheet(const std::vector<Group>& groups, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("shortcutSheet"));
  setWindowTitle(tr("Keyboard shortcuts"));
  auto* columns = new QHBoxLayout;
  columns->setSpacing(36);
  auto* left = new QVBoxLayout;
  auto* right = new QVBoxLayout;
  for (QVBoxLayout* column : {left, right}) {
    column->setSpacing(16);
    columns->addLayout(column, 1);
  }
  int place = 0;
  for (const Group& group : groups) {
    QList<QPair<QString, QString>> rows;
    for (const QAction* action : group.actions)
      if (!action->shortcut().isEmpty()) rows << qMakePair(keys_of(*action), action->statusTip());
    if (!rows.isEmpty()) (place++ % 2 == 0 ? left : right)->addLayout(table(group.title, rows));
  }
  right->addLayout(table(tr("Mouse and keys in the picture"), gestures()));
  left->addStretch();
  right->addStretch();
  auto* buttons = make_dialog_buttons(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* all = new QWidget;
  columns->setContentsMargins(0, 0, 12, 0);
  all->setLayout(columns);
  auto* scrolled = new QScrollArea;
  scrolled->setFrameShape(QFrame::NoFrame);
  scrolled->setWidgetResizable(true);
  scrolled->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scrolled->setWidget(all);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(22, 18, 22, 14);
  layout->setSpacing(16);
  layout->addWidget(scrolled);
  layout->addWidget(buttons);
  // As large as it needs to be, or as the screen allows.
  const QMargins around = layout->contentsMargins();
  const QSize whole =
      all->sizeHint() + QSize(around.left() + around.right() + 4,
                              around.top() + around.bottom() + 4 + layout->spacing() + buttons->sizeHint().height());
  resize(whole.boundedTo(largest_window()));
}

}  // namespace loopmend
