// SPDX-License-Identifier: GPL-3.0-or-later
// What MeshView paints over the picture: the loop under the mouse, corners around selected patches and around a place.
#include "document/labels.h"
#include "views/mesh_view_impl.h"

namespace loopmend {

void MeshView::update_highlight() {
  const Document& document = impl_->document;
  const int loop = impl_->selection.hovered();
  if (loop < 0 || loop >= impl_->picker.count() || !impl_->shows(loop)) {
    impl_->overlay->clear_highlight();
    return;
  }
  const QPolygonF line = line_on_screen(loop);
  const BoundaryLoop& l = document.loop(loop);
  const QString kind = l.kind == LoopKind::hole ? tr("Hole") : labels::sentence(labels::kind(l.kind));
  impl_->overlay->set_highlight(
      line, tr("%1 %2 \u00b7 %3 edges \u00b7 %4 across \u00b7 %5")
                .arg(kind, labels::hole_name(document, loop))
                .arg(l.edges())
                .arg(labels::length(document, l.diameter), labels::verdict_or_state(document, loop)));
}

/// In logical pixels, without what lies behind the eye.
QPolygonF MeshView::line_on_screen(int loop) const {
  impl_->follow_camera();
  const double ratio = impl_->canvas->devicePixelRatioF();
  QPolygonF line;
  for (const LoopPicker::Pixel& p : impl_->picker.projected(loop))
    if (p.z() >= 0) line << QPointF(p.x(), p.y()) / ratio;
  return line;
}

/// The line of a selected hole goes when it has a patch. Of more than a few patches no mark says which one is meant.
void MeshView::update_marks() {
  constexpr std::size_t most_marks = 12;
  const Document& document = impl_->document;
  std::vector<int> marked;
  for (int loop : impl_->selection.selected())
    if (loop < impl_->picker.count() && impl_->shows(loop) && document.patch_of(loop)) marked.push_back(loop);
  if (impl_->preview_shown || marked.size() > most_marks) marked.clear();
  std::vector<ViewOverlay::Mark> marks;
  const Vec3 eye = pose_of(impl_->camera()).position + document.origin();
  for (int loop : marked) {
    const BoundaryLoop& l = document.loop(loop);
    const QRectF box = line_on_screen(loop).boundingRect();
    if (box.isEmpty()) continue;
    using Side = ViewOverlay::Mark::Side;
    const bool seen = facing(*document.scan(document.scan_of(loop))->model, l).dot(eye - l.center) > 0;
    marks.push_back({box, seen ? Side::seen : Side::from_behind});
  }
  if (impl_->place)
    if (const QRectF box = box_on_screen(*impl_->place); !box.isEmpty()) marks.push_back({box});
  impl_->overlay->set_marks(marks);
}

/// Of the ball's bounding box, a few pixels at least; empty where a corner of it is behind the eye.
QRectF MeshView::box_on_screen(const MarkedPlace& place) const {
  constexpr double least = 6;
  const Eigen::Matrix4d to_clip = impl_->to_clip();
  const QSize size = impl_->canvas->size();
  QPolygonF corners;
  for (int k = 0; k < 8; ++k) {
    const Vec3 way(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
    const Eigen::Vector4d p = to_clip * Vec3(place.center + place.radius * way).homogeneous();
    if (!(p.w() > 0)) return {};
    corners << QPointF(size.width() * (1 + p.x() / p.w()) / 2, size.height() * (1 - p.y() / p.w()) / 2);
  }
  const QRectF box = corners.boundingRect();
  const double wider = std::max(0.0, least - box.width() / 2), higher = std::max(0.0, least - box.height() / 2);
  return box.adjusted(-wider, -higher, wider, higher);
}

}  // namespace loopmend
