// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/loop_picker.h"

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

struct Nearest {
  double distance = 0;
  LoopPicker::Pixel at;
};

Nearest nearest_on_segment(double x, double y, const LoopPicker::Pixel& a, const LoopPicker::Pixel& b) {
  const Eigen::Vector2d d = (b - a).head<2>(), to = Eigen::Vector2d(x, y) - a.head<2>();
  const double length2 = d.squaredNorm();
  const double t = length2 > 0 ? std::clamp(to.dot(d) / length2, 0.0, 1.0) : 0;
  return {(to - t * d).norm(), a + t * (b - a)};
}

}  // namespace

void LoopPicker::set_loops(std::vector<std::vector<float>> loops) {
  loops_ = std::move(loops);
  projected_.assign(loops_.size(), {});
}

void LoopPicker::set_view(const Eigen::Matrix4d& to_clip, int width, int height) {
  width_ = width;
  height_ = height;
  for (std::size_t l = 0; l < loops_.size(); ++l) {
    const std::vector<float>& xyz = loops_[l];
    projected_[l].resize(xyz.size() / 3);
    for (std::size_t i = 0; i < projected_[l].size(); ++i) {
      const Eigen::Vector4d p = to_clip * Eigen::Vector4d(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2], 1);
      if (p.w() <= 0) {
        projected_[l][i] = Pixel(0, 0, -1);
        continue;
      }
      const Eigen::Vector3d n = p.head<3>() / p.w();
      projected_[l][i] = Pixel((n.x() + 1) / 2 * width, (1 - n.y()) / 2 * height, (n.z() + 1) / 2);
    }
  }
}

const std::vector<LoopPicker::Pixel>& LoopPicker::projected(int loop) const { return projected_[loop]; }

int LoopPicker::pick(double x, double y, double reach, const DepthAt& depth_at) const {
  int best = -1;
  double best_distance = reach;
  for (std::size_t l = 0; l < projected_.size(); ++l) {
    const std::vector<Pixel>& loop = projected_[l];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Pixel &a = loop[i], &b = loop[(i + 1) % loop.size()];
      if (a.z() < 0 || b.z() < 0) continue;
      const Nearest nearest = nearest_on_segment(x, y, a, b);
      if (nearest.distance >= best_distance || !visible(nearest.at, depth_at)) continue;
      best_distance = nearest.distance;
      best = static_cast<int>(l);
    }
  }
  return best;
}

int LoopPicker::around(double x, double y, const std::function<bool(int loop)>& wanted, const DepthAt& depth_at) const {
  const double depth = depth_at(static_cast<int>(x), static_cast<int>(y));
  int best = -1;
  double best_area = 0;
  for (std::size_t l = 0; l < projected_.size(); ++l) {
    const std::vector<Pixel>& loop = projected_[l];
    double area = 0, nearest = 1, farthest = 0;
    bool is_inside = false, is_before_eye = !loop.empty();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Pixel &a = loop[i], &b = loop[(i + 1) % loop.size()];
      is_before_eye = is_before_eye && a.z() >= 0;
      nearest = std::min(nearest, a.z());
      farthest = std::max(farthest, a.z());
      area += (a.x() * b.y() - b.x() * a.y()) / 2;
      if ((a.y() > y) != (b.y() > y) && x < a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
        is_inside = !is_inside;
    }
    // A patch may bulge before its boundary, by about as much as that is deep.
    constexpr double slack = 2e-4;
    if (!is_before_eye || !is_inside || depth < nearest - (farthest - nearest) - slack) continue;
    if ((best >= 0 && std::abs(area) >= best_area) || !wanted(static_cast<int>(l))) continue;
    best_area = std::abs(area);
    best = static_cast<int>(l);
  }
  return best;
}

bool LoopPicker::visible(const Pixel& at, const DepthAt& depth_at) const {
  // A boundary borders its hole, so the deepest pixel close by belongs to the boundary or lies behind it.
  constexpr int around = 3;
  constexpr double slack = 2e-4;
  const int cx = static_cast<int>(std::lround(at.x())), cy = static_cast<int>(std::lround(at.y()));
  for (int y = std::max(0, cy - around); y <= std::min(height_ - 1, cy + around); ++y)
    for (int x = std::max(0, cx - around); x <= std::min(width_ - 1, cx + around); ++x)
      if (depth_at(x, y) + slack >= at.z()) return true;
  return false;
}

}  // namespace loopmend
