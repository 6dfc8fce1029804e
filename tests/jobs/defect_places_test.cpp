// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/defect_places.h"

#include "jobs/load_scan.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace loopmend::test {
namespace {

std::vector<int> changed_by(const TriangleSoup& soup, Defect defect) {
  return changed_faces(soup, repair_surface(soup, {defect}).soup);
}

int face_count(const TriangleSoup& soup) { return static_cast<int>(soup.triangles.size()); }

TEST(DefectPlaces, NothingOfASoundSurfaceChanges) {
  const TriangleSoup sphere = make_icosphere(2);
  for (const Defect defect : {Defect::duplicate_faces, Defect::non_manifold, Defect::fragments, Defect::intersections})
    EXPECT_TRUE(changed_by(sphere, defect).empty());
}

TEST(DefectPlaces, TheSecondOfTwoEqualFacesGoes) {
  TriangleSoup soup = make_icosphere(2);
  soup.triangles.push_back(soup.triangles[7]);
  EXPECT_EQ(changed_by(soup, Defect::duplicate_faces), std::vector<int>{face_count(soup) - 1});
}

TEST(DefectPlaces, OnlyFacesAtAnEdgeOfThreeFacesChange) {
  TriangleSoup soup = make_icosphere(3);
  const auto [a, b, c] = soup.triangles[11];
  soup.points.push_back(1.2 * soup.points[static_cast<std::size_t>(a)]);
  soup.triangles.push_back({a, b, static_cast<int>(soup.points.size()) - 1});
  const std::vector<int> changed = changed_by(soup, Defect::non_manifold);
  ASSERT_FALSE(changed.empty());
  for (int f : changed) {
    const Triangle& t = soup.triangles[static_cast<std::size_t>(f)];
    EXPECT_TRUE(std::count(t.begin(), t.end(), a) + std::count(t.begin(), t.end(), b) > 0) << f;
  }
}

TEST(DefectPlaces, EachFragmentIsAPlace) {
  TriangleSoup soup = make_icosphere(3);
  const auto add = [&soup](const std::vector<Vec3>& points, const std::vector<Triangle>& faces) {
    const int first = static_cast<int>(soup.points.size());
    soup.points.insert(soup.points.end(), points.begin(), points.end());
    for (const auto& [a, b, c] : faces) soup.triangles.push_back({first + a, first + b, first + c});
  };
  add({{2, 0, 0}, {2, 0.02, 0}, {2, 0, 0.02}}, {{0, 1, 2}});
  add({{3, 0, 0}, {3, 0.02, 0}, {3, 0.02, 0.02}, {3, 0, 0.02}}, {{0, 1, 2}, {0, 2, 3}});
  const auto scan = made_scan(soup, QStringLiteral("fragments"), Vec3::Zero());
  const DefectPlaces found = find_defect_places({scan}, Defect::fragments, Vec3::Zero());
  ASSERT_EQ(found.places.size(), 2u);
  EXPECT_EQ(found.places[0].faces, 2u);
  EXPECT_NEAR(found.places[0].center.x(), 3, 1e-12);
  EXPECT_NEAR(found.places[1].center.x(), 2, 1e-12);
  EXPECT_NEAR(std::abs(found.places[1].direction.x()), 1, 1e-12);
  EXPECT_LT(found.places[1].radius, 0.03);
  ASSERT_NE(found.shape, nullptr);
  EXPECT_EQ(found.shape->triangles.size(), 3u * 2 * 3);  // both sides of three faces
}

}  // namespace
}  // namespace loopmend::test
