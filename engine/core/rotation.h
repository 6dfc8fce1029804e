// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/types.h"

#include <Eigen/Geometry>

namespace loopmend {

/// The shortest rotation that takes one direction to the other; neither has to be of unit length. Eigen's, compiled once: it
/// brings a singular value decomposition with it.
Eigen::Quaterniond rotation_between(const Vec3& from, const Vec3& to);

}  // namespace loopmend
