// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/dissection.h"

#include "core/threads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace loopmend {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Lower triangle; couplings by pairs of rows.
Sparse matrix_of(int n, const std::vector<std::pair<int, int>>& couplings) {
  std::vector<Eigen::Triplet<double>> triplets;
  for (int i = 0; i < n; ++i) triplets.emplace_back(i, i, 1);
  for (auto [i, j] : couplings) triplets.emplace_back(std::max(i, j), std::min(i, j), 1);
  Sparse A(n, n);
  A.setFromTriplets(triplets.begin(), triplets.end());
  return A;
}

/// Each is coupled to those up to `reach` away in a grid.
Sparse grid(int width, int height, int reach) {
  std::vector<std::pair<int, int>> couplings;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int v = std::max(0, y - reach); v <= y; ++v)
        for (int u = std::max(0, x - reach); u <= std::min(width - 1, x + reach); ++u)
          if (v * width + u < y * width + x) couplings.emplace_back(y * width + x, v * width + u);
  return matrix_of(width * height, couplings);
}

void expect_sound(const Sparse& A, const Dissection& dissection) {
  std::vector<int> rows = dissection.order, all(A.rows());
  std::sort(rows.begin(), rows.end());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(rows, all);
  std::vector<int> part(A.rows(), 3);
  for (int i = 0; i < dissection.first + dissection.second; ++i)
    part[dissection.order[i]] = i < dissection.first ? 1 : 2;
  for (int j = 0; j < A.outerSize(); ++j)
    for (Sparse::InnerIterator it(A, j); it; ++it) EXPECT_NE(part[it.row()] + part[j], 1 + 2);
}

TEST(MatrixGraph, HasEachCouplingOnBothSides) {
  const Sparse A = matrix_of(4, {{0, 2}, {3, 1}, {2, 3}});
  const MatrixGraph graph = graph_of(A);
  EXPECT_EQ(graph.begin, (std::vector<int>{0, 1, 2, 4, 6}));
  EXPECT_EQ(graph.neighbour, (std::vector<int>{2, 3, 0, 3, 1, 2}));
}

TEST(MatrixGraph, DoesNotReadTheUpperTriangle) {
  Sparse A = matrix_of(3, {{2, 0}});
  A.coeffRef(0, 1) = 5;
  A.makeCompressed();
  EXPECT_EQ(graph_of(A).neighbour, (std::vector<int>{2, 0}));
}

TEST(Dissection, PartsAGridAcross) {
  const Sparse A = grid(100, 20, 2);
  const Dissection dissection = dissect(graph_of(A));
  expect_sound(A, dissection);
  // As narrow as two columns; and about as many rows on either side.
  EXPECT_LE(2000 - dissection.first - dissection.second, 2 * 2 * 20);
  EXPECT_GT(std::min(dissection.first, dissection.second), 900);
}

/// Entries of the factor in the order of the dissection: the rows of the factor are subtrees of its elimination tree (Liu).
long entries_of_factor(const Sparse& A) {
  const MatrixGraph graph = graph_of(A);
  const Dissection dissection = dissect(graph);
  const int n = static_cast<int>(A.rows());
  std::vector<int> place(n), parent(n, -1), mark(n, -1);
  for (int i = 0; i < n; ++i) place[dissection.order[i]] = i;
  long entries = 0;
  for (int i = 0; i < n; ++i) {
    mark[i] = i;
    const int row = dissection.order[i];
    for (int k = graph.begin[row]; k < graph.begin[row + 1]; ++k)
      for (int j = place[graph.neighbour[k]]; j < i && mark[j] != i; j = parent[j]) {
        if (parent[j] < 0) parent[j] = i;
        mark[j] = i;
        ++entries;
      }
  }
  return entries;
}

TEST(Dissection, FillsUpAsNestedDissectionDoes) {
  // n log (n / 200) entries, where rows in a band would have n^1.5: 5.6 and 8 times as many for four times the rows.
  EXPECT_LT(entries_of_factor(grid(160, 160, 2)), 5.8 * static_cast<double>(entries_of_factor(grid(80, 80, 2))));
}

TEST(Dissection, IsTheSameForAnyNumberOfThreads) {
  const MatrixGraph graph = graph_of(grid(70, 50, 3));
  const auto order_by = [&](int threads) { return with_thread_budget(threads, [&] { return dissect(graph).order; }); };
  EXPECT_EQ(order_by(1), order_by(2));
}

TEST(Dissection, PartsWhatIsNotConnectedWithoutASeparator) {
  std::vector<std::pair<int, int>> rings;
  for (int i = 0; i < 1000; ++i) rings.emplace_back(i, i < 500 ? (i + 1) % 500 : 500 + (i + 1) % 500);
  const Sparse A = matrix_of(1000, rings);
  const Dissection dissection = dissect(graph_of(A));
  expect_sound(A, dissection);
  EXPECT_LE(1000 - dissection.first - dissection.second, 2);
  EXPECT_GT(std::min(dissection.first, dissection.second), 400);
}

TEST(Dissection, LeavesInOnePieceWhatHasNoHalves) {
  std::vector<std::pair<int, int>> all;
  for (int i = 0; i < 300; ++i)
    for (int j = 0; j < i; ++j) all.emplace_back(i, j);
  const Dissection dissection = dissect(graph_of(matrix_of(300, all)));
  EXPECT_EQ(dissection.first, 300);
  EXPECT_EQ(dissection.second, 0);
}

}  // namespace
}  // namespace loopmend
