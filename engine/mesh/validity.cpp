// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/validity.h"

#include "mesh/quality.h"
#include "mesh/self_intersections.h"

namespace loopmend {

Message faults_of(const Validity& validity) {
  const Message folds = validity.folds == 0   ? Message()
                        : validity.folds == 1 ? say("1 folded edge")
                                              : say("%1 folded edges", validity.folds);
  if (validity.intersections == 0) return folds;
  if (folds.empty() && validity.intersections == 1) return say("1 self-intersection");
  if (folds.empty()) return say("%1 self-intersections", validity.intersections);
  return say("%1 folded edges and %2 self-intersections", validity.folds, validity.intersections);
}

Message nonmanifold_message(int edges) {
  return (edges == 1 ? say("1 edge of its patch would have more than two faces")
                     : say("%1 edges of its patch would have more than two faces", edges))
      .with_code("nonmanifold");
}

Validity patch_validity(const Patch& patch) {
  Validity validity;
  validity.folds = count_folds(patch.positions, patch.triangles, patch.patch_triangles);
  validity.intersections =
      static_cast<int>(self_intersections(patch.positions, patch.triangles, patch.patch_triangles).size());
  validity.min_angle_deg = min_angle_deg(patch.positions, patch.triangles, patch.patch_triangles);
  return validity;
}

}  // namespace loopmend
