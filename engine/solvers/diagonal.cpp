// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/diagonal.h"

#include <algorithm>

namespace loopmend {

void store_diagonal(Eigen::SparseMatrix<double>& A) {
  const auto stored = [&](Eigen::Index j) {
    const auto *begin = A.innerIndexPtr() + A.outerIndexPtr()[j], *end = A.innerIndexPtr() + A.outerIndexPtr()[j + 1];
    return std::binary_search(begin, end, static_cast<int>(j));
  };
  for (Eigen::Index j = 0; j < A.cols(); ++j) {
    if (stored(j)) continue;
    Eigen::SparseMatrix<double> zeros(A.rows(), A.cols());
    zeros.setIdentity();
    zeros.coeffs().setZero();
    A += zeros;
    A.makeCompressed();
    return;
  }
}

}  // namespace loopmend
