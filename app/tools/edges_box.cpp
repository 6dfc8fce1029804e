// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/edges_box.h"

#include "panels/parts.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace loopmend {

EdgesBox::EdgesBox(EdgeGuide& guide, QWidget* parent)
    : QWidget(parent),
      guide_(guide),
      found_(make_note("edgesFound")),
      restore_(make_button("edgesRestore", tr("Restore"), tr("Forget the edges that were drawn and removed"))) {
  auto* hint = make_note(
      "edgesHint",
      tr("The lines are sharp edges that will run on across the selected holes. Click a line to remove it, or two "
         "vertices of one boundary to draw an edge between them. Then fill."));
  auto* layout = make_layout<QVBoxLayout>(this);
  layout->addWidget(hint);
  layout->addWidget(found_);
  layout->addWidget(restore_, 0, Qt::AlignLeft);
  connect(restore_, &QPushButton::clicked, &guide_, &EdgeGuide::restore);
  connect(&guide_, &EdgeGuide::changed, this, &EdgesBox::follow);
  follow();
}

void EdgesBox::follow() {
  using Kind = EdgeGuide::Edge::Kind;
  const auto count = [this](Kind kind) {
    return static_cast<int>(std::count_if(guide_.edges().begin(), guide_.edges().end(),
                                          [kind](const EdgeGuide::Edge& edge) { return edge.kind == kind; }));
  };
  QStringList text;
  if (guide_.busy()) text << tr("Looking for edges\u2026");
  if (const int n = count(Kind::continued); n > 0) text << tr("%Ln edge(s) run on by themselves.", nullptr, n);
  if (const int n = count(Kind::drawn); n > 0) text << tr("%Ln edge(s) drawn.", nullptr, n);
  if (const int n = count(Kind::not_fitting); n > 0)
    text << tr("%Ln drawn edge(s) do not fit: no sharp edge was found there.", nullptr, n);
  if (text.isEmpty()) text << tr("No sharp edge runs on across these holes.");
  found_->setText(text.join(QLatin1Char(' ')));
  restore_->setEnabled(guide_.has_edits());
}

}  // namespace loopmend
