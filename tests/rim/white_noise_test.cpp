// SPDX-License-Identifier: GPL-3.0-or-later
#include "rim/white_noise.h"

#include "mesh/mesh_arrays.h"
#include "samples/random.h"
#include "support/patches.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace loopmend {
namespace {

constexpr double edge = 0.038;  // mean, of the icosphere

SurfaceModel noisy_sphere(double share, unsigned seed) {
  TriangleSoup soup = make_icosphere(5);
  Random random(seed);
  for (Vec3& p : soup.points) p *= 1 + share * edge * random.bell();
  return make_surface_model(trim_rims(cut(soup, [](const Vec3& p) { return p.z() > 0.85; })));
}

double rms_distance_of_fixed(const Patch& patch) {
  double sum = 0;
  for (int i = patch.free_count; i < patch.vertex_count(); ++i)
    sum += std::pow(patch.to_mesh(patch.positions[i]).norm() - 1, 2);
  return std::sqrt(sum / (patch.vertex_count() - patch.free_count));
}

/// rms distance of the new vertices from the sphere, over three seeds.
double error_of_fill(double share, BoundaryTrust trust) {
  double sum = 0, count = 0;
  for (unsigned seed : {3U, 4U, 5U}) {
    SurfaceModel model = noisy_sphere(share, seed);
    const Points before = model.soup.points;
    FillOptions options;
    options.evolution->boundary = trust;
    for (const HoleResult& result : fill_holes(model, find_boundary_loops(model), options, nullptr, {}))
      EXPECT_EQ(result.status, PatchStatus::converged);
    EXPECT_TRUE(std::equal(before.begin(), before.end(), model.soup.points.begin()));
    for (std::size_t v = before.size(); v < model.soup.points.size(); ++v) {
      sum += std::pow(model.soup.points[v].norm() - 1, 2);
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

TEST(WhiteNoise, IsTakenOffTheSurroundings) {
  const SurfaceModel model = noisy_sphere(0.05, 3);
  const Patch noisy = test::start_of(model), quiet = without_noise(noisy, model, 1);
  EXPECT_NEAR(rms_distance_of_fixed(noisy), 0.05 * edge, 0.1 * 0.05 * edge);
  EXPECT_LT(rms_distance_of_fixed(quiet), 0.4 * rms_distance_of_fixed(noisy));
}

TEST(WhiteNoise, GoesByShares) {
  const SurfaceModel model = noisy_sphere(0.05, 3);
  const Patch noisy = test::start_of(model), quiet = without_noise(noisy, model, 1);
  const Patch half = without_noise(noisy, model, 0.5), none = without_noise(noisy, model, 0);
  for (int i = noisy.free_count; i < noisy.vertex_count(); ++i) {
    EXPECT_LT((half.positions[i] - (noisy.positions[i] + quiet.positions[i]) / 2).norm(), 1e-12);
    EXPECT_EQ(none.positions[i], noisy.positions[i]);
  }
}

TEST(WhiteNoise, ComesBackBitForBit) {
  const SurfaceModel model = noisy_sphere(0.05, 3);
  const Patch noisy = test::start_of(model), back = with_noise_again(without_noise(noisy, model, 1), noisy);
  for (int i = noisy.free_count; i < noisy.vertex_count(); ++i) EXPECT_EQ(back.positions[i], noisy.positions[i]);
  // The free vertices come back up to the change of the metric on the way.
  const Patch quiet = without_noise(noisy, model, 1);
  double away = 0, left = 0;
  for (int i = 0; i < noisy.free_count; ++i) {
    away = std::max(away, (quiet.positions[i] - noisy.positions[i]).norm());
    left = std::max(left, (back.positions[i] - noisy.positions[i]).norm());
  }
  EXPECT_GT(away, 0.001);  // measured: 0.0013, of which 0.0002 are left
  EXPECT_LT(left, 0.3 * away);
}

TEST(WhiteNoise, TheErrorStaysBelowThatOfTheLiteralFlow) {
  for (double share : {0.01, 0.05})
    EXPECT_LT(error_of_fill(share, BoundaryTrust::automatic), 0.8 * error_of_fill(share, BoundaryTrust::exact)) << share;
}

}  // namespace
}  // namespace loopmend
