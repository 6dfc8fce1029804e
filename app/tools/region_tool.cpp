// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/region_tool.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

namespace loopmend {

RegionTool::RegionTool(const Document& document, const SceneVisibility& visibility, QObject* parent)
    : QObject(parent),
      document_(document),
      visibility_(visibility) {
  connect(&visibility_, &SceneVisibility::changed, this, &RegionTool::drop);
  connect(&document_, &Document::opened, this, &RegionTool::forget);
  connect(&document_, &Document::scans_changed, this, &RegionTool::drop);
  connect(&document_, &Document::patches_changed, this, &RegionTool::drop);
  connect(&document_, &Document::patch_moved, this, &RegionTool::drop);
}

/// Other surfaces: what was chosen on the old ones means nothing any more.
void RegionTool::forget() {
  fresh_ = false;
  const bool had = chosen_count_ > 0;
  chosen_.clear();
  chosen_count_ = 0;
  scan_ = -1;
  if (had) Q_EMIT changed();
}

void RegionTool::drop() {
  const bool had = chosen_count_ > 0;
  forget();
  if (had) Q_EMIT dropped();
}

/// Scans, each followed by the new vertices of its patches, in the order in which a paste would append them.
void RegionTool::take_surface() {
  if (std::exchange(fresh_, true)) return;
  std::vector<float> xyz;
  std::vector<char> unseen;
  soup_.clear();
  scan_of_.clear();
  triangles_.clear();
  normals_.clear();
  for (int index : document_.scans()) {
    const auto scan = document_.scan(index);
    const SurfaceShape& shape = *scan->shape;
    const int first = static_cast<int>(soup_.size());
    xyz.insert(xyz.end(), shape.points.begin(), shape.points.end());
    normals_.insert(normals_.end(), shape.normals.begin(), shape.normals.end());
    soup_.insert(soup_.end(), scan->model->soup_vertex.begin(), scan->model->soup_vertex.end());
    const int vertices = static_cast<int>(shape.points.size() / 3);
    for (int v = 0; v < vertices; ++v) unseen.push_back(visibility_.is_hidden_vertex(index, v));
    for (int v : shape.triangles) triangles_.push_back(first + v);
    int next_point = static_cast<int>(scan->model->soup.points.size());
    for (const OpenPatch& open : document_.patches()) {
      if (open.scan != index) continue;
      const Patch& patch = open.state->patch;
      const SurfaceShape& seen = *open.state->shape;
      const int own = static_cast<int>(soup_.size());
      xyz.insert(xyz.end(), seen.points.begin(), seen.points.begin() + 3 * patch.free_count);
      normals_.insert(normals_.end(), seen.normals.begin(), seen.normals.begin() + 3 * patch.free_count);
      for (int i = 0; i < patch.free_count; ++i) soup_.push_back(next_point++);
      unseen.resize(soup_.size(), visibility_.is_hidden_patch(open));
      for (int t = 0; t < patch.patch_triangles; ++t)
        for (int v : patch.triangles[t])
          triangles_.push_back(v < patch.free_count ? own + v : first + patch.view_vertex[v]);
    }
    scan_of_.resize(soup_.size(), index);
  }
  points_.set_points(std::move(xyz), std::move(unseen));
  chosen_.assign(soup_.size(), 0);
  chosen_count_ = 0;
  scan_ = -1;
}

void RegionTool::recount() {
  chosen_count_ = static_cast<int>(std::count(chosen_.begin(), chosen_.end(), 1));
  if (chosen_count_ == 0) scan_ = -1;
  Q_EMIT changed();
}

void RegionTool::clear() {
  if (chosen_count_ == 0) return;
  std::fill(chosen_.begin(), chosen_.end(), 0);
  recount();
}

/// The first vertex under the brush decides which scan the region belongs to.
void RegionTool::choose(const std::vector<int>& found, Effect effect) {
  bool other = false, beside = false;
  for (int v : found) {
    const auto at = static_cast<std::size_t>(v);
    if (scan_ < 0 && effect == Effect::add) scan_ = scan_of_[at];
    if (scan_of_[at] != scan_) {
      beside = true;
      continue;
    }
    const char wanted = effect == Effect::add;
    other = other || chosen_[at] != wanted;
    chosen_[at] = wanted;
  }
  if (other)
    recount();
  else if (beside && effect == Effect::add)
    Q_EMIT beside_scan(scan_);
}

bool RegionTool::shows_outside(const ViewSpace& space, int vertex) const {
  const Eigen::Vector3d p = points_.point(vertex).cast<double>();
  const Eigen::Vector4d clip = space.to_clip * Eigen::Vector4d(p.x(), p.y(), p.z(), 1);
  const Eigen::Matrix4d back = space.to_clip.inverse();
  const auto at_depth = [&](double depth) {
    const Eigen::Vector4d q = back * Eigen::Vector4d(clip.x() / clip.w(), clip.y() / clip.w(), depth, 1);
    return Eigen::Vector3d(q.head<3>() / q.w());
  };
  const Eigen::Vector3d sight = at_depth(1) - at_depth(-1);
  const Eigen::Map<const Eigen::Vector3f> normal(normals_.data() + 3 * static_cast<std::size_t>(vertex));
  return normal.cast<double>().dot(sight) <= 0;
}

std::vector<int> RegionTool::on_painted_side(const ViewSpace& space, std::vector<int> found) const {
  std::erase_if(found, [&](int v) { return shows_outside(space, v) != outside_; });
  return found;
}

void RegionTool::move_edge(Ring ring) {
  if (chosen_count_ == 0) return;
  const char from = ring == Ring::outward;
  std::vector<char> next = chosen_;
  for (std::size_t t = 0; t + 2 < triangles_.size(); t += 3) {
    const auto corner = [&](std::size_t k) { return static_cast<std::size_t>(triangles_[t + k]); };
    const bool touches = chosen_[corner(0)] == from || chosen_[corner(1)] == from || chosen_[corner(2)] == from;
    if (!touches) continue;
    for (std::size_t k = 0; k < 3; ++k) next[corner(k)] = from;
  }
  chosen_ = std::move(next);
  recount();
}

void RegionTool::grow() { move_edge(Ring::outward); }

void RegionTool::shrink() { move_edge(Ring::inward); }

std::vector<int> RegionTool::vertices() const {
  std::vector<int> points;
  for (std::size_t i = 0; i < chosen_.size(); ++i)
    if (chosen_[i]) points.push_back(soup_[i]);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

void RegionTool::set_vertices(int scan, const std::vector<int>& points) {
  take_surface();
  std::vector<int> wanted = points;
  std::sort(wanted.begin(), wanted.end());
  for (std::size_t i = 0; i < chosen_.size(); ++i)
    chosen_[i] = scan_of_[i] == scan && std::binary_search(wanted.begin(), wanted.end(), soup_[i]);
  scan_ = scan;
  recount();
}

SurfaceShapePtr RegionTool::shape() const {
  if (chosen_count_ == 0) return nullptr;
  auto shape = std::make_shared<SurfaceShape>();
  std::vector<int> number(chosen_.size(), -1), corners;
  for (std::size_t t = 0; t + 2 < triangles_.size(); t += 3) {
    bool moves = false;
    for (std::size_t k = 0; k < 3; ++k) moves = moves || chosen_[triangles_[t + k]];
    if (!moves) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const int v = triangles_[t + k];
      int& n = number[v];
      if (n < 0) {
        n = static_cast<int>(shape->points.size() / 3);
        const Eigen::Vector3f p = points_.point(v);
        shape->points.insert(shape->points.end(), p.data(), p.data() + 3);
        const auto normal = normals_.begin() + 3 * static_cast<std::ptrdiff_t>(v);
        shape->normals.insert(shape->normals.end(), normal, normal + 3);
      }
      corners.push_back(n);
    }
    ++shape->own_triangles;
  }
  shape->triangles = std::move(corners);
  return shape;
}

bool RegionTool::mouse(Act act, const QMouseEvent& event, const ViewSpace& space) {
  const QPointF at = event.localPos();
  const QPointF before = std::exchange(at_, at);
  if (act == Act::hover) return true;
  if (act == Act::press) {
    if (event.button() != Qt::LeftButton || event.modifiers().testFlag(Qt::ShiftModifier)) return false;
    take_surface();
    const bool ctrl = event.modifiers().testFlag(Qt::ControlModifier);
    stroke_ = ctrl != (effect_ == Effect::erase) ? Effect::erase : Effect::add;
    if (means_ == Means::lasso) {
      outline_ = QPolygonF{{at}};
      return true;
    }
    const std::vector<int> found = points_.under_brush(space, at, at, radius_);
    if (found.empty()) return false;  // beside the surface: the picture turns
    const auto depth = [&](int v) { return space.to_screen(points_.point(v).cast<double>()).z(); };
    outside_ = shows_outside(
        space, *std::min_element(found.begin(), found.end(), [&](int a, int b) { return depth(a) < depth(b); }));
    choose(on_painted_side(space, found), stroke_);
    return true;
  }
  if (means_ == Means::brush) {
    if (act == Act::move) choose(on_painted_side(space, points_.under_brush(space, before, at, radius_)), stroke_);
    return true;
  }
  outline_ << at;
  if (act != Act::release) return true;
  std::vector<int> found = points_.within(space, std::exchange(outline_, {}), hidden_);
  if (hidden_ == ScreenPoints::Hidden::left_out) {
    const auto outside = std::count_if(found.begin(), found.end(), [&](int v) { return shows_outside(space, v); });
    outside_ = 2 * outside >= static_cast<std::ptrdiff_t>(found.size());
    found = on_painted_side(space, std::move(found));
  }
  choose(found, stroke_);
  return true;
}

void RegionTool::paint(QPainter& painter, const ViewSpace&) {
  painter.setBrush(Qt::NoBrush);
  const auto twice = [&](const auto& draw) {  // dark in light, so that it reads on any ground
    painter.setPen(QPen(QColor(255, 255, 255, 220), 3));
    draw();
    painter.setPen(QPen(QColor(20, 24, 30), 1.2));
    draw();
  };
  if (means_ == Means::brush) twice([&] { painter.drawEllipse(at_, radius_, radius_); });
  if (outline_.size() > 1) twice([&] { painter.drawPolygon(outline_); });
}

}  // namespace loopmend
