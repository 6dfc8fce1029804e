// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/inspect_panel.h"

#include "document/document.h"
#include "document/hole_selection.h"
#include "document/labels.h"
#include "document/verdict_words.h"
#include "panels/curve_views.h"
#include "panels/parts.h"
#include "panels/plot.h"
#include "panels/steady_label.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSplitter>
#include <QStyle>
#include <QTabWidget>
#include <QTableWidget>
#include <QTime>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace loopmend {
namespace {

constexpr std::size_t most_rows = 200;
constexpr int cell_margin = 8;
constexpr int refresh_ms = 120;  ///< while a flow runs
enum Column { hole, angle_rms, angle_max, jump_rms, jump_max, jump_free, column_count };

double value(const SeamReport& seam, int column) {
  switch (column) {
    case angle_rms: return seam.g1_rms_deg;
    case angle_max: return seam.g1_max_deg;
    case jump_rms: return seam.h_jump_rms;
    case jump_max: return seam.h_jump_max;
    case jump_free: return seam.h_jump_rms_times_diameter;
    default: return 0;
  }
}

QWidget* titled(const QString& title, QWidget* content, QPushButton* button) {
  auto* box = new QWidget;
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(8, 4, 8, 8);
  layout->setSpacing(4);
  auto* top = new QHBoxLayout;
  auto* label = new QLabel(title);
  QFont bold = label->font();
  bold.setBold(true);
  label->setFont(bold);
  top->addWidget(label, 1);
  top->addWidget(button);
  layout->addLayout(top);
  layout->addWidget(content, 1);
  return box;
}

}  // namespace

InspectPanel::InspectPanel(const Document& document, const HoleSelection& selection, QWidget* parent)
    : QWidget(parent),
      document_(document),
      selection_(selection) {
  setObjectName(QStringLiteral("inspectPanel"));
  auto* split = new QSplitter(Qt::Horizontal);
  split->setChildrenCollapsible(false);
  split->addWidget(build_seam());
  split->addWidget(build_curves());
  split->setStretchFactor(0, 3);
  split->setStretchFactor(1, 2);
  split->setSizes({630, 450});
  auto* layout = make_layout<QVBoxLayout>(this);
  layout->addWidget(split);
  soon_.setSingleShot(true);
  soon_.setInterval(refresh_ms);
  connect(&soon_, &QTimer::timeout, this, &InspectPanel::update_seam);
  connect(&document, &Document::opened, this, &InspectPanel::update_seam);
  connect(&document, &Document::patches_changed, this, &InspectPanel::update_seam_soon);
  connect(&document, &Document::patch_moved, this, &InspectPanel::update_seam_soon);
  connect(&document, &Document::timeline_changed, this, &InspectPanel::update_seam_soon);
  connect(&selection, &HoleSelection::selection_changed, this, &InspectPanel::update_seam_soon);
  update_seam();
}

QWidget* InspectPanel::build_seam() {
  seam_ = new QTableWidget(0, column_count);
  seam_->setHorizontalHeaderLabels(
      {tr("Hole"), tr("Angle rms"), tr("Angle max"), tr("H jump rms"), tr("H jump max"), tr("H jump \u00b7 size")});
  const char* const help[] = {QT_TR_NOOP("The hole's number"),
                              QT_TR_NOOP("Angle between the normals on both sides, root mean square"),
                              QT_TR_NOOP("Angle between the normals on both sides, largest"),
                              QT_TR_NOOP("Jump of the mean curvature across the seam, root mean square, 1/length"),
                              QT_TR_NOOP("Jump of the mean curvature across the seam, largest, 1/length"),
                              QT_TR_NOOP("The rms jump times the hole's diameter: a number without a unit")};
  for (int c = 0; c < column_count; ++c) {
    seam_->horizontalHeaderItem(c)->setToolTip(tr(help[c]));
    seam_->horizontalHeaderItem(c)->setTextAlignment(Qt::AlignVCenter | (c == hole ? Qt::AlignLeft : Qt::AlignRight));
  }
  explain(seam_, "seamTable", tr("Seams"), tr("How each patch meets the scan, before the flow and now"));
  seam_->setToolTip({});
  seam_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  seam_->setSelectionMode(QAbstractItemView::NoSelection);
  seam_->setFocusPolicy(Qt::TabFocus);  // the arrow keys scroll it
  seam_->setTabKeyNavigation(false);
  seam_->setShowGrid(false);
  seam_->setWordWrap(false);
  seam_->setTextElideMode(Qt::ElideLeft);  // the value of now is seen whole
  seam_->verticalHeader()->hide();
  seam_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 9);
  sentence_ = new SteadyLabel;
  sentence_->setObjectName(QStringLiteral("seamSentence"));
  sentence_->keep_room_for({QStringLiteral("1\n2\n3")});  // the table stays where it is under one line as well
  sentence_->setAlignment(Qt::AlignTop);
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* content = new QWidget;
  auto* layout = make_layout<QVBoxLayout>(content);
  layout->addWidget(sentence_);
  layout->addWidget(seam_, 1);
  auto* copy = make_button("copySeam", tr("Copy"), tr("Copy the table as tab-separated text"));
  connect(copy, &QPushButton::clicked, this, &InspectPanel::copy_seam);
  return titled(tr("Seam, before \u2192 now"), content, copy);
}

