// SPDX-License-Identifier: GPL-3.0-or-later
#include "split/block_matrix.h"

namespace loopmend {

SparseMatrix lower_blocks(const SparseMatrix& A, const SparseMatrix& B, const SparseMatrix& C) {
  const Eigen::Index n = A.rows();
  SparseMatrix result(n + C.rows(), n + C.rows());
  result.reserve(A.nonZeros() + B.nonZeros() + C.nonZeros());
  const auto append = [&](const SparseMatrix& part, Eigen::Index from, Eigen::Index shift, Eigen::Index to) {
    for (SparseMatrix::InnerIterator entry(part, from); entry; ++entry)
      result.insertBack(entry.row() + shift, to) = entry.value();
  };
  for (Eigen::Index j = 0; j < result.cols(); ++j) {
    result.startVec(j);
    if (j < n) {
      append(A, j, 0, j);
      append(B, j, n, j);
    } else {
      append(C, j - n, n, j);
    }
  }
  result.finalize();
  return result;
}

}  // namespace loopmend
