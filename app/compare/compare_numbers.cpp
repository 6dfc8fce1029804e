// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/compare_numbers.h"

#include "analysis/surface_distance.h"
#include "compare/flow_view.h"
#include "document/labels.h"
#include "panels/parts.h"
#include "panels/plot.h"
#include "problems/comparison_table.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace loopmend {
namespace {

constexpr int flows = 4;
constexpr int folds = 10, cuts = 11;  ///< columns
enum Energy { variation, bending, area };

double energy_of(const PatchEnergies& energies, int which) {
  if (which == variation) return energies.variation;
  return which == bending ? energies.bending : energies.area;
}

QStringList head_words() {
  return {CompareNumbers::tr("Surface"),       CompareNumbers::tr("End"),
          CompareNumbers::tr("Steps"),         CompareNumbers::tr("\u222b|\u2207H|\u00b2"),
          CompareNumbers::tr("\u222bH\u00b2"), CompareNumbers::tr("Area"),
          CompareNumbers::tr("Wide jump"),     CompareNumbers::tr("Jump of H"),
          CompareNumbers::tr("\u00d7 diam."),  CompareNumbers::tr("Angle, \u00b0"),
          CompareNumbers::tr("Folds"),         CompareNumbers::tr("Cuts")};
}

QStringList head_help() {
  return {CompareNumbers::tr("Which flow"),
          CompareNumbers::tr("How the flow ended"),
          CompareNumbers::tr("Accepted steps"),
          CompareNumbers::tr("What MMCVF lowers, in 1/length\u00b2"),
          CompareNumbers::tr("What WF lowers, without a unit"),
          CompareNumbers::tr("What MCF and SDF lower, in length\u00b2"),
          CompareNumbers::tr(
              "Jump of H across the seam from wide one-sided fits, rms, in 1/length: the fairest figure between flows"),
          CompareNumbers::tr("Jump of H across the seam from narrow one-sided fits, rms, in 1/length"),
          CompareNumbers::tr("The jump of H times the hole's diameter: without a unit"),
          CompareNumbers::tr("Angle between the normals of both sides at the seam, rms, in degrees"),
          CompareNumbers::tr("Edges folded by more than 90\u00b0"),
          CompareNumbers::tr("Places where the patch cuts itself or its neighborhood")};
}

/// The engine's words for an end, in the window's language.
QString status_words(const std::string& status) {
  if (status == "converged") return CompareNumbers::tr("converged");
  if (status == "early_stop") return CompareNumbers::tr("all steps taken");
  if (status == "faired") return CompareNumbers::tr("faired");
  if (status == "step_limit") return CompareNumbers::tr("step limit");
  if (status == "stalled") return CompareNumbers::tr("stopped early");
  if (status == "invalid") return CompareNumbers::tr("cuts surface");
  if (status == "filled") return CompareNumbers::tr("filled");
  if (status == "failed") return CompareNumbers::tr("failed");
  return QString::fromStdString(status);
}

bool any_counted(const QTableWidget& table, int column) {
  for (int row = 0; row < table.rowCount(); ++row)
    if (const QTableWidgetItem* item = table.item(row, column); item && item->text().toInt() > 0) return true;
  return false;
}

std::vector<std::string> live_row(const ComparedRun& flow_run) {
  std::string status;
  if (flow_run.stage == ComparedRun::Stage::ended) status = to_string(flow_run.status);
  return comparison_row(upper_name(flow_run.flow), status, flow_run.steps, flow_run.energies, flow_run.seams,
                        flow_run.wide_jump, flow_run.validity);
}

}  // namespace

CompareNumbers::CompareNumbers(const ComparisonController& flow_comparison, const QString& unit, ComparedRunPtr filled,
                               QWidget* parent)
    : QWidget(parent),
      flow_comparison_(flow_comparison),
      unit_(unit.isEmpty() ? tr("length") : unit),
      filled_(std::move(filled)),
      table_(new QTableWidget),
      which_(new QComboBox),
      energies_(new Plot("compareEnergies", tr("Energy of each flow against the step"))),
      profiles_(new Plot("compareProfiles", tr("Mean curvature across the seam, one line for each flow"))),
      across_title_(new QLabel) {
  explain(table_, "compareTable", tr("Figures of all flows"), {});
  const QStringList heads = head_words(), help = head_help();
  table_->setColumnCount(heads.size());
  table_->setHorizontalHeaderLabels(heads);
  for (int c = 0; c < heads.size(); ++c) table_->horizontalHeaderItem(c)->setToolTip(help[c]);
  table_->verticalHeader()->hide();
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setAlternatingRowColors(true);
  table_->setShowGrid(false);
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
  table_->horizontalHeader()->setHighlightSections(false);
  explain(which_, "compareEnergyKind", tr("Which energy"), tr("Which energy the plot shows; each flow lowers its own"));
  which_->addItems({tr("\u222b|\u2207H|\u00b2, what MMCVF lowers"), tr("\u222bH\u00b2, what WF lowers"),
                    tr("Area, what MCF and SDF lower")});
  connect(which_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &CompareNumbers::update_energies);
  for (FlowKind flow : {FlowKind::mcf, FlowKind::sdf, FlowKind::wf, FlowKind::mmcvf})
    for (Plot* plot : {energies_, profiles_})
      plot->add_graph(Plot::Side::left, QString::fromStdString(upper_name(flow)), Plot::Line::solid, ink_of(flow));
  for (Plot* plot : {energies_, profiles_}) plot->set_axis(Plot::Side::left, Plot::Scale::linear);
  profiles_->leave_out_of_fit(0);                       // MCF: a crease's curvature would leave the others flat
  constexpr int least_width = 300, least_height = 190;  // with two lines of legend and a name below
  for (Plot* plot : {energies_, profiles_}) plot->setMinimumSize(least_width, least_height);
  energies_->set_name_below(tr("Step"));
  which_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  across_title_->setFixedHeight(which_->sizeHint().height());
  auto* column = make_layout<QVBoxLayout>(this);
  column->setSpacing(3);
  column->addWidget(which_);
  column->addWidget(energies_, 1);
  column->addWidget(across_title_);
  column->addWidget(profiles_, 1);
  update_all();
}

