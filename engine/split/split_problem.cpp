// SPDX-License-Identifier: GPL-3.0-or-later
#include "split/split_problem.h"

#include "split/block_matrix.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace loopmend {

namespace {

constexpr double longest_step = 0.25;  ///< of the hole's radius
constexpr int most_trials = 5;
constexpr double shorter = 0.4;              ///< each trial in the length of the one before
constexpr double shortest = 0.02;            ///< at least
constexpr double worth_a_step = 1e-4;        ///< of J
constexpr double still = 1e-3;               ///< of the hole's radius: a step that moves less
constexpr double promised = 1e-4;            ///< of the fall that the slope promises, at least
constexpr double worth_gauss_newton = 1e-4;  ///< of J
constexpr int steps_with_one_metric = 4;

Eigen::VectorXd times(const SparseMatrix& lower, const Eigen::VectorXd& x) {
  return lower.selfadjointView<Eigen::Lower>() * x;
}

/// Solves A x = b. @returns false where A is not positive definite, or when cancelled.
bool solve(SpdSolver& solver, const SparseMatrix& A, const Eigen::VectorXd& b, Eigen::VectorXd& x,
           const CancelToken& cancel) {
  Eigen::MatrixXd solution;
  if (!solver.factorize(A, cancel) || !solver.solve(b, solution)) return false;
  x = solution.col(0);
  return true;
}

}  // namespace

SplitProblem::SplitProblem(const Patch& patch, const SplitEstimate& estimate, const CancelToken& cancel)
    : scan_(patch.positions),
      free_(patch.free_count),
      lambda_(estimate.lambda()),
      s2_(estimate.noise_variance()),
      kappa_(1 / estimate.radius),
      edge_(estimate.edge),
      surface_(patch.vertex_count(), patch.triangles) {
  if (std::optional<State> first = state_at(scan_, cancel)) {
    state_ = std::move(*first);
    is_valid_ = true;
  }
}

Eigen::VectorXd SplitProblem::precision(const State& state) const {
  Eigen::VectorXd weight = state.geometry.mass / s2_;
  weight.head(free_).setZero();
  return weight;
}

std::optional<SplitProblem::State> SplitProblem::state_at(Points y, const CancelToken& cancel) {
  State state;
  state.geometry = surface_.at(y);
  state.S = state.geometry.roughness(kappa_);
  const auto n = static_cast<Eigen::Index>(y.size());
  state.distance = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = free_; i < n; ++i) state.distance[i] = (scan_[i] - y[i]).dot(state.geometry.normals[i]);
  state.y = std::move(y);
  if (!best_relief(state, cancel)) return std::nullopt;
  state.energy.smooth = 4 * lambda_ * state.geometry.variation();
  state.energy.relief = state.relief.dot(times(state.S, state.relief));
  if (s2_ > 0) {
    const Eigen::VectorXd e = state.distance - state.relief;
    state.energy.noise = e.dot(precision(state).cwiseProduct(e));
  }
  if (!std::isfinite(state.energy.total())) return std::nullopt;
  return state;
}

/// For the y of the state: without noise what is left of the scan, smoothly continued over the patch.
bool SplitProblem::best_relief(State& state, const CancelToken& cancel) {
  const Eigen::VectorXd& d = state.distance;
  if (s2_ > 0) {
    const Eigen::VectorXd weight = precision(state);
    return solve(*relief_solver_, state.S + SparseMatrix(weight.asDiagonal()), weight.cwiseProduct(d), state.relief,
                 cancel);
  }
  Eigen::VectorXd patch;
  if (!solve(*relief_solver_, state.S.topLeftCorner(free_, free_), -times(state.S, d).head(free_), patch, cancel))
    return false;
  state.relief = d;
  state.relief.head(free_) = patch;
  return true;
}

/// The matrix of Gauss-Newton: its factors are the metric of the steps that follow.
bool SplitProblem::factorize(const CancelToken& cancel) {
  const State& s = state_;
  const SparseMatrix Q = 4 * lambda_ * s.geometry.hessian();
  SparseMatrix A;
  if (s2_ > 0) {  // unknown: φ and r
    const SparseMatrix W(precision(s).asDiagonal());
    A = lower_blocks(Q + W, W, s.S + W);
  } else {  // φ everywhere, and φ + r on the patch
    const SparseMatrix whole = s.S.selfadjointView<Eigen::Lower>();
    A = lower_blocks(Q + s.S, -whole.topRows(free_), s.S.topLeftCorner(free_, free_));
  }
  steps_since_factors_ = step_solver_->factorize(A, cancel) ? 0 : -1;
  return steps_since_factors_ == 0;
}

