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
    cholesky_.cholmod().print = 0;  // a matrix that is not positive definite is our business, not the terminal's
    cholesky_.cholmod().error_handler = nullptr;
  }
  bool factorize(const SparseMatrix& A) override {
    // Never LDLᵀ, which takes indefinite matrices without a word.
    if (!pattern_.matches(A)) {
      // METIS takes longer to order than it saves but on large matrices; left to itself CHOLMOD tries it on all.
      cholesky_.cholmod().nmethods = 1;
      cholesky_.cholmod().method[0].ordering = A.rows() < 60000 ? CHOLMOD_AMD : CHOLMOD_METIS;
      cholesky_.setMode(A.rows() < 1500 ? Eigen::CholmodSimplicialLLt : Eigen::CholmodSupernodalLLt);
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
