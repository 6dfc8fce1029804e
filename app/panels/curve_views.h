// SPDX-License-Identifier: GPL-3.0-or-later
// The inspect dock's plots: how a run went, and how H runs through the seam.
#pragma once

#include "document/patch_state.h"

#include <QWidget>

class QLabel;
class QSlider;

namespace loopmend {

class Plot;
struct SectionProfile;

/// Energy and residual against the step.
class EnergyView : public QWidget {
  Q_OBJECT

 public:
  explicit EnergyView(QWidget* parent = nullptr);
  /// Null when there is nothing to show.
  void show_run(const OpenPatch* patch);
  Plot& plot() { return *plot_; }

 private:
  Plot* plot_;
};

/// H along a plane cut across one loop: in the patch and around it, before the flow and now.
class SectionView : public QWidget {
  Q_OBJECT

 public:
  explicit SectionView(QWidget* parent = nullptr);
  /// @param loop  which of the patch's loops. Null when there is nothing to show.
  void show_patch(const OpenPatch* patch, int loop);
  Plot& plot() { return *plot_; }

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void update_plot();
  void draw(const SectionProfile& profile, int graph_in, int graph_out);
  void draw_band(const Patch& patch, const SectionProfile& profile);

  Plot* plot_;
  QSlider* angle_;
  QLabel* angle_value_;
  PatchStatePtr now_, before_;
  int loop_ = 0;
};

}  // namespace loopmend