/// φ of the system with this right-hand side. @param pull  of the second block.
std::optional<Eigen::VectorXd> SplitProblem::solve_for(const Eigen::VectorXd& down, const Eigen::VectorXd& pull) const {
  Eigen::VectorXd b(down.size() + pull.size());
  b << down, pull;
  Eigen::MatrixXd x;
  if (!step_solver_->solve(b, x)) return std::nullopt;
  return Eigen::VectorXd(x.col(0).head(down.size()));
}

/// r is at its best, so that the derivative with respect to it is 0.
std::optional<Eigen::VectorXd> SplitProblem::direction(const Eigen::VectorXd& gradient) const {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(s2_ > 0 ? gradient.size() : free_);
  return memory_.direction(gradient, [&](const Eigen::VectorXd& q) { return solve_for(0.5 * q, none); });
}

/// With the best relief kept: it is the least, so that its own change counts nothing to first order.
Eigen::VectorXd SplitProblem::gradient() const {
  const State& s = state_;
  const auto n = static_cast<Eigen::Index>(s.y.size());
  SurfaceFunctional of;
  of.H = 8 * lambda_ * (s.geometry.inner_stiffness * s.geometry.curvature.H);
  of.inner_edge = [&](int i, int j) {
    const double difference = s.geometry.curvature.H[i] - s.geometry.curvature.H[j];
    return 4 * lambda_ * difference * difference;
  };
  // ∫((Δ − κ²) r)² = ‖u‖² in M⁻¹, u = (C + κ²M) r.
  const Eigen::VectorXd& r = s.relief;
  const Eigen::VectorXd u = s.geometry.stiffness * r + kappa_ * kappa_ * s.geometry.mass.cwiseProduct(r);
  const Eigen::VectorXd q = u.cwiseQuotient(s.geometry.mass);
  of.edge = [&](int i, int j) { return 2 * (q[i] - q[j]) * (r[i] - r[j]); };
  of.mass = 2 * kappa_ * kappa_ * q.cwiseProduct(r) - q.cwiseAbs2();
  Eigen::VectorXd of_distance;
  if (s2_ > 0) {
    const Eigen::VectorXd e = s.distance - r;
    of_distance = 2 * precision(s).cwiseProduct(e);
    of.mass.tail(n - free_) += e.tail(n - free_).cwiseAbs2() / s2_;
  } else {
    of_distance = 2 * times(s.S, r);
  }
  of.normals.assign(s.y.size(), Vec3::Zero());
  for (Eigen::Index i = free_; i < n; ++i) of.normals[i] = of_distance[i] * (scan_[i] - s.y[i]);
  const Points derivative = surface_.derivative(s.y, s.geometry, std::move(of));
  Eigen::VectorXd along(n);
  for (Eigen::Index i = 0; i < n; ++i) along[i] = derivative[i].dot(s.geometry.normals[i]);
  along.tail(n - free_) -= of_distance.tail(n - free_);
  return along;
}

std::optional<SplitProblem::State> SplitProblem::displaced(const Eigen::VectorXd& displacement,
                                                           const CancelToken& cancel) {
  Points y = state_.y;
  for (std::size_t i = 0; i < y.size(); ++i)
    y[i] += displacement[static_cast<Eigen::Index>(i)] * state_.geometry.normals[i];
  return state_at(std::move(y), cancel);
}

std::optional<SplitEnergy> SplitProblem::energy_after(const Eigen::VectorXd& displacement, const CancelToken& cancel) {
  const std::optional<State> next = displaced(displacement, cancel);
  if (!next) return std::nullopt;
  return next->energy;
}

/// Takes the first of ever shorter steps that lowers J, by a share of what the slope promises. Where the slope is known, J at
/// a step that was too long tells where the minimum of a parabola lies. @param slope  of J along the direction; 0: not known,
/// and any fall will do.
SplitProblem::Search SplitProblem::search(const Eigen::VectorXd& direction, double slope, const CancelToken& cancel) {
  const double length = kappa_ * direction.cwiseAbs().maxCoeff(), before = state_.energy.total();
  double share = std::min(1.0, longest_step / length);
  for (int trial = 0; trial < most_trials; ++trial) {
    if (cancel.cancelled()) return Search::nothing;
    std::optional<State> next = displaced(share * direction, cancel);
    const double rise = next ? next->energy.total() - before : std::numeric_limits<double>::infinity();
    if (rise < promised * share * slope) {
      take(std::move(*next), share * direction, slope < 0);
      return Search::taken;
    }
    double best = shorter * share;
    if (slope < 0 && std::isfinite(rise)) {
      best = -slope * share * share / (2 * (rise - slope * share));
      if (is_small(-0.5 * slope * best) && is_small(last_decrease_) && best * length < still) return Search::too_little;
    }
    share = std::clamp(best, shortest * share, 0.5 * share);
  }
  return Search::nothing;
}

