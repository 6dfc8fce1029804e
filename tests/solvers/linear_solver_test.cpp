// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/linear_solver.h"

#include "core/threads.h"
#include "solvers/diagonal.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <thread>
#include <vector>

namespace loopmend {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// 2D Laplacian plus `shift`, with `skew` breaking the symmetry.
Sparse grid_matrix(int side, double shift, double skew) {
  std::vector<Eigen::Triplet<double>> triplets;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const int i = y * side + x;
      triplets.emplace_back(i, i, 4 + shift);
      if (x > 0) triplets.emplace_back(i, i - 1, -1 - skew);
      if (x + 1 < side) triplets.emplace_back(i, i + 1, -1 + skew);
      if (y > 0) triplets.emplace_back(i, i - side, -1);
      if (y + 1 < side) triplets.emplace_back(i, i + side, -1);
    }
  Sparse A(side * side, side * side);
  A.setFromTriplets(triplets.begin(), triplets.end());
  return A;
}

/// The system of A, with the symmetric part of A nearby.
GeneralSystem system_of(const Sparse& A) {
  return {[&A](const Eigen::VectorXd& x) -> Eigen::VectorXd { return A * x; }, [&A] { return A; },
          [&A]() -> Sparse { return 0.5 * (Sparse(A.transpose()) + A); }};
}

TEST(SpdSolver, SolvesSeveralRightHandSides) {
  const Sparse A = grid_matrix(30, 0.1, 0);
  const Eigen::MatrixXd exact = Eigen::MatrixXd::Random(A.rows(), 3);
  Eigen::MatrixXd x;
  const auto solver = make_spd_solver();
  ASSERT_TRUE(solver->factorize(A));
  ASSERT_TRUE(solver->solve(A * exact, x));
  EXPECT_LT((x - exact).norm(), 1e-10 * exact.norm());
}

/// Cancelled before, during and after the work of CHOLMOD, which cannot be interrupted.
TEST(SpdSolver, AFactorizationThatIsCancelledEndsAndLeavesTheSolverWhole) {
  const Sparse G = grid_matrix(150, 0.3, 0), A = G * G * G;
  const Eigen::VectorXd exact = Eigen::VectorXd::LinSpaced(A.rows(), -1, 2);
  for (int threads : {1, 2})
    with_thread_budget(threads, [&] {
      const auto solver = make_spd_solver();
      Eigen::MatrixXd before, after;
      ASSERT_TRUE(solver->factorize(A) && solver->solve(A * exact, before));
      int stopped = 0;
      for (int wait_ms = 0; wait_ms < 40; wait_ms += 2) {
        const CancelToken cancel;
        std::jthread person([&] {
          std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
          cancel.cancel();
        });
        const bool factored = solver->factorize(A, cancel);
        EXPECT_TRUE(factored || cancel.cancelled());
        EXPECT_EQ(solver->solve(A * exact, after), factored) << "factors that are none are not used";
        stopped += !factored;
      }
      EXPECT_GT(stopped, 0);
      ASSERT_TRUE(solver->factorize(A) && solver->solve(A * exact, after));
      EXPECT_EQ(after, before) << "nothing is left of what was stopped";
    });
}

TEST(SpdSolver, WhatIsCancelledBeforeItBeginsIsNotFactored) {
  const CancelToken cancelled;
  cancelled.cancel();
  for (int side : {5, 30, 60}) {
    const Sparse A = grid_matrix(side, 0.3, 0);
    const auto solver = make_spd_solver();
    EXPECT_FALSE(solver->factorize(A, cancelled));
    EXPECT_TRUE(solver->factorize(A)) << "the pattern was not taken for analysed";
  }
}

/// As of patches: dense in one block, dissected, and halved.
TEST(SpdSolver, WideStencilsOfEverySize) {
  for (int side : {10, 18, 20, 22, 32, 50}) {
    const Sparse G = grid_matrix(side, 0.3, 0);
    for (const Sparse& A : {Sparse(G * G * G), Sparse(G * G * G * G * G * G)}) {
      const Eigen::VectorXd exact = Eigen::VectorXd::LinSpaced(A.rows(), -1, 2);
      Eigen::MatrixXd x;
      const auto solver = make_spd_solver();
      for (double factor : {1.0, 3.0}) {  // again with the same pattern
        ASSERT_TRUE(solver->factorize(Sparse(factor * A.triangularView<Eigen::Lower>())));
        ASSERT_TRUE(solver->solve(factor * (A * exact), x));
        EXPECT_LT((x - exact).norm(), 1e-8 * exact.norm()) << side;
      }
      EXPECT_FALSE(solver->factorize(Sparse((-A).triangularView<Eigen::Lower>()))) << side;
    }
  }
}