/// The font is known once the window is.
void InspectPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  set_seam_columns();
}

/// Room for the longest pair of numbers in each column, so that neither is cut off; the jumps with a unit share what is left.
/// Not by their contents: these would be measured again at every change of every row.
void InspectPanel::set_seam_columns() {
  constexpr const char* longest[column_count] = {"0000",
                                                 "00.0 \u2192 0.000\u00b0",
                                                 "000 \u2192 0.000\u00b0",
                                                 "0.0000 \u2192 0.00000",
                                                 "0.0000 \u2192 0.00000",
                                                 "00.0 \u2192 0.0000"};
  QHeaderView* header = seam_->horizontalHeader();
  int total = style()->pixelMetric(QStyle::PM_ScrollBarExtent) + 2 * seam_->frameWidth();
  for (int c = 0; c < column_count; ++c) {
    const int numbers = fontMetrics().horizontalAdvance(QString::fromUtf8(longest[c])) + cell_margin;
    const int width = std::max(numbers, header->sectionSizeHint(c));
    header->setSectionResizeMode(c, c == jump_rms || c == jump_max ? QHeaderView::Stretch : QHeaderView::Fixed);
    header->resizeSection(c, width);
    total += width;
  }
  seam_->setMinimumWidth(total);
}

QWidget* InspectPanel::build_curves() {
  energy_ = new EnergyView;
  section_ = new SectionView;
  tabs_ = new QTabWidget;
  tabs_->setDocumentMode(true);
  tabs_->addTab(energy_, tr("Energy"));
  tabs_->addTab(section_, tr("Section"));
  tabs_->addTab(build_log(), tr("Log"));
  tabs_->setTabToolTip(0, tr("Energy and residual against the step"));
  tabs_->setTabToolTip(1, tr("Mean curvature along a section across the seam"));
  tabs_->setTabToolTip(2, tr("What has happened so far"));
  explain(tabs_, "inspectTabs", tr("Energy, section, log"), {});
  curve_hole_ = new QLabel;
  curve_hole_->setContentsMargins(0, 0, 8, 0);
  explain(curve_hole_, "curveHole", tr("Whose curves"), tr("The hole whose energy and section are drawn"));
  tabs_->setCornerWidget(curve_hole_);
  return tabs_;
}

QWidget* InspectPanel::build_log() {
  log_ = new QPlainTextEdit;
  log_->setReadOnly(true);
  log_->setMaximumBlockCount(5000);
  log_->setPlaceholderText(tr("What happens is written down here."));
  log_->setFrameShape(QFrame::NoFrame);
  explain(log_, "log", tr("Log"), tr("What has happened so far"));
  log_->setToolTip({});
  auto* copy = make_button("copyLog", tr("Copy log"), tr("Copy the whole log"));
  connect(copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(log_->toPlainText()); });
  auto* box = new QWidget;
  auto* layout = new QHBoxLayout(box);
  layout->setContentsMargins(0, 0, 6, 4);
  layout->addWidget(log_, 1);
  layout->addWidget(copy, 0, Qt::AlignTop);
  return box;
}

void InspectPanel::log(const QString& words) {
  log_->appendPlainText(QTime::currentTime().toString(QStringLiteral("HH:mm:ss  ")) + words);
}

std::vector<int> InspectPanel::shown_loops() const {
  std::vector<int> loops;
  for (int loop = 0; loop < document_.loop_count() && loops.size() < most_rows; ++loop) {
    const bool wanted = selection_.selected().empty() || selection_.selected().contains(loop);
    if (wanted && document_.patch_of(loop)) loops.push_back(loop);
  }
  return loops;
}

