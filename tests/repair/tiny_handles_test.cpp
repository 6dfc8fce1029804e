// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/tiny_handles.h"

#include "mesh/boundary_loops.h"
#include "mesh/pieces.h"
#include "mesh/surface_model.h"
#include "repair/repair_surface.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace loopmend {
namespace {

/// The face whose middle is nearest to a place.
int face_at(const TriangleSoup& soup, const Vec3& place) {
  const auto distance = [&](const Triangle& t) {
    return (soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]] - 3 * place).norm();
  };
  return static_cast<int>(
      std::min_element(soup.triangles.begin(), soup.triangles.end(),
                       [&](const Triangle& a, const Triangle& b) { return distance(a) < distance(b); }) -
      soup.triangles.begin());
}

/// Two triangles of the surface become the ends of a strut of three edges around.
void add_strut(TriangleSoup& soup, const Vec3& from, const Vec3& to) {
  const int first = face_at(soup, from), second = face_at(soup, to);
  const Triangle a = soup.triangles[first];
  Triangle b = soup.triangles[second];
  std::swap(b[1], b[2]);
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    soup.triangles.push_back({a[k], a[next], b[k]});
    soup.triangles.push_back({b[k], a[next], b[next]});
  }
  soup.triangles.erase(soup.triangles.begin() + std::max(first, second));
  soup.triangles.erase(soup.triangles.begin() + std::min(first, second));
}

/// 2 for a sphere, 2 less for each handle, 1 less for each hole.
int euler_characteristic(const TriMesh& mesh) {
  return static_cast<int>(mesh.n_vertices()) - static_cast<int>(mesh.n_edges()) + static_cast<int>(mesh.n_faces());
}

const Vec3 top(0, 0, 1), near_top = Vec3(0.15, 0, 1).normalized(), bottom(0, 0, -1);

TEST(TinyHandles, AreFoundAndBecomeTwoHolesEach) {
  TriangleSoup soup = make_icosphere(5);
  add_strut(soup, top, near_top);
  add_strut(soup, bottom, -near_top);
  ASSERT_EQ(euler_characteristic(make_surface_model(soup).mesh), 2 - 2 * 2);
  const TinyHandles handles = find_tiny_handles(make_surface_model(soup).mesh);
  EXPECT_EQ(handles.count, 2);

  const RepairedSurface repaired = repair_surface(soup, {Defect::handles});
  EXPECT_EQ(repaired.counts.cut_handles, 2u);
  EXPECT_EQ(repaired.counts.handle_faces, handles.faces.size());
  EXPECT_EQ(repaired.soup.triangles.size(), soup.triangles.size() - handles.faces.size());
  EXPECT_EQ(repaired.soup.points, soup.points);
  const SurfaceModel opened = make_surface_model(repaired.soup);
  EXPECT_EQ(find_boundary_loops(opened).size(), 4u);
  EXPECT_EQ(euler_characteristic(opened.mesh), 2 - 4);
  EXPECT_EQ(find_tiny_handles(opened.mesh).count, 0);
  const std::vector<int> piece = pieces_of(opened.mesh);
  EXPECT_EQ(std::count(piece.begin(), piece.end(), 0), static_cast<int>(piece.size()));  // nothing falls off
  EXPECT_EQ(count_defects(soup).cut_handles, 2u);
}

TEST(TinyHandles, AreFoundInOpenSurfaces) {
  TriangleSoup soup = make_icosphere(5);
  add_strut(soup, top, near_top);
  soup = cut(soup, [](const Vec3& p) { return p.z() < -0.5 || (p - Vec3(0.3, 0, 0.95)).norm() < 0.1; });
  EXPECT_EQ(find_tiny_handles(make_surface_model(soup).mesh).count, 1);
}

TEST(TinyHandles, LongOnesAndWideOnesAreOfTheShape) {
  TriangleSoup long_strut = make_icosphere(5);
  add_strut(long_strut, top, bottom);
  EXPECT_EQ(find_tiny_handles(make_surface_model(long_strut).mesh).count, 0);
  TriangleSoup coarse = make_icosphere(3);  // three edges are a ninth of its extent
  add_strut(coarse, top, Vec3(0.6, 0, 0.8));
  EXPECT_EQ(find_tiny_handles(make_surface_model(coarse).mesh).count, 0);
  EXPECT_EQ(find_tiny_handles(make_surface_model(make_torus(1, 0.4, 40, 20)).mesh).count, 0);
  EXPECT_EQ(find_tiny_handles(make_surface_model(make_icosphere(4)).mesh).count, 0);
}

TEST(TinyHandles, AreNoHarmlessRepair) { EXPECT_FALSE(harmless_repairs.contains(Defect::handles)); }

TEST(TinyHandles, ACancelledSearchEnds) {
  TriangleSoup soup = make_icosphere(5);
  add_strut(soup, top, near_top);
  CancelToken cancel;
  cancel.cancel();
  EXPECT_EQ(find_tiny_handles(make_surface_model(soup).mesh, cancel).count, 0);
}

}  // namespace
}  // namespace loopmend
