// SPDX-License-Identifier: GPL-3.0-or-later
// Holes that touch at a vertex around which their faces cannot be arranged, because they overlap or turn over.
#pragma once

#include "mesh/surface_model.h"

#include <map>
#include <vector>

namespace loopmend {

/// A boundary that comes from `from` to `at` goes on to `to`, an edge of another fan.
struct BoundaryLink {
  int from, at, to;
};

/// Where fans of faces cannot be arranged around a vertex, the view has a copy of it for each. Of the copies that one loop
/// passes one after the other, one vertex is made again, and each part of the loop from one to the next is a loop.
struct JoinedCopies {
  std::map<int, int> joined;        ///< copy → the one whose number it takes
  std::vector<BoundaryLink> links;  ///< over the numbers before
};

/// Of copies of one fan each that share no edge of the file.
/// @param model  a view in which each fan has its copy; only `mesh` and `soup_vertex` are read
/// @param number  of each of its vertices; those of the result are such numbers
JoinedCopies join_copies_on_loops(const SurfaceModel& model, const std::vector<int>& number);

}  // namespace loopmend
