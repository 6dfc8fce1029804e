// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/factoring.h"
#include "solvers/gmres.h"
#include "solvers/linear_solver.h"

#include <Eigen/UmfPackSupport>

namespace loopmend {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// UMFPACK.
class LuSolver : public GeneralSolver {
 public:
  LuSolver() { use_one_blas_thread(); }
  SolveReport solve(const GeneralSystem& system, const Eigen::VectorXd& b, Eigen::VectorXd& x,
                    const CancelToken& cancel) override {
    SolveReport report;
    if (cancel.cancelled()) return report;
    matrix_ = system.matrix();
    if (matrix_.rows() == 0 || !matrix_.coeffs().allFinite()) return report;
    report.factored = true;
    const bool same_pattern = pattern_.matches(matrix_);
    if (!same_pattern || !analyzed_) {
      lu_.analyzePattern(matrix_);
      analyzed_ = lu_.info() == Eigen::Success;
      if (!analyzed_) return report;
    }
    lu_.factorize(matrix_);
    if (lu_.info() != Eigen::Success) return report;
    const Eigen::VectorXd solution = lu_.solve(b);
    report.solved = lu_.info() == Eigen::Success && solution.allFinite();
    if (report.solved) x = solution;
    return report;
  }

 private:
  SparseMatrix matrix_;  ///< Eigen's wrapper of UMFPACK keeps a reference to it
  Pattern pattern_;
  bool analyzed_ = false;  ///< of that pattern
  Eigen::UmfPackLU<SparseMatrix> lu_;
};

class GmresSolver : public GeneralSolver {
 public:
  explicit GmresSolver(double tolerance) : tolerance_(tolerance) {}
  SolveReport solve(const GeneralSystem& system, const Eigen::VectorXd& b, Eigen::VectorXd& x,
                    const CancelToken& cancel) override {
    SolveReport report;
    if (b.size() == 0) return report;
    // A few iterations tell whether the others are worth their time.
    const GmresLimits with_old_factors{tolerance_, 24, 6, 2e-2}, with_new_factors{tolerance_};
    report.solved = size_ == b.size() && iterate(system, b, with_old_factors, x, report, cancel);
    if (report.solved || cancel.cancelled()) return report;
    report.factored = true;
    size_ = factors_->factorize(system.preconditioner(), cancel) ? b.size() : 0;
    report.solved = size_ > 0 && iterate(system, b, with_new_factors, x, report, cancel);
    return report;
  }

 private:
  bool iterate(const GeneralSystem& system, const Eigen::VectorXd& b, const GmresLimits& limits, Eigen::VectorXd& x,
               SolveReport& report, const CancelToken& cancel) const {
    Eigen::VectorXd solution;
    const GmresReport iterated = gmres(system, *factors_, b, limits, solution, cancel);
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
  SolveReport solve(const GeneralSystem& system, const Eigen::VectorXd& b, Eigen::VectorXd& x,
                    const CancelToken& cancel) override {
    const SolveReport iterated = gmres_.solve(system, b, x, cancel);
    if (iterated.solved) return iterated;
    SolveReport report = direct_.solve(system, b, x, cancel);
    report.iterations = iterated.iterations;
    return report;
  }

 private:
  GmresSolver gmres_;
  LuSolver direct_;
};

}  // namespace

std::unique_ptr<GeneralSolver> make_general_solver(SolverKind kind, double tolerance) {
  switch (kind) {
    case SolverKind::direct: return std::make_unique<LuSolver>();
    case SolverKind::gmres: return std::make_unique<GmresSolver>(tolerance);
    case SolverKind::automatic: break;
  }
  return std::make_unique<AutomaticSolver>(tolerance);
}

}  // namespace loopmend
