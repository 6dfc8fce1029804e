// Which linear solver to use.
#pragma once

namespace loopmend {

enum class SolverKind {
  automatic,  ///< by size
  direct,     ///< sparse factorisation at every step
  gmres,      ///< GMRES, preconditioned by a factorisation that is kept over steps
};

}  // namespace loopmend
