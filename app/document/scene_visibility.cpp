// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene_visibility.h"

#include <algorithm>
#include <array>

namespace loopmend {

SceneVisibility::SceneVisibility(const Document& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document_, &Document::opened, this, [this] {
    known_scans_.clear();
    if (hidden_.empty() && hidden_patches_.empty()) return;
    hidden_.clear();
    hidden_patches_.clear();
    Q_EMIT changed();
  });
  connect(&document_, &Document::scans_changed, this, &SceneVisibility::follow_scans);
}

int SceneVisibility::piece_count(int scan) const {
  const auto opened = document_.scan(scan);
  return opened ? std::max(1, static_cast<int>(opened->pieces.list.size())) : 1;
}

PieceId SceneVisibility::piece_of_loop(int loop) const {
  const int scan = document_.scan_of(loop);
  const auto opened = document_.scan(scan);
  return {scan, opened ? opened->pieces.piece_of(document_.loop(loop).vertices.front()) : 0};
}

bool SceneVisibility::is_hidden_patch(const OpenPatch& patch) const {
  return hidden_patches_.contains(patch.id) ||
         (!hidden_.empty() &&
          std::all_of(patch.loops.begin(), patch.loops.end(), [this](int loop) { return is_hidden_loop(loop); }));
}

bool SceneVisibility::is_hidden_vertex(int scan, int vertex) const {
  return !hidden_.empty() && is_hidden(PieceId{scan, document_.scan(scan)->pieces.piece_of(vertex)});
}

bool SceneVisibility::hides_pieces_of(int scan) const {
  const auto first = hidden_.lower_bound({scan, 0});
  return first != hidden_.end() && first->scan == scan;
}

int SceneVisibility::hidden_count() const {
  const auto pieces = std::count_if(hidden_.begin(), hidden_.end(),
                                    [this](const PieceId& p) { return document_.scan(p.scan) != nullptr; });
  const auto patches = std::count_if(hidden_patches_.begin(), hidden_patches_.end(),
                                     [this](int id) { return document_.patch(id) != nullptr; });
  return static_cast<int>(pieces + patches);
}

void SceneVisibility::set_pieces(const std::set<PieceId>& pieces, Visible visible) {
  for (const PieceId& piece : pieces)
    if (visible == Visible::hidden)
      hidden_.insert(piece);
    else
      hidden_.erase(piece);
  Q_EMIT changed();
}

void SceneVisibility::set_patches(const std::set<int>& ids, Visible visible) {
  for (int id : ids)
    if (visible == Visible::hidden)
      hidden_patches_.insert(id);
    else
      hidden_patches_.erase(id);
  Q_EMIT changed();
}

void SceneVisibility::isolate(const std::set<PieceId>& pieces) {
  hidden_.clear();
  for (int scan : document_.scans())
    for (int piece = 0; piece < piece_count(scan); ++piece)
      if (!pieces.contains({scan, piece})) hidden_.insert({scan, piece});
  Q_EMIT changed();
}

void SceneVisibility::show_all() {
  hidden_.clear();
  hidden_patches_.clear();
  Q_EMIT changed();
}

void SceneVisibility::follow_scans() {
  const std::size_t before = hidden_.size();
  for (int scan : document_.scans())
    if (known_scans_.insert(scan).second) hide_heirs(scan);
  if (hidden_.size() != before) Q_EMIT changed();
}

/// Where a scan comes in place of another, trimmed or bridged, what was hidden stays so: a piece whose first vertex is one of a
/// hidden piece.
void SceneVisibility::hide_heirs(int scan) {
  const auto heir = document_.scan(scan);
  if (hidden_.empty() || heir->from != ScanOrigin::made) return;
  using Place = std::array<double, 3>;
  const auto place_of = [](const OpenedScan& opened, int vertex) {
    const Vec3& p = opened.model->soup.points[opened.model->soup_vertex[vertex]];
    return Place{p.x(), p.y(), p.z()};
  };
  std::vector<Place> places;
  for (int old : known_scans_) {
    const auto opened = document_.scan(old);
    if (!opened || old == scan || !hides_pieces_of(old)) continue;
    const int vertices = static_cast<int>(opened->model->soup_vertex.size());
    for (int v = 0; v < vertices; ++v)
      if (is_hidden_vertex(old, v)) places.push_back(place_of(*opened, v));
  }
  std::sort(places.begin(), places.end());
  for (int piece = 0; piece < piece_count(scan); ++piece) {
    const int first = heir->pieces.list.empty() ? 0 : heir->pieces.list[piece].first_vertex;
    if (std::binary_search(places.begin(), places.end(), place_of(*heir, first))) hidden_.insert({scan, piece});
  }
}

}  // namespace loopmend
