// SPDX-License-Identifier: GPL-3.0-or-later
// A plot in the palette's colours, quiet and readable; what the inspect dock's two plots share.
#pragma once

#include <QColor>
#include <QVector>
#include <QWidget>

class QCPAxis;
class QCPGraph;
class QCustomPlot;
class QLabel;

namespace loopmend {

/// Distinct for every kind of colour vision, on light and on dark ground: 0 blue, 1 orange, 2 grey, 3 green.
enum class PlotGround { light, dark };
QColor plot_ink(int ink, PlotGround ground);

class Plot : public QWidget {
  Q_OBJECT

 public:
  Plot(const char* name, const QString& accessible_name, QWidget* parent = nullptr);

  enum class Scale { linear, logarithmic };
  enum class Side { left, right };
  enum class Line { solid, faint, dotted, band };

  void set_axis(Side side, Scale scale);
  /// The lower axis counts: ticks at whole numbers only.
  void count_along();
  void set_axis_name(Side side, const QString& name);
  void set_name_below(const QString& name);
  /// @param ink  see plot_ink(). @returns the graph's index.
  int add_graph(Side side, const QString& name, Line line, int ink);
  /// Tints what lies between two graphs, in the colour of the first; they leave the legend's lines and the fit of the axis
  /// alone.
  void make_band(int low, int high);
  void set_name(int graph, const QString& name);  ///< empty: not in the legend
  /// Its values do not decide how far the axis reaches.
  void leave_out_of_fit(int graph);
  /// NaN breaks the line.
  void set_data(int graph, const QVector<double>& x, const QVector<double>& y);
  QVector<double> values(int graph) const;
  void set_marker(double x);
  void hide_marker();
  /// In words, instead of the plot.
  void show_words(const QString& words);
  void redraw();
  bool save(const QString& path) const;

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QCPAxis* axis(Side side) const;
  void take_colors();
  void lay_out_legend();
  void show_axes();
  void fit();
  void fit_axis(Side side);

  struct Ink {
    Line line;
    int ink;
    bool counts = true;  ///< for the fit of the axis
  };
  QCustomPlot* plot_;
  QVector<Ink> inks_;
  QLabel* words_ = nullptr;
};

}  // namespace loopmend
