// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/flow_view.h"

#include "analysis/surface_distance.h"
#include "compare/flow_canvas.h"
#include "document/labels.h"
#include "document/message_words.h"
#include "panels/parts.h"
#include "panels/plot.h"
#include "problems/comparison_table.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace loopmend {
namespace {

QString stage_words(const ComparedRun& flow_run) {
  switch (flow_run.stage) {
    case ComparedRun::Stage::start: return FlowView::tr("start");
    case ComparedRun::Stage::moving: return FlowView::tr("step %1").arg(flow_run.steps);
    case ComparedRun::Stage::stopped: return FlowView::tr("stopped at step %1").arg(flow_run.steps);
    case ComparedRun::Stage::ended: break;
  }
  switch (flow_run.status) {
    case PatchStatus::converged: return FlowView::tr("converged, %1 steps").arg(flow_run.steps);
    case PatchStatus::early_stop: return FlowView::tr("all %1 steps taken").arg(flow_run.steps);
    case PatchStatus::faired: return FlowView::tr("faired, %1 steps").arg(flow_run.steps);
    case PatchStatus::stalled: return FlowView::tr("stopped early, step %1").arg(flow_run.steps);
    default: return FlowView::tr("%1 steps").arg(flow_run.steps);
  }
}

}  // namespace

Arrival arrival_of(const ComparedRun& flow_run) {
  switch (flow_run.stage) {
    case ComparedRun::Stage::start: return Arrival::at_once;
    case ComparedRun::Stage::moving: return Arrival::with_the_next;
    case ComparedRun::Stage::ended:
    case ComparedRun::Stage::stopped: break;
  }
  return Arrival::soon;
}

int ink_of(FlowKind flow) {
  switch (flow) {
    case FlowKind::mcf: return 2;
    case FlowKind::sdf: return 3;
    case FlowKind::wf: return 1;
    case FlowKind::mmcvf: return 0;
  }
  return 0;
}

FlowView::FlowView(int number, PictureClock& clock, QWidget* parent)
    : QWidget(parent),
      flow_(new QComboBox),
      swatch_(new QLabel),
      figures_(new QLabel),
      accept_(make_button("", tr("Accept"), tr("Put this result into the document; can be undone"))) {
  const auto named = [number](const char* name) { return QLatin1String(name) + QString::number(number); };
  setObjectName(named("pane"));
  flow_->setObjectName(named("paneFlow"));
  accept_->setObjectName(named("paneAccept"));
  figures_->setObjectName(named("paneFigures"));
  canvas_ = new FlowCanvas(named("paneView").toLatin1().constData(), FlowCanvas::Sides::one, clock);
  explain(flow_, tr("Flow"), tr("Which flow this view shows"));
  for (FlowKind kind : {FlowKind::mcf, FlowKind::sdf, FlowKind::wf, FlowKind::mmcvf}) {
    flow_->addItem(labels::flow_name(kind), static_cast<int>(kind));
    flow_->setItemData(flow_->count() - 1, labels::flow_help(kind), Qt::ToolTipRole);
  }
  swatch_->setFixedSize(10, 16);
  figures_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  figures_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  figures_->installEventFilter(this);
  accept_->setFocusPolicy(Qt::TabFocus);
  accept_->setFixedWidth(accept_->fontMetrics().horizontalAdvance(accept_->text()) + 20);  // the figures need the room
  auto* head = new QHBoxLayout;
  head->setContentsMargins(6, 2, 2, 2);
  head->setSpacing(6);
  head->addWidget(swatch_);
  head->addWidget(flow_);
  head->addWidget(figures_, 1);
  head->addWidget(accept_);
  auto* column = make_layout<QVBoxLayout>(this);
  column->setSpacing(0);
  column->addLayout(head);
  column->addWidget(canvas_, 1);
  connect(flow_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    update_swatch();
    Q_EMIT flow_chosen(static_cast<FlowKind>(flow_->currentData().toInt()));
  });
  connect(accept_, &QPushButton::clicked, this, &FlowView::accept_wanted);
  accept_->setEnabled(false);
  update_swatch();
}

