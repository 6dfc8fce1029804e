// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotation.h"

namespace loopmend {

Eigen::Quaterniond rotation_between(const Vec3& from, const Vec3& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to);
}

}  // namespace loopmend
