// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/polynomial_fit.h"

#include "core/random.h"
#include "operators/vertex_normals.h"
#include "samples/analytic_surfaces.h"
#include "surfaces/roughen.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

namespace loopmend {
namespace {

const Vec3 up(0, 0, 1);
constexpr int middle = 60;  ///< of a graph with 10 cells along a side

PolynomialFit fit_at(const TriangleSoup& mesh, int i, const Vec3& normal, const FitOptions& options) {
  const int n = static_cast<int>(mesh.points.size());
  FitScratch scratch(n);
  PolynomialFit fit;
  const bool valid = fit_polynomial(mesh.points, Topology(n, mesh.triangles), i, normal, options, scratch, fit);
  EXPECT_EQ(valid, fit.valid);
  EXPECT_EQ(std::count(scratch.mark.begin(), scratch.mark.end(), 0), n);
  return fit;
}

FitOptions height_field(int degree, Centre centre, Weighting weighting) {
  FitOptions options;
  options.degree = options.least_degree = degree;
  options.rings = options.most_rings = 3;
  options.coordinates = Coordinates::projected;
  options.centre = centre;
  options.weighting = weighting;
  options.softening = weighting == Weighting::equal ? 0 : 0.1;
  return options;
}

/// A graph whose vertices are not on a grid.
TriangleSoup irregular_graph(const std::function<double(double, double)>& height) {
  return roughen(make_graph(height, 1, 10), 0.2, 0.2, 3,
                 [&](const Vec3& p) { return Vec3(p.x(), p.y(), height(p.x(), p.y())); });
}

class Exactness : public testing::TestWithParam<std::tuple<Centre, Weighting, Outliers>> {};
INSTANTIATE_TEST_SUITE_P(Policies, Exactness,
                         testing::Combine(testing::Values(Centre::interpolated, Centre::sample, Centre::left_out),
                                          testing::Values(Weighting::equal, Weighting::inverse_square),
                                          testing::Values(Outliers::count, Outliers::weighted_down)));

/// z = 0.3 x − 0.2 y + ½ (1.2 x² + 2 · 0.5 x y − 0.7 y²), away from its vertex.
TEST_P(Exactness, OfAQuadratic) {
  const auto [centre, weighting, outliers] = GetParam();
  const TriangleSoup graph =
      irregular_graph([](double x, double y) { return 0.3 * x - 0.2 * y + 0.6 * x * x + 0.5 * x * y - 0.35 * y * y; });
  for (int degree : {2, 3}) {
    FitOptions options = height_field(degree, centre, weighting);
    options.outliers = outliers;
    const PolynomialFit fit = fit_at(graph, middle, up, options);
    ASSERT_TRUE(fit.valid);
    EXPECT_EQ(fit.degree, degree);
    const Vec3& p = graph.points[middle];
    const double zx = 0.3 + 1.2 * p.x() + 0.5 * p.y(), zy = -0.2 + 0.5 * p.x() - 0.7 * p.y();
    const double w = 1 + zx * zx + zy * zy;
    EXPECT_LT((fit.normal - Vec3(-zx, -zy, 1).normalized()).norm(), 1e-10);
    EXPECT_NEAR(fit.H, ((1 + zy * zy) * 1.2 - 2 * zx * zy * 0.5 - (1 + zx * zx) * 0.7) / (2 * std::pow(w, 1.5)), 1e-9);
    EXPECT_NEAR(fit.K, (-1.2 * 0.7 - 0.25) / (w * w), 1e-9);
    EXPECT_NEAR(fit.second_form.trace(), 2 * fit.H, 1e-9);
    EXPECT_LT(fit.derivatives.col(0).norm(), 1e-10);
  }
}

/// z = x³/6 + x y²: H is 0 at the origin, its slopes are (1 + 2) / 2 and 0 there.
TEST_P(Exactness, OfACubic) {
  const auto [centre, weighting, outliers] = GetParam();
  TriangleSoup graph = make_graph([](double x, double y) { return x * x * x / 6 + x * y * y; }, 1, 10);
  FitOptions options = height_field(3, centre, weighting);
  options.outliers = outliers;
  options.output = FitOutput::uncertainty;
  const PolynomialFit fit = fit_at(graph, middle, up, options);
  ASSERT_TRUE(fit.valid);
  EXPECT_NEAR(fit.H, 0, 1e-9);
  EXPECT_NEAR(fit.H_slope, 1.5, 1e-8);
  EXPECT_LT(fit.H_slope_sigma, 1e-8);
  EXPECT_LT(fit.residual, 1e-10);
  EXPECT_LT((fit.normal - up).norm(), 1e-10);
}

TEST(PolynomialFit, WeightsAreExactForQuadraticFunctionsInThePlane) {
  const TriangleSoup plane = irregular_graph([](double, double) { return 0.0; });
  FitOptions options;
  options.output = FitOutput::operator_weights;
  const PolynomialFit fit = fit_at(plane, middle, up, options);
  ASSERT_TRUE(fit.valid);
  ASSERT_EQ(fit.laplacian.size(), fit.samples.size());
  const auto f = [](const Vec3& p) { return p.x() * p.x() + 3 * p.x() * p.y() + 2 * p.y(); };
  const Vec3& p = plane.points[middle];
  double laplacian = 0;
  Vec3 gradient = Vec3::Zero();
  for (std::size_t k = 0; k < fit.samples.size(); ++k) {
    const double difference = f(plane.points[fit.samples[k]]) - f(p);
    laplacian += fit.laplacian[k] * difference;
    gradient += fit.gradient[k] * difference;
  }
  EXPECT_NEAR(laplacian, 2, 1e-9);
  EXPECT_LT((gradient - Vec3(2 * p.x() + 3 * p.y(), 3 * p.x() + 2, 0)).norm(), 1e-9);
}

/// Rms error of H over an irregular mesh without boundary.
double error_of_H(const TriangleSoup& mesh, const std::function<double(const Vec3&)>& exact,
                  const FitOptions& options) {
  const int n = static_cast<int>(mesh.points.size());
  const Topology topology(n, mesh.triangles);
  const Points normals = angle_weighted_normals(mesh.points, mesh.triangles);
  FitScratch scratch(n);
  PolynomialFit fit;
  double squares = 0;
  for (int i = 0; i < n; ++i) {
    EXPECT_TRUE(fit_polynomial(mesh.points, topology, i, normals[i], options, scratch, fit));
    squares += std::pow(fit.H - exact(mesh.points[i]), 2);
  }
  return std::sqrt(squares / n);
}

Vec3 ring_centre(const Vec3& p) { return Vec3(p.x(), p.y(), 0).normalized() * 2; }

/// A quadratic has an error of first order where the mesh is irregular, a cubic of second; in either coordinates.
TEST(PolynomialFit, ConvergesOnSphereAndTorus) {
  const auto torus = [](int around) {
    return roughen(make_torus(2, 0.7, around, around * 7 / 20), 0.2, 0.25, 7,
                   [](const Vec3& p) { return Vec3(ring_centre(p) + 0.7 * (p - ring_centre(p)).normalized()); });
  };
  const auto sphere = [](int level) {
    return roughen(make_icosphere(level), 0.2, 0.25, 7, [](const Vec3& p) { return p.normalized(); });
  };
  const auto H_of_torus = [](const Vec3& p) {
    const double cosine = (p - ring_centre(p)).normalized().dot(ring_centre(p)) / 2;
    return -(1 / 0.7 + cosine / (2 + 0.7 * cosine)) / 2;
  };
  const auto H_of_sphere = [](const Vec3&) { return -1.0; };
  const TriangleSoup coarse_torus = torus(60), fine_torus = torus(120), coarse = sphere(3), fine = sphere(4);
  for (Coordinates coordinates : {Coordinates::true_distance, Coordinates::projected})
    for (int degree : {2, 3}) {
      FitOptions options;
      options.rings = options.most_rings = 3;
      options.coordinates = coordinates;
      options.degree = options.least_degree = degree;
      const double least = degree == 2 ? 0.8 : 1.7;
      EXPECT_GT(std::log2(error_of_H(coarse_torus, H_of_torus, options) / error_of_H(fine_torus, H_of_torus, options)),
                least);
      EXPECT_GT(std::log2(error_of_H(coarse, H_of_sphere, options) / error_of_H(fine, H_of_sphere, options)), least);
    }
}

TEST(PolynomialFit, RanksThatAreMissingAreReportedNotInvented) {
  // On three lines y³ = y: no cubic, but a quadratic. On two lines y² = y: nothing.
  TriangleSoup strip = make_graph([](double x, double y) { return 0.1 * x * x + 0.1 * y * y; }, 1, 10);
  std::erase_if(strip.triangles, [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](int v) { return std::abs(strip.points[v].y()) > 0.21; });
  });
  FitOptions options = height_field(3, Centre::interpolated, Weighting::equal);
  EXPECT_FALSE(fit_at(strip, middle, up, options).valid);
  options.least_degree = 2;
  const PolynomialFit quadratic = fit_at(strip, middle, up, options);
  ASSERT_TRUE(quadratic.valid);
  EXPECT_EQ(quadratic.degree, 2);
  EXPECT_NEAR(quadratic.H, 0.2, 1e-9);
  std::erase_if(strip.triangles, [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](int v) { return strip.points[v].y() > 0.1; });
  });
  options.output = FitOutput::operator_weights;
  const PolynomialFit none = fit_at(strip, middle, up, options);
  EXPECT_FALSE(none.valid);
  EXPECT_EQ(none.H, 0);
  EXPECT_EQ(none.normal, up);
  EXPECT_TRUE(none.laplacian.empty());
}