void SplitProblem::take(State next, const Eigen::VectorXd& step, bool learns) {
  last_decrease_ = state_.energy.total() - next.energy.total();
  state_ = std::move(next);
  ++steps_since_factors_;
  Eigen::VectorXd old = std::exchange(last_gradient_, Eigen::VectorXd());
  if (!learns) return;
  ++descent_steps_;
  last_gradient_ = gradient();
  memory_.learn(step, last_gradient_ - old);
}

bool SplitProblem::is_small(double decrease) const { return decrease < worth_a_step * state_.energy.total(); }

SplitProblem::Outcome SplitProblem::step(const CancelToken& cancel) {
  if (!is_valid_) return Outcome::stalled;
  if (last_gradient_.size() == 0) last_gradient_ = gradient();
  bool fresh = false;
  while (true) {
    if (steps_since_factors_ < 0 || steps_since_factors_ >= steps_with_one_metric) {
      if (!factorize(cancel)) return cancel.cancelled() ? Outcome::cancelled : Outcome::stalled;
      fresh = true;
    }
    const std::optional<Eigen::VectorXd> d = direction(last_gradient_);
    if (cancel.cancelled()) return Outcome::cancelled;
    const double slope = d ? last_gradient_.dot(*d) : 0;
    if (slope < 0) {
      // The model is quadratic: half of what the slope promises.
      if (is_small(-0.5 * slope) && is_small(last_decrease_) && kappa_ * d->cwiseAbs().maxCoeff() < still)
        return Outcome::converged;
      const Search found = search(*d, slope, cancel);
      if (found == Search::taken) return Outcome::moved;
      if (found == Search::too_little) return Outcome::converged;
      if (cancel.cancelled()) return Outcome::cancelled;
    }
    if (fresh && memory_.is_empty()) return Outcome::stalled;
    memory_.forget();
    steps_since_factors_ = -1;
  }
}

SplitProblem::Outcome SplitProblem::gauss_newton_step(const CancelToken& cancel) {
  if (!is_valid_) return Outcome::stalled;
  const State& s = state_;
  const Eigen::VectorXd down = -4 * lambda_ * s.geometry.half_gradient();
  if (!factorize(cancel)) return cancel.cancelled() ? Outcome::cancelled : Outcome::stalled;
  const Eigen::VectorXd pull = s2_ > 0 ? precision(s).cwiseProduct(s.distance) : times(s.S, s.distance);
  const Eigen::VectorXd second = s2_ > 0 ? pull : Eigen::VectorXd(-pull.head(free_));
  const std::optional<Eigen::VectorXd> d = solve_for(down + pull, second);
  if (!d) return Outcome::stalled;
  const double before = s.energy.total();
  if (search(*d, 0, cancel) == Search::taken) {
    gauss_newton_pays_ = last_decrease_ > worth_gauss_newton * before;
    return Outcome::moved;
  }
  gauss_newton_pays_ = false;
  return cancel.cancelled() ? Outcome::cancelled : Outcome::stalled;
}

SplitProblem::Outcome SplitProblem::look_ahead(const CancelToken& cancel) {
  const State here = state_;
  last_gradient_.resize(0);
  const Outcome outcome = step(cancel);
  state_ = here;
  last_gradient_.resize(0);
  memory_.forget();
  return outcome;
}

Points SplitProblem::patch_positions(const CancelToken& cancel) {
  Eigen::VectorXd r = state_.relief.head(free_);
  if (s2_ > 0) {
    // The patch meets the scan with its noise: (−Δ + 1/h²) e = 0 on the patch, e as it is on the boundary.
    Eigen::VectorXd e = state_.distance - state_.relief;
    e.head(free_).setZero();
    const SparseMatrix B =
        state_.geometry.stiffness + SparseMatrix((state_.geometry.mass / (edge_ * edge_)).asDiagonal());
    Eigen::VectorXd carried;
    const SparseMatrix own = B.topLeftCorner(free_, free_);
    if (!solve(*make_spd_solver(), own.triangularView<Eigen::Lower>(), -(B * e).head(free_), carried, cancel))
      return {};
    r += carried;
  }
  Points result(state_.y.begin(), state_.y.begin() + free_);
  for (int i = 0; i < free_; ++i) result[i] += r[i] * state_.geometry.normals[i];
  return result;
}

}  // namespace loopmend
