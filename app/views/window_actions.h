// SPDX-License-Identifier: GPL-3.0-or-later
// Everything the window can be asked to do: names, keys, menus, toolbar, in one table.
#pragma once

#include <QAction>
#include <QObject>

#include <vector>

class QMainWindow;
class QMenu;

namespace loopmend {

class WindowActions : public QObject {
  Q_OBJECT

 public:
  explicit WindowActions(QMainWindow* window);

  QAction* operator[](const char* name) const;
  /// By names that blanks separate; null for a "-".
  QList<QAction*> all(const char* names) const;
  template <class Receiver, class Act>
  void on(const char* name, const Receiver* receiver, Act act) const {
    connect((*this)[name], &QAction::triggered, receiver, act);
  }

  void build_menus(const QList<QAction*>& docks);
  void build_toolbar();
  /// What applies to the selected holes; goes when it is closed.
  QMenu* make_hole_menu();
  /// Icons in the palette's ink.
  void update_icons();

  /// Filled by their owners.
  QMenu* recent_menu() const { return recent_; }
  QMenu* close_menu() const { return close_; }

  struct Group {
    QString title;
    QList<QAction*> actions;
  };
  /// As in the menus, for the sheet of shortcuts.
  const std::vector<Group>& groups() const { return groups_; }

 private:
  struct Spec;
  static const std::vector<Spec>& specs();
  /// In the bar, or to be put into this menu.
  QMenu* add_menu(const QString& title, const char* names, QMenu* in = nullptr);

  QMainWindow* window_;
  QMenu *recent_ = nullptr, *close_ = nullptr;
  std::vector<Group> groups_;
};

}  // namespace loopmend
