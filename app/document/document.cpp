#include "document/document.h"

#include <algorithm>

namespace loopmend {

const std::vector<BoundaryLoop>& Document::loops() const {
  static const std::vector<BoundaryLoop> none;
  return scan_ ? scan_->loops : none;
}

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
  switch (patch->state->stage) {
    case PatchStage::filled: return HoleState::filled;
    case PatchStage::stepped: return HoleState::stepped;
    case PatchStage::converged: return HoleState::converged;
    case PatchStage::failed: return HoleState::failed;
  }
  return HoleState::open;
}

QString Document::message(int loop) const {
  if (const OpenPatch* patch = patch_of(loop)) return QString::fromStdString(patch->state->message);
  const auto it = failures_.find(loop);
  return it == failures_.end() ? QString() : QString::fromStdString(it->second);
}

bool Document::fillable(int loop) const {
  const LoopKind kind = loops()[static_cast<std::size_t>(loop)].kind;
  return kind == LoopKind::hole || kind == LoopKind::touching;
}

void Document::open(OpenedScan scan) {
  scan_ = std::make_unique<OpenedScan>(std::move(scan));
  patches_.clear();
  index_patches();
  running_.clear();
  failures_.clear();
  Q_EMIT opened();
}

void Document::set_shape(std::shared_ptr<const SurfaceShape> shape) {
  if (!scan_) return;
  scan_->shape = std::move(shape);
  Q_EMIT shape_changed();
}

void Document::add_patches(const std::vector<OpenPatch>& patches) {
  patches_.insert(patches_.end(), patches.begin(), patches.end());
  index_patches();
  Q_EMIT patches_changed();
  Q_EMIT holes_changed();
}

void Document::remove_patches(const std::vector<int>& ids) {
  std::erase_if(patches_, [&](const OpenPatch& p) { return std::find(ids.begin(), ids.end(), p.id) != ids.end(); });
  index_patches();
  for (int id : ids) running_.erase(id);
  Q_EMIT patches_changed();
  Q_EMIT holes_changed();
}

void Document::set_states(const std::map<int, PatchStatePtr>& states) {
  bool renamed = false;
  for (const auto& [id, state] : states) {
    const auto it = patch_by_id_.find(id);
    if (it == patch_by_id_.end() || patches_[it->second].state == state) continue;
    PatchStatePtr& now = patches_[it->second].state;
    renamed = renamed || now->stage != state->stage || now->message != state->message;
    now = state;
    Q_EMIT patch_moved(id);
  }
  if (renamed) Q_EMIT holes_changed();
}

void Document::set_running(const std::set<int>& ids) {
  if (ids == running_) return;
  running_ = ids;
  Q_EMIT holes_changed();
}

void Document::set_failures(const std::map<int, std::string>& words_by_loop) {
  failures_ = words_by_loop;
  Q_EMIT holes_changed();
}

}  // namespace loopmend