void CompareNumbers::fill_row(int row, const std::vector<std::string>& cells) {
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const int column = static_cast<int>(c);
    QString text = QString::fromStdString(cells[c]);
    if (bool is_number = false; QLocale::c().toDouble(text, &is_number), is_number)
      text.replace(QLatin1Char('.'), QLocale().decimalPoint());
    if (c == 0 && text == QLatin1String("start")) text = tr("Start");
    if (c == 0 && text == QLatin1String("as filled")) text = tr("As filled");
    if (c == 1) text = status_words(cells[c]);
    if (text == QLatin1String("nan")) text = QStringLiteral("\u2013");
    QTableWidgetItem* item = table_->item(row, column);
    if (!item) {
      item = new QTableWidgetItem;
      item->setTextAlignment(c < 2 ? Qt::AlignLeft | Qt::AlignVCenter : Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(row, column, item);
    }
    if (item->text() != text) item->setText(text);
  }
}

void CompareNumbers::update_all() {
  auto rows_now = table_rows(flow_comparison_);
  if (filled_ && !rows_now.empty())
    rows_now.push_back(comparison_row("as filled", to_string(filled_->status), filled_->steps, filled_->energies,
                                      filled_->seams, filled_->wide_jump, filled_->validity));
  table_->setRowCount(static_cast<int>(rows_now.size()));
  for (std::size_t row = 0; row < rows_now.size(); ++row) fill_row(static_cast<int>(row), rows_now[row]);
  if (filled_ && !rows_now.empty())
    table_->item(table_->rowCount() - 1, 0)
        ->setToolTip(tr("The patch that is in the document. Fill and smooth runs the flow on the smooth surface under "
                        "a rough scan; "
                        "the flows above take the boundary as it is."));
  const int rows = flows + (filled_ ? 2 : 1);
  table_->setFixedHeight(table_->horizontalHeader()->sizeHint().height() +
                         rows * table_->verticalHeader()->defaultSectionSize() + 4);
  table_->resizeColumnsToContents();
  fit_width();
  update_energies();
  update_across();
}

/// No figure is cut off, and no column is there for zeros alone. While flows run, columns grow and never shrink: the plots beside them would not come to rest.
void CompareNumbers::fit_width() {
  for (int c : {folds, cuts}) table_->setColumnHidden(c, !any_counted(*table_, c));
  for (int c = 0; c < table_->columnCount(); ++c) {
    const int needed = static_cast<const QAbstractItemView*>(table_)->sizeHintForColumn(c);
    if (!table_->isColumnHidden(c)) table_->setColumnWidth(c, std::max(table_->columnWidth(c), needed + 2));
  }
  table_->setFixedWidth(table_->horizontalHeader()->length() + 2 * table_->frameWidth() + 2);
}

void CompareNumbers::update_flow_run(int flow_run) {
  fill_row(flow_run + 1, live_row(*flow_comparison_.flow_run(flow_run)));
  fit_width();
  update_energies();
  update_across();
}

