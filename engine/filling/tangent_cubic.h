// SPDX-License-Identifier: GPL-3.0-or-later
// A curve between two points that leaves the one and reaches the other in given directions.
#pragma once

#include "core/types.h"

namespace loopmend {

/// Cubic Hermite curve; its speed at both ends is that of a circular arc of the same turn.
class TangentCubic {
 public:
  /// @param leaving, arriving  unit; both along the curve
  TangentCubic(const Vec3& from, const Vec3& leaving, const Vec3& to, const Vec3& arriving);

  /// @param t  0 at `from`, 1 at `to`
  Vec3 at(double t) const;
  Vec3 derivative(double t) const;

  /// Mesh units, of a polyline of 16 edges.
  double length() const;

 private:
  Vec3 p_, q_, u_, v_;  ///< ends and derivatives there
};

}  // namespace loopmend