TEST(SpdSolver, RefusesAnIndefiniteMatrixWithoutAWord) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const auto solver = make_spd_solver();
  EXPECT_FALSE(solver->factorize(grid_matrix(10, -5, 0)));
  Sparse small(2, 2);
  small.insert(0, 0) = small.insert(1, 1) = 1;
  small.insert(1, 0) = small.insert(0, 1) = 2;
  small.makeCompressed();
  EXPECT_FALSE(solver->factorize(small));
  EXPECT_TRUE(solver->factorize(grid_matrix(10, 1, 0)));  // and can be used again
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(SpdSolver, FollowsAChangeOfPattern) {
  const auto solver = make_spd_solver();
  Eigen::MatrixXd x;
  for (int side : {10, 20, 15}) {
    const Sparse A = grid_matrix(side, 1, 0);
    const Eigen::MatrixXd b = Eigen::MatrixXd::Ones(A.rows(), 1);
    ASSERT_TRUE(solver->factorize(A));
    ASSERT_TRUE(solver->solve(b, x));
    EXPECT_LT((A * x - b).norm(), 1e-10);
  }
}

/// So large that it is factored in halves.
constexpr int separated_side = 60;

TEST(SpdSolver, GivesTheSameBitsForAnyNumberOfThreads) {
  const Sparse L = grid_matrix(separated_side, 0.1, 0), A = Sparse(L * L) * L;
  const Eigen::MatrixXd b = Eigen::MatrixXd::Random(A.rows(), 3);
  std::vector<Eigen::MatrixXd> solutions;
  for (int threads : {1, 2, 5}) {
    with_thread_budget(threads, [&] {
      const auto solver = make_spd_solver();
      ASSERT_TRUE(solver->factorize(A));
      ASSERT_TRUE(solver->solve(b, solutions.emplace_back()));
    });
  }
  EXPECT_LT((A * solutions[0] - b).norm(), 1e-9 * b.norm());
  EXPECT_EQ(solutions[0], solutions[1]);
  EXPECT_EQ(solutions[0], solutions[2]);
}

TEST(SpdSolver, FactorsOtherValuesOfTheSamePattern) {
  const auto solver = make_spd_solver();
  Eigen::MatrixXd x;
  for (double shift : {0.1, 1.0, 0.1}) {
    const Sparse A = grid_matrix(separated_side, shift, 0);
    const Eigen::MatrixXd exact = Eigen::MatrixXd::Random(A.rows(), 2);
    ASSERT_TRUE(solver->factorize(A));
    ASSERT_TRUE(solver->solve(A * exact, x));
    EXPECT_LT((x - exact).norm(), 1e-10 * exact.norm());
  }
}

TEST(SpdSolver, SeesThatAMatrixIsIndefiniteWhereItsHalvesAreNot) {
  // The lowest eigenvalue of the grid is 0.0053, that of half of it 0.013.
  const auto solver = make_spd_solver();
  EXPECT_FALSE(solver->factorize(grid_matrix(separated_side, -0.01, 0)));
  EXPECT_TRUE(solver->factorize(grid_matrix(separated_side, -0.005, 0)));
  EXPECT_FALSE(solver->factorize(grid_matrix(separated_side, -1, 0)));
}

TEST(SpdSolver, FactorsWhatDoesNotFallIntoHalves) {
  // An arrow: all rows are coupled to the first alone.
  const int n = 5000;
  std::vector<Eigen::Triplet<double>> triplets{{0, 0, n}};
  for (int i = 1; i < n; ++i) {
    triplets.emplace_back(i, i, 2);
    triplets.emplace_back(i, 0, 1);
    triplets.emplace_back(0, i, 1);
  }
  Sparse A(n, n);
  A.setFromTriplets(triplets.begin(), triplets.end());
  const Eigen::MatrixXd exact = Eigen::MatrixXd::Random(n, 1);
  Eigen::MatrixXd x;
  const auto solver = make_spd_solver();
  ASSERT_TRUE(solver->factorize(A));
  ASSERT_TRUE(solver->solve(A * exact, x));
  EXPECT_LT((x - exact).norm(), 1e-10 * exact.norm());
}

class GeneralSolverTest : public testing::TestWithParam<SolverKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, GeneralSolverTest,
                         testing::Values(SolverKind::automatic, SolverKind::direct, SolverKind::gmres));

TEST_P(GeneralSolverTest, SolvesUnsymmetricSystemsThatDriftAndChangeSize) {
  const auto solver = make_general_solver(GetParam());
  for (int call = 0; call < 6; ++call) {
    const Sparse A = grid_matrix(call < 4 ? 25 : 18, 0.1 + 0.02 * call, 0.3);
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(A.rows(), -1, 1);
    Eigen::VectorXd x;
    const SolveReport report = solver->solve(system_of(A), b, x);
    ASSERT_TRUE(report.solved);
    // Iterated to 1e-6 of the preconditioned residual, which here is at most some ten times smaller.
    EXPECT_LT((A * x - b).norm(), (GetParam() == SolverKind::direct ? 1e-10 : 1e-5) * b.norm());
  }
}

