// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature and normals at every vertex, for colouring and shading.
#pragma once

#include "mesh/patch.h"
#include "mesh/tri_mesh.h"

#include <vector>

namespace loopmend {

/// Mesh units. H < 0 on a sphere with outward normals (H n = ½ Δr). NaN where no fit was possible.
struct CurvatureField {
  std::vector<double> H;  ///< #V, mean curvature, 1/length
  std::vector<double> K;  ///< #V, Gaussian curvature, 1/length²
  Points normals;         ///< #V, unit
};

/// Over the vertices of a halfedge mesh.
CurvatureField curvature_field(const TriMesh& mesh);

/// Over the vertices of a patch and its neighborhood.
CurvatureField curvature_field(const Patch& patch);

}  // namespace loopmend
