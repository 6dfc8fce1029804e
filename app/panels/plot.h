// A plot in the palette's colours, quiet and readable; what the inspect dock's two plots share.
#pragma once

#include <QPointer>
#include <QVector>
#include <QWidget>

class QCPAxis;
class QCPGraph;
class QCustomPlot;

namespace loopmend {

class Plot : public QWidget {
  Q_OBJECT

 public:
  Plot(const char* name, const QString& accessible_name, QWidget* parent = nullptr);

  enum class Scale { linear, logarithmic };
  enum class Side { left, right };
  enum class Line { solid, faint, dotted };

  void set_axis(Side side, Scale scale);
  /// @returns the graph's index.
  int add_graph(Side side, const QString& name, Line line, int ink);
  void set_name(int graph, const QString& name);
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

 private:
  QCPAxis* axis(Side side) const;
  void take_colors();
  void fit();
  void fit_axis(Side side);

  struct Ink {
    Line line;
    int ink;
  };
  QCustomPlot* plot_;
  QVector<Ink> inks_;
  QString words_;
};

}  // namespace loopmend
