// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/document_run.h"

#include "document/timeline.h"

#include <algorithm>

namespace loopmend {
namespace {

bool meet(const std::set<int>& a, const std::set<int>& b) {
  return std::any_of(a.begin(), a.end(), [&](int loop) { return b.contains(loop); });
}

}  // namespace

DocumentRun::DocumentRun(Document& document, std::size_t timeline_budget)
    : document_(document),
      timeline_budget_(timeline_budget) {
  for (const OpenPatch& patch : document.patches()) before_.emplace(patch.id, patch);
}

std::set<int> DocumentRun::patches_at(const std::set<int>& loops) const {
  std::set<int> ids;
  for (int loop : loops)
    if (const OpenPatch* patch = document_.patch_of(loop)) ids.insert(patch->id);
  return ids;
}

TimelinePtr DocumentRun::timeline(const PatchRun& run) const {
  Timeline all;
  if (run.first) all.push_back(run.first);
  all.insert(all.end(), run.steps.begin(), run.steps.end());
  return extended({all.front()}, all.front(), {all.begin() + 1, all.end()}, timeline_budget_);
}

OpenPatch DocumentRun::opened(const PatchRun& run, const std::set<int>& loops) const {
  OpenPatch patch;
  patch.id = document_.next_patch_id();
  patch.scan = document_.scan_of(*loops.begin());
  patch.state = run.steps.empty() ? run.first : run.steps.back();
  for (int number : patch.state->patch.loop_numbers)
    patch.loops.push_back(document_.first_loop_of(patch.scan) + number - 1);
  patch.timeline = timeline(run);
  return patch;
}

void DocumentRun::place(const PatchRuns& news) {
  std::vector<OpenPatch> come;
  std::map<int, PatchStatePtr> states;
  for (const auto& [loops, run] : news) {
    std::erase_if(waiting_, [&, &now = loops](const auto& entry) { return meet(entry.first, now); });
    const std::set<int> there = patches_at(loops);
    const OpenPatch* patch = there.size() == 1 ? document_.patch(*there.begin()) : nullptr;
    if (there.empty()) {
      come.push_back(opened(run, loops));
    } else if (!patch || loops_of(*patch) != loops) {
      waiting_[loops] = run;
    } else if (!run.steps.empty()) {
      const auto known = before_.find(patch->id);
      states[patch->id] = run.steps.back();
      document_.set_timeline(patch->id, known == before_.end() ? timeline(run)
                                                               : extended(*known->second.timeline, known->second.state,
                                                                          run.steps, timeline_budget_));
    }
  }
  if (!come.empty()) document_.replace({}, come);
  document_.set_states(states);
  part(Open::none);
}

void DocumentRun::place_rest() { part(Open::some); }

void DocumentRun::part(Open allowed) {
  PatchRuns left = waiting_;
  for (const auto& [moved, run] : left) {
    if (run.steps.empty() || !waiting_.contains(moved)) continue;
    std::set<int> loops = moved, gone;
    PatchRuns parts;
    for (std::size_t n = 0; n != loops.size();) {
      n = loops.size();
      gone = patches_at(loops);
      for (int id : gone) loops.merge(loops_of(*document_.patch(id)));
      for (const auto& [own, part] : waiting_)
        if (meet(own, loops) && parts.emplace(own, part).second) loops.insert(own.begin(), own.end());
    }
    for (const auto& [own, part] : parts)
      for (int loop : own) loops.erase(loop);
    if (!loops.empty() && allowed == Open::none) continue;
    std::vector<OpenPatch> come;
    for (const auto& [own, part] : parts) {
      come.push_back(opened(part, own));
      waiting_.erase(own);
    }
    document_.replace({gone.begin(), gone.end()}, come);
  }
}

std::vector<PatchChange::Pair> DocumentRun::changes() const {
  std::vector<PatchChange::Pair> pairs;
  for (const auto& [id, before] : before_) {
    const OpenPatch* now = document_.patch(id);
    if (!now || now->state != before.state) pairs.push_back({before, now ? std::optional(*now) : std::nullopt});
  }
  for (const OpenPatch& patch : document_.patches())
    if (!before_.contains(patch.id)) pairs.push_back({std::nullopt, patch});
  return pairs;
}

}  // namespace loopmend
