// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/changes.h"

#include <algorithm>

namespace loopmend {
namespace {

std::size_t size_of(const OpenedScan& scan) {
  const TriangleSoup& soup = scan.model->soup;
  constexpr std::size_t halfedge_view_bytes = 250;  // OpenMesh, per vertex with its six halfedges and two faces
  std::size_t sum =
      soup.points.size() * (sizeof(Vec3) + halfedge_view_bytes) + soup.triangles.size() * sizeof(Triangle);
  if (scan.shape) sum += 4 * (scan.shape->points.size() * 2 + scan.shape->triangles.size() + scan.shape->H.size() * 2);
  return sum;
}

}  // namespace

PatchChange::PatchChange(Document& document, std::vector<Pair> pairs, const QString& text, Joining joining)
    : Change(text),
      document_(document),
      pairs_(std::move(pairs)),
      joining_(joining) {}

bool PatchChange::mergeWith(const QUndoCommand* next) {
  const auto* change = dynamic_cast<const PatchChange*>(next);
  if (!change || change->joining_ == Joining::none || forgotten()) return false;
  for (const Pair& pair : change->pairs_) {
    const auto ours = std::find_if(pairs_.begin(), pairs_.end(), [&](const Pair& mine) {
      return mine.after && pair.before && mine.after->id == pair.before->id;
    });
    if (ours == pairs_.end())
      pairs_.push_back(pair);
    else
      ours->after = pair.after;
  }
  std::erase_if(pairs_, [](const Pair& pair) { return !pair.before && !pair.after; });
  setText(change->text());
  return true;
}

void PatchChange::redo() { go(Direction::forth); }

void PatchChange::undo() { go(Direction::back); }

void PatchChange::go(Direction direction) {
  std::vector<int> gone;
  std::vector<OpenPatch> now;
  for (const Pair& pair : pairs_) {
    const auto& from = direction == Direction::forth ? pair.before : pair.after;
    const auto& to = direction == Direction::forth ? pair.after : pair.before;
    if (to) {
      now.push_back(*to);
    } else if (from) {
      gone.push_back(from->id);
    }
  }
  document_.replace(gone, now);
}

std::size_t PatchChange::held_bytes(std::set<const void*>& seen) const {
  std::size_t sum = 0;
  const auto count = [&](const PatchStatePtr& state) {
    if (seen.insert(state.get()).second) sum += size_of(*state);
  };
  for (const Pair& pair : pairs_)
    for (const auto& side : {pair.before, pair.after}) {
      if (!side) continue;
      count(side->state);
      for (const PatchStatePtr& state : *side->timeline) count(state);
    }
  return sum;
}

ScanChange::ScanChange(Document& document, int scan, const QString& text)
    : Change(text),
      document_(document),
      scan_(scan),
      held_(document.held_scan(scan)) {}

std::size_t ScanChange::held_bytes(std::set<const void*>& seen) const {
  const bool ours = held_ && !document_.scan(scan_) && seen.insert(held_.get()).second;
  return ours ? size_of(*held_) : 0;
}

void AddScan::redo() {
  if (!document_.scan(scan_)) document_.put_scan(scan_, held_);
}

CloseScan::CloseScan(Document& document, int scan, const QString& text) : ScanChange(document, scan, text) {
  for (const OpenPatch& patch : document.patches())
    if (patch.scan == scan) patches_.push_back(patch);
}

void CloseScan::redo() {
  std::vector<int> gone;
  for (const OpenPatch& patch : patches_) gone.push_back(patch.id);
  document_.replace(gone, {});
  document_.take_scan(scan_);
}

void CloseScan::undo() {
  document_.put_scan(scan_, held_);
  document_.replace({}, patches_);
}

ChooseUnits::ChooseUnits(Document& document, std::map<int, std::string> after, const QString& text)
    : Change(text),
      document_(document),
      before_(document.chosen_units()),
      after_(std::move(after)) {}

ChooseShapes::ChooseShapes(Document& document, std::map<int, SeamContinuity> after, const QString& text)
    : Change(text),
      document_(document),
      before_(document.chosen_shapes()),
      after_(std::move(after)) {}

ChangeGroup::ChangeGroup(std::vector<std::unique_ptr<Change>> parts, const QString& text)
    : Change(text),
      parts_(std::move(parts)) {}

void ChangeGroup::redo() {
  for (auto& part : parts_) part->redo();
}

void ChangeGroup::undo() {
  for (auto part = parts_.rbegin(); part != parts_.rend(); ++part) (*part)->undo();
}

bool ChangeGroup::mergeWith(const QUndoCommand* next) {
  const auto* change = dynamic_cast<const PatchChange*>(next);
  if (!change || change->joining() == PatchChange::Joining::none || forgotten()) return false;
  auto* last = parts_.empty() ? nullptr : dynamic_cast<PatchChange*>(parts_.back().get());
  if (!last || !last->mergeWith(next)) parts_.push_back(change->copy());
  return true;
}

std::size_t ChangeGroup::held_bytes(std::set<const void*>& seen) const {
  std::size_t sum = 0;
  for (const auto& part : parts_) sum += part->held_bytes(seen);
  return sum;
}

void ChangeGroup::forget() {
  for (auto& part : parts_) part->forget();
}

bool ChangeGroup::forgotten() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const auto& part) { return part->forgotten(); });
}

}  // namespace loopmend