TEST(PolynomialFit, TooFewSamplesOrNoNormalGiveNoFit) {
  const TriangleSoup graph = make_graph([](double x, double y) { return x * y; }, 1, 10);
  FitOptions options = height_field(2, Centre::interpolated, Weighting::equal);
  const int available = static_cast<int>(fit_at(graph, middle, up, options).samples.size());
  options.spare = available - 5;
  EXPECT_TRUE(fit_at(graph, middle, up, options).valid);
  ++options.spare;
  EXPECT_FALSE(fit_at(graph, middle, up, options).valid);
  EXPECT_FALSE(fit_at(graph, middle, Vec3::Zero(), FitOptions{}).valid);
}

TEST(PolynomialFit, RingsAreAddedUntilTheyDetermineItAndAreEnough) {
  const TriangleSoup sphere = make_icosphere(4);
  constexpr int of_valence_five = 0;
  FitOptions options;
  options.rings = 1;
  options.most_rings = 5;
  const auto fit = [&] { return fit_at(sphere, of_valence_five, sphere.points[of_valence_five], options); };
  EXPECT_EQ(fit().rings, 1);
  EXPECT_EQ(fit().samples.size(), 5u);
  options.spare = 1;
  EXPECT_EQ(fit().rings, 2);
  EXPECT_EQ(fit().samples.size(), 15u);
  options.enough = 16;
  EXPECT_EQ(fit().rings, 3);
  EXPECT_NEAR(fit().H, -1, 0.01);
}

