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
    settings.nmethods = 1;
    // Never LDLᵀ, which takes indefinite matrices without a word.
    settings.final_asis = 0;
    settings.final_ll = 1;
  }
  bool factorize(const SparseMatrix& A) override {
    const NoThreadsWithin alone;
    if (!pattern_.matches(A)) {
      choose_for(A);
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
  void choose_for(const SparseMatrix& A) {
    cholmod_common& settings = cholesky_.cholmod();
    // METIS takes longer to order than it saves but on large matrices with much fill, not Laplacians. Small matrices of
    // wide stencils fill up in any order: then one dense block is the fastest. All else is CHOLMOD's own: wider supernodes
    // and later ones only paid while its threads were on.
    const bool much_fill = A.rows() > 60000 && A.nonZeros() > 15 * A.rows();
    const bool fills_up = A.rows() < 700 && A.nonZeros() > 25 * A.rows();
    settings.method[0].ordering = much_fill ? CHOLMOD_METIS : fills_up ? CHOLMOD_NATURAL : CHOLMOD_AMD;
  }

  Pattern pattern_;
  Eigen::CholmodDecomposition<SparseMatrix, Eigen::Lower> cholesky_;
};

}  // namespace

std::unique_ptr<SpdSolver> make_spd_solver() { return std::make_unique<CholeskySolver>(); }

}  // namespace loopmend
