// SPDX-License-Identifier: GPL-3.0-or-later
// The planes in which a surface is its own mirror image, nearly (docs/math/mirror_image.md, "The plane").
#pragma once

#include "core/cancel.h"
#include "mesh/surface_model.h"

#include <vector>

namespace loopmend {

struct MirrorPlane {
  Vec3 point = Vec3::Zero();    ///< mesh units
  Vec3 normal = Vec3::UnitX();  ///< unit
  /// Seven tenths of the surface lie within so much of its image, in diagonals of the surface's box. 0 for a plane that a
  /// person placed.
  double misfit = 0;

  bool operator==(const MirrorPlane&) const = default;
  Vec3 image_of(const Vec3& p) const { return p - 2 * normal.dot(p - point) * normal; }
};

/// @throws InvalidArgument unless the numbers are finite, and the normal is not 0.
MirrorPlane make_mirror_plane(const Vec3& point, const Vec3& normal);

/// Nine starts from the principal axes of the surface, each a trimmed ICP of points with their image. Deterministic.
/// @returns up to three different planes, the best first; empty when cancelled, or for a surface without area.
std::vector<MirrorPlane> find_mirror_planes(const SurfaceModel& model, const CancelToken& cancel = {});

}  // namespace loopmend
