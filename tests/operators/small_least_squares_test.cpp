// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/small_least_squares.h"

#include <gtest/gtest.h>
#include <Eigen/Core>

#include <cmath>
#include <random>

namespace loopmend {
namespace {

using Matrix10 = Eigen::Matrix<double, 10, 10>;

Matrix10 random_positive_definite(std::mt19937& random) {
  Matrix10 rows;
  for (double& entry : rows.reshaped()) entry = std::normal_distribution<double>()(random);
  return rows.transpose() * rows + 0.1 * Matrix10::Identity();
}

void copy_lower(const Matrix10& A, double (&N)[10][10]) {
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j) N[i][j] = j <= i ? A(i, j) : std::nan("");  // the rest must not be read
}

TEST(SmallLeastSquares, SolvesAndInverts) {
  std::mt19937 random(1);
  const Matrix10 A = random_positive_definite(random);
  double N[10][10], inverse[10][10];
  copy_lower(A, N);
  SmallCholesky<10> factors;
  ASSERT_TRUE(factors.factorize(N));
  Eigen::Matrix<double, 10, 1> expected, x;
  for (int i = 0; i < 10; ++i) expected[i] = i - 3.5;
  x = A * expected;
  factors.solve(x.data());
  EXPECT_LT((x - expected).norm(), 1e-11 * expected.norm());
  factors.invert(inverse);
  Matrix10 whole;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j) whole(i, j) = inverse[std::max(i, j)][std::min(i, j)];
  EXPECT_LT((A * whole - Matrix10::Identity()).norm(), 1e-11);
  const std::array<double, 10> diagonal = factors.inverse_diagonal();
  for (int i = 0; i < 10; ++i) EXPECT_NEAR(diagonal[i], whole(i, i), 1e-11 * whole(i, i));
}

TEST(SmallLeastSquares, RefusesIndefiniteMatrices) {
  std::mt19937 random(2);
  Matrix10 A = random_positive_definite(random);
  A(7, 7) = -1;
  double N[10][10];
  copy_lower(A, N);
  EXPECT_FALSE(SmallCholesky<10>().factorize(N));
}

TEST(SmallLeastSquares, MomentsAreSumsOfPowers) {
  const double samples[][3] = {{0.5, 1.5, -0.25}, {2, -0.75, 0.5}, {1, 0.125, 3}, {0.25, -2, -1}};  // w, u, v
  Moments<2, 6> one_by_one(0.0);
  Moments<2, 6, Eigen::Array2d> in_pairs(Eigen::Array2d::Zero());
  for (const auto& [w, u, v] : samples) one_by_one.add(w, u, v);
  for (int k = 0; k < 4; k += 2) {
    const auto pair = [&](int c) { return Eigen::Array2d(samples[k][c], samples[k + 1][c]); };
    in_pairs.add(pair(0), pair(1), pair(2));
  }
  for (int a = 0; a <= 6; ++a)
    for (int b = std::max(0, 2 - a); a + b <= 6; ++b) {
      double sum = 0;
      for (const auto& [w, u, v] : samples) sum += w * std::pow(u, a) * std::pow(v, b);
      EXPECT_NEAR(one_by_one(a, b), sum, 1e-12 * (1 + std::abs(sum)));
      EXPECT_NEAR(in_pairs(a, b).sum(), sum, 1e-12 * (1 + std::abs(sum)));
    }
}

}  // namespace
}  // namespace loopmend
