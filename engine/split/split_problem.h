// SPDX-License-Identifier: GPL-3.0-or-later
// One variational problem for every boundary: the smooth surface under the scan, its relief and noise, and the patch.
#pragma once

#include "core/cancel.h"
#include "mesh/patch.h"
#include "solvers/linear_solver.h"
#include "split/quasi_newton.h"
#include "split/split_energy.h"
#include "split/split_estimate.h"
#include "split/split_surface.h"

#include <memory>
#include <optional>

namespace loopmend {

/// y + r n + e n = x, along n, at the vertices of the neighborhood, which never move; on the patch there is no x, so that y and r are free.
/// Minimises J over y, displaced along its normals; r and e are the best for each y.
class SplitProblem {
 public:
  /// From the patch as it is. @param patch  with neighborhood.
  SplitProblem(const Patch& patch, const SplitEstimate& estimate, const CancelToken& cancel);

  enum class Outcome {
    moved,
    converged,  ///< the next step would lower J by next to nothing and move next to nothing
    stalled,    ///< no trial was accepted although one should lower J, or a matrix is not positive definite
    cancelled
  };
  /// Along the derivative of J, in the metric of Gauss-Newton.
  Outcome step(const CancelToken& cancel);
  /// Of Gauss-Newton with B for the derivative of H: its first steps are long, but later ones may point uphill.
  Outcome gauss_newton_step(const CancelToken& cancel);
  /// False once a step of Gauss-Newton lowered J by next to nothing, or none was accepted.
  bool gauss_newton_pays() const { return gauss_newton_pays_; }
  /// What step() would come to, without taking it.
  Outcome look_ahead(const CancelToken& cancel);

  /// Steps that were taken along the derivative of J.
  int descent_steps() const { return descent_steps_; }

  /// False where J cannot be evaluated at the start.
  bool is_valid() const { return is_valid_; }
  const SplitEnergy& energy() const { return state_.energy; }
  /// Derivative of J with respect to displacements of all vertices of y along its normals; #V.
  Eigen::VectorXd gradient() const;
  /// J after such a displacement; empty where it cannot be evaluated.
  std::optional<SplitEnergy> energy_after(const Eigen::VectorXd& displacement, const CancelToken& cancel);
  /// Of the patch's free vertices: y + r n, with e carried in over about one edge. Empty if that cannot be solved, or when cancelled.
  Points patch_positions(const CancelToken& cancel);

 private:
  struct State {
    Points y;
    SplitGeometry geometry;
    SparseMatrix S;            ///< lower triangle
    Eigen::VectorXd distance;  ///< from y to x along the normals; 0 on the patch
    Eigen::VectorXd relief;
    SplitEnergy energy;
  };

  std::optional<State> state_at(Points y, const CancelToken& cancel);
  std::optional<State> displaced(const Eigen::VectorXd& displacement, const CancelToken& cancel);
  bool best_relief(State& state, const CancelToken& cancel);
  bool factorize(const CancelToken& cancel);
  std::optional<Eigen::VectorXd> solve_for(const Eigen::VectorXd& down, const Eigen::VectorXd& pull) const;
  std::optional<Eigen::VectorXd> direction(const Eigen::VectorXd& gradient) const;
  enum class Search { taken, too_little, nothing };
  Search search(const Eigen::VectorXd& direction, double slope, const CancelToken& cancel);
  void take(State next, const Eigen::VectorXd& step, bool learns);
  bool is_small(double decrease) const;
  Eigen::VectorXd precision(const State& state) const;

  Points scan_;
  int free_ = 0;
  double lambda_, s2_, kappa_, edge_;
  SplitSurface surface_;
  State state_;
  std::unique_ptr<SpdSolver> step_solver_ = make_spd_solver(), relief_solver_ = make_spd_solver();
  QuasiNewton memory_;
  Eigen::VectorXd last_gradient_;  ///< of J at the state; empty where it is not known
  int steps_since_factors_ = -1;   ///< −1: there are none
  double last_decrease_ = 0;       ///< of J by the last step
  bool gauss_newton_pays_ = true;
  int descent_steps_ = 0;
  bool is_valid_ = false;
};

}  // namespace loopmend
