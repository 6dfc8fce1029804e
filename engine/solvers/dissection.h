// SPDX-License-Identifier: GPL-3.0-or-later
// Nested dissection: an order of elimination in which two halves of a matrix know nothing of each other.
#pragma once

#include "core/cancel.h"

#include <Eigen/SparseCore>

#include <vector>

namespace loopmend {

/// Who is coupled to whom in a symmetric matrix: the neighbours of i are `neighbour[k]`, begin[i] <= k < begin[i + 1], in
/// ascending order and without i itself.
struct MatrixGraph {
  std::vector<int> begin, neighbour;
};

/// @param lower  n by n, compressed; only the lower triangle is read.
MatrixGraph graph_of(const Eigen::SparseMatrix<double>& lower);

struct Dissection {
  /// n: the rows of the first part, of the second, none of which is coupled to one of the first, and those between them.
  std::vector<int> order;
  int first = 0, second = 0;  ///< how many rows these parts have
};

/// Halves, quarters, and so on, down to some two hundred rows, each parted by rows at one distance from a far end. (George,
/// Liu, Computer Solution of Large Sparse Positive Definite Systems, ch. 8: automatic nested dissection.) On meshes it fills
/// up less than minimum degree, and is found sooner. The two halves of a large matrix are ordered by two threads, where the
/// caller has them. When cancelled, what is not yet dissected stays in its order.
Dissection dissect(const MatrixGraph& graph, const CancelToken& cancel = {});

}  // namespace loopmend
