// SPDX-License-Identifier: GPL-3.0-or-later
// The union of bodies in exact arithmetic (CGAL's corefinement).
#pragma once

#include "core/cancel.h"
#include "mesh/surface_model.h"

#include <array>
#include <utility>
#include <vector>

namespace loopmend {

/// A face of a union: a face of the model, or a part of it.
struct FaceOfUnion {
  int face = 0;                  ///< soup triangle of the model
  std::array<int, 3> corners{};  ///< soup points of the model; −1 − k: the new point k
};

struct ExactUnion {
  std::vector<int> bodies;  ///< that became one, ascending
  Points points;            ///< new ones, rounded
  std::vector<FaceOfUnion> faces;
};

struct ExactUnions {
  std::vector<ExactUnion> made;                      ///< of two bodies or more, by the least of them
  std::vector<std::pair<int, int>> only_touching{};  ///< pairs that touch at points or edges alone
  std::vector<std::pair<int, int>>
      refused{};  ///< pairs that overlap, but have no union that is a manifold, or that CGAL refuses: faces without area, bodies
                  ///< that touch themselves
};

/// Unites bodies in pairs, small ones first.
/// @param bodies  view faces of each. It is closed, bounds a volume and does not cross itself.
/// @param pairs  of bodies that overlap or touch, or of which one lies within the other
/// @returns nothing of use when cancelled
ExactUnions unite_exactly(const SurfaceModel& model, const std::vector<std::vector<int>>& bodies,
                          const std::vector<std::pair<int, int>>& pairs, const CancelToken& cancel = {});

}  // namespace loopmend
