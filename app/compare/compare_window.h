// SPDX-License-Identifier: GPL-3.0-or-later
// Flows side by side: a window of its own, beside the main one.
#pragma once

#include "dialogs/picture_dialog.h"
#include "document/problem_commands.h"
#include "jobs/comparison_controller.h"
#include "scene/look.h"

#include <QElapsedTimer>
#include <QImage>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSlider;
class QStackedWidget;
class QToolButton;

namespace loopmend {

class Banner;
class CompareNumbers;
class FlowCanvas;
class FlowView;
class LegendStrip;
class PictureClock;

/// What a comparison is about, and what becomes of its winner.
struct CompareTask {
  ComparisonSource source;
  ProblemWords command;  ///< the same for a shell
  QString unit;          ///< "mm"; empty: not known
  QString accept_help;   ///< what taking a result over does, in words
  ComparedRunPtr
      filled{};  ///< the patch that closes the holes in the document; null: there is none, or it is of other holes
  std::function<QString(const ComparedRun& start, const ComparedRun& flow_run)>
      accept;  ///< does it. @returns what to tell the person
};

class CompareWindow : public QWidget {
  Q_OBJECT

 public:
  /// @param race  stays alive as long as the window.
  CompareWindow(ComparisonController& flow_comparison, CompareTask task, const Look& look, QWidget* parent = nullptr);

  void run();
  /// Now, or as soon as the start is there.
  void run_when_ready();
  /// Shows how far each view is from this mesh.
  void measure_from_mesh(const QString& path);
  /// All views; with captions and the legend unless the surfaces alone are wanted. Null when the graphics cannot.
  QImage picture(const PictureOptions& options);
  /// The table into `path`; curves and profiles beside it. @returns what was written, in words. @throws WriteError
  QString save_numbers(const QString& path) const;
  /// For the next comparison.
  void keep_place() const;
  const ComparisonController& flow_comparison() const { return flow_comparison_; }
  FlowView& flow_view(int number) { return *flow_views_[number]; }
  FlowCanvas& wipe() { return *wipe_; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* build_run_bar();
  QWidget* build_look_bar();
  QWidget* build_wipe_bar();
  QWidget* build_views();
  void build_from();
  void wire();
  void set_view_count(int count);
  void choose_flow(int flow_run, FlowKind flow);
  void arrange();
  void update_all();
  void update_flow_run(int flow_run);
  void update_use();
  void update_wait();
  void update_range();
  void apply_look();
  void choose_from();
  void measure();
  double range_of_distances() const;
  void face_patch();
  void frame();
  void follow(FlowCanvas& leader);
  void update_wipe();
  void accept(int flow_run);
  void ask_picture();
  void ask_numbers();
  void copy_command();
  EvolutionOptions options() const;
  std::vector<FlowCanvas*> canvases() const;

  ComparisonController& flow_comparison_;
  CompareTask task_;
  Look look_;
  PictureClock* clock_;
  double range_ = 1;
  QElapsedTimer running_;
  bool faced_ = false, run_soon_ = false, was_ready_ = false;
  std::vector<FlowView*> flow_views_;
  FlowCanvas* wipe_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  QGridLayout* grid_ = nullptr;
  LegendStrip* legend_ = nullptr;
  CompareNumbers* numbers_ = nullptr;
  Banner* banner_ = nullptr;
  QPushButton *run_ = nullptr, *stop_ = nullptr, *save_picture_ = nullptr, *save_numbers_ = nullptr, *copy_ = nullptr;
  QString mesh_;  ///< that distances are from; empty: none was chosen
  QComboBox *mode_ = nullptr, *count_ = nullptr, *shading_ = nullptr, *from_ = nullptr, *left_ = nullptr,
            *right_ = nullptr;
  QSlider *sigma_ = nullptr, *stripes_ = nullptr;
  QLabel *sigma_value_ = nullptr, *wait_ = nullptr;
  QCheckBox *edges_ = nullptr, *seams_ = nullptr, *linked_ = nullptr, *wiping_ = nullptr, *own_range_ = nullptr;
  QDoubleSpinBox* half_width_ = nullptr;
};

}  // namespace loopmend
