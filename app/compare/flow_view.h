// SPDX-License-Identifier: GPL-3.0-or-later
// One view of a comparison: which flow, its figures, its picture, and the button that takes it over.
#pragma once

#include "jobs/comparison_controller.h"
#include "scene/shape_glide.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;

namespace loopmend {

class FlowCanvas;
class PictureClock;

class FlowView : public QWidget {
  Q_OBJECT

 public:
  FlowView(int number, PictureClock& clock, QWidget* parent = nullptr);

  void show_flow(FlowKind flow);
  /// @param accepting  what taking it over would do, in words; empty: it cannot be taken over.
  void show_flow_run(const ComparedRun& flow_run, const QString& accepting);
  enum class Use { open, running };
  void set_use(Use use);
  FlowCanvas& canvas() { return *canvas_; }
  QString caption() const;

 Q_SIGNALS:
  void flow_chosen(FlowKind flow);
  void accept_wanted();

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void update_swatch();
  void fit_figures();

  QComboBox* flow_;
  QLabel *swatch_, *figures_;
  QPushButton* accept_;
  FlowCanvas* canvas_;
  QString words_;
  bool can_accept_ = false;
};

/// How a picture comes to this state: a flow at work moves on evenly.
Arrival arrival_of(const ComparedRun& flow_run);

/// The colour that stands for a flow in plots and headings; see plot_ink().
int ink_of(FlowKind flow);

}  // namespace loopmend
