// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/sample_scan.h"

#include "mesh_facts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <set>
#include <tuple>

namespace loopmend {
namespace {

using test::mesh_facts;
using test::MeshFacts;

/// FNV-1a over the bits of the points and the triangles.
std::uint64_t fingerprint(const TriangleSoup& soup) {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto mix = [&](std::uint64_t bits) {
    for (int shift = 0; shift < 64; shift += 8) hash = (hash ^ (bits >> shift & 255U)) * 1099511628211ULL;
  };
  for (const Vec3& p : soup.points) {
    for (const double c : p) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &c, sizeof bits);
      mix(bits);
    }
  }
  for (const Triangle& t : soup.triangles) {
    for (const int v : t) mix(static_cast<std::uint64_t>(v));
  }
  return hash;
}

/// Total geodesic curvature of a loop in units of 2π, seen from the surface: +1 for the boundary of a flat disc.
double turning(const TriangleSoup& soup, const std::vector<int>& loop) {
  std::vector<double> angle(soup.points.size(), 0);
  for (const Triangle& t : soup.triangles) {
    for (int k = 0; k < 3; ++k) {
      angle[t[k]] += test::angle_at(soup.points[t[k]], soup.points[t[(k + 1) % 3]], soup.points[t[(k + 2) % 3]]);
    }
  }
  double sum = 0;
  for (const int v : loop) sum += std::numbers::pi - angle[v];
  return sum / (2 * std::numbers::pi);
}

double perimeter(const TriangleSoup& soup, const std::vector<int>& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    sum += (soup.points[loop[i]] - soup.points[loop[(i + 1) % loop.size()]]).norm();
  }
  return sum;
}

/// Loops by falling perimeter: the outer rim, then the holes.
std::vector<std::vector<int>> sorted_loops(const TriangleSoup& soup) {
  std::vector<std::vector<int>> loops = mesh_facts(soup).loops;
  std::sort(loops.begin(), loops.end(),
            [&](const auto& a, const auto& b) { return perimeter(soup, a) > perimeter(soup, b); });
  return loops;
}

double cross_2d(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool is_simple_polygon(const TriangleSoup& soup, const std::vector<int>& loop) {
  const auto at = [&](std::size_t i) -> const Vec3& { return soup.points[loop[i % loop.size()]]; };
  for (std::size_t i = 0; i < loop.size(); ++i) {
    for (std::size_t j = i + 2; j < loop.size(); ++j) {
      if (i == 0 && j + 1 == loop.size()) continue;
      const bool splits_j = cross_2d(at(i), at(i + 1), at(j)) * cross_2d(at(i), at(i + 1), at(j + 1)) <= 0;
      const bool splits_i = cross_2d(at(j), at(j + 1), at(i)) * cross_2d(at(j), at(j + 1), at(i + 1)) <= 0;
      if (splits_j && splits_i) return false;
    }
  }
  return true;
}

class SampleScan : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scan() = make_sample_scan();
    truth() = make_complete_sample_scan();
  }
  static TriangleSoup& scan() {
    static TriangleSoup soup;
    return soup;
  }
  static TriangleSoup& truth() {
    static TriangleSoup soup;
    return soup;
  }
};

TEST_F(SampleScan, IsACleanSheetWithFiveHoles) {
  const MeshFacts facts = mesh_facts(scan());
  EXPECT_GT(facts.vertices, 12000);
  EXPECT_LT(facts.vertices, 20000);
  EXPECT_EQ(facts.loops.size(), 6U);
  EXPECT_EQ(facts.euler_characteristic(), 1 - 5);
  EXPECT_EQ(facts.components, 1);
  EXPECT_TRUE(facts.oriented);
  EXPECT_TRUE(facts.vertex_manifold);
  EXPECT_TRUE(facts.all_used);
  EXPECT_EQ(facts.hanging_faces, 0);
  EXPECT_GT(facts.min_angle_deg, 14);
  EXPECT_GT(facts.mean_edge, 0.9);
  EXPECT_LT(facts.mean_edge, 1.4);
}

TEST_F(SampleScan, TruthIsTheSameSheetWithoutHoles) {
  const MeshFacts facts = mesh_facts(truth());
  EXPECT_EQ(facts.loops.size(), 1U);
  EXPECT_EQ(facts.euler_characteristic(), 1);
  EXPECT_TRUE(facts.oriented);
  EXPECT_TRUE(facts.vertex_manifold);
  EXPECT_EQ(facts.hanging_faces, 0);
  std::set<std::tuple<double, double, double>> points;
  for (const Vec3& p : truth().points) points.emplace(p.x(), p.y(), p.z());
  EXPECT_EQ(points.size(), truth().points.size());
  for (const Vec3& p : scan().points) ASSERT_TRUE(points.contains({p.x(), p.y(), p.z()}));
}