void FlowView::show_flow(FlowKind flow) {
  const QSignalBlocker quiet(flow_);
  flow_->setCurrentIndex(flow_->findData(static_cast<int>(flow)));
  update_swatch();
}

void FlowView::set_use(Use use) {
  flow_->setEnabled(use == Use::open);
  accept_->setEnabled(use == Use::open && can_accept_);
}

void FlowView::show_flow_run(const ComparedRun& flow_run, const QString& accepting) {
  const SeamFigures seam = seam_figures(flow_run.seams);
  words_ = stage_words(flow_run);
  QString in_full = words_;
  if (const DistanceSummary off = summary_of(flow_run.distances); off.count > 0) {
    words_.prepend(tr("off %1 \u00b7 ").arg(labels::number(off.rms)));  // what the picture shows; last parts go first
    in_full += QLatin1Char('\n') +
               tr("Distance: %1 rms, 95 % within %2, at most %3")
                   .arg(labels::number(off.rms), labels::number(off.nearly_all), labels::number(off.largest));
  }
  words_ += tr(" \u00b7 \u222b|\u2207H|\u00b2 %1").arg(labels::number(flow_run.energies.variation));
  in_full += QLatin1Char('\n') + tr("Energy \u222b|\u2207H|\u00b2 %1").arg(labels::number(flow_run.energies.variation));
  if (!flow_run.seams.empty()) {
    words_ += tr(" \u00b7 %1\u00b0 \u00b7 \u0394H %2").arg(labels::number(seam.angle), labels::number(seam.jump));
    in_full += QLatin1Char('\n') + tr("At the seam: angle %1\u00b0 (rms), jump of H %2 (rms)")
                                       .arg(labels::number(seam.angle), labels::number(seam.jump));
  }
  if (!flow_run.message.empty()) in_full += QLatin1Char('\n') + labels::sentence(labels::in_words(flow_run.message));
  fit_figures();
  figures_->setToolTip(in_full);
  figures_->setAccessibleDescription(in_full);
  can_accept_ = !accepting.isEmpty() && flow_run.stage != ComparedRun::Stage::start &&
                flow_run.stage != ComparedRun::Stage::moving;
  accept_->setToolTip(accepting.isEmpty() ? tr("Run the flows first") : accepting);
  canvas_->show_patch(0, flow_run.shape, arrival_of(flow_run));
}

/// As many whole figures as there is room for; the tooltip has all.
void FlowView::fit_figures() {
  const QString between = QStringLiteral(" \u00b7 "), more = QStringLiteral(" \u2026");
  const QFontMetrics letters = figures_->fontMetrics();
  QStringList parts = words_.split(between);
  QString text = words_;
  while (letters.horizontalAdvance(text) > figures_->width() && parts.size() > 1) {
    parts.removeLast();
    text = parts.join(between) + more;
  }
  figures_->setText(letters.elidedText(text, Qt::ElideRight, figures_->width()));
}

bool FlowView::eventFilter(QObject* watched, QEvent* event) {
  if (watched == figures_ && event->type() == QEvent::Resize) fit_figures();
  return QWidget::eventFilter(watched, event);
}

QString FlowView::caption() const { return flow_->currentText() + QStringLiteral("   ") + words_; }

void FlowView::update_swatch() {
  const bool dark = palette().color(QPalette::Base).lightness() < 128;
  const QColor ink = plot_ink(ink_of(static_cast<FlowKind>(flow_->currentData().toInt())),
                              dark ? PlotGround::dark : PlotGround::light);
  swatch_->setStyleSheet(QStringLiteral("background: %1; border-radius: 2px;").arg(ink.name()));
}

void FlowView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) update_swatch();
}

}  // namespace loopmend
