// SPDX-License-Identifier: GPL-3.0-or-later
// Symmetric matrices of two blocks.
#pragma once

#include "operators/operator_set.h"

namespace loopmend {

/// The lower triangle of [A Bᵀ; B C]. @param A, C  lower triangles; B  #C by #A. Inner indices in order.
SparseMatrix lower_blocks(const SparseMatrix& A, const SparseMatrix& B, const SparseMatrix& C);

}  // namespace loopmend