// A sheet whose triangles all face up, over a boundary that is a simple polygon, covers every place below it exactly once:
// so it cannot cut itself. The scan is a part of it.
TEST_F(SampleScan, DoesNotCutItself) {
  for (const auto& [a, b, c] : truth().triangles) {
    EXPECT_GT(cross_2d(truth().points[a], truth().points[b], truth().points[c]), 0.01);
  }
  EXPECT_TRUE(is_simple_polygon(truth(), mesh_facts(truth()).loops.at(0)));
}

TEST_F(SampleScan, BoundaryIsThatOfASheetAndTheHolesAreHoles) {
  const std::vector<std::vector<int>> loops = sorted_loops(scan());
  ASSERT_EQ(loops.size(), 6U);
  EXPECT_GT(turning(scan(), loops[0]), 0.5);
  for (std::size_t i = 1; i < loops.size(); ++i) EXPECT_LT(turning(scan(), loops[i]), -0.5) << "hole " << i;
  const Points normals = test::unit_normals(scan());
  for (const int v : loops[0]) EXPECT_GT(normals[v].z(), std::cos(std::numbers::pi / 4));
}

TEST_F(SampleScan, HolesAreLargeEnoughAndKeepClearOfEachOther) {
  const std::vector<std::vector<int>> loops = sorted_loops(scan());
  for (std::size_t i = 1; i < loops.size(); ++i) EXPECT_GE(loops[i].size(), 20U);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (std::size_t j = i + 1; j < loops.size(); ++j) {
      double distance = 1e9;
      for (const int v : loops[i]) {
        for (const int w : loops[j]) distance = std::min(distance, (scan().points[v] - scan().points[w]).norm());
      }
      EXPECT_GT(distance, 7) << "loops " << i << " and " << j;
    }
  }
}

/// 4π·area/perimeter² of the projection: 1 for a disc, less for anything else.
double roundness(const TriangleSoup& soup, const std::vector<int>& loop) {
  double area = 0;
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3& a = soup.points[loop[i]];
    const Vec3& b = soup.points[loop[(i + 1) % loop.size()]];
    area += (a.x() * b.y() - a.y() * b.x()) / 2;
    length += (b - a).head<2>().norm();
  }
  return 4 * std::numbers::pi * std::abs(area) / (length * length);
}

TEST_F(SampleScan, HolesAreOfDifferentShape) {
  const std::vector<std::vector<int>> loops = sorted_loops(scan());
  std::vector<double> round;
  for (std::size_t i = 1; i < loops.size(); ++i) round.push_back(roundness(scan(), loops[i]));
  std::sort(round.begin(), round.end());
  EXPECT_LT(round[0], 0.35);  // slit
  EXPECT_LT(round[1], 0.5);   // star
  EXPECT_LT(round[2], 0.76);  // ellipse
  EXPECT_GT(round[4], 0.8);   // disc; its boundary is jagged like a scan's
}

TEST_F(SampleScan, NoiseIsAboutOnePercentOfTheMeanEdge) {
  double sum = 0;
  const Points normals = test::unit_normals(truth());
  for (std::size_t v = 0; v < truth().points.size(); ++v) {
    const Vec3& p = truth().points[v];
    const double off = (p.z() - sample_relief_height(p.x(), p.y())) * normals[v].z();
    EXPECT_LT(std::abs(off), 0.05);
    sum += off * off;
  }
  const double rms = std::sqrt(sum / static_cast<double>(truth().points.size()));
  EXPECT_NEAR(rms / mesh_facts(truth()).mean_edge, 0.01, 0.002);
}

TEST_F(SampleScan, IsSymmetricWithoutItsNoise) {
  for (const double y : {-60.0, -20.0, 0.0, 35.0}) {
    for (const double x : {5.0, 21.0, 48.0}) EXPECT_EQ(sample_relief_height(x, y), sample_relief_height(-x, y));
  }
}

TEST_F(SampleScan, HasTheSameBitsEverywhere) {
  EXPECT_EQ(fingerprint(scan()), fingerprint(make_sample_scan()));
  // GCC at every level, with and without fused multiply-add, and clang agree on this.
  EXPECT_EQ(fingerprint(scan()), 0x1cac19ef8d4d10cdULL);
}

}  // namespace
}  // namespace loopmend
