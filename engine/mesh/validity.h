// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a patch, counted: the one type for what initial patches, flows and jobs are judged by.
#pragma once

#include "core/message.h"
#include "mesh/patch.h"

#include <vector>

namespace loopmend {

struct Validity {
  int folds = 0;          ///< edges inside the patch or on its loops with a dihedral angle over 90 degrees
  int intersections = 0;  ///< triangles that cut each other, at least one of them the patch's; who counts tells how
  /// Edges inside the patch that would have more than two faces, of patch and surface together, and that the surface does not
  /// have; who counts tells how. A patch that has any is not pasted.
  int nonmanifold_edges = 0;
  double min_angle_deg = 0;  ///< smallest angle of a triangle of the patch
  /// Per loop of the patch, of its part; empty: not asked for.
  std::vector<int> intersections_of_loop;
  /// The patch's triangles beside a fold or in an intersection, ascending; empty: not asked for.
  std::vector<int> spoiled;

  bool is_clean() const { return folds == 0 && intersections == 0 && nonmanifold_edges == 0; }
};

/// True if a has no more folds, intersections and edges with more than two faces than b.
inline bool no_worse(const Validity& a, const Validity& b) {
  return a.folds <= b.folds && a.intersections <= b.intersections && a.nonmanifold_edges <= b.nonmanifold_edges;
}

/// "2 folded edges and 3 self-intersections"; empty where there are none.
Message faults_of(const Validity& validity);

/// Of a patch that is not pasted since so many of its edges would have more than two faces. Without a full stop.
Message nonmanifold_message(int edges);

/// Of the patch and the rings around it alone: pairs of triangles; edges with more than two faces are not counted.
Validity patch_validity(const Patch& patch);

}  // namespace loopmend
