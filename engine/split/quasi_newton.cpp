// SPDX-License-Identifier: GPL-3.0-or-later
#include "split/quasi_newton.h"

#include <vector>

namespace loopmend {

namespace {

constexpr std::size_t most_pairs = 8;
constexpr double least_curvature = 1e-8;  ///< cosine between step and change of the gradient

}  // namespace

void QuasiNewton::learn(const Eigen::VectorXd& step, const Eigen::VectorXd& change_of_gradient) {
  const double curvature = step.dot(change_of_gradient);
  if (!(curvature > least_curvature * step.norm() * change_of_gradient.norm())) return;
  if (pairs_.size() == most_pairs) pairs_.pop_front();
  pairs_.push_back({step, change_of_gradient, curvature});
}

std::optional<Eigen::VectorXd> QuasiNewton::direction(const Eigen::VectorXd& gradient, const Metric& metric) const {
  Eigen::VectorXd q = gradient;
  std::vector<double> alpha(pairs_.size());
  for (std::size_t k = pairs_.size(); k-- > 0;) {
    alpha[k] = pairs_[k].step.dot(q) / pairs_[k].curvature;
    q -= alpha[k] * pairs_[k].change;
  }
  std::optional<Eigen::VectorXd> d = metric(q);
  if (!d) return std::nullopt;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const double beta = pairs_[k].change.dot(*d) / pairs_[k].curvature;
    *d += (alpha[k] - beta) * pairs_[k].step;
  }
  return Eigen::VectorXd(-*d);
}

}  // namespace loopmend
