// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/hole_selection.h"

namespace loopmend {

void HoleSelection::select(const std::set<int>& loops) {
  if (loops == selected_) return;
  selected_ = loops;
  Q_EMIT selection_changed();
}

void HoleSelection::toggle(int loop) {
  std::set<int> loops = selected_;
  if (loops.erase(loop) == 0) loops.insert(loop);
  select(loops);
}

void HoleSelection::hover(int loop) {
  if (loop == hovered_) return;
  hovered_ = loop;
  Q_EMIT hover_changed();
}

void HoleSelection::clear() {
  hover(no_loop);
  select({});
}

}  // namespace loopmend
