// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/shape_glide.h"

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

/// Unknown values become known at once: there is nothing between.
void mix(const std::vector<float>& from, const std::vector<float>& to, float share, std::vector<float>& out) {
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = std::isfinite(from[i]) ? from[i] + share * (to[i] - from[i]) : to[i];
}

}  // namespace

/// A flow flips edges here and there; where most triangles are others, the vertices are others, too.
bool ShapeGlide::is_possible(const SurfaceShape& from, const SurfaceShape& to) {
  if (from.points.size() != to.points.size() || from.H.size() != to.H.size() || from.K.size() != to.K.size() ||
      from.deviation.size() != to.deviation.size() || from.triangles.size() != to.triangles.size())
    return false;
  std::size_t same = 0;
  for (std::size_t i = 0; i < to.triangles.size(); ++i) same += from.triangles[i] == to.triangles[i];
  return 2 * same > to.triangles.size();
}

ShapeGlide::ShapeGlide(const SurfaceShape& from, SurfaceShapePtr to, Clock::time_point now, Clock::duration time)
    : to_(std::move(to)) {
  shown_.points = from.points;
  shown_.normals = from.normals;
  shown_.H = from.H;
  shown_.K = from.K;
  shown_.deviation = from.deviation;
  start_from_shown(now, now + time);
}

void ShapeGlide::start_from_shown(Clock::time_point now, Clock::time_point end) {
  from_ = shown_;
  begin_ = now;
  end_ = end;
}

void ShapeGlide::advance(Clock::time_point now) {
  const std::chrono::duration<float> all = end_ - begin_, gone = now - begin_;
  const float share = all.count() > 0 ? std::clamp(gone / all, 0.0F, 1.0F) : 1.0F;
  mix(from_.points, to_->points, share, shown_.points);
  mix(from_.normals, to_->normals, share, shown_.normals);
  mix(from_.H, to_->H, share, shown_.H);
  mix(from_.K, to_->K, share, shown_.K);
  mix(from_.deviation, to_->deviation, share, shown_.deviation);
}

void ShapeGlide::hurry(Clock::time_point now, Clock::time_point end) {
  if (end >= end_) return;
  advance(now);
  start_from_shown(now, end);
}

}  // namespace loopmend
