#include "solvers/factoring.h"
#include "solvers/gmres.h"
#include "solvers/linear_solver.h"

#include <Eigen/UmfPackSupport>
#include <unsupported/Eigen/IterativeSolvers>

#include <limits>

namespace loopmend::internal {
class MatrixFree;
}

namespace Eigen::internal {

// Eigen asks for this and the product below to multiply by a type of ours ("Matrix-free solvers" in its manual).
template <>
struct traits<loopmend::internal::MatrixFree> : traits<SparseMatrix<double>> {};

}  // namespace Eigen::internal

namespace loopmend::internal {

/// A GeneralSystem as Eigen's iterative solvers want to see it.
class MatrixFree : public Eigen::EigenBase<MatrixFree> {
 public:
  using Scalar = double;
  using RealScalar = double;
  using StorageIndex = int;
  enum { ColsAtCompileTime = Eigen::Dynamic, MaxColsAtCompileTime = Eigen::Dynamic, IsRowMajor = 0 };

  MatrixFree(const GeneralSystem& system, Eigen::Index size) : system_(system), size_(size) {}
  Eigen::Index rows() const { return size_; }
  Eigen::Index cols() const { return size_; }
  Eigen::VectorXd times(const Eigen::VectorXd& x) const { return system_.times(x); }
  template <typename Rhs>
  Eigen::Product<MatrixFree, Rhs, Eigen::AliasFreeProduct> operator*(const Eigen::MatrixBase<Rhs>& x) const {
    return Eigen::Product<MatrixFree, Rhs, Eigen::AliasFreeProduct>(*this, x.derived());
  }

 private:
  const GeneralSystem& system_;
  Eigen::Index size_;
};

}  // namespace loopmend::internal

namespace Eigen::internal {

template <typename Rhs>
struct generic_product_impl<loopmend::internal::MatrixFree, Rhs, SparseShape, DenseShape, GemvProduct>
    : generic_product_impl_base<loopmend::internal::MatrixFree, Rhs,
                                generic_product_impl<loopmend::internal::MatrixFree, Rhs>> {
  using Scalar = double;
  template <typename Dest>
  static void scaleAndAddTo(Dest& to, const loopmend::internal::MatrixFree& A, const Rhs& x, const Scalar& alpha) {
    to += alpha * A.times(x);
  }
};

}  // namespace Eigen::internal

namespace loopmend {

namespace {

using internal::MatrixFree;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// UMFPACK.
class LuSolver : public GeneralSolver {
 public:
  LuSolver() { use_one_blas_thread(); }
  SolveReport solve(const GeneralSystem& system, const Eigen::VectorXd& b, Eigen::VectorXd& x) override {
    SolveReport report;
    report.factored = true;
    matrix_ = system.matrix();
    if (!pattern_.matches(matrix_)) lu_.analyzePattern(matrix_);
    lu_.factorize(matrix_);
    if (lu_.info() != Eigen::Success) return report;
    const Eigen::VectorXd solution = lu_.solve(b);
    report.solved = solution.allFinite();
    if (report.solved) x = solution;
    return report;
  }

 private:
  SparseMatrix matrix_;  ///< Eigen's wrapper of UMFPACK keeps a reference to it
  Pattern pattern_;
  Eigen::UmfPackLU<SparseMatrix> lu_;
};

/// Eigen's preconditioner concept over factors that somebody else keeps.
class KeptFactors {
 public:
  KeptFactors() = default;
  template <typename Matrix>
  explicit KeptFactors(const Matrix&) {}
  template <typename Matrix>
  KeptFactors& analyzePattern(const Matrix&) {
    return *this;
  }
  template <typename Matrix>
  KeptFactors& factorize(const Matrix&) {
    return *this;
  }
  template <typename Matrix>
  KeptFactors& compute(const Matrix&) {
    return *this;
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    Eigen::MatrixXd x = Eigen::VectorXd::Constant(b.size(), std::numeric_limits<double>::quiet_NaN());
    factors->solve(b, x);
    return x;
  }
  Eigen::ComputationInfo info() const { return Eigen::Success; }

  const SpdSolver* factors = nullptr;
};

class GmresSolver : public GeneralSolver {
 public:
  explicit GmresSolver(double tolerance) : tolerance_(tolerance) {}
  SolveReport solve(const GeneralSystem& system, const Eigen::VectorXd& b, Eigen::VectorXd& x) override {
    SolveReport report;
    // A few iterations tell whether the others are worth their time.
    const GmresLimits with_old_factors{tolerance_, 24, 6, 2e-2}, with_new_factors{tolerance_};
    report.solved = size_ == b.size() && iterate(system, b, with_old_factors, x, report);
    if (report.solved) return report;
    report.factored = true;
    size_ = factors_->factorize(system.nearby()) ? b.size() : 0;
    report.solved = size_ > 0 && iterate(system, b, with_new_factors, x, report);
    return report;
  }

 private:
  bool iterate(const GeneralSystem& system, const Eigen::VectorXd& b, const GmresLimits& limits, Eigen::VectorXd& x,
               SolveReport& report) const {
    Eigen::VectorXd solution;
    const GmresReport iterated = gmres(system, *factors_, b, limits, solution);
    report.iterations += iterated.iterations;
    if (!(iterated.left <= tolerance_)) return false;
    x = solution;
    return true;
  }

  double tolerance_;
  std::unique_ptr<SpdSolver> factors_ = make_spd_solver();
  Eigen::Index size_ = 0;  ///< of the factors; 0 while there are none
};

class AutomaticSolver : public GeneralSolver {
 public:
  explicit AutomaticSolver(double tolerance) : gmres_(tolerance) {}
  SolveReport solve(const GeneralSystem& system, const Eigen::VectorXd& b, Eigen::VectorXd& x) override {
    const SolveReport iterated = gmres_.solve(system, b, x);
    if (iterated.solved) return iterated;
    SolveReport report = direct_.solve(system, b, x);
    report.iterations = iterated.iterations;
    return report;
  }

 private:
  GmresSolver gmres_;
  LuSolver direct_;
};

}  // namespace

SolveReport conjugate_gradients(const GeneralSystem& system, const Eigen::VectorXd& b, Eigen::VectorXd& x) {
  constexpr int most_iterations = 400;
  SolveReport report;
  const auto factors = make_spd_solver();
  report.factored = true;
  if (!factors->factorize(system.nearby())) return report;
  const MatrixFree A(system, b.size());
  Eigen::ConjugateGradient<MatrixFree, Eigen::Lower | Eigen::Upper, KeptFactors> cg;
  cg.preconditioner().factors = factors.get();
  cg.compute(A);
  cg.setTolerance(1e-5);
  cg.setMaxIterations(most_iterations);
  const Eigen::VectorXd solution = cg.solve(b);
  report.iterations = static_cast<int>(cg.iterations());
  report.solved = cg.info() == Eigen::Success && solution.allFinite();
  if (report.solved) x = solution;
  return report;
}

std::unique_ptr<GeneralSolver> make_general_solver(SolverKind kind, double tolerance) {
  switch (kind) {
    case SolverKind::direct: return std::make_unique<LuSolver>();
    case SolverKind::gmres: return std::make_unique<GmresSolver>(tolerance);
    case SolverKind::automatic: break;
  }
  return std::make_unique<AutomaticSolver>(tolerance);
}

}  // namespace loopmend
