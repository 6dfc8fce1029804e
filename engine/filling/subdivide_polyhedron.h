// SPDX-License-Identifier: GPL-3.0-or-later
// Point interpolation (paper §5, Fig. 5.4): a polyhedron with its faces subdivided, the vertices to be interpolated fixed.
#pragma once

#include "mesh/patch.h"
#include "mesh/surface_model.h"

#include <vector>

namespace loopmend {

enum class PolyhedronBoundary {
  refuse,  ///< an open polyhedron is an error: a face may have been forgotten
  smooth,  ///< its boundaries become smooth closed curves through their vertices (fair_closed_curve), held like these
};

struct SubdivisionOptions {
  int subdivisions = 3;    ///< k, 1..8: each triangle into 4^k
  std::vector<int> fixed;  ///< input vertices (0-based) to be interpolated, at least 4; empty: all
  PolyhedronBoundary boundary = PolyhedronBoundary::refuse;
};

/// Where a vertex lies on the boundaries of an open polyhedron.
struct BoundaryPlace {
  int boundary = -1;  ///< −1: nowhere
  int step = 0;       ///< from the boundary's first corner, in edges of the subdivision
};

/// A patch without a neighborhood. Fixed vertices are of ring 1: those interpolated, in input order, then those on boundaries.
struct PolyhedronPatch {
  Patch patch;
  Points fixed;  ///< places of the fixed vertices in mesh units; those interpolated bit for bit as given
  std::vector<BoundaryPlace> boundary_place;  ///< of the fixed vertices
  std::vector<Points> boundaries;             ///< corners of each boundary, mesh units: vertices of the polyhedron
  int subdivisions = 0;                       ///< k
};

/// @throws InvalidArgument for options out of range, fewer than 4 vertices, a polyhedron that is no manifold or lies in
/// one plane, and boundaries where these are refused.
PolyhedronPatch subdivide_polyhedron(const SurfaceModel& polyhedron, const SubdivisionOptions& options);

/// The same problem with every triangle of an evolved state split into four by the middles of its edges; those of boundaries lie
/// on the boundary's curve.
PolyhedronPatch split_further(const PolyhedronPatch& start, const Patch& evolved);

/// The surface after the patch has evolved: fixed vertices first, as in PolyhedronPatch::fixed, then the free ones.
TriangleSoup polyhedron_surface(const PolyhedronPatch& start, const Patch& evolved);

}  // namespace loopmend
