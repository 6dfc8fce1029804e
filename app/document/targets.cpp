// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/targets.h"

#include <algorithm>

namespace loopmend {

std::set<int> loops_to_fill(const Document& document, const HoleSelection& selection) {
  std::set<int> loops;
  const bool chosen = !selection.selected().empty();
  for (int loop = 0; loop < document.loop_count(); ++loop) {
    const bool wanted = chosen ? selection.selected().contains(loop) : document.fillable(loop);
    const bool possible = document.present(loop) && document.loop(loop).kind != LoopKind::cut;
    if (wanted && possible && !document.patch_of(loop)) loops.insert(loop);
  }
  return loops;
}

std::vector<int> largest(const Document& document, const std::set<int>& loops, std::size_t at_most) {
  std::vector<int> sorted(loops.begin(), loops.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](int a, int b) { return document.loop(a).diameter > document.loop(b).diameter; });
  sorted.resize(std::min(sorted.size(), at_most));
  return sorted;
}

std::set<int> chosen_patches(const Document& document, const HoleSelection& selection) {
  std::set<int> ids;
  const std::set<int>& chosen = selection.selected();
  for (const OpenPatch& patch : document.patches()) {
    const bool wanted = chosen.empty() || std::any_of(patch.loops.begin(), patch.loops.end(),
                                                      [&](int loop) { return chosen.contains(loop); });
    if (wanted) ids.insert(patch.id);
  }
  return ids;
}

std::set<int> patches_to_move(const Document& document, const HoleSelection& selection) {
  std::set<int> ids = chosen_patches(document, selection);
  std::erase_if(ids, [&](int id) { return document.patch(id)->acceptance == Acceptance::accepted; });
  return ids;
}

std::set<int> loops_of(const Document& document, const std::set<int>& patches) {
  std::set<int> loops;
  for (int id : patches)
    if (const OpenPatch* patch = document.patch(id)) loops.insert(patch->loops.begin(), patch->loops.end());
  return loops;
}

int open_loops(const Document& document) {
  int open = 0;
  for (int loop = 0; loop < document.loop_count(); ++loop) {
    if (!document.present(loop)) continue;
    const LoopKind kind = document.loop(loop).kind;
    const bool closed = document.patch_of(loop) && document.state(loop) != HoleState::cutting;
    open += !closed && kind != LoopKind::cut && kind != LoopKind::crack;
  }
  return open;
}

int cracks_left(const Document& document) {
  int cracks = 0;
  for (int loop = 0; loop < document.loop_count(); ++loop)
    cracks += document.present(loop) && document.loop(loop).kind == LoopKind::crack &&
              (!document.patch_of(loop) || document.state(loop) == HoleState::cutting);
  return cracks;
}

bool is_left_out(const Document& document, int loop) {
  return document.present(loop) && !document.fillable(loop) && !document.patch_of(loop);
}

int loops_left_out(const Document& document) {
  int count = 0;
  for (int loop = 0; loop < document.loop_count(); ++loop) count += is_left_out(document, loop);
  return count;
}

int scan_of_selection(const Document& document, const HoleSelection& selection) {
  int scan = document.has_scan() ? document.scans().front() : -1;
  for (int loop : selection.selected())
    if (document.present(loop)) scan = document.scan_of(loop);
  return scan;
}

std::set<int> loops_up_to(const Document& document, SizeMeasure measure, double limit) {
  std::set<int> loops;
  for (int loop = 0; loop < document.loop_count(); ++loop) {
    if (!document.fillable(loop) || document.patch_of(loop)) continue;
    const BoundaryLoop& l = document.loop(loop);
    if ((measure == SizeMeasure::edges ? l.edges() : l.diameter) <= limit) loops.insert(loop);
  }
  return loops;
}

}  // namespace loopmend
