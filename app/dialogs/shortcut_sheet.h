// SPDX-License-Identifier: GPL-3.0-or-later
// All keys on one sheet, made from the actions themselves, so that it cannot be wrong.
#pragma once

#include <QAction>
#include <QDialog>

#include <vector>

namespace loopmend {

class ShortcutSheet : public QDialog {
  Q_OBJECT

 public:
  struct Group {
    QString title;
    QList<QAction*> actions;
  };
  explicit ShortcutSheet(const std::vector<Group>& groups, QWidget* parent = nullptr);
};

}  // namespace loopmend
