// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighborhood/boundary_fits.h"

#include "core/random.h"
#include "support/patches.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

TEST(BoundaryFits, OfASphereAreExactAndSaySo) {
  const Patch patch = test::start_of(test::open_sphere(5, 0.8));
  const std::vector<BoundaryFit> fits = boundary_fits(patch, FixedSurface(patch))[0];
  ASSERT_EQ(fits.size(), patch.loops[0].size());
  ASSERT_GT(fits.size(), 60u);
  for (const BoundaryFit& fit : fits) {
    ASSERT_TRUE(fit.valid);
    EXPECT_NEAR(fit.H / patch.scale, -1, 6e-3);  // second order in the width of three rings, 0.12
    EXPECT_LT(fit.H_sigma / patch.scale, 1e-2);
    EXPECT_LT(fit.gradient / (patch.scale * patch.scale), 0.1);
  }
}

/// The uncertainty must be what the errors over many vertices are like.
TEST(BoundaryFits, UncertaintyIsThatOfTheErrors) {
  const double sigma = 0.03 * 0.038;  // 3 % of an edge
  double error = 0, foreseen = 0, angle = 0, angle_foreseen = 0;
  int count = 0;
  for (unsigned seed = 9; seed < 15; ++seed) {
    TriangleSoup soup = make_icosphere(5);
    Random random(seed);
    for (Vec3& p : soup.points) p *= 1 + sigma * random.bell();
    const Patch patch =
        test::start_of(make_surface_model(trim_boundaries(cut(soup, [](const Vec3& p) { return p.z() > 0.6; }))));
    const std::vector<BoundaryFit> fits = boundary_fits(patch, FixedSurface(patch))[0];
    for (std::size_t k = 0; k < fits.size(); ++k) {
      if (!fits[k].valid) continue;
      ++count;
      error += std::pow(fits[k].H / patch.scale + 1, 2);
      foreseen += std::pow(fits[k].H_sigma / patch.scale, 2);
      const Vec3 truth = patch.to_mesh(patch.positions[patch.loops[0][k]]).normalized();
      angle += std::pow(std::acos(std::min(1.0, truth.dot(fits[k].normal))), 2);
      angle_foreseen += std::pow(fits[k].normal_sigma, 2);
    }
  }
  ASSERT_GT(count, 600);
  for (double ratio : {error / foreseen, angle / angle_foreseen}) {  // measured: 1.33 and 1.24
    EXPECT_GT(ratio, 0.7);
    EXPECT_LT(ratio, 1.7);
  }
}

TEST(BoundaryFits, UncertaintyOfHIsKnownAtFixedVerticesThatWereAskedFor) {
  TriangleSoup soup = make_icosphere(5);
  Random random(4);
  for (Vec3& p : soup.points) p *= 1 + 0.001 * random.bell();
  const Patch patch = test::start_of(make_surface_model(cut(soup, [](const Vec3& p) { return p.z() > 0.8; })));
  const std::vector<float> all = curvature_uncertainty(patch);
  ASSERT_EQ(static_cast<int>(all.size()), patch.vertex_count() - patch.free_count);
  std::vector<int> asked{0};  // a free vertex has no fit
  for (int i = patch.free_count; i < patch.vertex_count(); i += 7) asked.push_back(i);
  const std::vector<float> some = curvature_uncertainty(patch, asked);
  ASSERT_EQ(some.size(), all.size());
  int known = 0;
  for (int i = patch.free_count; i < patch.vertex_count(); ++i) {
    const float sigma = some[i - patch.free_count];
    const bool expected = (i - patch.free_count) % 7 == 0 && patch.ring[i] <= 4;
    EXPECT_EQ(std::isfinite(sigma), expected) << i;
    if (!expected) continue;
    ++known;
    EXPECT_EQ(sigma, all[i - patch.free_count]) << i;  // white noise: fits of five rings in both
  }
  EXPECT_GT(known, 30);
}

TEST(BoundaryFits, SummaryIsInMeshUnits) {
  TriangleSoup soup = cut(make_icosphere(5), [](const Vec3& p) { return p.z() > 0.8; });
  for (Vec3& p : soup.points) p *= 100;
  const Patch patch = test::start_of(make_surface_model(soup));
  const BoundarySummary summary = boundary_summaries(patch, estimate_split(patch)).front();
  EXPECT_NEAR(summary.H, 0.01, 1e-4);
  EXPECT_EQ(summary.fitted, static_cast<int>(patch.loops[0].size()));
}

}  // namespace
}  // namespace loopmend
