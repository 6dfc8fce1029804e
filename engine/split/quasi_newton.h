// SPDX-License-Identifier: GPL-3.0-or-later
// Limited-memory BFGS (Nocedal, Wright, Numerical Optimization, 2nd ed., algorithm 7.4) in a metric of the caller.
#pragma once

#include <Eigen/Core>

#include <deque>
#include <functional>
#include <optional>

namespace loopmend {

class QuasiNewton {
 public:
  /// Of the linear system of the metric; empty where it cannot be solved.
  using Metric = std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd&)>;

  /// Learns how the gradient has changed along a step. A pair that shows no curvature is left out.
  void learn(const Eigen::VectorXd& step, const Eigen::VectorXd& change_of_gradient);
  void forget() { pairs_.clear(); }
  bool is_empty() const { return pairs_.empty(); }
  /// Where to go from this gradient. Empty where the metric cannot be solved.
  std::optional<Eigen::VectorXd> direction(const Eigen::VectorXd& gradient, const Metric& metric) const;

 private:
  struct Pair {
    Eigen::VectorXd step, change;
    double curvature;
  };
  std::deque<Pair> pairs_;
};

}  // namespace loopmend
