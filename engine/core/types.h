// SPDX-License-Identifier: GPL-3.0-or-later
// Small value types that every other folder shares.
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace loopmend {

using Vec3 = Eigen::Vector3d;
using Points = std::vector<Vec3>;
/// Three vertex indices, 0-based, counter-clockwise seen from outside.
using Triangle = std::array<int, 3>;
using Triangles = std::vector<Triangle>;
/// Red, green, blue, alpha, each 0..255.
using Color = std::array<unsigned char, 4>;

}  // namespace loopmend
