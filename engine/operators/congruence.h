// SPDX-License-Identifier: GPL-3.0-or-later
// Bᵀ Q B of sparse factors: the matrix of every Gauss-Newton step.
#pragma once

#include "operators/operator_set.h"

namespace loopmend {

/// Lower triangle of Bᵀ Q B; in parallel, with the same bits for any number of threads.
/// @param B  m by n, inner indices in order.
/// @param Q  m by m, symmetric.
SparseMatrix lower_congruence(const RowSparseMatrix& B, const SparseMatrix& Q);

}  // namespace loopmend
