// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/cholmod_solve.h"
#include "solvers/dissection.h"
#include "solvers/factoring.h"
#include "solvers/linear_solver.h"
#include "solvers/nested_cholesky.h"

#include <Eigen/CholmodSupport>

#include <utility>
#include <vector>

namespace loopmend {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

static_assert(CHOLMOD_OUT_OF_MEMORY == -2 && CHOLMOD_TOO_LARGE == -3, "as check_memory() has them");

constexpr int least_separated = 2000;  ///< rows: below, a second thread does not pay
constexpr int least_dissected = 300;   ///< rows
constexpr int least_dissected_of_widest = 450;
constexpr double wide_stencil = 10;    ///< entries of the lower triangle in a column, in the mean
constexpr double widest_stencil = 25;  ///< the same

/// In the mean; 0 of a matrix without rows. Some callers store the upper triangle as well.
double entries_of_lower_column(const SparseMatrix& A) {
  if (A.rows() == 0) return 0;
  Eigen::Index entries = 0;
  for (Eigen::Index j = 0; j < A.cols(); ++j)
    for (SparseMatrix::InnerIterator it(A, j); it; ++it) entries += it.row() >= j ? 1 : 0;
  return static_cast<double>(entries) / static_cast<double>(A.rows());
}

/// CHOLMOD, with an order of elimination from outside.
class OrderedCholmod : public Eigen::CholmodDecomposition<SparseMatrix, Eigen::Lower> {
 public:
  /// In place of analyzePattern(); once, on a fresh object. @param order  the rows, first eliminated first.
  void analyze(const SparseMatrix& A, std::vector<int> order) {
    cholmod().method[0].ordering = CHOLMOD_GIVEN;
    cholmod_sparse view = Eigen::viewAsCholmod(A.selfadjointView<Eigen::Lower>());
    m_cholmodFactor = cholmod_analyze_p(&view, order.data(), nullptr, 0, &cholmod());
    m_isInitialized = true;
    m_analysisIsOk = 1;
    m_info = Eigen::Success;
  }

  /// Eigen looks at no analysis and at no lack of memory.
  bool is_analyzed() const { return m_cholmodFactor != nullptr; }
  /// @returns false if the matrix is not positive definite. @throws std::bad_alloc
  bool is_factored() {
    check_memory(cholmod().status);
    return cholmod().status == CHOLMOD_OK && m_cholmodFactor->minor == m_cholmodFactor->n;
  }
  void solve_in_place(Eigen::MatrixXd& x) { solve_by_cholmod(CHOLMOD_A, *m_cholmodFactor, cholmod(), x); }
};

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
    const NoThreadsWithin alone;
    const double couplings = entries_of_lower_column(A);
    // On wide stencils minimum degree takes longer than all the rest. Of the widest, small matrices fill up in any order:
    // then one dense block is the fastest.
    const bool is_widest = couplings > widest_stencil;
    if (couplings > wide_stencil && A.rows() >= (is_widest ? least_dissected_of_widest : least_dissected)) {
      cholesky_.analyze(A, dissect(graph_of(A)).order);
    } else {
      settings.method[0].ordering = is_widest ? CHOLMOD_NATURAL : CHOLMOD_AMD;
      cholesky_.analyzePattern(A);
    }
    check_memory(settings.status);
  }
  bool factorize(const SparseMatrix& A, const CancelToken& cancel) override {
    if (!cholesky_.is_analyzed() || cancel.cancelled()) return false;
    const NoThreadsWithin alone;
    cholesky_.factorize(A);
    return cholesky_.is_factored();
  }
  bool solve(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const override {
    Eigen::MatrixXd solution = b;
    cholesky_.solve_in_place(solution);
    if (!solution.allFinite()) return false;
    x = std::move(solution);
    return true;
  }
  double log_determinant() const override { return cholesky_.logDeterminant(); }

 private:
  mutable OrderedCholmod cholesky_;  ///< CHOLMOD counts in its settings, also when it solves
};

class CholeskySolver : public SpdSolver {
 public:
  bool factorize(const SparseMatrix& A, const CancelToken& cancel) override {
    factored_ = false;
    if (cancel.cancelled() || A.rows() == 0 || A.rows() != A.cols() || !A.coeffs().allFinite()) return false;
    const bool same_pattern = pattern_.matches(A);
    if (!same_pattern || !factors_) {
      factors_.reset();  // its memory first
      factors_ = A.rows() >= least_separated ? make_nested_cholesky(A, cancel) : nullptr;
      if (cancel.cancelled()) return false;
      if (!factors_) factors_ = std::make_unique<WholeCholesky>(A);
    }
    return factored_ = factors_->factorize(A, cancel);
  }
  bool solve(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const override { return factored_ && factors_->solve(b, x); }
  double log_determinant() const override { return factors_->log_determinant(); }

 private:
  Pattern pattern_;  ///< of the factors, where there are any
  std::unique_ptr<SpdSolver> factors_;
  bool factored_ = false;  ///< the last factorize() succeeded
};

}  // namespace

std::unique_ptr<SpdSolver> make_spd_solver() { return std::make_unique<CholeskySolver>(); }

}  // namespace loopmend
