// SPDX-License-Identifier: GPL-3.0-or-later
// Sparse matrices whose diagonal is changed in place.
#pragma once

#include <Eigen/SparseCore>

namespace loopmend {

/// Adds explicit zeros where the diagonal of A lacks entries, so that A.diagonal() can be written. Eigen writes outside the
/// matrix where an entry is missing, and says so in debug builds only. Copies A only where something is missing.
/// @param A  n by n, compressed, before and after.
void store_diagonal(Eigen::SparseMatrix<double>& A);

}  // namespace loopmend
