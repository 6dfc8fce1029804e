// SPDX-License-Identifier: GPL-3.0-or-later
// A halfedge mesh as plain arrays.
#pragma once

#include "mesh/tri_mesh.h"

namespace loopmend {

/// #V points in the order of the vertices.
Points points_of(const TriMesh& mesh);
/// #F triangles in the order of the faces.
Triangles triangles_of(const TriMesh& mesh);

}  // namespace loopmend
