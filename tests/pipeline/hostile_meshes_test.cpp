// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that no scanner should make: every hole is filled or left with a reason, and what was there stays in every bit.
#include "core/error.h"
#include "io/read_mesh.h"
#include "pipeline/fill_holes.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace loopmend {
namespace hostile_meshes {

struct HostileMesh {
  std::string name;
  TriangleSoup soup;
};

TriangleSoup sphere_with_two_holes() {
  return cut(make_icosphere(2), [](const Vec3& p) { return std::abs(p.z()) > 0.8; });
}

HostileMesh changed(const std::string& name, const std::function<void(TriangleSoup&)>& change) {
  HostileMesh mesh{name, sphere_with_two_holes()};
  change(mesh.soup);
  return mesh;
}

double between(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

std::vector<HostileMesh> bent_surfaces() {
  std::vector<HostileMesh> all;
  const auto add = [&](const std::string& name, const std::function<void(TriangleSoup&)>& change) {
    all.push_back(changed(name, change));
  };
  add("degenerate faces", [](TriangleSoup& s) {
    s.triangles.insert(s.triangles.end(), {{0, 0, 1}, {2, 2, 2}, {0, 1, 0}});
  });
  add("every face twice", [](TriangleSoup& s) {
    const Triangles once = s.triangles;
    s.triangles.insert(s.triangles.end(), once.begin(), once.end());
  });
  add("every face from both sides", [](TriangleSoup& s) {
    const Triangles once = s.triangles;
    for (const Triangle& t : once) s.triangles.push_back({t[0], t[2], t[1]});
  });
  add("every fifth face turned", [](TriangleSoup& s) {
    for (std::size_t k = 0; k < s.triangles.size(); k += 5) std::swap(s.triangles[k][0], s.triangles[k][1]);
  });
  add("every third face missing", [](TriangleSoup& s) {
    Triangles kept;
    for (std::size_t k = 0; k < s.triangles.size(); ++k)
      if (k % 3 != 0) kept.push_back(s.triangles[k]);
    s.triangles = kept;
  });
  add("fins on edges", [](TriangleSoup& s) {
    for (std::size_t k = 0; k < 40; k += 4) {
      s.triangles.push_back({s.triangles[k][0], s.triangles[k][1], static_cast<int>(s.points.size())});
      s.points.push_back(2 * s.points[s.triangles[k][0]]);
    }
  });
  add("every face by itself", [](TriangleSoup& s) {
    TriangleSoup apart;
    for (const Triangle& t : s.triangles) {
      const int first = static_cast<int>(apart.points.size());
      for (const int v : t) apart.points.push_back(s.points[v]);
      apart.triangles.push_back({first, first + 1, first + 2});
    }
    s = apart;
  });
  add("one vertex far out", [](TriangleSoup& s) { s.points[5] *= 1e6; });
  add("every tenth vertex far out", [](TriangleSoup& s) {
    for (std::size_t k = 0; k < s.points.size(); k += 10) s.points[k] *= 100;
  });
  add("flat", [](TriangleSoup& s) {
    for (Vec3& p : s.points) p[2] = 0;
  });
  add("in one line", [](TriangleSoup& s) {
    for (Vec3& p : s.points) p[1] = p[2] = 0;
  });
  add("in one point", [](TriangleSoup& s) {
    for (Vec3& p : s.points) p.setZero();
  });
  add("coordinates of a coarse grid", [](TriangleSoup& s) {
    for (Vec3& p : s.points)
      for (double& x : p) x = std::round(3 * x);
  });
  for (const double scale : {1e-300, 1e-150, 1e-30, 1e30, 1e150, 1e300})
    add("as large as " + std::to_string(std::log10(scale)), [=](TriangleSoup& s) {
      for (Vec3& p : s.points) p *= scale;
    });
  for (const double far : {1e6, 1e12, 1e17})
    add("as far as " + std::to_string(std::log10(far)), [=](TriangleSoup& s) {
      for (Vec3& p : s.points) p += Vec3(far, far, -far);
    });
  add("fragments around", [](TriangleSoup& s) {
    for (int k = 0; k < 20; ++k) {
      const int first = static_cast<int>(s.points.size());
      const Vec3 at(0.05 * (k % 5), 0.05 * (k / 5), 0.9);
      for (const Vec3& p : {Vec3(0, 0, 0), Vec3(0.03, 0, 0), Vec3(0, 0.03, 0.01)}) s.points.push_back(at + p);
      s.triangles.push_back({first, first + 1, first + 2});
    }
  });
  add("vertices exchanged", [](TriangleSoup& s) {
    std::mt19937_64 random(1);
    std::shuffle(s.points.begin(), s.points.end(), random);
  });
  return all;
}

/// Random triangles over few points: every fault at once.
HostileMesh random_triangles(unsigned seed) {
  std::mt19937_64 random(seed);
  TriangleSoup soup;
  for (int k = 0; k < 24; ++k)
    soup.points.emplace_back(between(random, -1, 1), between(random, -1, 1), between(random, -1, 1));
  for (int k = 0; k < 60; ++k) {
    Triangle t;
    for (int& v : t) v = static_cast<int>(random() % soup.points.size());
    soup.triangles.push_back(t);
  }
  return {"random triangles " + std::to_string(seed), soup};
}

/// A sphere with some bits of its coordinates turned over, as after a bad transfer.
HostileMesh turned_bits(unsigned seed) {
  std::mt19937_64 random(seed);
  TriangleSoup soup = sphere_with_two_holes();
  for (int k = 0; k < 10; ++k) {
    double& x = soup.points[random() % soup.points.size()][static_cast<int>(random() % 3)];
    const double turned =
        std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ (std::uint64_t{1} << (random() % 64)));
    if (std::isfinite(turned)) x = turned;
  }
  return {"turned bits " + std::to_string(seed), soup};
}

std::vector<std::uint64_t> first_bits(const Points& points, std::size_t count) {
  std::vector<std::uint64_t> bits;
  for (std::size_t k = 0; k < count; ++k)
    for (const double x : points[k]) bits.push_back(std::bit_cast<std::uint64_t>(x));
  return bits;
}

void expect_filled_or_said(const HostileMesh& mesh) {
  SCOPED_TRACE(mesh.name);
  SurfaceModel model;
  try {
    model = make_surface_model(mesh.soup);
  } catch (const InvalidArgument&) {
    return;  // every face is degenerate
  }
  const TriangleSoup before = model.soup;
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  FillOptions options;
  options.most_memory_mb = 300;
  const std::vector<HoleResult> results = fill_holes(model, loops, options, nullptr, {});
  EXPECT_GE(results.size(), loops.size());
  for (const HoleResult& result : results)
    EXPECT_TRUE(is_filled(result.status) || !result.message.empty()) << to_string(result.status);
  const TriangleSoup& after = model.soup;
  ASSERT_GE(after.points.size(), before.points.size());
  ASSERT_GE(after.triangles.size(), before.triangles.size());
  EXPECT_EQ(first_bits(after.points, before.points.size()), first_bits(before.points, before.points.size()));
  EXPECT_TRUE(std::equal(before.triangles.begin(), before.triangles.end(), after.triangles.begin()));
  for (std::size_t k = before.points.size(); k < after.points.size(); ++k) EXPECT_TRUE(after.points[k].allFinite());
  const int count = static_cast<int>(after.points.size());
  for (const Triangle& t : after.triangles)
    for (const int v : t) EXPECT_TRUE(v >= 0 && v < count);
}

TEST(HostileMeshes, BentSurfacesAreFilledOrSaidWhyNot) {
  for (const HostileMesh& mesh : bent_surfaces()) expect_filled_or_said(mesh);
}

TEST(HostileMeshes, RandomTrianglesAreFilledOrSaidWhyNot) {
  for (unsigned seed = 0; seed < 20; ++seed) expect_filled_or_said(random_triangles(seed));
}

TEST(HostileMeshes, TurnedBitsAreFilledOrSaidWhyNot) {
  for (unsigned seed = 0; seed < 20; ++seed) expect_filled_or_said(turned_bits(seed));
}

/// Files that were collected for what they do to readers; their outcomes in tests/io/corpus_test.cpp.
TEST(HostileMeshes, TheCorpusIsFilledOrSaidWhyNot) {
  const std::filesystem::path folder = std::filesystem::path(LOOPMEND_SHARED_DIR) / "malformed";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << folder << " is not there";
  constexpr std::size_t small = 5000;  // faces: a minute of sanitizers for all
  int filled = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!is_mesh_name(entry.path())) continue;
    try {
      const ImportedMesh mesh = read_mesh(entry.path());
      if (mesh.soup.triangles.size() > small) continue;
      expect_filled_or_said({entry.path().filename().string(), mesh.soup});
      ++filled;
    } catch (const ReadError&) {
    }
  }
  EXPECT_GT(filled, 20);
}

}  // namespace hostile_meshes
}  // namespace loopmend
