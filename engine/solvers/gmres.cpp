// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/gmres.h"

#include <Eigen/Jacobi>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace loopmend {

namespace {

constexpr int most_between_restarts = 40;

/// The Krylov space of one cycle: vectors q with qᵢᵀ P qⱼ = δᵢⱼ, beside each its P q, and the least squares problem of the
/// small Hessenberg matrix, solved as it grows.
class Cycle {
 public:
  Cycle(Eigen::Index size, int most) : q_(size, most + 1), Pq_(size, most + 1), R_(most, most), rhs_(most + 1) {
    R_.setZero();
  }
  int size() const { return size_; }
  double left() const { return std::abs(rhs_[size_]); }
  auto last() const { return q_.col(size_); }

  void start(const Eigen::VectorXd& r, const Eigen::VectorXd& z, double norm) {
    size_ = 0;
    rotations_.clear();
    Pq_.col(0) = r / norm;
    q_.col(0) = z / norm;
    rhs_.setZero();
    rhs_[0] = norm;
  }
  /// @param Pz  A times last(). @param z  P⁻¹ Pz. @returns false when the space does not grow any more.
  bool add(const Eigen::VectorXd& Pz, const Eigen::VectorXd& z) {
    const int k = size_;
    Eigen::VectorXd h(k + 2);
    h.head(k + 1).noalias() = q_.leftCols(k + 1).transpose() * Pz;
    auto next = q_.col(k + 1), P_next = Pq_.col(k + 1);
    next = z;
    next.noalias() -= q_.leftCols(k + 1) * h.head(k + 1);
    P_next = Pz;
    P_next.noalias() -= Pq_.leftCols(k + 1) * h.head(k + 1);
    h[k + 1] = std::sqrt(std::max(0.0, next.dot(P_next)));
    const bool grows = h[k + 1] > 1e-14 * h.head(k + 1).norm();
    if (grows) {
      next /= h[k + 1];
      P_next /= h[k + 1];
    }
    for (int i = 0; i < k; ++i) h.applyOnTheLeft(i, i + 1, rotations_[i].adjoint());
    Eigen::JacobiRotation<double> rotation;
    rotation.makeGivens(h[k], h[k + 1]);
    h.applyOnTheLeft(k, k + 1, rotation.adjoint());
    rhs_.applyOnTheLeft(k, k + 1, rotation.adjoint());
    rotations_.push_back(rotation);
    R_.col(k).head(k + 1) = h.head(k + 1);
    ++size_;
    return grows;
  }
  Eigen::VectorXd best() const {
    const Eigen::VectorXd y = R_.topLeftCorner(size_, size_).triangularView<Eigen::Upper>().solve(rhs_.head(size_));
    return q_.leftCols(size_) * y;
  }

 private:
  Eigen::MatrixXd q_, Pq_, R_;
  Eigen::VectorXd rhs_;
  std::vector<Eigen::JacobiRotation<double>> rotations_;
  int size_ = 0;
};

/// P⁻¹ r; not finite where that fails.
Eigen::VectorXd preconditioned(const SpdSolver& factors, const Eigen::VectorXd& r) {
  Eigen::MatrixXd z = Eigen::VectorXd::Constant(r.size(), std::numeric_limits<double>::quiet_NaN());
  factors.solve(r, z);
  return z;
}

}  // namespace

GmresReport gmres(const GeneralSystem& system, const SpdSolver& factors, const Eigen::VectorXd& b,
                  const GmresLimits& limits, Eigen::VectorXd& x, const CancelToken& cancel) {
  GmresReport report;
  x = Eigen::VectorXd::Zero(b.size());
  Cycle cycle(b.size(), std::min(limits.most, most_between_restarts));
  Eigen::VectorXd r = b;
  double whole = 0;
  while (report.iterations < limits.most) {
    const Eigen::VectorXd z = preconditioned(factors, r);
    const double norm = std::sqrt(r.dot(z));
    if (whole == 0) whole = norm;
    report.left = norm == 0 ? 0 : norm / whole;
    if (!(report.left > limits.wanted)) break;
    cycle.start(r, z, norm);
    bool goes_on = true;
    while (goes_on && cycle.size() < most_between_restarts && report.iterations < limits.most) {
      const Eigen::VectorXd Aq = system.times(cycle.last());
      goes_on = cycle.add(Aq, preconditioned(factors, Aq)) && std::isfinite(cycle.left());
      ++report.iterations;
      report.left = cycle.left() / whole;
      const bool hopeless = report.iterations == limits.trial && report.left > limits.promising;
      goes_on = goes_on && report.left > limits.wanted && !hopeless && !cancel.cancelled();
    }
    x += cycle.best();
    if (!goes_on) break;
    r = b - system.times(x);
  }
  if (!x.allFinite()) report.left = std::numeric_limits<double>::infinity();
  return report;
}

}  // namespace loopmend