/// One neighbour 0.3 off, in a neighbourhood 0.6 wide.
TEST(PolynomialFit, OutliersWeightedDownHardlyMatter) {
  TriangleSoup graph = make_graph([](double x, double y) { return 0.5 * x * x + 0.2 * y * y; }, 1, 10);
  graph.points[middle + 1].z() += 0.3;
  const auto H = [&](Outliers outliers) {
    return fit_at(graph, middle, up, cubic_height_field(3, outliers, FitOutput::curvatures)).H;
  };
  const double plain = H(Outliers::count), robust = H(Outliers::weighted_down);
  EXPECT_GT(std::abs(plain - 0.7), 0.05);
  EXPECT_LT(std::abs(robust - 0.7), 0.02 * std::abs(plain - 0.7));
}

TEST(PolynomialFit, CentreThatIsLeftOutIsPutWhereItsNeighboursSay) {
  TriangleSoup graph = make_graph([](double x, double y) { return 0.5 * x * x - 0.2 * x * y; }, 1, 10);
  graph.points[middle].z() += 0.3;
  FitOptions options = cubic_height_field(3, Outliers::count, FitOutput::curvatures);
  options.centre = Centre::left_out;
  EXPECT_LT((fit_at(graph, middle, up, options).derivatives.col(0) + 0.3 * up).norm(), 1e-9);
  options.centre = Centre::sample;
  EXPECT_GT((fit_at(graph, middle, up, options).derivatives.col(0) + 0.3 * up).norm(), 0.01);
}

/// Standard deviations are those of the errors under noise, and scale with the surface.
TEST(PolynomialFit, UncertaintyIsThatOfTheErrors) {
  constexpr double sigma = 0.001;
  const FitOptions options = cubic_height_field(3, Outliers::count, FitOutput::uncertainty);
  double noise = 0, H = 0, H_foreseen = 0, angle = 0, angle_foreseen = 0, slope = 0, slope_foreseen = 0;
  constexpr int runs = 400;
  for (int run = 0; run < runs; ++run) {
    TriangleSoup plane = make_graph([](double, double) { return 0.0; }, 1, 10);
    Random random(static_cast<unsigned>(run));
    for (Vec3& p : plane.points) p.z() += sigma * random.bell();
    const PolynomialFit fit = fit_at(plane, middle, up, options);
    ASSERT_TRUE(fit.valid);
    noise += fit.residual * fit.residual / runs;
    H += fit.H * fit.H;
    H_foreseen += fit.H_sigma * fit.H_sigma;
    angle += (fit.normal - up).squaredNorm();
    angle_foreseen += fit.normal_sigma * fit.normal_sigma;
    slope += fit.H_slope * fit.H_slope;
    slope_foreseen += fit.H_slope_sigma * fit.H_slope_sigma;
  }
  EXPECT_NEAR(std::sqrt(noise), sigma, 0.03 * sigma);
  EXPECT_NEAR(H / H_foreseen, 1, 0.2);
  EXPECT_NEAR(angle / angle_foreseen, 1, 0.2);
  EXPECT_NEAR(slope / slope_foreseen, 1, 0.2);
}

}  // namespace
}  // namespace loopmend