TEST_P(GeneralSolverTest, ASingularMatrixIsAValueNotACrash) {
  const auto solver = make_general_solver(GetParam());
  Sparse A(5, 5);
  A.setIdentity();
  A.coeffRef(2, 2) = 0;
  Eigen::VectorXd x = Eigen::VectorXd::Constant(5, 7);
  EXPECT_FALSE(solver->solve(system_of(A), Eigen::VectorXd::Ones(5), x).solved);
  EXPECT_EQ(x[0], 7);
}

TEST(GmresSolver, KeepsItsFactorsWhileTheyServe) {
  const auto solver = make_general_solver(SolverKind::gmres);
  Eigen::VectorXd x;
  const Sparse A = grid_matrix(25, 0.1, 0.3), near = grid_matrix(25, 0.11, 0.3), far = grid_matrix(25, 40, -0.9);
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(A.rows());
  EXPECT_TRUE(solver->solve(system_of(A), b, x).factored);
  const SolveReport second = solver->solve(system_of(near), b, x);
  EXPECT_FALSE(second.factored);
  EXPECT_GT(second.iterations, 0);
  EXPECT_TRUE(solver->solve(system_of(far), b, x).solved);
}

TEST(GmresSolver, MeasuresTheErrorInTheEnergyAndStopsThere) {
  // Eigenvalues from 1e-2 to 1e3, so that a residual without weights would tell of the high frequencies alone.
  const Sparse L = grid_matrix(25, 0.1, 0), A = Sparse(L * L) * L + 0.003 * grid_matrix(25, 0, 0.3);
  GeneralSystem system = system_of(A);
  const Sparse P = Sparse(L * L) * L;
  system.preconditioner = [&] { return P; };
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(A.rows(), -1, 2);
  Eigen::VectorXd exact;
  ASSERT_TRUE(make_general_solver(SolverKind::direct)->solve(system, b, exact).solved);
  const auto energy_norm = [&](const Eigen::VectorXd& e) { return std::sqrt(e.dot(P * e)); };
  int fewest = 0;
  for (double tolerance : {1e-2, 1e-4, 1e-8}) {
    Eigen::VectorXd x;
    const SolveReport report = make_general_solver(SolverKind::gmres, tolerance)->solve(system, b, x);
    ASSERT_TRUE(report.solved);
    EXPECT_LT(energy_norm(x - exact), 2 * tolerance * energy_norm(exact));
    EXPECT_GT(report.iterations, fewest);
    fewest = report.iterations;
  }
}

TEST(GmresSolver, GoesOnAfterARestart) {
  const Sparse A = grid_matrix(40, 0.001, 0.3);
  GeneralSystem system = system_of(A);
  system.preconditioner = [&] { return grid_matrix(40, 1, 0); };  // far from A: more iterations than one cycle has
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(A.rows(), -1, 2);
  Eigen::VectorXd x;
  const SolveReport report = make_general_solver(SolverKind::gmres, 1e-10)->solve(system, b, x);
  ASSERT_TRUE(report.solved);
  EXPECT_GT(report.iterations, 40);
  EXPECT_LT((A * x - b).norm(), 1e-8 * b.norm());
}

int threads_of_this_process() {
  return static_cast<int>(std::distance(std::filesystem::directory_iterator("/proc/self/task"), {}));
}

TEST(SpdSolver, StartsNoThreadsThatTheCallerDoesNotHave) {
  if (!std::filesystem::exists("/proc/self/task")) GTEST_SKIP() << "threads are counted in /proc";
  const Sparse L = grid_matrix(60, 0.1, 0), A = Sparse(L * L) * L;
  int before = 0, after = 0;
  // In a thread of its own, which has no team from earlier on.
  std::thread([&] {
    with_thread_budget(1, [&] {
      before = threads_of_this_process();
      EXPECT_TRUE(make_spd_solver()->factorize(A));
      after = threads_of_this_process();
    });
  }).join();
  EXPECT_LE(after, before);
}

TEST(ConjugateGradients, SolveWhatIsTooLargeToFactor) {
  const Sparse A = grid_matrix(30, 0.1, 0);
  GeneralSystem system = system_of(A);
  system.preconditioner = [] { return grid_matrix(30, 1, 0); };
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(A.rows(), -1, 1);
  Eigen::VectorXd x;
  const auto factors = make_spd_solver();
  const SolveReport report = conjugate_gradients(system, *factors, {1e-8, 400}, b, x);
  ASSERT_TRUE(report.solved);
  EXPECT_GT(report.iterations, 1);
  EXPECT_LT((A * x - b).norm(), 1e-5 * b.norm());
}

