// SPDX-License-Identifier: GPL-3.0-or-later
#include "mirror/mirror_plane.h"

#include "core/error.h"
#include "core/threads.h"
#include "support/mirror_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace loopmend {
namespace {

TEST(MirrorPlane, IsFoundToAThousandth) {
  const test::BumpyEllipsoid shape;
  for (const TriangleSoup& soup : {shape.mesh(5), shape.open_mesh(4)}) {
    const std::vector<MirrorPlane> planes = find_mirror_planes(make_surface_model(soup));
    ASSERT_FALSE(planes.empty());
    const MirrorPlane& plane = planes.front();
    EXPECT_LT(plane.normal.cross(shape.plane_normal()).norm(), 1e-3);
    EXPECT_LT(std::abs((plane.point - shape.plane_point()).dot(shape.plane_normal())), 1e-3);
    EXPECT_LT(plane.misfit, 2e-3);
  }
}

/// Seven tenths of the surface fit every plane through the axis; two horns, one of each side, say which is the right one.
TEST(MirrorPlane, OfABodyOfRevolutionIsSaidByItsHorns) {
  for (double turn : {0.3, 0.9, 1.7}) {
    const Vec3 right(std::cos(turn), 0, std::sin(turn)), forward(-std::sin(turn), 0, std::cos(turn));
    TriangleSoup soup = make_icosphere(5);
    for (Vec3& p : soup.points) {
      const Vec3 on_ball = p;
      p.y() *= 1.3;
      for (double side : {-1.0, 1.0}) {
        const Vec3 horn = (side * 0.55 * right + 0.2 * Vec3::UnitY() + 0.8 * forward).normalized();
        p *= 1 + 0.35 * std::exp(-(on_ball - horn).squaredNorm() / 0.03);
      }
    }
    std::erase_if(soup.triangles, [&](const Triangle& t) {  // a hole in the middle
      return std::ranges::any_of(t, [&](int v) { return (soup.points[v] - Vec3(0, 0.3, 0) - forward).norm() < 0.35; });
    });
    const std::vector<MirrorPlane> planes = find_mirror_planes(make_surface_model(soup));
    ASSERT_FALSE(planes.empty());
    EXPECT_LT(planes.front().normal.cross(right).norm(), 1e-3) << turn;
  }
}

TEST(MirrorPlane, DoesNotDependOnTheNumberOfThreads) {
  const SurfaceModel model = make_surface_model(test::BumpyEllipsoid().mesh(4));
  const auto with = [&](int threads) { return with_thread_budget(threads, [&] { return find_mirror_planes(model); }); };
  const std::vector<MirrorPlane> one = with(1), two = with(2);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].point, two[k].point);
    EXPECT_EQ(one[k].normal, two[k].normal);
    EXPECT_EQ(one[k].misfit, two[k].misfit);
  }
}

TEST(MirrorPlane, OfABoxAreAllThree) {
  TriangleSoup soup = make_icosphere(4);
  for (Vec3& p : soup.points) p = p.cwiseProduct(Vec3(1, 2, 3));
  const std::vector<MirrorPlane> planes = find_mirror_planes(make_surface_model(soup));
  ASSERT_EQ(planes.size(), 3u);
  Vec3 along = Vec3::Zero();
  for (const MirrorPlane& plane : planes) along += plane.normal.cwiseAbs();
  EXPECT_LT((along - Vec3::Ones()).norm(), 3e-3);
}

TEST(MirrorPlane, TakesAPersonsPlaneAndRefusesNone) {
  const MirrorPlane plane = make_mirror_plane({1, 2, 3}, {0, 0, 4});
  EXPECT_EQ(plane.image_of({5, 6, 7}), Vec3(5, 6, -1));
  EXPECT_THROW(make_mirror_plane({0, 0, 0}, {0, 0, 0}), InvalidArgument);
  EXPECT_THROW(make_mirror_plane({0, std::numeric_limits<double>::quiet_NaN(), 0}, {1, 0, 0}), InvalidArgument);
}

}  // namespace
}  // namespace loopmend
