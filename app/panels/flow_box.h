// SPDX-License-Identifier: GPL-3.0-or-later
// Second part of the patch dock: which flow, to which boundary; watched, or time step by time step.
#pragma once

#include "jobs/fill_run.h"

#include <QGroupBox>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QSlider;

namespace loopmend {

class DecisionBox;
class QuietLabel;
class HoleSelection;
class FillController;

class FlowBox : public QGroupBox {
  Q_OBJECT

 public:
  FlowBox(const Document& document, const HoleSelection& selection, FillController& controller,
          QWidget* parent = nullptr);

  void step();
  void run_or_pause();
  EvolutionOptions options() const;
  /// What of it is chosen before a fill.
  QWidget* options_widget() const { return options_; }
  /// The recorded states and what plays them, under this box's title.
  void add_states(DecisionBox& of);
  void update_state();

 Q_SIGNALS:
  void compare_wanted();

 private:
  void build();
  double sigma() const;
  void evolve(Pace pace);

  const Document& document_;
  const HoleSelection& selection_;
  FillController& controller_;
  QuietLabel* target_ = nullptr;
  QWidget* options_ = nullptr;
  QGridLayout* rest_ = nullptr;
  QLabel* sigma_value_ = nullptr;
  QuietLabel* help_ = nullptr;
  QComboBox *flow_ = nullptr, *boundary_ = nullptr, *continuity_ = nullptr;
  QCheckBox *relief_ = nullptr, *edges_ = nullptr;
  QSlider* sigma_ = nullptr;
  QPushButton *step_ = nullptr, *steps_ = nullptr, *run_ = nullptr, *compare_ = nullptr;
};

}  // namespace loopmend