TEST(ConjugateGradients, EachIterationLowersTheQuadraticModel) {
  const Sparse A = grid_matrix(30, 0.1, 0);
  GeneralSystem system = system_of(A);
  system.preconditioner = [] { return grid_matrix(30, 1, 0); };
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(A.rows(), -1, 1);
  const auto factors = make_spd_solver();
  double last = 0;
  for (int most : {1, 2, 4, 8}) {
    Eigen::VectorXd x;
    const SolveReport report = conjugate_gradients(system, *factors, {0, most}, b, x);
    ASSERT_TRUE(report.solved);
    EXPECT_EQ(report.iterations, most);
    const double model = 0.5 * x.dot(A * x) - b.dot(x);
    EXPECT_LT(model, last) << most;
    last = model;
  }
}

TEST(ConjugateGradients, SayWhereAMatrixIsNotPositiveDefinite) {
  const Sparse A = grid_matrix(30, 0.1, 0), negative = -A;
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(A.rows());
  Eigen::VectorXd x;
  GeneralSystem system = system_of(A);
  system.preconditioner = [&] { return negative; };
  EXPECT_FALSE(conjugate_gradients(system, *make_spd_solver(), {}, b, x).solved);
  system = system_of(negative);
  system.preconditioner = [&] { return A; };
  EXPECT_FALSE(conjugate_gradients(system, *make_spd_solver(), {}, b, x).solved);
  EXPECT_EQ(x.size(), 0);
}

TEST(AutomaticSolver, GoesOverToTheDirectWayWhereNothingSymmetricIsNear) {
  const Sparse A = grid_matrix(25, 0.1, 0.3);
  GeneralSystem system = system_of(A);
  system.preconditioner = [&]() -> Sparse { return -A; };
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(A.rows());
  Eigen::VectorXd x;
  EXPECT_FALSE(make_general_solver(SolverKind::gmres)->solve(system, b, x).solved);
  EXPECT_TRUE(make_general_solver(SolverKind::automatic)->solve(system, b, x).solved);
  EXPECT_LT((A * x - b).norm(), 1e-10 * b.norm());
}

TEST(SpdSolver, RefusesWhatHoldsNothingToFactor) {
  const auto solver = make_spd_solver();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Sparse empty(0, 0), zero(4, 4), broken = grid_matrix(3, 1, 0);
  broken.coeffRef(0, 0) = nan;
  Eigen::MatrixXd x;
  for (const Sparse* A : {&empty, &zero, &broken}) {
    EXPECT_FALSE(solver->factorize(*A));
    EXPECT_FALSE(solver->solve(Eigen::MatrixXd::Ones(A->rows(), 1), x));
  }
  // It is none the worse for that.
  const Sparse good = grid_matrix(3, 1, 0);
  ASSERT_TRUE(solver->factorize(good));
  ASSERT_TRUE(solver->solve(Eigen::MatrixXd::Ones(9, 1), x));
  EXPECT_LT((good.selfadjointView<Eigen::Lower>() * x - Eigen::MatrixXd::Ones(9, 1)).norm(), 1e-12);
}

TEST(GeneralSolver, RefusesWhatHoldsNothingToFactor) {
  for (SolverKind kind : {SolverKind::automatic, SolverKind::direct, SolverKind::gmres}) {
    const auto solver = make_general_solver(kind);
    for (int size : {0, 3}) {
      const Sparse zero(size, size);
      GeneralSystem system;
      system.times = [&](const Eigen::VectorXd& v) { return Eigen::VectorXd(zero * v); };
      system.matrix = system.preconditioner = [&] { return zero; };
      Eigen::VectorXd x;
      EXPECT_FALSE(solver->solve(system, Eigen::VectorXd::Ones(size), x).solved)
          << static_cast<int>(kind) << ", " << size;
    }
  }
}

TEST(StoreDiagonal, AddsWhatIsMissingAndNothingElse) {
  Sparse A(4, 4);
  A.insert(2, 0) = 5;
  A.insert(1, 1) = 7;
  A.makeCompressed();
  const Eigen::MatrixXd before = A;
  store_diagonal(A);
  EXPECT_EQ(Eigen::MatrixXd(A), before);
  EXPECT_EQ(A.nonZeros(), 5);
  A.diagonal() += Eigen::VectorXd::Ones(4);
  EXPECT_EQ(Eigen::MatrixXd(A), before + Eigen::MatrixXd::Identity(4, 4));
  const double* values = A.valuePtr();
  store_diagonal(A);
  EXPECT_EQ(A.valuePtr(), values) << "a full diagonal is left where it is";
}

}  // namespace
}  // namespace loopmend
