// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/curve_views.h"

#include "analysis/section_profile.h"
#include "document/labels.h"
#include "document/run_curves.h"
#include "neighborhood/boundary_fits.h"
#include "panels/parts.h"
#include "panels/plot.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <limits>
#include <utility>

namespace loopmend {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;
constexpr int blue = 0, orange = 1, grey = 2;
enum EnergyGraph { energy_graph, residual_graph, smooth_graph, relief_graph };
enum SectionGraph { around_now, patch_now, patch_before, band_low, band_high };

QString energy_unit(FlowKind flow) {
  switch (flow) {
    case FlowKind::mmcvf: return EnergyView::tr("Energy \u222b|\u2207H|\u00b2, 1/length\u00b2");
    case FlowKind::wf: return EnergyView::tr("Energy \u222bH\u00b2");
    default: return EnergyView::tr("Area, length\u00b2");
  }
}

}  // namespace

EnergyView::EnergyView(QWidget* parent)
    : QWidget(parent),
      plot_(new Plot("energyPlot", tr("Energy and residual against the step"))) {
  plot_->set_axis(Plot::Side::left, Plot::Scale::logarithmic);
  plot_->set_axis(Plot::Side::right, Plot::Scale::logarithmic);
  plot_->count_along();
  plot_->add_graph(Plot::Side::left, tr("Energy"), Plot::Line::solid, blue);
  plot_->add_graph(Plot::Side::right, tr("Residual (right)"), Plot::Line::dotted, orange);
  plot_->add_graph(Plot::Side::left, QString(), Plot::Line::dotted, blue);
  plot_->add_graph(Plot::Side::left, QString(), Plot::Line::solid, grey);
  auto* layout = make_layout<QVBoxLayout>(this);
  layout->addWidget(plot_);
  show_run(nullptr);
}

void EnergyView::show_run(const OpenPatch* patch) {
  const bool has_run = patch && patch->state->steps > 0;
  plot_->show_words(has_run ? QString() : tr("Run a flow, and its energy is drawn here."));
  if (!has_run) {
    for (int graph : {energy_graph, residual_graph, smooth_graph, relief_graph}) plot_->set_data(graph, {}, {});
    plot_->hide_marker();
    return plot_->redraw();
  }
  const RunCurves run(*patch);
  const auto [low, high] = std::minmax_element(run.lowered.begin(), run.lowered.end());
  constexpr double wide = 20;  // from here on a straight scale shows nothing of the end
  const bool logarithmic = !run.split && !run.step.empty() && *low > 0 && *high > wide * *low;
  plot_->set_axis(Plot::Side::left, logarithmic ? Plot::Scale::logarithmic : Plot::Scale::linear);
  plot_->set_name(energy_graph, run.fairing ? QString()
                                : run.split ? tr("J, lowered")
                                            : energy_unit(patch->state->flow));
  plot_->set_name(smooth_graph, run.split ? tr("smooth part") : QString());
  plot_->set_name(relief_graph, run.split ? tr("relief and noise") : QString());
  plot_->set_data(energy_graph, run.step, run.lowered);
  plot_->set_data(residual_graph, run.residual_step, run.residual);
  plot_->set_data(smooth_graph, run.split ? run.step : QVector<double>(), run.smooth);
  plot_->set_data(relief_graph, run.split ? run.step : QVector<double>(), run.relief);
  plot_->set_marker(patch->state->steps);
  plot_->redraw();
}

