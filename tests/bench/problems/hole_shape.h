// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines of holes in the plane, to be laid onto surfaces.
#pragma once

#include "core/random.h"

#include <vector>

namespace loopmend::bench {

enum class ShapeKind { disc, ellipse, star, slit, concave_polygon };

const char* to_string(ShapeKind kind);

/// Fits into the unit circle and touches it; contains the origin.
struct HoleShape {
  ShapeKind kind = ShapeKind::disc;
  double aspect = 1;          ///< ellipse, slit: half width, 0..1
  int lobes = 0;              ///< star
  std::vector<double> radii;  ///< concave polygon: of its corners, evenly spaced in angle

  bool contains(double u, double v) const;
  double area() const;  ///< of the outline; by counting, to 1 %
};

/// A shape of this kind with random proportions.
HoleShape random_shape(ShapeKind kind, Random& random);

}  // namespace loopmend::bench
