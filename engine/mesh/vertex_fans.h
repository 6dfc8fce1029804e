// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary vertices at which several fans of faces meet: which gap between the fans belongs to which boundary loop.
#pragma once

#include "mesh/tri_mesh.h"

#include <optional>
#include <vector>

namespace loopmend {

/// The faces (center, link[i], link[i + 1]) of one open fan, counter-clockwise as seen from outside the surface.
using FanLink = Points;

/// Open fans that lie side by side around their common normal.
struct FanArrangement {
  std::vector<int> order;   ///< of the fans, counter-clockwise
  std::vector<double> gap;  ///< after each fan of `order`, to the next: radians, in (0, 2π)
};

/// @returns nothing where the fans overlap as seen along their mean normal, or face different sides: two sheets that touch.
std::optional<FanArrangement> arrange_fans(const Vec3& center, const std::vector<FanLink>& fans);

/// Boundary edges that leave v: as many as there are fans.
int fan_count(const TriMesh& mesh, TriMesh::VertexHandle v);

/// Makes the boundary pass from each fan at v to the next across the gap between them, so that two holes that touch at v are
/// two loops. No change where the fans cannot be arranged.
void link_fans(TriMesh& mesh, TriMesh::VertexHandle v);

/// Angle of the gap that lies between the boundary edge `in` and the next one, at the vertex between them: 2π less the
/// angles of the faces where there is one fan, else as seen along the mean normal; where the fans cannot be arranged, an equal
/// share of what their faces leave. Radians.
double gap_angle(const TriMesh& mesh, TriMesh::HalfedgeHandle in);

}  // namespace loopmend
