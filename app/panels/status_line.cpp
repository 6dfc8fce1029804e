// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/status_line.h"

#include "document/document.h"
#include "document/labels.h"
#include "document/run_curves.h"
#include "document/targets.h"
#include "jobs/fill_controller.h"
#include "jobs/print_check.h"

#include <QHBoxLayout>
#include <QLabel>

namespace loopmend {

StatusLine::StatusLine(const Document& document, const FillController& controller, const PrintCheck& check,
                       QWidget* parent)
    : QWidget(parent),
      document_(document),
      check_(check),
      stage_(new QLabel(tr("Ready"))),
      figures_(new QLabel),
      closed_(new QLabel),
      scan_(new QLabel) {
  setObjectName(QStringLiteral("statusLine"));
  stage_->setObjectName(QStringLiteral("statusStage"));
  figures_->setObjectName(QStringLiteral("statusFigures"));
  scan_->setObjectName(QStringLiteral("statusScan"));
  closed_->setObjectName(QStringLiteral("statusWatertight"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 0, 8, 0);
  layout->setSpacing(24);
  layout->addWidget(stage_);
  layout->addWidget(figures_, 1);
  layout->addWidget(closed_);
  layout->addWidget(scan_);
  connect(&controller, &FillController::stage_changed, this,
          [this](const QString& words) { stage_->setText(words.isEmpty() ? tr("Ready") : words); });
  connect(&controller, &FillController::activity_changed, this, [this, &controller] {
    if (!controller.busy()) count();  // flows add and remove vertices
  });
  connect(&check, &PrintCheck::changed, this, &StatusLine::count);
  connect(&document, &Document::patches_changed, this, &StatusLine::count);
  connect(&document, &Document::opened, this, &StatusLine::count);
  connect(&document, &Document::scans_changed, this, &StatusLine::count);
}

void StatusLine::count() {
  std::size_t triangles = 0, vertices = 0;
  for (int index : document_.scans()) {
    const auto scan = document_.scan(index);
    triangles += scan->model->soup.triangles.size();
    vertices += scan->model->soup.points.size();
  }
  for (const OpenPatch& patch : document_.patches()) {
    triangles += static_cast<std::size_t>(patch.state->patch.patch_triangles);
    vertices += static_cast<std::size_t>(patch.state->patch.free_count);
  }
  const int cracks = cracks_left(document_);
  int cuts = 0;
  for (int loop = 0; loop < document_.loop_count(); ++loop)
    cuts += document_.present(loop) && document_.loop(loop).kind == LoopKind::cut;
  const int open = open_loops(document_) + cracks;
  scan_->setText(triangles == 0
                     ? QString()
                     : tr("%1 triangles \u00b7 %2 vertices").arg(labels::count(triangles), labels::count(vertices)));
  if (const auto& checked = check_.result(); checked && triangles > 0) {
    // Sides of a crack lie in the same place, and count as joined in the check: in files of vertices they are not.
    const int left_out = loops_left_out(document_);
    QString words = labels::verdict(*checked);
    if (checked->encloses() && cracks > 0 && left_out == cracks)
      words = tr("Watertight but for %Ln crack(s): press Stitch", nullptr, cracks);
    else if (checked->encloses() && left_out > 0)  // closed by faces that lie on others
      words += tr("; %L1 left out").arg(left_out);
    closed_->setText(words);
    closed_->setToolTip(labels::verdict_help(*checked));
    return;
  }
  closed_->setToolTip(tr("Intersections have not been looked for yet"));
  // Only the check shows whether a surface that had to be cut is one.
  closed_->setText(triangles == 0 ? QString()
                   : open > 0     ? tr("Not watertight: %Ln open boundary loop(s)", nullptr, open)
                   : cuts > 0     ? tr("Not checked yet")
                                  : tr("No open boundary loops"));
}

void StatusLine::say(const QString& words) {
  if (words.isEmpty())
    show_figures(patch_);
  else
    figures_->setText(words);
}

void StatusLine::show_figures(int patch_id) {
  patch_ = patch_id;
  const OpenPatch* patch = document_.patch(patch_id);
  if (!patch || patch->state->steps == 0) {
    figures_->clear();
    return;
  }
  const PatchState& state = *patch->state;
  QString text = tr("step %1").arg(state.steps);
  switch (lowered_by_last_step(state)) {
    case Lowered::J: text += tr(" \u00b7 J %1").arg(labels::number(state.last_step.split.total())); break;
    case Lowered::energy: text += tr(" \u00b7 energy %1").arg(labels::number(state.energy.final)); break;
    case Lowered::nothing: break;
  }
  if (state.last_step.max_move > 0) text += tr(" \u00b7 residual %1").arg(labels::number(state.last_step.max_move));
  if (state.last_step.tau > 0)
    text += tr(" \u00b7 \u03c3 %1 \u00b7 \u03c4 %2")
                .arg(labels::number(state.last_step.sigma), labels::number(state.last_step.tau));
  figures_->setText(text + tr(" \u00b7 %1 s").arg(labels::seconds(std::llround(1000 * state.seconds.total))));
}

}  // namespace loopmend
