// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/linear_solver.h"

#include <cmath>
#include <utility>

namespace loopmend {

/// (Saad, Iterative Methods for Sparse Linear Systems, 2nd ed., algorithm 9.1.) Eigen's own looks at the residual without
/// the weights of the nearby matrix, and so at the low frequencies alone.
SolveReport conjugate_gradients(const GeneralSystem& system, SpdSolver& factors, const IterationLimits& limits,
                                const Eigen::VectorXd& b, Eigen::VectorXd& x, const CancelToken& cancel) {
  SolveReport report;
  report.factored = true;
  if (!factors.factorize(system.preconditioner(), cancel)) return report;
  Eigen::VectorXd solution = Eigen::VectorXd::Zero(b.size()), r = b, p = solution;
  Eigen::MatrixXd z;  // one column
  if (!factors.solve(r, z)) return report;
  double rz = r.dot(z.col(0)), share = 0;
  const double enough = limits.wanted * limits.wanted * rz;
  while (rz > enough && report.iterations < limits.most) {
    if (cancel.cancelled()) return report;
    p = z.col(0) + share * p;
    const Eigen::VectorXd Ap = system.times(p);
    const double way = rz / p.dot(Ap);
    if (!(way > 0) || !std::isfinite(way)) return report;
    solution += way * p;
    r -= way * Ap;
    if (!factors.solve(r, z)) return report;
    const double before = std::exchange(rz, r.dot(z.col(0)));
    share = rz / before;
    ++report.iterations;
  }
  report.solved = std::isfinite(rz);
  if (report.solved) x = std::move(solution);
  return report;
}

}  // namespace loopmend
