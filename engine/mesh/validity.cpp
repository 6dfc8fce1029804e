// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/validity.h"

#include "mesh/quality.h"
#include "mesh/self_intersections.h"

namespace loopmend {

std::string nonmanifold_message(int edges) {
  return std::to_string(edges) + (edges == 1 ? " edge" : " edges") + " of its patch would have more than two faces";
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
