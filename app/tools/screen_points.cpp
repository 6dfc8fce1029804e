// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/screen_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loopmend {

double distance_to_segment(const QPointF& p, const QPointF& a, const QPointF& b) {
  const QPointF d = b - a;
  const double t = std::clamp(QPointF::dotProduct(p - a, d) / std::max(1e-9, QPointF::dotProduct(d, d)), 0.0, 1.0);
  const QPointF off = p - (a + t * d);
  return std::hypot(off.x(), off.y());
}

void ScreenPoints::set_points(std::vector<float> xyz, std::vector<char> unseen) {
  xyz_ = std::move(xyz);
  unseen_ = std::move(unseen);
  seen_from_.setZero();
}

/// Again only when the eye has moved.
void ScreenPoints::project(const ViewSpace& space) {
  if (seen_from_ == space.to_clip && width_ == space.width && height_ == space.height) return;
  seen_from_ = space.to_clip;
  width_ = space.width;
  height_ = space.height;
  pixels_.resize(static_cast<std::size_t>(count()));
  for (int i = 0; i < count(); ++i) pixels_[i] = space.to_screen(point(i).cast<double>()).cast<float>();
  for (std::size_t i = 0; i < unseen_.size(); ++i)
    if (unseen_[i]) pixels_[i].z() = -1;  // as if it were behind the eye
}

bool ScreenPoints::is_seen(const ViewSpace& space, int i) {
  project(space);
  const Eigen::Vector3f& p = pixels_[i];
  if (p.z() < 0) return false;
  constexpr int around = 2;  // pixels: a surface that is seen at a slant is deeper beside its vertex
  constexpr float slack = 3e-4F;
  const int x = static_cast<int>(std::lround(p.x())), y = static_cast<int>(std::lround(p.y()));
  for (int j = std::max(0, y - around); j <= std::min(height_ - 1, y + around); ++j)
    for (int k = std::max(0, x - around); k <= std::min(width_ - 1, x + around); ++k)
      if (space.depth_at(k, j) + slack >= p.z()) return true;
  return false;
}

std::vector<int> ScreenPoints::under_brush(const ViewSpace& space, const QPointF& a, const QPointF& b, double reach) {
  project(space);
  const Eigen::Vector2f from(static_cast<float>(a.x() * space.ratio), static_cast<float>(a.y() * space.ratio));
  const Eigen::Vector2f way(static_cast<float>((b - a).x() * space.ratio),
                            static_cast<float>((b - a).y() * space.ratio));
  const float length2 = std::max(1e-6F, way.squaredNorm()), r2 = static_cast<float>(std::pow(reach * space.ratio, 2));
  std::vector<int> found;
  for (int i = 0; i < count(); ++i) {
    const Eigen::Vector2f to = pixels_[i].head<2>() - from;
    const float t = std::clamp(to.dot(way) / length2, 0.0F, 1.0F);
    if ((to - t * way).squaredNorm() <= r2 && is_seen(space, i)) found.push_back(i);
  }
  return found;
}

std::vector<int> ScreenPoints::within(const ViewSpace& space, const QPolygonF& outline, Hidden hidden) {
  project(space);
  const QRectF box = outline.boundingRect();
  std::vector<int> found;
  for (int i = 0; i < count(); ++i) {
    const Eigen::Vector3f& p = pixels_[i];
    const QPointF at(p.x() / space.ratio, p.y() / space.ratio);
    if (p.z() < 0 || !box.contains(at) || !outline.containsPoint(at, Qt::OddEvenFill)) continue;
    if (hidden == Hidden::taken || is_seen(space, i)) found.push_back(i);
  }
  return found;
}

int ScreenPoints::nearest(const ViewSpace& space, const QPointF& at, double reach) {
  project(space);
  int best = -1;
  double best_distance = reach * space.ratio;
  for (int i = 0; i < count(); ++i) {
    const Eigen::Vector3f& p = pixels_[i];
    const double distance = std::hypot(p.x() - at.x() * space.ratio, p.y() - at.y() * space.ratio);
    if (p.z() < 0 || distance >= best_distance || !is_seen(space, i)) continue;
    best_distance = distance;
    best = i;
  }
  return best;
}

QPointF ScreenPoints::on_screen(const ViewSpace& space, int i) {
  project(space);
  const Eigen::Vector3f& p = pixels_[i];
  if (p.z() < 0) return {std::numeric_limits<double>::quiet_NaN(), 0};
  return {p.x() / space.ratio, p.y() / space.ratio};
}

}  // namespace loopmend
