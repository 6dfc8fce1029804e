// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/congruence.h"

#include "core/threads.h"

#include <gtest/gtest.h>

#include <random>

using namespace loopmend;

namespace {

/// m by n with about `filled` entries in each row, and a symmetric m by m.
struct Factors {
  RowSparseMatrix B;
  SparseMatrix Q;
};

Factors random_factors(int m, int n, int filled) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> column(0, n - 1), row(0, m - 1);
  std::normal_distribution<double> value;
  std::vector<Eigen::Triplet<double>> b, q;
  for (int i = 0; i < m; ++i) {
    for (int k = 0; k < filled; ++k) b.emplace_back(i, column(random), value(random));
    q.emplace_back(i, i, value(random));
    const int j = row(random);
    const double off = value(random);
    q.emplace_back(i, j, off);
    q.emplace_back(j, i, off);
  }
  Factors factors{RowSparseMatrix(m, n), SparseMatrix(m, m)};
  factors.B.setFromTriplets(b.begin(), b.end());
  factors.Q.setFromTriplets(q.begin(), q.end());
  return factors;
}

}  // namespace

TEST(Congruence, EqualsTheDenseProduct) {
  const Factors f = random_factors(90, 60, 5);
  const Eigen::MatrixXd dense = Eigen::MatrixXd(f.B).transpose() * Eigen::MatrixXd(f.Q) * Eigen::MatrixXd(f.B);
  const SparseMatrix lower = lower_congruence(f.B, f.Q);
  EXPECT_LT((Eigen::MatrixXd(lower) - Eigen::MatrixXd(dense.triangularView<Eigen::Lower>())).norm(),
            1e-13 * dense.norm());
}

TEST(Congruence, EntriesAreInOrderAndNoneAboveTheDiagonal) {
  const Factors f = random_factors(400, 300, 6);
  const SparseMatrix lower = lower_congruence(f.B, f.Q);
  EXPECT_TRUE(lower.isCompressed());
  for (int j = 0; j < lower.outerSize(); ++j) {
    Eigen::Index last = j - 1;
    for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry) {
      EXPECT_GT(entry.row(), last);
      last = entry.row();
    }
  }
}

TEST(Congruence, IsTheSameToTheBitForAnyNumberOfThreads) {
  const Factors f = random_factors(13000, 12000, 4);
  const SparseMatrix all = lower_congruence(f.B, f.Q);
  const SparseMatrix one = with_thread_budget(1, [&] { return lower_congruence(f.B, f.Q); });
  ASSERT_EQ(one.nonZeros(), all.nonZeros());
  EXPECT_TRUE(std::equal(one.valuePtr(), one.valuePtr() + one.nonZeros(), all.valuePtr()));
  EXPECT_TRUE(std::equal(one.innerIndexPtr(), one.innerIndexPtr() + one.nonZeros(), all.innerIndexPtr()));
}
