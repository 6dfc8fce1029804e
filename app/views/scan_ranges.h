// SPDX-License-Identifier: GPL-3.0-or-later
// How far the curvatures of each scan go: of millions of values, so each answer is kept.
#pragma once

#include "scene/shading.h"
#include "scene/surface_shape.h"

#include <map>

namespace loopmend {

class ScanRanges {
 public:
  /// @returns the half-width of the range; 0 where no curvature is known.
  /// @param shading  coloured: which curvature
  double of(int scan, const SurfaceShapePtr& shape, Shading shading, double percent);

 private:
  struct Entry {
    SurfaceShapePtr shape;
    double percent = 0, half_width = 0;
  };
  std::map<std::pair<int, Shading>, Entry> entries_;
};

}  // namespace loopmend
