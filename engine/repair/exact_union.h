// SPDX-License-Identifier: GPL-3.0-or-later
// The union of bodies in exact arithmetic (CGAL's corefinement).
#pragma once

#include "core/cancel.h"
#include "mesh/surface_model.h"

#include <array>
#include <map>
#include <set>
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

using BodyPair = std::pair<int, int>;  ///< ascending

struct ExactUnions {
  std::vector<ExactUnion> made;      ///< of two bodies or more, by the least of them
  std::set<BodyPair> only_touching;  ///< at points or edges: the exact union has all faces of both
  /// That overlap, but have no union that is a manifold, or that CGAL refuses: faces without area, bodies that touch themselves.
  std::set<BodyPair> refused;
};

/// Unites bodies in pairs, small ones first. What a union is found to touch or refuse is named by the least of its bodies.
/// @param bodies  soup triangles of each, ascending. It is closed, bounds a volume and does not cross itself.
/// @param pairs  of bodies that overlap or touch
/// @returns nothing of use when cancelled
ExactUnions unite_exactly(const SurfaceModel& model, const std::map<int, std::vector<int>>& bodies,
                          const std::set<BodyPair>& pairs, const CancelToken& cancel = {});

}  // namespace loopmend
