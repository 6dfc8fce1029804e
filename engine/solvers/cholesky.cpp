#include "solvers/factoring.h"
#include "solvers/linear_solver.h"

#include <Eigen/CholmodSupport>

namespace loopmend {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

class CholeskySolver : public SpdSolver {
 public:
  CholeskySolver() {
    use_one_blas_thread();
    cholmod_common& settings = cholesky_.cholmod();
    settings.print = 0;  // a matrix that is not positive definite is our business, not the terminal's
    settings.error_handler = nullptr;
    // Supernodes pay from so many operations per entry of L on: measured from 500 to 34 000 vertices, Laplacians and
    // Gauss-Newton matrices. CHOLMOD's own 40 is too early.
    settings.supernodal_switch = 160;
    settings.nmethods = 1;
    // Never LDLᵀ, which takes indefinite matrices without a word.
    settings.final_asis = 0;
    settings.final_ll = 1;
  }
  bool factorize(const SparseMatrix& A) override {
    if (!pattern_.matches(A)) {
      // METIS takes longer to order than it saves but on large matrices with much fill, not Laplacians.
      const bool much_fill = A.rows() > 60000 && A.nonZeros() > 15 * A.rows();
      // Small matrices of wide stencils fill up in any order: then blocks as wide as they go are the fastest.
      const bool fills_up = A.rows() < 600 && A.nonZeros() > 25 * A.rows();
      cholesky_.cholmod().method[0].ordering = much_fill ? CHOLMOD_METIS : fills_up ? CHOLMOD_NATURAL : CHOLMOD_AMD;
      cholesky_.analyzePattern(A);
    }
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
  Pattern pattern_;
  Eigen::CholmodDecomposition<SparseMatrix, Eigen::Lower> cholesky_;
};

}  // namespace

std::unique_ptr<SpdSolver> make_spd_solver() { return std::make_unique<CholeskySolver>(); }

}  // namespace loopmend
