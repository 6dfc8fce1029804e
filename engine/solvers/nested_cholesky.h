// SPDX-License-Identifier: GPL-3.0-or-later
// Sparse Cholesky by two threads. For the .cpp files of this folder alone.
#pragma once

#include "solvers/linear_solver.h"

namespace loopmend {

/// For matrices of the pattern of A alone: factors the two halves of a dissection side by side, each with the rows between
/// them for a separator, and then what is left of the separator. The factors are the same to the bit for any number of threads.
/// @param A  n by n, compressed; only the lower triangle is read. @returns null where A does not fall into halves, and when
/// cancelled.
std::unique_ptr<SpdSolver> make_nested_cholesky(const Eigen::SparseMatrix<double>& A, const CancelToken& cancel);

}  // namespace loopmend
