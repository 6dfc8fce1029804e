// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/repair_preview.h"

#include "document/labels.h"
#include "jobs/defect_places.h"
#include "panels/banner.h"
#include "views/mesh_view.h"

#include <utility>

namespace loopmend {

RepairPreview::RepairPreview(const Document& document, Banner& banner, MeshView& view, QObject* parent)
    : QObject(parent),
      banner_(banner),
      view_(view) {
  connect(&banner_, &Banner::changed, this, [this] {
    if (!asked_.isEmpty() && (!banner_.isVisibleTo(banner_.parentWidget()) || banner_.text() != asked_)) drop();
  });
  // It was computed for the scene as it was.
  for (auto signal : {&Document::opened, &Document::scans_changed, &Document::patches_changed})
    connect(&document, signal, this, &RepairPreview::drop);
}

void RepairPreview::show(const RepairQuestion& question) { show_place(question, 0); }

void RepairPreview::show_place(const RepairQuestion& question, std::size_t at) {
  const std::vector<DefectPlace>& places = question.places->places;
  QStringList words{question.proposal};
  if (question.loops != question.loops_before)
    words << tr("Boundary loops: %L1 in place of %L2.").arg(question.loops).arg(question.loops_before);
  if (question.patches > 0) words << tr("%Ln patch(es) of this scan would go.", nullptr, question.patches);
  if (!places.empty())
    words << tr("Red: what would change, place %1 of %2.").arg(labels::count(at + 1), labels::count(places.size()));
  std::vector<Banner::Answer> answers{{tr("&Apply"), "proposalApply", question.apply}};
  if (places.size() > 1)
    answers.push_back({tr("&Next place"), "proposalNext",
                       [this, question, next = (at + 1) % places.size()] { show_place(question, next); }});
  answers.push_back({tr("&Leave it as it is"), "proposalKeep", [] {}});
  asked_.clear();  // no longer the words before
  const QString text = words.join(QLatin1Char(' '));
  banner_.ask(text, std::move(answers));
  asked_ = text;
  view_.show_marked(question.places->shape);
  if (!places.empty()) view_.fly_to_place(places[at].center, places[at].radius, places[at].direction);
}

void RepairPreview::drop() {
  if (asked_.isEmpty()) return;
  const QString asked = std::exchange(asked_, QString());
  view_.show_marked(nullptr);
  if (banner_.isVisibleTo(banner_.parentWidget()) && banner_.text() == asked) banner_.hide();
}

}  // namespace loopmend
