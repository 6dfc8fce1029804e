// SPDX-License-Identifier: GPL-3.0-or-later
// Every command of the menus, found by typing: some letters of its words, in their order.
#pragma once

#include <QDialog>
#include <QList>

#include <vector>

class QAction;
class QLineEdit;
class QListWidget;

namespace loopmend {

/// How well the typed text fits a command: each of its words has to be found. The start of a word counts more than its
/// middle, letters with gaps between them least. @returns 0 where it does not fit.
int fit_of(const QString& typed, const QString& command);

class CommandPalette : public QDialog {
  Q_OBJECT

 public:
  struct Group {
    QString title;
    QList<QAction*> actions;
  };
  CommandPalette(const std::vector<Group>& groups, QWidget* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void find();
  void run();

  struct Entry {
    QAction* action = nullptr;
    QString text, group;
  };
  std::vector<Entry> entries_;
  QLineEdit* typed_;
  QListWidget* found_;
};

}  // namespace loopmend
