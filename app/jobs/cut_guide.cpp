// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/cut_guide.h"

#include "document/targets.h"

#include <Eigen/Geometry>

namespace loopmend {
namespace {

Eigen::AlignedBox3d box_of(const TriangleSoup& soup) {
  Eigen::AlignedBox3d box;
  for (const Triangle& t : soup.triangles)
    for (int v : t) box.extend(soup.points[v]);
  return box;
}

}  // namespace

CutGuide::CutGuide(const Document& document, const HoleSelection& selection, QObject* parent)
    : PlaneGuide(parent),
      document_(document),
      selection_(selection) {
  for (auto signal : {&Document::opened, &Document::scans_changed})
    connect(&document_, signal, this, &CutGuide::follow);
  connect(&selection_, &HoleSelection::selection_changed, this, &CutGuide::follow);
}

void CutGuide::watch(Watch what) {
  watch_ = what;
  follow();
}

/// At first the plane parts the longest side of the scan's box, and the upper half would go.
void CutGuide::follow() {
  const int scan = watch_ == Watch::scan ? scan_of_selection(document_, selection_) : -1;
  if (scan == scan_) return;
  const bool keeps_plane = plane_ && scan >= 0 && scan_ >= 0 && !document_.scan(scan_);  // a changed scan in its place
  scan_ = scan;
  if (keeps_plane) {
    Q_EMIT changed();
    return;
  }
  plane_.reset();
  if (scan < 0) {
    Q_EMIT changed();
    return;
  }
  Eigen::Index longest = 0;
  box_of(document_.scan(scan)->model->soup).sizes().maxCoeff(&longest);
  place_across(static_cast<int>(longest));
}

void CutGuide::move_plane(const MirrorPlane& plane) {
  plane_ = plane;
  Q_EMIT changed();
}

void CutGuide::place_across(int axis) {
  if (scan_ < 0) return;
  MirrorPlane plane;
  plane.point = box_of(document_.scan(scan_)->model->soup).center();
  plane.normal = Vec3::Unit(axis);
  move_plane(plane);
}

void CutGuide::turn() {
  if (!plane_) return;
  plane_->normal = -plane_->normal;
  Q_EMIT changed();
}

}  // namespace loopmend
