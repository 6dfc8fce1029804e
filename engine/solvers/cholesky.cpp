#include "solvers/factoring.h"
#include "solvers/linear_solver.h"

#include <Eigen/CholmodSupport>

#include <algorithm>

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
    // Supernodes pay from so many operations per entry of L on, merged as below: measured from 200 to 20 000 vertices,
    // Laplacians, triharmonics and Gauss-Newton matrices. CHOLMOD's own 40 is too early.
    settings.supernodal_switch = 75;
    settings.nmethods = 1;
    // Never LDLᵀ, which takes indefinite matrices without a word.
    settings.final_asis = 0;
    settings.final_ll = 1;
  }
  bool factorize(const SparseMatrix& A) override {
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
    // wide stencils fill up in any order: then one dense block is the fastest.
    const bool much_fill = A.rows() > 60000 && A.nonZeros() > 15 * A.rows();
    const bool fills_up = A.rows() < 800 && A.nonZeros() > 25 * A.rows();
    settings.method[0].ordering = much_fill ? CHOLMOD_METIS : fills_up ? CHOLMOD_NATURAL : CHOLMOD_AMD;
    // Supernodes of up to so many columns are merged while no more than such a share of them is zero: with wider blocks
    // than CHOLMOD's own (4, 16, 48 columns; 0.8, 0.1, 0.05) a factor is a quarter faster. Where memory is what counts,
    // its own.
    const bool wide = A.rows() < 200000;
    const std::size_t columns[] = {4, 16, 48}, wide_columns[] = {32, 64, 200};
    const double zeros[] = {0.8, 0.1, 0.05}, wide_zeros[] = {0.8, 0.4, 0.15};
    std::copy_n(wide ? wide_columns : columns, 3, settings.nrelax);
    std::copy_n(wide ? wide_zeros : zeros, 3, settings.zrelax);
  }

  Pattern pattern_;
  Eigen::CholmodDecomposition<SparseMatrix, Eigen::Lower> cholesky_;
};

}  // namespace

std::unique_ptr<SpdSolver> make_spd_solver() { return std::make_unique<CholeskySolver>(); }

}  // namespace loopmend
