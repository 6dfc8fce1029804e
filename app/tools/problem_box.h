// SPDX-License-Identifier: GPL-3.0-or-later
// What all tools end with: which flow, try it, look at it, take it over or give it up.
#pragma once

#include "jobs/problem_controller.h"

#include <QGroupBox>

class QComboBox;
class QLabel;
class QPushButton;

namespace loopmend {

class ProblemBox : public QGroupBox {
  Q_OBJECT

 public:
  explicit ProblemBox(const ProblemController& trial, QWidget* parent = nullptr);

  EvolutionOptions options() const;
  /// @param wanting  what is still missing before anything can be tried, in words; empty: it can.
  void set_wanting(const QString& wanting);

 Q_SIGNALS:
  void preview_wanted();
  void evolve_wanted();
  void compare_wanted();
  void cancel_wanted();
  void accept_wanted();
  void discard_wanted();
  void copy_wanted();

 private:
  void update_state();

  const ProblemController& trial_;
  QString wanting_;
  QComboBox *flow_, *boundary_, *continuity_;
  QLabel* words_;
  QPushButton *preview_, *evolve_, *compare_, *cancel_, *accept_, *discard_, *copy_;
};

}  // namespace loopmend
