// SPDX-License-Identifier: GPL-3.0-or-later
// The symmetric matrices that precondition the steps: their factors must make few iterations of many.
#include "evolution/state.h"
#include "flows/decay_rate.h"
#include "flows/gauss_newton.h"
#include "flows/symmetric_part.h"
#include "solvers/linear_solver.h"
#include "support/patches.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

EvolutionState disturbed_state(int level) {
  Patch patch = test::exact_sphere_patch(level, 0.8);
  test::disturb(patch, 0.01);
  return make_state(std::move(patch), {}, Stencil::two_ring);
}

class FlowStep : public testing::TestWithParam<FlowKind> {};
INSTANTIATE_TEST_SUITE_P(Flows, FlowStep, testing::Values(FlowKind::mcf, FlowKind::sdf, FlowKind::wf, FlowKind::mmcvf));

TEST_P(FlowStep, TakesFewIterationsWithTheSymmetricPartForAnyTimeStep) {
  const EvolutionState state = disturbed_state(5);
  const Eigen::VectorXd mass =
      barycentric_areas(state.patch.positions, state.patch.triangles).head(state.patch.free_count);
  const SparseMatrix M(mass.asDiagonal());
  const FlowSystem flow(GetParam(), FlowState(state.ops, state.patch.free_count));
  const double rate = slowest_decay_rate(GetParam(), state.patch);
  for (double sigma : {0.1, 10.0, 1e4}) {
    const double tau = sigma / rate;
    const SparseMatrix A = M - tau * (M * flow.jacobian());
    const GeneralSystem system{
        [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
          return mass.cwiseProduct(x - tau * flow.times_jacobian(x));
        },
        [&] { return A; },
        [&]() -> SparseMatrix { return M + tau * symmetric_part(GetParam(), state.patch, state.ops); }};
    const Eigen::VectorXd b = tau * mass.cwiseProduct(flow.velocity());
    Eigen::VectorXd iterated, direct;
    const SolveReport report = make_general_solver(SolverKind::gmres)->solve(system, b, iterated);
    ASSERT_TRUE(report.solved) << sigma;
    EXPECT_LE(report.iterations, 40) << sigma;
    ASSERT_TRUE(make_general_solver(SolverKind::direct)->solve(system, b, direct).solved);
    EXPECT_LT((iterated - direct).norm(), 1e-4 * direct.norm()) << sigma;
  }
}

TEST(NearGaussNewton, SolvesTheStepByConjugateGradients) {
  const EvolutionState state = disturbed_state(5);
  const GaussNewtonSystem newton = assemble_gauss_newton(state.patch, state.ops, {1, 20});
  const double mu = slowest_decay_rate(FlowKind::mmcvf, state.patch) / 1000;
  const SparseMatrix A = newton.curvature() + mu * SparseMatrix(newton.mass.asDiagonal());
  const GeneralSystem system{[&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
                               return newton.curvature_times(x) + mu * newton.mass.cwiseProduct(x);
                             },
                             {},
                             [&] {
                               return near_gauss_newton(state.patch, {1, 20}, mu);
                             }};
  Eigen::VectorXd iterated;
  Eigen::MatrixXd direct;
  const auto preconditioner_factors = make_spd_solver();
  const SolveReport report =
      conjugate_gradients(system, *preconditioner_factors, {1e-5, 101}, -newton.half_gradient, iterated);
  ASSERT_TRUE(report.solved);
  EXPECT_LE(report.iterations, 100);
  const auto factors = make_spd_solver();
  ASSERT_TRUE(factors->factorize(A) && factors->solve(-newton.half_gradient, direct));
  EXPECT_LT((iterated - direct).norm(), 1e-3 * direct.norm());
  EXPECT_LT(near_gauss_newton(state.patch, {1, 20}, mu).nonZeros(), 0.5 * static_cast<double>(A.nonZeros()));
}

}  // namespace
}  // namespace loopmend
