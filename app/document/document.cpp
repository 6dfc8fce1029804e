#include "document/document.h"

#include <algorithm>

namespace loopmend {

const std::vector<BoundaryLoop>& Document::loops() const {
  static const std::vector<BoundaryLoop> none;
  return scan_ ? scan_->loops : none;
}

const OpenPatch* Document::patch(int id) const {
  const auto it = std::find_if(patches_.begin(), patches_.end(), [id](const OpenPatch& p) { return p.id == id; });
  return it == patches_.end() ? nullptr : &*it;
}

const OpenPatch* Document::patch_of(int loop) const {
  for (const OpenPatch& patch : patches_)
    if (std::find(patch.loops.begin(), patch.loops.end(), loop) != patch.loops.end()) return &patch;
  return nullptr;
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
  Q_EMIT patches_changed();
  Q_EMIT holes_changed();
}

void Document::remove_patches(const std::vector<int>& ids) {
  std::erase_if(patches_, [&](const OpenPatch& p) { return std::find(ids.begin(), ids.end(), p.id) != ids.end(); });
  for (int id : ids) running_.erase(id);
  Q_EMIT patches_changed();
  Q_EMIT holes_changed();
}

void Document::set_state(int id, PatchStatePtr state) {
  for (OpenPatch& patch : patches_) {
    if (patch.id != id || patch.state == state) continue;
    patch.state = std::move(state);
    Q_EMIT patch_moved(id);
    Q_EMIT holes_changed();
    return;
  }
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
