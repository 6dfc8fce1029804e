// SPDX-License-Identifier: GPL-3.0-or-later
// Which linear solver to use.
#pragma once

namespace loopmend {

enum class SolverKind {
  automatic,  ///< GMRES, and direct where that fails
  direct,     ///< sparse factorisation at every step
  gmres,      ///< GMRES, preconditioned by Cholesky factors that are kept over steps
};

}  // namespace loopmend
