// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/verdict_box.h"

#include "document/document.h"
#include "document/hole_selection.h"
#include "document/labels.h"
#include "document/verdict_words.h"
#include "panels/parts.h"

#include <QLabel>
#include <QScrollBar>

#include <algorithm>

namespace loopmend {
namespace {

constexpr int lines = 5;                ///< more are reached by scrolling
constexpr int lines_of_no_verdict = 2;  ///< while there is nothing to judge the table has the room
constexpr int refresh_ms = 120;         ///< while a flow runs

}  // namespace

VerdictBox::VerdictBox(const Document& document, const HoleSelection& selection, QWidget* parent)
    : QScrollArea(parent),
      document_(document),
      selection_(selection),
      label_(new QLabel) {
  explain(this, "verdictBox", tr("Verdict on the selected hole"), {});
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::TabFocus);  // the arrow keys scroll it
  explain(label_, "holeVerdict", tr("Verdict on the selected hole"), {});
  label_->setWordWrap(true);
  label_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  setWidget(label_);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  soon_.setSingleShot(true);
  soon_.setInterval(refresh_ms);
  connect(&soon_, &QTimer::timeout, this, &VerdictBox::update_text);
  const auto later = [this] {
    if (!soon_.isActive()) soon_.start();
  };
  for (auto signal : {&Document::opened, &Document::scans_changed, &Document::patches_changed, &Document::holes_changed,
                      &Document::units_changed})
    connect(&document, signal, this, later);
  connect(&document, &Document::patch_moved, this, later);
  connect(&selection, &HoleSelection::selection_changed, this, &VerdictBox::update_text);
  update_text();
}

int VerdictBox::height_of(int line_count) const { return line_count * label_->fontMetrics().lineSpacing() + 4; }

QSize VerdictBox::sizeHint() const { return {QScrollArea::sizeHint().width(), minimumHeight()}; }

int VerdictBox::spare_height() const { return height_of(lines) - minimumHeight(); }

/// Not by the text: what lies above would change under the mouse that selects in it.
void VerdictBox::update_height() {
  bool any = !document_.patches().empty();
  for (int loop = 0; !any && loop < document_.loop_count(); ++loop)
    any = document_.present(loop) && document_.to_look_at(loop);
  const int height = height_of(any ? lines : lines_of_no_verdict);
  if (height == minimumHeight()) return;
  setFixedHeight(height);
  Q_EMIT spare_height_changed();
}

QString VerdictBox::text() const { return label_->text(); }

QString VerdictBox::text_of_selection() const {
  const auto chosen = [this] {
    std::set<int> loops = selection_.selected();
    std::erase_if(loops, [this](int loop) { return loop >= document_.loop_count() || !document_.present(loop); });
    return loops;
  }();
  if (chosen.size() == 1) {
    const int loop = *chosen.begin();
    return tr("Hole %1: %2").arg(labels::hole_name(document_, loop), labels::verdict_text(document_, loop));
  }
  int filled = 0, to_look_at = 0;
  for (int loop = 0; loop < document_.loop_count(); ++loop) {
    if (!document_.present(loop) || (!chosen.empty() && !chosen.contains(loop))) continue;
    filled += document_.patch_of(loop) != nullptr;
    to_look_at += document_.to_look_at(loop);
  }
  if (filled + to_look_at == 0) return tr("Select a filled hole to read its verdict.");
  return to_look_at == 0 ? tr("No hole to look at. Select one to read more.")
                         : tr("%Ln hole(s) to look at. Select one to read why.", nullptr, to_look_at);
}

void VerdictBox::update_text() {
  soon_.stop();
  update_height();
  const QString now = text_of_selection();
  if (now == label_->text()) return;
  label_->setText(now);
  verticalScrollBar()->setValue(0);
}

}  // namespace loopmend
