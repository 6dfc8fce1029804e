// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/plot.h"

#include "panels/parts.h"
#include "panels/plot_library.h"
#include "panels/quiet_label.h"

#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace loopmend {
QColor plot_ink(int ink, PlotGround ground) {
  static const std::array<std::array<QColor, 2>, 4> colors{{{QColor(0, 92, 168), QColor(110, 180, 245)},
                                                            {QColor(190, 88, 0), QColor(250, 165, 80)},
                                                            {QColor(96, 100, 108), QColor(168, 172, 180)},
                                                            {QColor(0, 128, 96), QColor(80, 205, 165)}}};
  return colors[ink][ground == PlotGround::dark ? 1 : 0];
}

Plot::Plot(const char* name, const QString& accessible_name, QWidget* parent)
    : QWidget(parent),
      plot_(new QCustomPlot(this)) {
  setObjectName(QLatin1String(name));
  explain(this, accessible_name, {});
  plot_->setAccessibleName(accessible_name);
  plot_->setMinimumSize(160, 90);
  plot_->setNoAntialiasingOnDrag(true);
  plot_->legend->setVisible(true);
  // The legend as a line above the plot: inside, it would lie on the curves.
  plot_->plotLayout()->insertRow(0);
  plot_->plotLayout()->addElement(0, 0, plot_->legend);
  plot_->plotLayout()->setRowStretchFactor(0, 0.001);
  plot_->plotLayout()->setRowSpacing(0);
  plot_->legend->setFillOrder(QCPLegend::foColumnsFirst);
  plot_->legend->setMargins(QMargins(4, 0, 4, 0));
  words_ = new QuietLabel;  // on the plot: its own items do not break lines
  words_->setObjectName(QStringLiteral("words"));
  words_->setAlignment(Qt::AlignCenter);
  words_->setMargin(8);
  auto* over = make_layout<QVBoxLayout>(plot_);
  over->addWidget(words_);
  auto* marker = new QCPItemStraightLine(plot_);
  marker->setObjectName(QStringLiteral("marker"));
  marker->setVisible(false);
  auto* layout = make_layout<QVBoxLayout>(this);
  layout->addWidget(plot_);
  take_colors();
}

QCPAxis* Plot::axis(Side side) const { return side == Side::left ? plot_->yAxis : plot_->yAxis2; }

void Plot::set_axis(Side side, Scale scale) {
  QCPAxis* at = axis(side);
  at->setVisible(true);
  at->setTickLabels(true);
  const bool logarithmic = scale == Scale::logarithmic;
  at->setScaleType(logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
  if (logarithmic) {
    at->setTicker(QSharedPointer<QCPAxisTickerLog>::create());
    at->ticker()->setTickCount(3);  // within one decade: a plot may be no higher than five lines
    at->setNumberFormat(QStringLiteral("gb"));
    at->setNumberPrecision(3);  // within one decade the marks are 1.5, 2, 2.5
  } else {
    at->setTicker(QSharedPointer<QCPAxisTicker>::create());
    at->ticker()->setTickCount(4);
    at->setNumberFormat(QStringLiteral("gb"));
    at->setNumberPrecision(4);
  }
}

void Plot::set_name(int graph, const QString& name) {
  plot_->graph(graph)->setName(name);
  // All again, so that they stand in the order of the graphs.
  for (int g = 0; g < plot_->graphCount(); ++g) plot_->graph(g)->removeFromLegend();
  for (int g = 0; g < plot_->graphCount(); ++g)
    if (!plot_->graph(g)->name().isEmpty()) plot_->graph(g)->addToLegend();
  lay_out_legend();
}

int Plot::add_graph(Side side, const QString& name, Line line, int ink) {
  QCPGraph* graph = plot_->addGraph(plot_->xAxis, axis(side));
  graph->setName(name);
  inks_.append({line, ink, true});
  take_colors();
  lay_out_legend();
  return plot_->graphCount() - 1;
}

void Plot::make_band(int low, int high) {
  plot_->graph(low)->setChannelFillGraph(plot_->graph(high));
  plot_->graph(high)->removeFromLegend();
  for (int graph : {low, high}) inks_[graph].line = Line::band;
  leave_out_of_fit(low);
  leave_out_of_fit(high);
  take_colors();
}

/// In two columns: four words in one row would be cut off. Where two columns are too wide for a few words, in one.
void Plot::lay_out_legend() {
  constexpr int most_rows = 3;
  const auto arrange = [this](int columns) {
    plot_->legend->setWrap(columns);
    plot_->legend->setFillOrder(QCPLegend::foColumnsFirst);  // only this moves what is there
  };
  arrange(2);
  if (plot_->legend->itemCount() <= most_rows && plot_->legend->minimumOuterSizeHint().width() > width()) arrange(1);
}

void Plot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  lay_out_legend();
}

void Plot::leave_out_of_fit(int graph) { inks_[graph].counts = false; }

void Plot::count_along() {
  const QSharedPointer<QCPAxisTickerFixed> whole(new QCPAxisTickerFixed);
  whole->setTickStep(1);
  whole->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
  plot_->xAxis->setTicker(whole);
  take_colors();
}

void Plot::set_name_below(const QString& name) {
  constexpr int few = 3;  // numbers of a narrow plot must not run into each other
  plot_->xAxis->setLabel(name);
  plot_->xAxis->ticker()->setTickCount(few);
}

void Plot::set_axis_name(Side side, const QString& name) { axis(side)->setLabel(name); }

