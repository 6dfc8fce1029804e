// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/hole_filter.h"

#include "document/document.h"
#include "document/hole_table.h"
#include "document/labels.h"

#include <algorithm>

namespace loopmend {

HoleFilter::HoleFilter(const Document& document, QObject* parent) : QSortFilterProxyModel(parent), document_(document) {
  setSortRole(HoleTable::sort_role);
  // Rows leave a group while a flow runs; to sort and filter again at every state would make the table jump.
  setDynamicSortFilter(false);
  connect(&document, &Document::holes_changed, this, [this] {
    if (group_ != HoleGroup::all) invalidateFilter();
  });
}

void HoleFilter::set_group(HoleGroup group) {
  group_ = group;
  invalidateFilter();
}

void HoleFilter::set_words(const QString& words) {
  words_ = words.toLower().split(QLatin1Char(' '), Qt::SkipEmptyParts);
  invalidateFilter();
}

bool HoleFilter::in_group(int loop) const {
  const HoleState state = document_.state(loop);
  switch (group_) {
    case HoleGroup::all: return true;
    case HoleGroup::to_do: return state == HoleState::open || state == HoleState::failed;
    case HoleGroup::filled: return document_.patch_of(loop) != nullptr;
    case HoleGroup::accepted: return state == HoleState::accepted;
    case HoleGroup::fault: return document_.to_look_at(loop);
    case HoleGroup::left_out: return state == HoleState::left_out;
  }
  return true;
}

bool HoleFilter::filterAcceptsRow(int loop, const QModelIndex&) const {
  if (loop >= document_.loop_count() || !document_.present(loop) || !in_group(loop)) return false;
  if (words_.isEmpty()) return true;
  const BoundaryLoop& l = document_.loop(loop);
  const QString cells = labels::kind(l.kind) + QLatin1Char(' ') + labels::verdict_or_state(document_, loop) +
                        QLatin1Char(' ') + document_.scan(document_.scan_of(loop))->name.toLower();
  const QString number = QString::number(l.number);
  return std::all_of(words_.begin(), words_.end(),
                     [&](const QString& word) { return word == number || cells.contains(word); });
}

}  // namespace loopmend
