// SPDX-License-Identifier: GPL-3.0-or-later
// The docks of the window, which are put away with the tool bar while nothing is open, and have a title only where no tab has it.
#pragma once

#include <QByteArray>
#include <QList>
#include <QObject>
#include <QTimer>

class QAction;
class QDockWidget;
class QMainWindow;

namespace loopmend {

class Docks : public QObject {
  Q_OBJECT

 public:
  explicit Docks(QMainWindow* window);

  QDockWidget* add(const char* name, const QString& title, QWidget* content, Qt::DockWidgetArea area);
  /// Each shows or hides one.
  const QList<QAction*>& toggles() const { return toggles_; }
  /// While nothing is open: none of them has anything to show.
  void put_away(bool away);
  bool are_away() const { return !kept_.isEmpty(); }
  /// As they lie, or lay before they were put away.
  QByteArray state() const;
  void restore(const QByteArray& state);

 private:
  void update_titles();

  QMainWindow* window_;
  QList<QDockWidget*> docks_;
  QList<QAction*> toggles_;
  QByteArray kept_;      ///< while they are put away
  QByteArray at_first_;  ///< for one that was kept and cannot be read
  QTimer soon_{this};
};

}  // namespace loopmend
