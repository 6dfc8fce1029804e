// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/continue_attributes.h"

#include "mesh/boundary_loops.h"
#include "mesh/scan_attributes.h"
#include "pipeline/fill_holes.h"
#include "samples/analytic_surfaces.h"
#include "support/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

/// A sphere without its cap, filled, whose points and faces have numbers of every kind.
struct FilledSphere {
  SurfaceModel model;
  std::size_t old_points = 0, old_triangles = 0;

  FilledSphere() {
    TriangleSoup soup = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.8; });
    auto scan = std::make_shared<ScanAttributes>();
    scan->format = "PLY";
    scan->point_count = old_points = soup.points.size();
    scan->triangle_count = old_triangles = soup.triangles.size();
    for (const char* name : {"quality", "nx", "ny", "nz"}) scan->points.emplace_back(name, ScalarType::float64);
    scan->points.emplace_back("red", ScalarType::uint8);
    scan->points.emplace_back("side", ScalarType::int32);
    scan->points.emplace_back("broken", ScalarType::float32);
    for (std::size_t v = 0; v < soup.points.size(); ++v) {
      const Vec3& p = soup.points[v];
      scan->points[0].push(p.x());
      for (int c = 0; c < 3; ++c) scan->points[1 + c].push(-p[c]);  // inward
      scan->points[4].push(200 + 30 * p.y());
      scan->points[5].push(p.x() < 0 ? 111 : 222);
      scan->points[6].push(v % 2 == 0 ? std::nan("") : 5);
    }
    scan->faces.emplace_back("tag", ScalarType::uint16);
    scan->faces.emplace_back("height", ScalarType::float32);
    FaceNames names{"usemtl", {"left", "right"}, {}};
    for (const Triangle& t : soup.triangles) {
      const Vec3 middle = (soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]]) / 3;
      scan->faces[0].push(middle.x() < 0 ? 3 : 4);
      scan->faces[1].push(middle.z());
      names.of_face.push_back(middle.x() < 0 ? 0 : 1);
    }
    scan->names.push_back(names);
    soup.attributes = scan;
    model = make_surface_model(std::move(soup));
    fill_holes(model, find_boundary_loops(model), FillOptions{}, nullptr, CancelToken());
    continue_attributes(model.soup);
  }
};

TEST(ContinueAttributes, EveryNewPointAndTriangleHasARow) {
  const FilledSphere sphere;
  const TriangleSoup& soup = sphere.model.soup;
  ASSERT_TRUE(soup.continued);
  ASSERT_GT(soup.points.size(), sphere.old_points);
  ASSERT_EQ(soup.continued->points.size(), soup.attributes->points.size());
  for (const AttributeColumn& column : soup.continued->points)
    EXPECT_EQ(column.rows(), soup.points.size() - sphere.old_points) << column.name();
  for (const AttributeColumn& column : soup.continued->faces)
    EXPECT_EQ(column.rows(), soup.triangles.size() - sphere.old_triangles) << column.name();
  EXPECT_EQ(soup.continued->names[0].of_face.size(), soup.triangles.size() - sphere.old_triangles);
}

/// On a cap of the sphere up to height h the harmonic function with the values x on its edge is x (1 + h) / (1 + z).
TEST(ContinueAttributes, NumbersGoOnSmoothlyAndStayInRange) {
  const FilledSphere sphere;
  const TriangleSoup& soup = sphere.model.soup;
  const std::vector<AttributeColumn>& columns = soup.continued->points;
  double highest = 0;
  for (std::size_t v = 0; v < sphere.old_points; ++v) highest = std::max(highest, soup.points[v].z());
  for (std::size_t k = 0; k < columns[0].rows(); ++k) {
    const Vec3& p = soup.points[sphere.old_points + k];
    const double share = (1 + highest) / (1 + p.z());
    EXPECT_NEAR(columns[0].value(k), share * p.x(), 0.01);
    EXPECT_LE(std::abs(columns[0].value(k)), 0.65);
    EXPECT_NEAR(columns[4].value(k), 200 + 30 * share * p.y(), 1.3) << "rounded twice";
    const Vec3 n(columns[1].value(k), columns[2].value(k), columns[3].value(k));
    EXPECT_LT((n + p.normalized()).norm(), 0.1) << "inward, as those of the file";
    EXPECT_EQ(columns[6].value(k), 5) << "of those that are numbers";
  }
}

TEST(ContinueAttributes, LabelsAndNamesAreOfTheNearest) {
  const FilledSphere sphere;
  const TriangleSoup& soup = sphere.model.soup;
  const ScanAttributes& made = *soup.continued;
  int left = 0, wrong = 0;
  for (std::size_t k = 0; k < made.faces[0].rows(); ++k) {
    const Triangle& t = soup.triangles[sphere.old_triangles + k];
    const double x = (soup.points[t[0]].x() + soup.points[t[1]].x() + soup.points[t[2]].x()) / 3;
    const int name = made.names[0].of_face[k];
    EXPECT_EQ(made.faces[0].value(k), name == 0 ? 3 : 4) << "a tag between 3 and 4 would be none";
    left += name == 0;
    wrong += std::abs(x) > 0.2 && (x < 0) != (name == 0);
    EXPECT_GT(made.faces[1].value(k), 0.6);
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(left, static_cast<int>(made.faces[0].rows()) / 3);
  for (std::size_t k = 0; k < made.points[5].rows(); ++k)
    EXPECT_TRUE(made.points[5].value(k) == 111 || made.points[5].value(k) == 222);
}

TEST(ContinueAttributes, WhatHangsOnNothingGetsZero) {
  FilledSphere sphere;
  TriangleSoup& soup = sphere.model.soup;
  const int first = static_cast<int>(soup.points.size());
  soup.points.insert(soup.points.end(), {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}});
  soup.triangles.push_back({first, first + 1, first + 2});
  continue_attributes(soup);
  const std::size_t last = soup.continued->points[0].rows() - 1;
  EXPECT_EQ(soup.continued->points[0].value(last), 0);
  EXPECT_EQ(soup.continued->faces[0].value(soup.continued->faces[0].rows() - 1), 0);
  EXPECT_EQ(soup.continued->names[0].of_face.back(), -1);
  EXPECT_NEAR(soup.continued->points[0].value(0), soup.points[sphere.old_points].x(), 0.02)
      << "the others are as before";
}

}  // namespace
}  // namespace loopmend
