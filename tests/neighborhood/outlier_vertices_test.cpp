// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighborhood/outlier_vertices.h"

#include "mesh/quality.h"
#include "support/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace loopmend {
namespace {

/// A surface that is known, with a hole.
struct Known {
  const char* name;
  TriangleSoup open;
  std::function<Vec3(const Vec3&)> normal;
  std::function<double(const Vec3&)> height;  ///< above the surface
};

Known sphere() {
  return {"sphere", trim_boundaries(cut(make_icosphere(5), [](const Vec3& p) { return p.z() > 0.85; })),
          [](const Vec3& p) { return p.normalized(); }, [](const Vec3& p) { return p.norm() - 1; }};
}

Known torus() {
  const auto axis = [](const Vec3& p) { return Vec3(p.x(), p.y(), 0).normalized(); };
  const Vec3 middle(1 + 0.4 * std::cos(1.0), 0, 0.4 * std::sin(1.0));
  return {"torus",
          trim_boundaries(cut(make_torus(1, 0.4, 150, 60), [=](const Vec3& p) { return (p - middle).norm() < 0.36; })),
          [=](const Vec3& p) { return (p - axis(p)).normalized(); },
          [=](const Vec3& p) { return (p - axis(p)).norm() - 0.4; }};
}

double edge_of(const Patch& patch) {
  return patch.scale * mean_edge_length(patch.positions, patch.triangles, patch.patch_triangles);
}

struct Spikes {
  std::vector<int> vertices;  ///< soup points
  Points feet;                ///< where they stood before
};

/// Moves `count` vertices of a ring, far from one another, by this many edges along the normal.
Spikes add_spikes(Known& known, int ring, int count, double height) {
  const SurfaceModel model = make_surface_model(known.open);
  const Patch patch = test::start_of(model);
  std::vector<int> on_ring;
  for (int i = patch.free_count; i < patch.vertex_count(); ++i)
    if (patch.ring[i] == ring) on_ring.push_back(model.soup_vertex[patch.view_vertex[i]]);
  std::rotate(on_ring.begin(), std::min_element(on_ring.begin(), on_ring.end()), on_ring.end());
  Spikes spikes;
  for (int k = 0; k < count; ++k) {
    spikes.vertices.push_back(on_ring[k * on_ring.size() / count]);
    Vec3& p = known.open.points[spikes.vertices.back()];
    spikes.feet.push_back(p);
    p += height * edge_of(patch) * known.normal(p);
  }
  return spikes;
}

struct Filled {
  double rms = 0;  ///< of the new vertices that are three edges and more from the foot of any spike, in edges
  double max = 0;  ///< of all new vertices, in edges
  bool exterior_unchanged = false;
};

Filled fill(const Known& known, const Spikes& spikes, BoundaryTrust confidence) {
  SurfaceModel model = make_surface_model(known.open);
  const double edge = edge_of(test::start_of(model));
  FillOptions options;
  options.evolution->boundary = confidence;
  for (const HoleResult& result : fill_holes(model, find_boundary_loops(model), options, nullptr, {}))
    EXPECT_EQ(result.status, PatchStatus::converged) << result.message;
  Filled filled;
  double count = 0;
  for (std::size_t v = known.open.points.size(); v < model.soup.points.size(); ++v) {
    const Vec3& p = model.soup.points[v];
    const double height = std::abs(known.height(p)) / edge;
    filled.max = std::max(filled.max, height);
    if (std::any_of(spikes.feet.begin(), spikes.feet.end(),
                    [&](const Vec3& foot) { return (foot - p).norm() < 3 * edge; }))
      continue;
    filled.rms += height * height;
    ++count;
  }
  filled.rms = std::sqrt(filled.rms / count);
  filled.exterior_unchanged =
      std::equal(known.open.points.begin(), known.open.points.end(), model.soup.points.begin()) &&
      std::equal(known.open.triangles.begin(), known.open.triangles.end(), model.soup.triangles.begin());
  return filled;
}

TEST(OutlierVertices, ACleanNeighborhoodIsLeftBitForBit) {
  for (const SurfaceModel& model : {test::open_sphere(3, 0.2), test::open_sphere(4, 0.8),
                                    test::rough_open_sphere(4, 0.8), make_surface_model(torus().open)}) {
    const Patch patch = test::start_of(model);
    const CleanNeighborhood clean_neighborhood = remove_outliers(patch);
    EXPECT_EQ(clean_neighborhood.outliers, 0);
    EXPECT_EQ(clean_neighborhood.patch.positions, patch.positions);
  }
}

TEST(OutlierVertices, ASpikeIsFoundAndNothingElse) {
  for (const auto& make : {sphere, torus})
    for (int ring : {1, 2})
      for (double height : {0.3, 1.0, 3.0, -0.3, -1.0}) {
        Known known = make();
        const Spikes spikes = add_spikes(known, ring, 2, height);
        const SurfaceModel model = make_surface_model(known.open);
        const Patch patch = test::start_of(model);
        const CleanNeighborhood clean_neighborhood = remove_outliers(patch);
        EXPECT_EQ(clean_neighborhood.outliers, 2) << known.name << ", ring " << ring << ", " << height;
        for (int i = patch.free_count; i < patch.vertex_count(); ++i) {
          const bool spike =
              std::count(spikes.vertices.begin(), spikes.vertices.end(), model.soup_vertex[patch.view_vertex[i]]) > 0;
          if (spike) {
            EXPECT_LT(std::abs(known.height(clean_neighborhood.patch.to_mesh(clean_neighborhood.patch.positions[i]))),
                      0.02 * edge_of(patch))
                << known.name << ", ring " << ring << ", " << height;
          } else {
            EXPECT_EQ(clean_neighborhood.patch.positions[i], patch.positions[i]);
          }
        }
      }
}

TEST(OutlierVertices, SmallSpikesCountInPartWithoutAJump) {
  double before = 0, most = 0;
  for (double height = 0.015; height < 0.09; height += 0.005) {
    Known known = sphere();
    const int spike = add_spikes(known, 2, 1, height).vertices.front();
    const SurfaceModel model = make_surface_model(known.open);
    const Patch patch = test::start_of(model), clean_neighborhood = remove_outliers(patch).patch;
    const auto at = std::find_if(patch.view_vertex.begin() + patch.free_count, patch.view_vertex.end(),
                                 [&](int v) { return model.soup_vertex[v] == spike; });
    ASSERT_NE(at, patch.view_vertex.end());
    // Of the height, in edges.
    const double left =
        known.height(clean_neighborhood.to_mesh(clean_neighborhood.positions[at - patch.view_vertex.begin()])) /
        edge_of(patch);
    most = std::max(most, left);
    EXPECT_NEAR(left, before, 0.02) << height;
    EXPECT_LE(left, height * 1.01);  // the spike makes the initial patch's mean edge a little longer
    before = left;
  }
  EXPECT_LT(std::abs(before), 0.001);
  EXPECT_GT(most, 0.02);  // measured: 0.030
}

TEST(OutlierVertices, ThreeInOnePlaceAreAFeature) {
  Known known = sphere();
  const SurfaceModel model = make_surface_model(known.open);
  const Patch patch = test::start_of(model);
  std::vector<int> ring;
  for (int v : patch.loops[0]) ring.push_back(model.soup_vertex[patch.view_vertex[v]]);
  for (int k : {5, 6, 7}) known.open.points[ring[k]] *= 1.04;
  EXPECT_EQ(remove_outliers(test::start_of(make_surface_model(known.open))).outliers, 0);
}

TEST(OutlierVertices, APatchBesideASpikeIsThatOfTheSmoothSurface) {
  for (const auto& make : {sphere, torus})
    for (int ring : {1, 2})
      for (double height : {0.3, 1.0, 3.0}) {
        Known known = make();
        const Spikes spikes = add_spikes(known, ring, 1, height);
        const Filled filled = fill(known, spikes, BoundaryTrust::automatic);
        EXPECT_TRUE(filled.exterior_unchanged);
        // The patch must meet a spike on its own boundary, so that something of it is left beside; a second ring it need not meet.
        EXPECT_LT(filled.rms, ring == 1 ? 0.005 * height : 0.001) << known.name << ", ring " << ring << ", " << height;
        EXPECT_LT(filled.max, ring == 1 ? 0.4 * height : 0.002) << known.name << ", ring " << ring << ", " << height;
      }
}

TEST(OutlierVertices, AreMetLiterallyWhereThatIsAsked) {
  Known known = sphere();
  const Spikes spikes = add_spikes(known, 1, 1, 0.3);
  EXPECT_GT(fill(known, spikes, BoundaryTrust::exact).rms, 50 * fill(known, spikes, BoundaryTrust::automatic).rms);
}

}  // namespace
}  // namespace loopmend
