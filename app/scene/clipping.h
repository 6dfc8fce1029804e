// SPDX-License-Identifier: GPL-3.0-or-later
// A plane that cuts the surfaces open, so that their inside is seen.
#pragma once

#include "core/types.h"

namespace loopmend {

/// What lies on the side that `normal` points to is drawn, the rest is not.
struct ClippingPlane {
  Vec3 point = Vec3::Zero();  ///< of the plane, in the scene's frame
  Vec3 normal = Vec3::UnitZ();
};

/// As a person chooses it.
struct Clipping {
  enum class Across { nothing, line_of_sight, x, y, z } across = Across::nothing;
  double place = 0.5;  ///< 0..1, of the way through the scene
  enum class Side { behind, in_front } drawn = Side::behind;

  bool operator==(const Clipping&) const = default;
};

}  // namespace loopmend
