// SPDX-License-Identifier: GPL-3.0-or-later
// Which loops are selected and which one the mouse is over; shared by table, view and panels.
#pragma once

#include <QObject>

#include <set>

namespace loopmend {

inline constexpr int no_loop = -1;

class HoleSelection : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  const std::set<int>& selected() const { return selected_; }
  int hovered() const { return hovered_; }

  void select(const std::set<int>& loops);
  void toggle(int loop);
  void hover(int loop);
  void clear();

 Q_SIGNALS:
  void selection_changed();
  void hover_changed();

 private:
  std::set<int> selected_;
  int hovered_ = no_loop;
};

}  // namespace loopmend
