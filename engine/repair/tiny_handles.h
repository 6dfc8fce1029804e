// SPDX-License-Identifier: GPL-3.0-or-later
// Handles of a few edges, as noise and the reconstruction of a surface leave them: a strut between two sheets that nearly touch, a
// tunnel through a thin wall.
#pragma once

#include "core/cancel.h"
#include "mesh/tri_mesh.h"

#include <vector>

namespace loopmend {

struct TinyHandles {
  int count = 0;
  /// View faces, ascending: those at the shortest loop of each handle, and scraps that hang on nothing else. Without them there
  /// are holes in place of each handle, mostly two.
  std::vector<int> faces;
};

/// Handles that lie within eight edges of one of their vertices, and whose shortest loop has eight edges and a 25th of the
/// extent of its piece of surface at most.
/// Source: tree and cotree, after Erickson and Whittlesey, Greedy optimal homotopy and homology generators (2005); that noise
/// shows as a ball of positive genus, after Guskov and Wood, Topological noise removal (2001).
/// Cancelled, those found so far.
TinyHandles find_tiny_handles(const TriMesh& mesh, const CancelToken& cancel = {});

}  // namespace loopmend
