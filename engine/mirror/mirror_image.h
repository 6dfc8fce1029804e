// SPDX-License-Identifier: GPL-3.0-or-later
// The mirror image of a surface at a hole, moved as a rigid body onto the surface around it (docs/math/mirror_image.md, "The fit").
#pragma once

#include "core/cancel.h"
#include "mesh/patch.h"
#include "mesh/self_intersections.h"
#include "mirror/mirror_plane.h"

namespace loopmend {

/// The vertices around a hole that its image is compared with.
struct Collar {
  std::vector<int> vertices;  ///< of the patch: on its loop, and up to six rings and 0.7 diameters from it
  Points normals;             ///< of each, of the surface alone
  double diameter = 0;        ///< of the loop, patch frame
};

/// @param patch  with one loop.
Collar collar_of(const Patch& patch);

struct MirrorImage {
  Points points;              ///< patch frame, where it was moved to
  Triangles triangles;        ///< oriented like the surface; those of the patch's own image last
  int surface_triangles = 0;  ///< those before them
  /// Of the collar's vertices that have an image: all but those that lie on the image of the patch.
  Collar collar;
  Points nearest;     ///< of each vertex of `collar`, on the image
  double misfit = 0;  ///< rms distance of `collar` from the image, in loop diameters
};

/// What is mirrored: the surface alone, or the surface with its hole closed by the patch.
enum class MirrorOf { surface, closed_surface };

/// What the surface has within two diameters of the image of the hole, mirrored and moved.
/// @param index  of the model's soup triangles. @returns no triangles where there is nothing, or when cancelled.
MirrorImage mirror_image(const SurfaceModel& model, const TriangleIndex& index, const Patch& patch,
                         const Collar& collar, const MirrorPlane& plane, MirrorOf what, const CancelToken& cancel);

}  // namespace loopmend
