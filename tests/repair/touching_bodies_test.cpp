// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/watertight.h"
#include "repair/repair_surface.h"
#include "support/box.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace loopmend {
namespace {

/// As STL has them: both name the same corners of the face in common, which the one divides along the other diagonal.
TEST(UniteBodies, BodiesWithTheCornersOfAFaceInCommonAreOne) {
  for (const bool along_the_other : {false, true}) {
    TriangleSoup soup = test::box({0, 0, 0}, {1, 2, 3});
    const TriangleSoup other = test::box({1, 0, 0}, {2, 2, 3});
    std::vector<int> at;
    for (const Vec3& p : other.points) {
      const auto same = std::find(soup.points.begin(), soup.points.end(), p);
      at.push_back(static_cast<int>(same - soup.points.begin()));
      if (same == soup.points.end()) soup.points.push_back(p);
    }
    for (const Triangle& t : other.triangles) soup.triangles.push_back({at[t[0]], at[t[1]], at[t[2]]});
    ASSERT_EQ(soup.points.size(), 12U);
    if (along_the_other) {  // the face in common, x = 1 of the second box
      Triangle &t = soup.triangles[12 + 8], &u = soup.triangles[12 + 9];
      const Triangle q{t[0], t[1], t[2]};
      const int last = u[2];
      t = {q[0], q[1], last};
      u = {q[1], q[2], last};
    }
    std::set<Defect> defects = harmless_repairs;
    defects.insert(Defect::overlaps);
    const RepairedSurface repaired = repair_surface(soup, defects);
    const Watertightness made = watertightness(repaired.soup);
    EXPECT_TRUE(made.printable()) << along_the_other;
    EXPECT_EQ(made.pieces, 1U);
    EXPECT_NEAR(made.volume, 12, 1e-12);
  }
}

}  // namespace
}  // namespace loopmend