SectionView::SectionView(QWidget* parent)
    : QWidget(parent),
      plot_(new Plot("sectionPlot", tr("Mean curvature along a section across the seam"))),
      angle_(new QSlider(Qt::Vertical)),
      angle_value_(new QLabel) {
  plot_->set_axis(Plot::Side::left, Plot::Scale::linear);
  plot_->add_graph(Plot::Side::left, tr("H of scan"), Plot::Line::solid, grey);
  plot_->add_graph(Plot::Side::left, tr("patch"), Plot::Line::solid, orange);
  plot_->add_graph(Plot::Side::left, tr("initial patch"), Plot::Line::dotted, blue);
  plot_->add_graph(Plot::Side::left, tr("\u00b1\u03c3"), Plot::Line::solid, grey);
  plot_->add_graph(Plot::Side::left, QString(), Plot::Line::solid, grey);
  plot_->make_band(band_low, band_high);
  angle_->setRange(0, 179);
  explain(angle_, "sectionAngle", tr("Direction of the section"),
          tr("Turns the section about the hole's axis; 0\u00b0 runs along the hole's longest direction"));
  angle_value_->setAlignment(Qt::AlignCenter);
  angle_value_->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("179\u00b0 ")));
  connect(angle_, &QSlider::valueChanged, this, &SectionView::update_plot);
  auto* turn = new QVBoxLayout;
  turn->addWidget(angle_, 1, Qt::AlignHCenter);
  turn->addWidget(angle_value_);
  auto* layout = make_layout<QHBoxLayout>(this);
  layout->addWidget(plot_, 1);
  layout->addLayout(turn);
  update_plot();
}

void SectionView::show_patch(const OpenPatch* patch, int loop) {
  now_ = patch ? patch->state : nullptr;
  before_ = patch && patch->timeline->front() != patch->state ? patch->timeline->front() : nullptr;
  loop_ = loop;
  if (isVisible()) update_plot();
}

void SectionView::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  update_plot();
}

void SectionView::draw(const SectionProfile& profile, int graph_in, int graph_out) {
  QVector<double> arc, inside, outside;
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < profile.arc.size(); ++i) {
    const bool in_patch = profile.side[i] == SectionProfile::Side::patch;
    // The seam's own sample ends both lines, so that they meet.
    const bool at_seam = in_patch && ((i > 0 && profile.side[i - 1] != profile.side[i]) ||
                                      (i + 1 < profile.arc.size() && profile.side[i + 1] != profile.side[i]));
    arc << profile.arc[i];
    inside << (in_patch ? profile.value[i] : gap);
    outside << (!in_patch || at_seam ? profile.value[i] : gap);
  }
  plot_->set_data(graph_in, arc, inside);
  if (graph_out >= 0) plot_->set_data(graph_out, arc, outside);
}

/// How far the neighborhood knows its own H, around its line. Fits at the vertices beside the section alone take
/// milliseconds; at all vertices of a large hole they would stop the window.
void SectionView::draw_band(const Patch& patch, const SectionProfile& profile) {
  std::vector<int> beside;
  for (const auto& edge : profile.edge) beside.insert(beside.end(), edge.begin(), edge.end());
  std::sort(beside.begin(), beside.end());
  beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
  const std::vector<float> known = curvature_uncertainty(patch, beside);
  const auto at = [&](int v) {
    return v < patch.free_count ? std::numeric_limits<double>::quiet_NaN() : known[v - patch.free_count];
  };
  QVector<double> arc, low, high;
  for (std::size_t i = 0; i < profile.arc.size(); ++i) {
    const auto [a, b] = profile.edge[i];
    const double sigma = (1 - profile.weight[i]) * at(a) + profile.weight[i] * at(b);
    arc << profile.arc[i];
    low << profile.value[i] - sigma;
    high << profile.value[i] + sigma;
  }
  plot_->set_data(band_low, arc, low);
  plot_->set_data(band_high, arc, high);
}

void SectionView::update_plot() {
  angle_value_->setText(tr("%1\u00b0").arg(angle_->value()));
  angle_->setEnabled(now_ != nullptr);
  for (int graph : {around_now, patch_now, patch_before, band_low, band_high}) plot_->set_data(graph, {}, {});
  plot_->show_words(now_ ? QString() : tr("Fill a hole, and H across its seam is drawn here."));
  const auto section_of = [&](const PatchState& state) {
    return section_profile(state.patch, loop_, angle_->value() * degree, state.shape->H);
  };
  if (before_) draw(section_of(*before_), patch_before, -1);
  if (now_) {
    const SectionProfile section = section_of(*now_);
    draw(section, patch_now, around_now);
    draw_band(now_->patch, section);
  }
  plot_->redraw();
}

}  // namespace loopmend
