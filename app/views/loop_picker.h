// SPDX-License-Identifier: GPL-3.0-or-later
// Which loop is under the mouse: nearest projected segment, if it is not hidden behind the surface.
#pragma once

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace loopmend {

class LoopPicker {
 public:
  using Pixel = Eigen::Vector3d;  ///< x right, y down, in device pixels; z depth 0..1, < 0 behind the eye

  /// Each loop as x y z x y z ..., closed by itself.
  void set_loops(std::vector<std::vector<float>> loops);
  /// @param to_clip  world to OpenGL clip space.
  void set_view(const Eigen::Matrix4d& to_clip, int width, int height);

  /// Depth of what is drawn at a pixel, 0..1.
  using DepthAt = std::function<float(int x, int y)>;
  /// @returns the loop's index, or −1 when none passes within `reach` pixels.
  int pick(double x, double y, double reach, const DepthAt& depth_at) const;
  /// @returns the smallest loop of `wanted` that runs round the pixel with nothing before it, or −1.
  int around(double x, double y, const std::function<bool(int loop)>& wanted, const DepthAt& depth_at) const;

  /// A loop as it appears on the screen.
  const std::vector<Pixel>& projected(int loop) const;
  int count() const { return static_cast<int>(loops_.size()); }

 private:
  bool visible(const Pixel& at, const DepthAt& depth_at) const;

  std::vector<std::vector<float>> loops_;
  std::vector<std::vector<Pixel>> projected_;
  int width_ = 0, height_ = 0;
};

}  // namespace loopmend
