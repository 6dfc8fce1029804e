#include "solvers/linear_solver.h"

#include <Eigen/CholmodSupport>
#include <Eigen/UmfPackSupport>
#include <unsupported/Eigen/IterativeSolvers>

#include <algorithm>
#include <vector>

extern "C" void openblas_set_num_threads(int threads);

namespace loopmend {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// OpenBLAS threads spin-wait and lose tenfold on a busy machine (NUMERICS §5); loops run in parallel instead.
void use_one_blas_thread() {
  static const bool done = (openblas_set_num_threads(1), true);
  static_cast<void>(done);
}

/// Remembers a sparsity pattern, to tell whether a symbolic analysis still holds.
class Pattern {
 public:
  /// True if A has the pattern seen last; remembers A's.
  bool matches(const SparseMatrix& A) {
    const int *outer = A.outerIndexPtr(), *inner = A.innerIndexPtr();
    const bool same = static_cast<Eigen::Index>(outer_.size()) == A.outerSize() + 1 &&
                      std::equal(outer_.begin(), outer_.end(), outer) &&
                      std::equal(inner_.begin(), inner_.end(), inner);
    if (!same) {
      outer_.assign(outer, outer + A.outerSize() + 1);
      inner_.assign(inner, inner + A.nonZeros());
    }
    return same;
  }

 private:
  std::vector<int> outer_, inner_;
};

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
      // METIS pays on the largest matrices only; left to itself CHOLMOD tries it on all.
      cholesky_.cholmod().nmethods = A.rows() < 60000 ? 1 : 0;
      cholesky_.cholmod().method[0].ordering = CHOLMOD_AMD;
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

/// UMFPACK's factors with the matrix they belong to: Eigen's wrapper keeps a reference to it.
class Factors {
 public:
  bool renew(const SparseMatrix& A) {
    matrix_ = A;
    if (!pattern_.matches(matrix_)) lu_.analyzePattern(matrix_);
    lu_.factorize(matrix_);
    usable_ = lu_.info() == Eigen::Success;
    return usable_;
  }
  bool usable_for(const SparseMatrix& A) const { return usable_ && matrix_.rows() == A.rows(); }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return lu_.solve(b); }

 private:
  SparseMatrix matrix_;
  Pattern pattern_;
  Eigen::UmfPackLU<SparseMatrix> lu_;
  bool usable_ = false;
};

class LuSolver : public GeneralSolver {
 public:
  LuSolver() { use_one_blas_thread(); }
  SolveReport solve(const SparseMatrix& A, const Eigen::VectorXd& b, Eigen::VectorXd& x) override {
    SolveReport report;
    report.factored = true;
    if (!factors_.renew(A)) return report;
    const Eigen::VectorXd solution = factors_.solve(b);
    report.solved = solution.allFinite();
    if (report.solved) x = solution;
    return report;
  }

 private:
  Factors factors_;
};

/// Eigen's preconditioner concept over factors of an earlier matrix.
class StaleFactors {
 public:
  StaleFactors() = default;
  template <typename Matrix>
  explicit StaleFactors(const Matrix&) {}
  template <typename Matrix>
  StaleFactors& analyzePattern(const Matrix&) {
    return *this;
  }
  template <typename Matrix>
  StaleFactors& factorize(const Matrix&) {
    return *this;
  }
  template <typename Matrix>
  StaleFactors& compute(const Matrix&) {
    return *this;
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return factors->solve(b); }
  Eigen::ComputationInfo info() const { return Eigen::Success; }

  const Factors* factors = nullptr;
};

class GmresSolver : public GeneralSolver {
 public:
  GmresSolver() { use_one_blas_thread(); }
  SolveReport solve(const SparseMatrix& A, const Eigen::VectorXd& b, Eigen::VectorXd& x) override {
    SolveReport report;
    const bool had_factors = factors_.usable_for(A);
    if (had_factors && iterate(A, b, x, report)) return report;
    report.factored = true;
    if (factors_.renew(A)) iterate(A, b, x, report);
    return report;
  }

 private:
  bool iterate(const SparseMatrix& A, const Eigen::VectorXd& b, Eigen::VectorXd& x, SolveReport& report) {
    Eigen::GMRES<SparseMatrix, StaleFactors> gmres;
    gmres.preconditioner().factors = &factors_;
    gmres.compute(A);
    gmres.setTolerance(1e-10);
    gmres.setMaxIterations(most_iterations);
    const Eigen::VectorXd solution = gmres.solve(b);
    report.iterations += static_cast<int>(gmres.iterations());
    report.solved = gmres.info() == Eigen::Success && solution.allFinite();
    if (report.solved) x = solution;
    return report.solved;
  }

  static constexpr int most_iterations = 20;
  Factors factors_;
};

}  // namespace

std::unique_ptr<SpdSolver> make_spd_solver() { return std::make_unique<CholeskySolver>(); }

std::unique_ptr<GeneralSolver> make_general_solver(SolverKind kind) {
  if (kind == SolverKind::gmres) return std::make_unique<GmresSolver>();
  return std::make_unique<LuSolver>();
}

}  // namespace loopmend
