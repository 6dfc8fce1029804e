// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/patch_quality.h"

#include "mesh/quality.h"
#include "mesh/self_intersections.h"

namespace loopmend {

FillerQuality patch_quality(const Patch& patch) {
  FillerQuality quality;
  quality.folds = count_folds(patch.positions, patch.triangles, patch.patch_triangles);
  quality.self_intersections =
      static_cast<int>(self_intersections(patch.positions, patch.triangles, patch.patch_triangles).size());
  quality.min_angle_deg = min_angle_deg(patch.positions, patch.triangles, patch.patch_triangles);
  return quality;
}

}  // namespace loopmend
