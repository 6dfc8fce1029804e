// SPDX-License-Identifier: GPL-3.0-or-later
// From where to look at a surface, and where to stand to see all of it.
#pragma once

#include "core/types.h"
#include "mesh/boundary_loops.h"
#include "mesh/surface_model.h"
#include "scene/look.h"
#include "scene/surface_shape.h"

#include <Eigen/Geometry>

#include <vector>

class vtkCamera;

namespace loopmend {

/// Unit vector from the middle of the loop to an eye that looks straight into it.
Vec3 facing(const SurfaceModel& model, const BoundaryLoop& loop);

/// Towards most of the fillable boundaries, slightly from above and from the left; the front when there are none.
Vec3 view_direction(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, const Vec3& up);

/// Which way is up in a scan that does not say: z when it is tallest along z, y otherwise.
Vec3 guessed_up(const Vec3& extents);

/// The unit vector of the axis; where the shape says it, that of guessed_up().
Vec3 up_of(UpAxis axis, const Vec3& extents);

/// A usable up for this direction: the wanted one; when the eye looks along it, what comes up when it tilts there from the front.
Vec3 view_up(const Vec3& direction, const Vec3& wanted);

/// The side that the first picture shows: slightly from the right and above.
Vec3 front(const Vec3& up);

enum class NamedView { front, back, left, right, top, bottom, iso };

/// From the middle towards the eye. Left and right are those of the person who looks at the front: with z or −z up the front
/// shows −y, else +z. The iso view shows front, right and top alike.
Vec3 direction_of(NamedView view, const Vec3& up);

/// A sphere that should be seen whole, and the eye's direction. `aspect` is width / height.
struct Stand {
  Vec3 focus = Vec3::Zero();
  double radius = 1;
  Vec3 direction = Vec3::UnitZ();
  Vec3 up = Vec3::UnitY();
  double aspect = 1;
};
void place_camera(vtkCamera* camera, const Stand& stand);

/// Moves the camera sideways and zooms until the points, three coordinates each, fill `share` of the picture, in its
/// middle.
void fit(vtkCamera* camera, const std::vector<float>& points, double aspect, double share);

/// A picture of which parts are taken; pixels from its lower left corner.
struct TakenPicture {
  Eigen::Vector2d size;
  std::vector<Eigen::AlignedBox2d> taken;
};
/// Moves the eye away until none of the points, three coordinates each, lies beside the picture or where it is taken.
/// Gives up at a third of the size.
void clear_of(vtkCamera* camera, const std::vector<float>& points, const TakenPicture& picture);

}  // namespace loopmend
