// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotation.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

TEST(RotationBetween, TakesOneDirectionToTheOther) {
  const Vec3 from(3, 0, 0), to(0, 0.5, 0.5);
  EXPECT_NEAR((rotation_between(from, to) * from.normalized() - to.normalized()).norm(), 0, 1e-15);
  EXPECT_NEAR((rotation_between(from, -from) * from.normalized() + from.normalized()).norm(), 0, 1e-7);
}

TEST(RotationBetween, LeavesWhatIsAcrossBoth) {
  const Vec3 axis = rotation_between(Vec3::UnitX(), Vec3::UnitY()) * Vec3::UnitZ();
  EXPECT_NEAR((axis - Vec3::UnitZ()).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace loopmend
