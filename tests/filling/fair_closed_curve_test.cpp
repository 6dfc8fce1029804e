// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/fair_closed_curve.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace loopmend {
namespace {

Points on_curve(int count, const std::function<Vec3(double)>& curve) {
  Points points;
  for (int k = 0; k < count; ++k) points.push_back(curve(2 * std::numbers::pi * k / count));
  return points;
}

TEST(FairClosedCurve, CornersOnACircleGiveTheCircle) {
  const Points uneven{{1, 0, 0}, {std::cos(1.2), std::sin(1.2), 0}, {-1, 0, 0}, {std::cos(4.0), std::sin(4.0), 0}};
  for (const Points& corners : {on_curve(3, [](double t) { return Vec3(std::cos(t), std::sin(t), 0); }),
                                on_curve(7, [](double t) { return Vec3(std::cos(t), std::sin(t), 0); }), uneven}) {
    const Points curve = fair_closed_curve(corners, 8);
    ASSERT_EQ(curve.size(), 8 * corners.size());
    for (std::size_t i = 0; i < curve.size(); ++i) {
      EXPECT_NEAR(curve[i].norm(), 1, 1e-3);
      if (i % 8 == 0) {
        EXPECT_EQ(curve[i], corners[i / 8]);
      }
    }
  }
}

TEST(FairClosedCurve, ComesNearASmoothCurveInSpaceWithFourthOrder) {
  double last = 1;
  for (int n : {12, 24, 48}) {
    const auto wave = [](double t) { return Vec3(std::cos(t), std::sin(t), 0.3 * std::sin(2 * t)); };
    double worst = 0;  // off the cylinder, and off the wave on it
    for (const Vec3& p : fair_closed_curve(on_curve(n, wave), 4)) {
      const double off = p.z() - wave(std::atan2(p.y(), p.x())).z();
      worst = std::max({worst, std::abs(std::hypot(p.x(), p.y()) - 1), std::abs(off)});
    }
    if (n > 12) {
      EXPECT_LT(worst, last / 12) << n;
    }
    last = worst;
  }
}

TEST(FairClosedCurve, NeverBulgesFar) {
  const Points corners{{0, 0, 0}, {10, 0, 0}, {5, 0.01, 0}};  // the circle through them is 2500 wide
  for (const Vec3& p : fair_closed_curve(corners, 8)) EXPECT_LT(p.norm(), 30);
}

TEST(FairClosedCurve, RefusesWhatIsNoCurve) {
  EXPECT_THROW(fair_closed_curve({{0, 0, 0}, {1, 0, 0}}, 4), InvalidArgument);
  EXPECT_THROW(fair_closed_curve({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}, 4), InvalidArgument);
  EXPECT_THROW(fair_closed_curve({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 0), InvalidArgument);
}

}  // namespace
}  // namespace loopmend
