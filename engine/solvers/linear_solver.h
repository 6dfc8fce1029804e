// SPDX-License-Identifier: GPL-3.0-or-later
// Sparse linear systems behind one small interface. Backends (CHOLMOD, UMFPACK, GMRES) stay inside the .cpp file.
#pragma once

#include "core/cancel.h"
#include "solvers/solver_kind.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <functional>
#include <memory>

namespace loopmend {

/// Symmetric positive definite systems by sparse Cholesky. The symbolic analysis is kept while the pattern stays.
class SpdSolver {
 public:
  virtual ~SpdSolver() = default;
  /// @param A  n by n, compressed; only the lower triangle is read. @returns false if A is not positive definite, has no
  /// rows or an entry that is not finite, or when cancelled. @throws std::bad_alloc
  virtual bool factorize(const Eigen::SparseMatrix<double>& A, const CancelToken& cancel = {}) = 0;
  /// With the factors of the last factorize(). @param b  n by any number of columns. @param x  like b, written only on
  /// success. @returns false if that failed, or the solution is not finite.
  virtual bool solve(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const = 0;
  /// log |A| of the last factorize(), which must have succeeded.
  virtual double log_determinant() const = 0;
};

std::unique_ptr<SpdSolver> make_spd_solver();

/// What one solve was like. Failure is a value: a singular matrix happens, and the caller has a smaller step to try.
struct SolveReport {
  bool solved = false;
  int iterations = 0;     ///< 0 for a direct solve
  bool factored = false;  ///< a new factorisation was made for this solve
};

/// A general system A x = b, given by what the solvers may ask for.
struct GeneralSystem {
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> times;  ///< A x
  std::function<Eigen::SparseMatrix<double>()> matrix;           ///< A, n by n, compressed
  /// A symmetric positive definite matrix near A, n by n, compressed; only the lower triangle is read.
  std::function<Eigen::SparseMatrix<double>()> preconditioner;
};

/// Until the residual in the norm of the nearby matrix, relative to b, is at most `wanted`; that is near the error of x in
/// the energy of the system.
struct IterationLimits {
  double wanted = 1e-6;
  int most = 400;
};

/// Symmetric positive definite systems too large to be factored: conjugate gradients, preconditioned by the factors of the
/// nearby matrix. The matrix itself is not asked for.
/// @param factors  of the nearby matrix, made here; its symbolic analysis is kept from call to call
/// @param b  n. @param x  n: what the iterations came to, each of which has lowered ½xᵀAx − bᵀx; written only when solved.
/// @returns solved: whether there is such an x, which may have more left than was wanted. There is none where a matrix is
/// not positive definite, and when cancelled.
SolveReport conjugate_gradients(const GeneralSystem& system, SpdSolver& factors, const IterationLimits& limits,
                                const Eigen::VectorXd& b, Eigen::VectorXd& x, const CancelToken& cancel = {});

/// General systems, again and again for matrices that change a little from call to call.
class GeneralSolver {
 public:
  virtual ~GeneralSolver() = default;
  /// @param b  n. @param x  n, written only when solved, which it is not when cancelled; UMFPACK hears of that too late.
  virtual SolveReport solve(const GeneralSystem& system, const Eigen::VectorXd& b, Eigen::VectorXd& x,
                            const CancelToken& cancel = {}) = 0;
};

/// direct: sparse LU at every call. gmres: the Cholesky factors of the nearby matrix of an earlier call are the
/// preconditioner, renewed when more than some 20 iterations are needed. automatic: gmres, and direct where that fails.
/// @param tolerance  of the residual of gmres in the norm of the nearby matrix, relative to b: near the error of x in that norm.
std::unique_ptr<GeneralSolver> make_general_solver(SolverKind kind, double tolerance = 1e-6);

}  // namespace loopmend
