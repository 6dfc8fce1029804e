// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/document.h"

#include "mesh/scan_attributes.h"

#include <algorithm>

namespace loopmend {

bool Document::has_scan() const {
  return std::any_of(slots_.begin(), slots_.end(), [](const Slot& slot) { return slot.scan != nullptr; });
}

std::vector<int> Document::scans_with_work() const {
  std::vector<int> found = scans();
  std::erase_if(found, [this](int i) {
    return scan(i)->from != ScanOrigin::made && units_.count(i) == 0 &&
           std::none_of(shapes_.begin(), shapes_.end(), [&](const auto& of) { return scan_of(of.first) == i; }) &&
           std::none_of(patches_.begin(), patches_.end(), [i](const OpenPatch& patch) { return patch.scan == i; });
  });
  return found;
}

bool Document::has_work() const { return !scans_with_work().empty(); }

std::vector<int> Document::scans() const {
  std::vector<int> indices;
  for (std::size_t i = 0; i < slots_.size(); ++i)
    if (slots_[i].scan) indices.push_back(static_cast<int>(i));
  return indices;
}

std::shared_ptr<const OpenedScan> Document::scan(int index) const {
  const auto at = static_cast<std::size_t>(index);
  return at < slots_.size() ? slots_[at].scan : nullptr;
}

const OpenedScan& Document::first_scan() const {
  return *std::find_if(slots_.begin(), slots_.end(), [](const Slot& slot) { return slot.scan != nullptr; })->scan;
}

bool Document::present(int loop) const { return loop < loop_count() && slots_[scan_of(loop)].scan != nullptr; }

const OpenPatch* Document::patch(int id) const {
  const auto it = patch_by_id_.find(id);
  return it == patch_by_id_.end() ? nullptr : &patches_[it->second];
}

const OpenPatch* Document::patch_of(int loop) const {
  const auto it = patch_by_loop_.find(loop);
  return it == patch_by_loop_.end() ? nullptr : &patches_[it->second];
}

void Document::index_patches() {
  patch_by_id_.clear();
  patch_by_loop_.clear();
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    patch_by_id_[patches_[i].id] = i;
    for (int loop : patches_[i].loops) patch_by_loop_[loop] = i;
  }
}

HoleState Document::state(int loop) const {
  const OpenPatch* patch = patch_of(loop);
  if (!patch) {
    if (failures_.contains(loop)) return HoleState::failed;
    return fillable(loop) ? HoleState::open : HoleState::left_out;
  }
  if (running_.contains(patch->id)) return HoleState::running;
  if (patch->acceptance == Acceptance::accepted) return HoleState::accepted;
  if (const Verdict* found = verdict(loop); found && is_filled(patch->state->status)) {
    if (found->grade == Grade::bad) return HoleState::bad;
    if (found->grade == Grade::look) return HoleState::look;
  }
  switch (patch->state->status) {
    case PatchStatus::filled: return HoleState::filled;
    case PatchStatus::ready: return HoleState::stepped;
    case PatchStatus::converged: return HoleState::converged;
    case PatchStatus::early_stop: return HoleState::early_stop;
    case PatchStatus::stalled:
    case PatchStatus::step_limit: return HoleState::stalled;
    case PatchStatus::invalid: return HoleState::cutting;
    case PatchStatus::faired: return HoleState::faired;
    default: return HoleState::open;
  }
}

const Verdict* Document::verdict(int loop) const {
  const OpenPatch* patch = patch_of(loop);
  if (!patch) return nullptr;
  const std::size_t at = patch->place_of(loop);
  return at < patch->state->verdicts.size() ? &patch->state->verdicts[at] : nullptr;
}

ExpectedDeviation Document::deviation(int loop) const {
  const OpenPatch* patch = patch_of(loop);
  if (!patch) return {};
  const std::size_t at = patch->place_of(loop);
  const std::vector<ExpectedDeviation>& all = patch->state->deviation.loops;
  return at < all.size() ? all[at] : ExpectedDeviation();
}

