// The right dock: fill, choose a flow, step, run, stop.
#pragma once

#include "document/document.h"
#include "jobs/workbench.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QGroupBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSlider;

namespace loopmend {

class HoleSelection;

class PatchPanel : public QWidget {
  Q_OBJECT

 public:
  PatchPanel(const Document& document, const HoleSelection& selection, Workbench& workbench, QWidget* parent = nullptr);

  void fill();
  void step();
  void run_or_pause();
  void to_steady_state();

 private:
  QWidget* build_fill();
  QWidget* build_flow();
  QWidget* build_progress();
  void connect_parts();
  void update_state();
  void update_live_figures(int moved_id = 0);
  void show_progress(int done, int total);

  std::set<int> loops_to_fill() const;
  std::set<int> patches_to_move() const;
  FlowKind flow() const;
  double sigma() const;
  void evolve(Pace pace);

  const Document& document_;
  const HoleSelection& selection_;
  Workbench& workbench_;
  QLabel *fill_target_ = nullptr, *flow_target_ = nullptr, *flow_help_ = nullptr, *sigma_value_ = nullptr;
  QLabel *stage_ = nullptr, *figures_ = nullptr;
  QDoubleSpinBox* density_ = nullptr;
  QComboBox* flow_ = nullptr;
  QSlider* sigma_ = nullptr;
  QPushButton *fill_ = nullptr, *step_ = nullptr, *run_ = nullptr, *steady_ = nullptr, *cancel_ = nullptr;
  QProgressBar* bar_ = nullptr;
};

}  // namespace loopmend
