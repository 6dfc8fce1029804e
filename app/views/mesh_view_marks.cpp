// SPDX-License-Identifier: GPL-3.0-or-later
// What MeshView paints over the picture to name holes: the loop under the mouse, corners around selected patches.
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
  impl_->overlay->set_marks(marks);
}

}  // namespace loopmend
