// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scan_ranges.h"

namespace loopmend {

double ScanRanges::of(int scan, const SurfaceShapePtr& shape, Shading shading, double percent) {
  Entry& entry = entries_[{scan, shading}];
  if (entry.shape != shape || entry.percent != percent) {
    const std::vector<float>& values = values_of(*shape, shading);
    entry = {shape, percent, values.empty() ? 0 : symmetric_range(values, percent)};
  }
  return entry.half_width;
}

}  // namespace loopmend
