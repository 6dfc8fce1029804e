#include "solvers/factoring.h"
#include "solvers/halved_cholesky.h"
#include "solvers/linear_solver.h"

#include <Eigen/CholmodSupport>

namespace loopmend {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

constexpr int least_halved = 2000;  ///< rows: below, a second thread does not pay

/// In one piece. For matrices of the pattern of A alone.
class WholeCholesky : public SpdSolver {
 public:
  explicit WholeCholesky(const SparseMatrix& A) {
    use_one_blas_thread();
    cholmod_common& settings = cholesky_.cholmod();
    settings.print = 0;  // a matrix that is not positive definite is our business, not the terminal's
    settings.error_handler = nullptr;
    settings.nmethods = 1;
    // Never LDLᵀ, which takes indefinite matrices without a word.
    settings.final_asis = 0;
    settings.final_ll = 1;
    // Small matrices of wide stencils fill up in any order: then one dense block is the fastest.
    const bool fills_up = A.rows() < 700 && A.nonZeros() > 25 * A.rows();
    settings.method[0].ordering = fills_up ? CHOLMOD_NATURAL : CHOLMOD_AMD;
    const NoThreadsWithin alone;
    cholesky_.analyzePattern(A);
  }
  bool factorize(const SparseMatrix& A) override {
    const NoThreadsWithin alone;
    cholesky_.factorize(A);
    return cholesky_.info() == Eigen::Success;
  }
  bool solve(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const override {
    const Eigen::MatrixXd solution = cholesky_.solve(b);
    if (!solution.allFinite()) return false;
    x = solution;
    return true;
  }

 private:
  Eigen::CholmodDecomposition<SparseMatrix, Eigen::Lower> cholesky_;
};

class CholeskySolver : public SpdSolver {
 public:
  bool factorize(const SparseMatrix& A) override {
    if (!pattern_.matches(A)) {
      factors_.reset();  // its memory first
      factors_ = A.rows() >= least_halved ? make_halved_cholesky(A) : nullptr;
      if (!factors_) factors_ = std::make_unique<WholeCholesky>(A);
    }
    return factors_->factorize(A);
  }
  bool solve(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const override { return factors_->solve(b, x); }

 private:
  Pattern pattern_;
  std::unique_ptr<SpdSolver> factors_;
};

}  // namespace

std::unique_ptr<SpdSolver> make_spd_solver() { return std::make_unique<CholeskySolver>(); }

}  // namespace loopmend