void Plot::set_data(int graph, const QVector<double>& x, const QVector<double>& y) {
  plot_->graph(graph)->setData(x, y, true);
  const bool as_points = x.size() == 1 || (x.size() <= 60 && inks_[graph].line == Line::solid);
  plot_->graph(graph)->setScatterStyle(as_points ? QCPScatterStyle(QCPScatterStyle::ssDisc, 4) : QCPScatterStyle());
}

QVector<double> Plot::values(int graph) const {
  QVector<double> y;
  for (const QCPGraphData& point : *plot_->graph(graph)->data()) y << point.value;
  return y;
}

void Plot::set_marker(double x) {
  auto* marker = static_cast<QCPItemStraightLine*>(plot_->item(0));
  marker->setVisible(true);
  marker->point1->setCoords(x, 0);
  marker->point1->setTypeY(QCPItemPosition::ptAxisRectRatio);
  marker->point2->setTypeY(QCPItemPosition::ptAxisRectRatio);
  marker->point2->setCoords(x, 1);
}

void Plot::hide_marker() { plot_->item(0)->setVisible(false); }

void Plot::show_words(const QString& words) {
  words_->setText(words);
  words_->setVisible(!words.isEmpty());
  plot_->legend->setVisible(words.isEmpty());
}

void Plot::fit_axis(Side side) {
  QCPAxis* at = axis(side);
  double low = std::numeric_limits<double>::max(), high = -low;
  for (int g = 0; g < plot_->graphCount(); ++g) {
    QCPGraph* graph = plot_->graph(g);
    if (graph->valueAxis() != at || !inks_[g].counts) continue;
    for (const QCPGraphData& point : *graph->data()) {
      const bool counts = std::isfinite(point.value) && (at->scaleType() == QCPAxis::stLinear || point.value > 0);
      if (!counts) continue;
      low = std::min(low, point.value);
      high = std::max(high, point.value);
    }
  }
  if (low > high) return;
  if (at->scaleType() == QCPAxis::stLogarithmic) {
    at->setRange(low / 1.6, high * 1.6);
    return;
  }
  // Of nearly equal values the marks would be equal, too, in four digits.
  const double least = std::max(1e-9, 0.04 * std::max(std::abs(low), std::abs(high)));
  const double margin = std::max(0.08 * (high - low), (least - (high - low)) / 2);
  at->setRange(low - margin, high + margin);
}

void Plot::fit() {
  plot_->xAxis->rescale();
  bool any = false;
  QCPRange along;
  for (int g = 0; g < plot_->graphCount(); ++g) {
    bool has_values = false;
    const QCPRange range = plot_->graph(g)->getKeyRange(has_values);
    if (has_values) along = std::exchange(any, true) ? along.expanded(range) : range;
  }
  if (any && along.size() <= 0) plot_->xAxis->setRange(along.lower - 0.5, along.upper + 0.5);
  fit_axis(Side::left);
  fit_axis(Side::right);
}

/// Axes without curves are noise.
void Plot::show_axes() {
  const auto is_drawn = [](const QCPGraph* graph) { return !graph->data()->isEmpty(); };
  bool any = false;
  for (QCPAxis* at : {plot_->yAxis, plot_->yAxis2}) {
    const QList<QCPGraph*> graphs = at->graphs();
    const bool shown = words_->text().isEmpty() && std::any_of(graphs.begin(), graphs.end(), is_drawn);
    at->setVisible(shown);
    at->grid()->setVisible(shown && at == plot_->yAxis);
    any = any || shown;
  }
  plot_->xAxis->setVisible(any);
  plot_->xAxis->grid()->setVisible(any);
}

void Plot::redraw() {
  show_axes();
  fit();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

bool Plot::save(const QString& path) const { return plot_->savePng(path); }

void Plot::take_colors() {
  const QColor ink = palette().color(QPalette::WindowText), ground = palette().color(QPalette::Base);
  const bool dark = ground.lightness() < 128;
  QColor faint = ink;
  faint.setAlpha(40);
  plot_->setBackground(ground);
  plot_->axisRect()->setBackground(ground);
  for (QCPAxis* at : {plot_->xAxis, plot_->yAxis, plot_->yAxis2}) {
    at->setBasePen(QPen(faint));
    at->setTickPen(QPen(faint));
    at->setSubTickPen(Qt::NoPen);
    at->setTickLabelColor(ink);
    at->setLabelColor(ink);
    at->setLabelFont(font());
    at->setTickLabelFont(font());
    at->grid()->setPen(QPen(faint, 1, Qt::DotLine));
    at->grid()->setZeroLinePen(QPen(faint, 1));
  }
  plot_->xAxis->ticker()->setTickCount(6);
  QColor sheet = ground;
  sheet.setAlpha(200);
  plot_->legend->setBrush(sheet);
  plot_->legend->setBorderPen(Qt::NoPen);
  plot_->legend->setTextColor(ink);
  plot_->legend->setFont(font());
  static_cast<QCPItemStraightLine*>(plot_->item(0))->setPen(QPen(ink, 1, Qt::DashLine));
  for (int g = 0; g < inks_.size(); ++g) {
    QColor color = plot_ink(inks_[g].ink, dark ? PlotGround::dark : PlotGround::light);
    if (inks_[g].line == Line::faint) color.setAlpha(110);
    if (inks_[g].line == Line::band) {
      color.setAlpha(60);
      plot_->graph(g)->setBrush(plot_->graph(g)->channelFillGraph() ? QBrush(color) : QBrush(Qt::NoBrush));
      plot_->graph(g)->setPen(Qt::NoPen);
      continue;
    }
    plot_->graph(g)->setPen(QPen(color, 2, inks_[g].line == Line::dotted ? Qt::DotLine : Qt::SolidLine));
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void Plot::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) take_colors();
}

}  // namespace loopmend