bool Document::to_look_at(int loop) const {
  switch (state(loop)) {
    case HoleState::failed:
    case HoleState::cutting:
    case HoleState::bad:
    case HoleState::look:
    case HoleState::stalled: return true;
    default: return false;
  }
}

Message Document::message(int loop) const {
  if (const OpenPatch* patch = patch_of(loop)) return patch->state->message;
  const auto it = failures_.find(loop);
  return it == failures_.end() ? Message() : it->second;
}

bool Document::fillable(int loop) const {
  if (!present(loop)) return false;
  const LoopKind kind = this->loop(loop).kind;
  return kind == LoopKind::hole || (kind == LoopKind::outer_rim && outer_rims_ == OuterRims::include);
}

void Document::set_outer_rims(OuterRims rule) {
  if (rule == outer_rims_) return;
  outer_rims_ = rule;
  Q_EMIT holes_changed();
}

void Document::swap_with(Aside& other) {
  slots_.swap(other.slots);
  loops_.swap(other.loops);
  scan_of_loop_.swap(other.scan_of_loop);
  std::swap(origin_, other.origin);
  patches_.swap(other.patches);
  failures_.swap(other.failures);
  units_.swap(other.units);
  edge_edits_.swap(other.edge_edits);
  mirror_planes_.swap(other.mirror_planes);
  shapes_.swap(other.shapes);
  index_patches();
  running_.clear();
}

void Document::set_aside() {
  if (aside_ || slots_.empty()) return;
  swap_with(aside_.emplace());
  Q_EMIT opened();
  Q_EMIT scans_changed();
}

void Document::bring_back() {
  if (!aside_) return;
  swap_with(*aside_);
  aside_.reset();
  Q_EMIT scans_changed();
  Q_EMIT patches_changed();
  Q_EMIT units_changed();
  Q_EMIT holes_changed();
}

void Document::clear() {
  aside_.reset();
  slots_.clear();
  loops_.clear();
  scan_of_loop_.clear();
  origin_ = Vec3::Zero();
  units_.clear();
  edge_edits_.clear();
  mirror_planes_.clear();
  shapes_.clear();
  patches_.clear();
  index_patches();
  running_.clear();
  failures_.clear();
  Q_EMIT opened();
}

std::string Document::unit(int scan) const {
  if (const auto chosen = units_.find(scan); chosen != units_.end()) return chosen->second;
  const auto opened = this->scan(scan);
  return opened && opened->model->soup.attributes ? opened->model->soup.attributes->unit : std::string();
}

std::string Document::unit() const {
  const std::vector<int> indices = scans();
  if (indices.empty()) return {};
  const std::string first = unit(indices.front());
  const bool agree = std::all_of(indices.begin(), indices.end(), [&](int scan) { return unit(scan) == first; });
  return agree ? first : std::string();
}

const EdgeEdits& Document::edge_edits(int scan) const {
  static const EdgeEdits none;
  const auto found = edge_edits_.find(scan);
  return found == edge_edits_.end() ? none : found->second;
}

void Document::set_edge_edits(int scan, EdgeEdits edits) {
  if (edge_edits(scan) == edits) return;
  edge_edits_[scan] = std::move(edits);
  Q_EMIT edge_edits_changed();
}

std::optional<SeamContinuity> Document::chosen_shape(int loop) const {
  const auto found = shapes_.find(loop);
  return found == shapes_.end() ? std::nullopt : std::optional(found->second);
}

void Document::set_chosen_shapes(const std::map<int, SeamContinuity>& shapes) {
  if (shapes_ == shapes) return;
  shapes_ = shapes;
  Q_EMIT holes_changed();
}

std::optional<MirrorPlane> Document::mirror_plane(int scan) const {
  const auto found = mirror_planes_.find(scan);
  return found == mirror_planes_.end() ? std::nullopt : std::optional(found->second);
}

