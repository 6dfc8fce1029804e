// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/curvature_energy.h"

#include "evolution/state.h"
#include "flows/gauss_newton.h"
#include "support/patches.h"

#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

Eigen::VectorXd smooth_variation(const Patch& patch) {
  Eigen::VectorXd phi(patch.free_count);
  for (int i = 0; i < patch.free_count; ++i)
    phi[i] = std::cos(5 * patch.positions[i].x()) + std::sin(4 * patch.positions[i].y() + 1);
  return phi;
}

EvolutionState disturbed_state(const Objective& objective) {
  Patch patch = test::exact_sphere_patch(4, 0.8);
  test::disturb(patch, 0.01);
  return make_state(std::move(patch), objective, Stencil::two_ring);
}

TEST(CurvatureJacobian, AgreesWithFiniteDifferencesOfH) {
  const Objective objective;
  const EvolutionState state = disturbed_state(objective);
  const Eigen::VectorXd phi = smooth_variation(state.patch);
  constexpr double step = 1e-6;
  const Eigen::VectorXd plus = displaced(state, objective, Stencil::two_ring, step * phi).ops.H;
  const Eigen::VectorXd minus = displaced(state, objective, Stencil::two_ring, -step * phi).ops.H;
  const Eigen::VectorXd difference = (plus - minus) / (2 * step);
  const Eigen::VectorXd analytic = curvature_jacobian(state.ops, state.patch.free_count) * phi;
  EXPECT_LT((analytic - difference).norm(), 0.03 * difference.norm());
}

/// ∂E/∂s against a central difference of E: sign, factor and every term.
void expect_gradient(const EnergyWeights& weights, const Objective& objective) {
  const EvolutionState state = disturbed_state(objective);
  const GaussNewtonSystem system = assemble_gauss_newton(state.patch, state.ops, weights);
  EXPECT_NEAR(system.energy, state.measure, 1e-12 * state.measure);
  const Eigen::VectorXd phi = smooth_variation(state.patch);
  constexpr double step = 1e-6;
  const double difference = (displaced(state, objective, Stencil::two_ring, step * phi).measure -
                             displaced(state, objective, Stencil::two_ring, -step * phi).measure) /
                            (2 * step);
  EXPECT_NEAR(2 * system.half_gradient.dot(phi), difference, 0.03 * std::abs(difference));
  EXPECT_GT(std::abs(difference), 1e-3);
}

TEST(GaussNewton, GradientOfTheVariationEnergy) { expect_gradient({1, 0}, {FlowKind::mmcvf, 0}); }
TEST(GaussNewton, GradientOfTheBendingEnergy) { expect_gradient({0, 1}, {FlowKind::wf, 0}); }
TEST(GaussNewton, GradientOfTheBlend) { expect_gradient({1, 20}, {FlowKind::mmcvf, 20}); }

TEST(GaussNewton, MatrixIsTheCongruenceAndPositive) {
  const EvolutionState state = disturbed_state({});
  const GaussNewtonSystem system = assemble_gauss_newton(state.patch, state.ops, {1, 0});
  const Eigen::MatrixXd lower(system.curvature()), A(lower.selfadjointView<Eigen::Lower>());
  const Eigen::MatrixXd B(curvature_jacobian(state.ops, state.patch.free_count)),
      Q(curvature_energy(state.patch, state.ops, {1, 0}).Q);
  EXPECT_LT((A - B.transpose() * Q * B).norm(), 1e-12 * A.norm());
  const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(A.rows(), -1, 2).array().sin();
  EXPECT_LT((system.curvature_times(x) - A * x).norm(), 1e-11 * (A * x).norm());
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A).eigenvalues()[0], 0);
}

TEST(CurvatureEnergy, FallsToZeroOnTheSphereUnderRefinement) {
  const auto energy = [](int level) {
    return make_state(test::exact_sphere_patch(level, 0.8), {}, Stencil::two_ring).measure;
  };
  const double coarse = energy(3), fine = energy(4);
  EXPECT_LT(fine, coarse / 3);
  EXPECT_LT(fine, 1e-2);
}

TEST(CurvatureEnergy, BendingOfASphericalPatchIsItsAreaOverRadiusSquared) {
  Patch patch = test::exact_sphere_patch(4, 0.8);
  const EvolutionState state = make_state(patch, {FlowKind::wf, 0}, Stencil::two_ring);
  // The energy also counts rings 1 and 2 around the patch: H² = 1 in mesh units, scale² in the frame.
  double area = 0;
  const Eigen::VectorXd mass = barycentric_areas(patch.positions, patch.triangles);
  for (int i = 0; i < patch.vertex_count(); ++i)
    if (patch.ring[i] <= 2) area += mass[i];
  EXPECT_NEAR(state.measure, area * patch.scale * patch.scale, 0.01 * state.measure);
}

/// Where nothing fits, any value of H is as good as another: none has a part in the energy.
TEST(CurvatureEnergy, LeavesOutWhereAFitIsMissing) {
  const EvolutionState state = disturbed_state({});
  const Patch& patch = state.patch;
  for (int ring : {1, 2, 3}) {
    const auto at = std::find(patch.ring.begin(), patch.ring.end(), ring);
    const int vertex = static_cast<int>(at - patch.ring.begin());
    OperatorSet ops = state.ops;
    ops.valid[vertex] = 0;
    double left_out = 0;
    for (const Triangle& t : patch.triangles) {
      const bool touches = std::find(t.begin(), t.end(), vertex) != t.end();
      if (!touches || std::min({patch.ring[t[0]], patch.ring[t[1]], patch.ring[t[2]]}) > 2) continue;
      const auto weight = half_cotangents(patch.positions, t);
      for (int k = 0; k < 3; ++k) left_out += weight[k] * std::pow(ops.H[t[(k + 1) % 3]] - ops.H[t[(k + 2) % 3]], 2);
    }
    ASSERT_GT(left_out, 0);
    std::vector<double> energies;
    std::vector<Eigen::VectorXd> gradients;
    for (double H : {0.0, 1e3}) {
      ops.H[vertex] = H;
      energies.push_back(energy_value(patch, ops, {1, 20}));
      gradients.push_back(assemble_gauss_newton(patch, ops, {1, 20}).half_gradient);
      EXPECT_NEAR(energy_value(patch, ops, {1, 0}), state.measure - left_out, 1e-12 * state.measure);
      EXPECT_NEAR(assemble_gauss_newton(patch, ops, {1, 0}).energy, state.measure - left_out, 1e-12 * state.measure);
    }
    EXPECT_EQ(energies[0], energies[1]);
    EXPECT_EQ(gradients[0], gradients[1]);
  }
}

TEST(PatchRadius, AClosedPatchCountsAsOneLoop) {
  const TriangleSoup ball = make_icosphere(4);
  Patch patch;
  patch.positions = ball.points;
  patch.triangles = ball.triangles;
  patch.patch_triangles = static_cast<int>(ball.triangles.size());
  EXPECT_NEAR(patch_radius(patch), 2, 0.01);  // π · 2² is the area of the unit sphere
  patch.loops.resize(4);
  EXPECT_NEAR(patch_radius(patch), 1, 0.005);
}

}  // namespace
}  // namespace loopmend
