// SPDX-License-Identifier: GPL-3.0-or-later
// One variational problem for every boundary: the smooth surface under the scan, its relief and noise, and the patch.
#pragma once

#include "core/cancel.h"
#include "mesh/patch.h"
#include "solvers/linear_solver.h"
#include "split/split_energy.h"
#include "split/split_estimate.h"
#include "split/split_surface.h"

#include <memory>
#include <optional>

namespace loopmend {

/// y + z n + e n = x, along n, at the vertices of the neighborhood, which never move; on the patch there is no x, so that y and z are free.
/// Minimises J over y, displaced along its normals; z and e are the best for each y.
class SplitProblem {
 public:
  /// From the patch as it is. @param patch  with neighborhood.
  SplitProblem(const Patch& patch, const SplitEstimate& estimate, const CancelToken& cancel);

  enum class Outcome {
    moved,
    moved_little,  ///< J fell by next to nothing: the last step that pays
    ended,         ///< no trial lowers J
    failed,        ///< J cannot be evaluated, or a matrix is not positive definite
    cancelled
  };
  /// Of Gauss-Newton with B for the derivative of H: its first steps are long, but later ones may point uphill.
  Outcome step(const CancelToken& cancel);

  /// False where J cannot be evaluated at the start.
  bool is_valid() const { return is_valid_; }
  const SplitEnergy& energy() const { return state_.energy; }
  /// Of the patch's free vertices: y + z n, with e carried in over about one edge. Empty if that cannot be solved, or when cancelled.
  Points patch_positions(const CancelToken& cancel);

 private:
  struct State {
    Points y;
    SplitGeometry geometry;
    SparseMatrix U;            ///< of the relief, lower triangle
    Eigen::VectorXd distance;  ///< from y to x along the normals; 0 on the patch
    Eigen::VectorXd relief;
    SplitEnergy energy;
  };

  std::optional<State> state_at(Points y, const CancelToken& cancel);
  std::optional<State> displaced(const Eigen::VectorXd& displacement, const CancelToken& cancel);
  bool best_relief(State& state, const CancelToken& cancel);
  bool factorize(const CancelToken& cancel);
  std::optional<Eigen::VectorXd> solve_for(const Eigen::VectorXd& down, const Eigen::VectorXd& pull) const;
  bool search(const Eigen::VectorXd& direction, const CancelToken& cancel);
  Eigen::VectorXd precision(const State& state) const;

  Points scan_;
  int free_ = 0;
  double lambda_, s2_, kappa_, edge_;
  SplitSurface surface_;
  State state_;
  std::unique_ptr<SpdSolver> step_solver_ = make_spd_solver(), relief_solver_ = make_spd_solver();
  bool is_valid_ = false;
};

}  // namespace loopmend