/// Of the patch that a run moves, else of the hole in the table's first row.
void InspectPanel::update_curves(int loop) {
  const OpenPatch* patch = loop == no_loop ? nullptr : document_.patch_of(loop);
  const OpenPatch* run = document_.patch(run_);
  const OpenPatch* followed = run && patch ? run : patch;
  const int place = followed && followed == patch ? static_cast<int>(patch->place_of(loop)) : 0;
  energy_->show_run(followed);
  section_->show_patch(followed, place);
  const std::set<int> holes = followed ? loops_of(*followed) : std::set<int>();
  curve_hole_->setText(holes.empty() ? QString() : labels::sentence(labels::holes(document_, holes)));
}

void InspectPanel::follow_run(int patch_id) {
  if (std::exchange(run_, patch_id) != patch_id) update_seam_soon();
}

void InspectPanel::update_seam_soon() {
  if (!soon_.isActive()) soon_.start();
}

void InspectPanel::update_seam() {
  const std::vector<int> loops = shown_loops();
  seam_->setRowCount(static_cast<int>(loops.size()));
  for (int row = 0; row < static_cast<int>(loops.size()); ++row) fill_row(row, loops[row]);
  update_curves(loops.empty() ? no_loop : loops.front());
  if (loops.empty()) {
    sentence_->setText(!document_.has_scan() ? tr("Open a scan, fill a hole, and its seam is measured here.")
                       : selection_.selected().empty()
                           ? tr("No hole is filled yet. Press Fill and smooth, and the seam is measured here.")
                           : tr("The selection is not filled yet."));
    return;
  }
  const int first = loops.front();
  QString text = labels::seam_text(document_, first);
  if (text.isEmpty()) return;
  const Verdict* verdict = document_.verdict(first);
  if (verdict && verdict->grade != Grade::good) text = labels::sentence_of(*verdict) + QLatin1Char(' ') + text;
  sentence_->setText(tr("Hole %1: %2").arg(labels::hole_name(document_, first), text));
}

void InspectPanel::fill_row(int row, int loop) {
  const OpenPatch& patch = *document_.patch_of(loop);
  const std::size_t at = patch.place_of(loop);
  for (int column = 0; column < column_count; ++column) {
    QString text;
    if (column == hole) {
      text = labels::hole_name(document_, loop);
    } else if (at < patch.state->seams.size()) {
      const bool is_angle = column == angle_rms || column == angle_max;
      const bool measured = std::isfinite(value(patch.state->seams[at], column));
      const QString unit = is_angle && measured ? QStringLiteral("\u00b0") : QString();
      const QString now = labels::number(value(patch.state->seams[at], column)) + unit;
      const QString before = labels::number(value(patch.state->seams_before[at], column)) + unit;
      text = before == now ? now : before.chopped(unit.size()) + QStringLiteral(" \u2192 ") + now;
    }
    // The table cuts at the left, which would take the number of "3 of head_holes.ply".
    const QString shown =
        column == hole ? fontMetrics().elidedText(text, Qt::ElideRight, seam_->columnWidth(hole) - cell_margin) : text;
    if (QTableWidgetItem* there = seam_->item(row, column)) {
      if (there->text() != shown || there->toolTip() != text) {
        there->setText(shown);
        there->setToolTip(text);
      }
      continue;
    }
    auto* item = new QTableWidgetItem(shown);
    item->setToolTip(text);
    item->setTextAlignment(Qt::AlignVCenter | (column == hole ? Qt::AlignLeft : Qt::AlignRight));
    seam_->setItem(row, column, item);
  }
}

void InspectPanel::copy_seam() const {
  QStringList lines;
  for (int row = -1; row < seam_->rowCount(); ++row) {
    QStringList cells;
    for (int column = 0; column < column_count; ++column) {
      const QTableWidgetItem* item = row < 0 ? seam_->horizontalHeaderItem(column) : seam_->item(row, column);
      cells << (!item ? QString() : row < 0 ? item->text() : item->toolTip());  // whole
    }
    lines << cells.join(QLatin1Char('\t'));
  }
  QApplication::clipboard()->setText(sentence_->text() + QLatin1Char('\n') + lines.join(QLatin1Char('\n')));
}

}  // namespace loopmend
