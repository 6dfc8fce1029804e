// SPDX-License-Identifier: GPL-3.0-or-later
// Judges a filled file by itself: none of the engine's own tests is used.
#pragma once

#include "mesh/triangle_soup.h"

namespace loopmend::bench {

/// A connected set of triangles that the output has beyond those of the input.
struct FilledPart {
  int triangles = 0;
  int open_edges = 0;     ///< with one face: the patch does not close its loop
  int crowded_edges = 0;  ///< with more than two faces, or two that run the same way
  int crossings = 0;      ///< with other triangles of the output
  int folds = 0;          ///< edges at which the surface turns back by more than 150°, but for:
  int forced_folds = 0;   ///< of edges between input and patch, those where the smallest triangulation does so as well
  double area_ratio = 0;  ///< to the smallest triangulation found of its boundary; 0 where that is several loops

  bool is_closed() const { return open_edges == 0 && crowded_edges == 0; }
  bool is_clean() const;
};

struct OutputCheck {
  bool exterior_kept = false;  ///< points bit by bit, triangles in their order up to a turn
  std::vector<FilledPart> parts;
};

/// @param output  begins with the points and triangles of `input`.
OutputCheck check_output(const TriangleSoup& input, const TriangleSoup& output);

}  // namespace loopmend::bench
