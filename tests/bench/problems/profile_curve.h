// SPDX-License-Identifier: GPL-3.0-or-later
// Profiles of surfaces of revolution, parametrised by arc length.
#pragma once

#include <Eigen/Core>

#include <functional>

namespace loopmend::bench {

/// (radius, z) as a function of arc length s, and its unit tangent.
struct ProfileCurve {
  std::function<Eigen::Vector2d(double)> point;
  std::function<Eigen::Vector2d(double)> tangent;
};

/// r = √(1 + s²), z = asinh s.
ProfileCurve catenoid_profile();

/// r = √(1 + b² + 2b sin s), z = ∫ (1 + b sin t)/r dt: Gauss-Legendre quadrature between knots, exact to rounding.
/// @param length  z is known for |s| ≤ length.
ProfileCurve unduloid_profile(double bulge, double length);

/// A plane curve of least curvature variation: κ'''' + κ²κ'' − ½κκ'² = 0, which is the paper's equation for the cylinder over
/// the curve (K = 0, H = κ/2). Starts at the origin along x; Runge-Kutta steps of 1e-3, exact to about 1e-13.
/// @param curvature  κ, κ', κ'', κ''' at s = 0. @param length  known for |s| ≤ length.
ProfileCurve mvc_profile(const Eigen::Vector4d& curvature, double length);

/// Arc length of the profile's point nearest to `place`, found from the best of samples over [from, to].
double nearest_arc_length(const ProfileCurve& profile, const Eigen::Vector2d& place, double from, double to);

}  // namespace loopmend::bench
