// SPDX-License-Identifier: GPL-3.0-or-later
#include "split/continue_relief.h"

#include "evolution/evolution.h"
#include "support/filled_surface.h"
#include "support/patches.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

constexpr double edge_of_level_5 = 0.04;

/// A sphere with relief along its normals, without its cap.
SurfaceModel rough_sphere(const std::vector<double>& relief, double height) {
  TriangleSoup soup = make_icosphere(5);
  for (std::size_t i = 0; i < soup.points.size(); ++i) soup.points[i] *= 1 + height * relief[i];
  return make_surface_model(trim_boundaries(cut(soup, [](const Vec3& p) { return p.z() > 0.8; })));
}

std::vector<double> white_noise(std::uint64_t seed) {
  Random random(seed);
  std::vector<double> noise(make_icosphere(5).points.size());
  for (double& e : noise) e = random.bell();
  return noise;
}

Evolution split_flow(const SurfaceModel& model) {
  Evolution evolution(test::start_of(model), {});
  evolution.run(nullptr, {});
  return evolution;
}

/// Rms of the differences of height above the unit sphere between vertices about `distance` apart, among those chosen.
double roughness(const Points& points, const std::vector<int>& chosen, double distance) {
  double sum = 0;
  int count = 0;
  for (int a : chosen)
    for (int b : chosen) {
      const double d = (points[a].normalized() - points[b].normalized()).norm();
      if (a >= b || std::abs(d - distance) > 0.2 * distance) continue;
      sum += std::pow(points[a].norm() - points[b].norm(), 2);
      ++count;
    }
  return std::sqrt(sum / std::max(1, count));
}

struct Vertices {
  Points points;  ///< mesh units
  std::vector<int> patch, collar;
};

/// Those of the patch two edges away from the seam, and all fixed ones.
Vertices vertices_of(const Patch& patch) {
  Vertices result;
  for (const Vec3& p : patch.positions) result.points.push_back(patch.to_mesh(p));
  const Topology topology(patch.vertex_count(), patch.triangles);
  for (int v = 0; v < patch.vertex_count(); ++v) {
    bool inner = v < patch.free_count;
    for (int w : topology.neighbors(v)) inner = inner && w < patch.free_count;
    if (inner) result.patch.push_back(v);
    if (v >= patch.free_count) result.collar.push_back(v);
  }
  return result;
}

Patch with(Patch patch, const Points& free) {
  std::copy(free.begin(), free.end(), patch.positions.begin());
  return patch;
}

enum class Kind { relief, noise };

class ContinueRelief : public testing::TestWithParam<Kind> {
 protected:
  static Evolution smooth_patch(std::uint64_t seed) {
    const std::vector<double> heights =
        GetParam() == Kind::noise ? white_noise(seed) : test::random_relief(make_icosphere(5), seed);
    return split_flow(rough_sphere(heights, 0.1 * edge_of_level_5));
  }
};

/// Over eight scans, since a hole has room for few of the longest waves. Measured at 3, 5, 6, 7 and 12 edges: 0.88, 0.83, 0.82, 0.78,
/// 0.77 with relief, 1.07, 1.06, 1.10, 1.13, 1.28 with noise; without 0.46 to 0.60, and 0.06 to 0.19.
TEST_P(ContinueRelief, IsAsStrongAsAroundTheHoleAtThreeWavelengths) {
  constexpr std::array wavelengths{3.0, 4.5, 6.0};  // edges
  std::array<double, 3> around{}, smooth{}, rough{};
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Evolution evolution = smooth_patch(seed);
    ASSERT_EQ(evolution.method(), Method::split_flow);
    const auto relief = continue_relief(evolution.patch(), *evolution.split(), seed);
    ASSERT_TRUE(relief);
    const Vertices before = vertices_of(evolution.patch()),
                   after = vertices_of(with(evolution.patch(), relief->positions));
    for (int k = 0; k < 3; ++k) {
      const double lag = wavelengths[k] / 2 * edge_of_level_5;
      around[k] += std::pow(roughness(before.points, before.collar, lag), 2);
      smooth[k] += std::pow(roughness(before.points, before.patch, lag), 2);
      rough[k] += std::pow(roughness(after.points, after.patch, lag), 2);
    }
  }
  for (int k = 0; k < 3; ++k) {
    EXPECT_LT(std::sqrt(smooth[k] / around[k]), 0.75) << wavelengths[k];
    EXPECT_GT(std::sqrt(rough[k] / around[k]), 0.8) << wavelengths[k];
    EXPECT_LT(std::sqrt(rough[k] / around[k]), 1.25) << wavelengths[k];
  }
}

/// The angle between the two sides of the seam stays below that between triangles of the scan, which has the relief, too.
TEST_P(ContinueRelief, MakesNoStepAtTheSeam) {
  const Evolution evolution = smooth_patch(1);
  const auto relief = continue_relief(evolution.patch(), *evolution.split(), 1);
  ASSERT_TRUE(relief);
  const Patch after = with(evolution.patch(), relief->positions);
  std::array<double, 3> squares{}, count{};  // on the seam, in the patch, around
  const Topology topology(after.vertex_count(), after.triangles);
  for (int v = 0; v < after.vertex_count(); ++v)
    for (int w : topology.neighbors(v)) {
      if (v > w || (v >= after.free_count && after.ring[v] == 1 && w >= after.free_count && after.ring[w] == 1))
        continue;
      const int where = w < after.free_count ? 1 : v < after.free_count ? 0 : 2;
      squares[where] +=
          std::pow(after.to_mesh(after.positions[v]).norm() - after.to_mesh(after.positions[w]).norm(), 2);
      ++count[where];
    }
  std::array<double, 3> rms{};
  for (int k = 0; k < 3; ++k) rms[k] = std::sqrt(squares[k] / count[k]);
  EXPECT_LT(rms[0], 1.25 * std::max(rms[1], rms[2]));
}

TEST_P(ContinueRelief, TheSameSeedGivesTheSameBits) {
  const Evolution smooth = smooth_patch(1);
  const auto draw = [&](std::uint64_t seed) { return continue_relief(smooth.patch(), *smooth.split(), seed); };
  const auto one = draw(7), same = draw(7), other = draw(8);
  ASSERT_TRUE(one && same && other);
  EXPECT_EQ(one->positions, same->positions);
  EXPECT_NE(one->positions, other->positions);
}

INSTANTIATE_TEST_SUITE_P(Of, ContinueRelief, testing::Values(Kind::relief, Kind::noise), [](const auto& param) {
  return std::string(param.param == Kind::noise ? "Noise" : "Relief");
});

TEST(ReliefOfASmoothScan, IsNotContinued) {
  const Patch patch = test::exact_sphere_patch(4, 0.8);
  EXPECT_FALSE(continue_relief(patch, estimate_split(patch), 1));
}

}  // namespace
}  // namespace loopmend
