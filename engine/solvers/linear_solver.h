// Sparse linear systems behind one small interface. Backends (CHOLMOD, UMFPACK, GMRES) stay inside the .cpp file.
#pragma once

#include "solvers/solver_kind.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>

namespace loopmend {

/// Symmetric positive definite systems by sparse Cholesky. The symbolic analysis is kept while the pattern stays.
class SpdSolver {
 public:
  virtual ~SpdSolver() = default;
  /// @param A  n by n, compressed; only the lower triangle is read. @returns false if A is not positive definite.
  virtual bool factorize(const Eigen::SparseMatrix<double>& A) = 0;
  /// With the factors of the last factorize(). @param b  n by any number of columns. @param x  like b, written only on
  /// success. @returns false if the solution is not finite.
  virtual bool solve(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const = 0;
};

std::unique_ptr<SpdSolver> make_spd_solver();

/// What one solve was like. Failure is a value: a singular matrix happens, and the caller has a smaller step to try.
struct SolveReport {
  bool solved = false;
  int iterations = 0;     ///< of GMRES; 0 for a direct solve
  bool factored = false;  ///< a new factorisation was made for this solve
};

/// General systems, again and again for matrices that change a little from call to call.
class GeneralSolver {
 public:
  virtual ~GeneralSolver() = default;
  /// @param A  n by n, compressed. @param b  n. @param x  n, written only when solved.
  virtual SolveReport solve(const Eigen::SparseMatrix<double>& A, const Eigen::VectorXd& b, Eigen::VectorXd& x) = 0;
};

/// direct: sparse LU at every call. gmres: the LU of an earlier call is the preconditioner, renewed when more than 20
/// iterations are needed (NUMERICS §5). automatic: direct.
std::unique_ptr<GeneralSolver> make_general_solver(SolverKind kind);

}  // namespace loopmend
