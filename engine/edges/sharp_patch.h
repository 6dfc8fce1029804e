// SPDX-License-Identifier: GPL-3.0-or-later
// A patch in which the sharp edges of the neighborhood run on (docs/math/sharp_edges.md).
#pragma once

#include "core/cancel.h"
#include "edges/sides.h"
#include "mesh/patch.h"

#include <optional>
#include <utility>
#include <vector>

namespace loopmend {

struct SharpPatch {
  LoopPatch patch;  ///< mesh units
  int sides = 0;    ///< whose surfaces the patch continues
  /// Sharp edges within the patch: indices into patch.points, from one end to the other.
  std::vector<std::vector<int>> edges;
  double sharpest_deg = 0;    ///< largest bend at one of them
  std::vector<char> creased;  ///< of each loop edge: whether the patch continues another side than the one across it
};

struct ContinuedEdges {
  /// Nothing where no sharp edge runs on: one surface explains the neighborhood as well, the loop is off the
  /// surfaces, or the parts are no discs.
  std::optional<SharpPatch> patch;
  /// Whether two or more sides fit the neighborhood so closely that it has sharp edges beyond doubt.
  bool are_clear = false;
};

/// What a person says of the edges of one loop, by places on it.
struct LoopEdits {
  std::vector<std::pair<int, int>> drawn;  ///< ends of an edge, whatever the neighborhood shows
  std::vector<int> stopped;                ///< where an edge ends that is not to run on

  bool empty() const { return drawn.empty() && stopped.empty(); }
};

/// Parts the patch where the continued surfaces of two sides meet, meshes each part with the seams as edges, puts it onto its
/// side's surface, and carries what the loop is off that surface into it.
/// @param initial  patch of one loop. @param edits  by hand. Between drawn edges and the sides beside them greater distances are
/// allowed; a stopped edge joins the sides beside it.
ContinuedEdges continue_sharp_edges(const Patch& initial, const LoopEdits& edits, const CancelToken& cancel);

/// Whether sides with sharp edges between them explain the neighborhood of a patch of one loop: fast, and true where
/// continue_sharp_edges() may still find nothing.
bool ends_at_sharp_edges(const Patch& patch);

}  // namespace loopmend