void Document::set_mirror_plane(int scan, const std::optional<MirrorPlane>& plane) {
  mirror_planes_.erase(scan);
  if (plane) mirror_planes_.emplace(scan, *plane);
}

void Document::set_chosen_units(const std::map<int, std::string>& units) {
  units_ = units;
  Q_EMIT units_changed();
}

int Document::add_scan(std::shared_ptr<OpenedScan> scan) {
  const int index = static_cast<int>(slots_.size());
  const bool first = slots_.empty();
  if (first) origin_ = scan->origin;
  slots_.push_back({scan, loop_count()});
  loops_.insert(loops_.end(), scan->loops.begin(), scan->loops.end());
  scan_of_loop_.resize(loops_.size(), index);
  if (first) Q_EMIT opened();
  Q_EMIT scans_changed();
  return index;
}

void Document::take_scan(int index) {
  slots_[index].scan = nullptr;
  Q_EMIT scans_changed();
}

void Document::put_scan(int index, std::shared_ptr<OpenedScan> scan) {
  slots_[index].scan = std::move(scan);
  Q_EMIT scans_changed();
}

void Document::set_shape(int scan, SurfaceShapePtr shape) {
  const auto at = static_cast<std::size_t>(scan);
  if (at >= slots_.size() || !slots_[at].scan) return;
  slots_[at].scan->shape = std::move(shape);
  Q_EMIT shape_changed(scan);
}

void Document::replace(const std::vector<int>& gone, const std::vector<OpenPatch>& now) {
  bool other_patches = !gone.empty();
  const std::set<int> leaving(gone.begin(), gone.end());
  std::erase_if(patches_, [&](const OpenPatch& p) { return leaving.contains(p.id); });
  for (int id : gone) running_.erase(id);
  index_patches();
  std::vector<int> moved;
  for (const OpenPatch& patch : now) {
    const auto it = patch_by_id_.find(patch.id);
    if (it == patch_by_id_.end()) {
      patches_.push_back(patch);
      other_patches = true;
      continue;
    }
    OpenPatch& old = patches_[it->second];
    if (old.state != patch.state) moved.push_back(patch.id);
    old = patch;
  }
  index_patches();
  if (other_patches) Q_EMIT patches_changed();
  for (int id : moved) Q_EMIT patch_moved(id);
  for (const OpenPatch& patch : now) Q_EMIT timeline_changed(patch.id);
  Q_EMIT holes_changed();
}

void Document::set_states(const std::map<int, PatchStatePtr>& states) {
  bool renamed = false;
  for (const auto& [id, state] : states) {
    const auto it = patch_by_id_.find(id);
    if (it == patch_by_id_.end() || patches_[it->second].state == state) continue;
    PatchStatePtr& now = patches_[it->second].state;
    renamed = renamed || now->status != state->status || now->message != state->message;
    now = state;
    Q_EMIT patch_moved(id);
  }
  if (renamed) Q_EMIT holes_changed();
}

void Document::set_timeline(int id, TimelinePtr timeline) {
  const auto it = patch_by_id_.find(id);
  if (it == patch_by_id_.end()) return;
  patches_[it->second].timeline = std::move(timeline);
  Q_EMIT timeline_changed(id);
}

void Document::set_running(const std::set<int>& ids) {
  if (ids == running_) return;
  running_ = ids;
  Q_EMIT running_changed();
  Q_EMIT holes_changed();
}

void Document::add_failures(const std::map<int, Message>& by_loop) {
  if (by_loop.empty()) return;
  for (const auto& [loop, why] : by_loop) failures_[loop] = why;
  Q_EMIT holes_changed();
}

void Document::forget_failures(const std::set<int>& loops) {
  if (std::erase_if(failures_, [&](const auto& entry) { return loops.contains(entry.first); }) > 0)
    Q_EMIT holes_changed();
}

}  // namespace loopmend