void CompareNumbers::update_energies() {
  bool moved = false, positive = true;
  double low = 1e300, high = 0;
  for (int graph = 0; graph < flows; ++graph) energies_->set_data(graph, {}, {});
  for (int flow_run = 0; flow_run < flow_comparison_.flow_runs(); ++flow_run) {
    QVector<double> step, value;
    for (const ComparisonPoint& point : flow_comparison_.curve(flow_run)) {
      step << point.step;
      value << energy_of(point.energies, which_->currentIndex());
      positive = positive && value.last() > 0;
      low = std::min(low, value.last());
      high = std::max(high, value.last());
    }
    moved = moved || step.size() > 1;
    if (step.size() > 1) energies_->set_data(static_cast<int>(flow_comparison_.flow(flow_run)), step, value);
  }
  constexpr double wide = 20;  // from here on a straight scale shows nothing of the end
  energies_->set_axis(Plot::Side::left, positive && high > wide * low ? Plot::Scale::logarithmic : Plot::Scale::linear);
  const QChar squared(0x00b2);
  const QString unit = which_->currentIndex() == variation ? QStringLiteral("1/") + unit_ + squared
                       : which_->currentIndex() == bending ? tr("no unit")
                                                           : unit_ + squared;
  energies_->set_axis_name(Plot::Side::left, unit);
  energies_->show_words(moved ? QString() : tr("Run the flows, and their energies are drawn here."));
  energies_->redraw();
}

void CompareNumbers::show_across(Across across) {
  across_ = across;
  update_across();
}

void CompareNumbers::update_across() {
  across_title_->setText(across_ == Across::curvature ? tr("H across the seam, patch right of 0")
                                                      : tr("% of vertices at each distance"));
  profiles_->set_axis_name(Plot::Side::left,
                           across_ == Across::curvature ? tr("H, 1/%1").arg(unit_) : tr("% of vertices"));
  profiles_->set_name_below(tr("Distance, %1").arg(unit_));
  across_ == Across::curvature ? update_profiles() : update_histogram();
}

void CompareNumbers::update_histogram() {
  constexpr int bins = 41;
  double reach = 0;
  for (int graph = 0; graph < flows; ++graph) profiles_->set_data(graph, {}, {});
  for (int flow_run = 0; flow_comparison_.start() && flow_run < flow_comparison_.flow_runs(); ++flow_run)
    reach = std::max(reach, summary_of(flow_comparison_.flow_run(flow_run)->distances).largest);
  for (int flow_run = 0; reach > 0 && flow_run < flow_comparison_.flow_runs(); ++flow_run) {
    const std::vector<double>& distances = flow_comparison_.flow_run(flow_run)->distances;
    if (summary_of(distances).largest == 0) continue;  // what the others are measured from would hide them
    QVector<double> middle(bins), share(bins, 0);
    for (int k = 0; k < bins; ++k) middle[k] = reach * ((2.0 * k + 1) / bins - 1);
    for (double d : distances)
      if (!std::isnan(d))
        share[std::min(bins - 1, static_cast<int>(bins * (d + reach) / (2 * reach)))] +=
            100.0 / static_cast<double>(distances.size());
    profiles_->set_data(static_cast<int>(flow_comparison_.flow(flow_run)), middle, share);
  }
  profiles_->show_words(reach > 0 ? QString() : tr("There is no distance to draw."));
  profiles_->redraw();
}

void CompareNumbers::update_profiles() {
  bool any = false;
  for (int graph = 0; graph < flows; ++graph) profiles_->set_data(graph, {}, {});
  for (int flow_run = 0; flow_comparison_.start() && flow_run < flow_comparison_.flow_runs(); ++flow_run) {
    QVector<double> distance, H;
    for (const ProfilePoint& point : flow_comparison_.flow_run(flow_run)->profile) {
      if (!distance.isEmpty() && distance.last() == point.distance) {  // at the seam, once from either side
        distance << point.distance;
        H << std::nan("");
      }
      distance << point.distance;
      H << point.H;
    }
    any = any || !distance.isEmpty();
    profiles_->set_data(static_cast<int>(flow_comparison_.flow(flow_run)), distance, H);
  }
  profiles_->show_words(any ? QString() : tr("There is no seam to look across."));
  profiles_->redraw();
}

/// Of a finished comparison in its own words, so that they are those of the command line to the last digit.
std::vector<std::vector<std::string>> table_rows(const ComparisonController& flow_comparison) {
  if (flow_comparison.comparison()) return comparison_rows(*flow_comparison.comparison());
  std::vector<std::vector<std::string>> rows;
  if (!flow_comparison.start()) return rows;
  rows.push_back(comparison_row("start", "", 0, flow_comparison.start()->energies, flow_comparison.start()->seams,
                                std::nan(""), {}));
  for (int flow_run = 0; flow_run < flow_comparison.flow_runs(); ++flow_run)
    rows.push_back(live_row(*flow_comparison.flow_run(flow_run)));
  return rows;
}

std::string curves_csv(const ComparisonController& flow_comparison) {
  std::string text = "flow,step,int |grad H|^2,int H^2,area\n";
  char line[160];
  for (int flow_run = 0; flow_run < flow_comparison.flow_runs(); ++flow_run)
    for (const ComparisonPoint& point : flow_comparison.curve(flow_run)) {
      std::snprintf(line, sizeof line, "%s,%d,%.17g,%.17g,%.17g\n", upper_name(flow_comparison.flow(flow_run)).c_str(),
                    point.step, point.energies.variation, point.energies.bending, point.energies.area);
      text += line;
    }
  return text;
}

}  // namespace loopmend
