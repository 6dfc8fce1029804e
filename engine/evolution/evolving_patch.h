// SPDX-License-Identifier: GPL-3.0-or-later
// What all methods to step a patch share: the present state, what a step may do to it, and the record of the steps.
#pragma once

#include "core/message.h"
#include "evolution/evolution.h"
#include "evolution/state.h"

#include <Eigen/Geometry>

namespace loopmend {

inline constexpr int most_trials = 12;      ///< before a step is given up
inline constexpr double small_move = 1e-3;  ///< in mean edge lengths: no eye sees it

struct EvolvingPatch {
  /// @throws InvalidArgument if the patch has no free vertex, or one that is not finite.
  explicit EvolvingPatch(Patch first);
  /// From the present state on, with quadratic fits.
  void begin(const EvolutionOptions& new_options, const Objective& new_objective);

  /// Whether the energy stays within the limit, and no vertex leaves the room, no fit is lost and no fold too many is made.
  bool acceptable(const EvolutionState& next, double limit) const;
  /// @param s  n, patch frame: the displacement. @param rate  decay rate in which sigma is measured.
  void accept(EvolutionState next, StepRecord record, const Eigen::VectorXd& s, double sigma, double rate);
  /// A better start, from which the way to the steady state goes on. @param move  patch frame.
  void accept_start(EvolutionState next, StepRecord record, double move);
  /// Another mesh in place of the present one, unless it folds more or its energy is above the limit.
  bool replace_if_good(Patch patch, double limit);
  /// Mesh improvement while the surface still moves: near convergence the mesh must stand still. The energy stays within the
  /// limit, except where a folded patch is repaired.
  void improve_mesh(double limit);
  /// Whether most fits succeed, or there is no curvature that a flow could follow. Stops with a message if not.
  bool require_fits();
  /// @returns true if cancelled; the evolution has then stopped.
  bool stop_if(const CancelToken& cancel);
  void stop(PatchStatus why, Message text = {});

  double edge_length() const;  ///< mean, of the patch
  double energy() const { return shown_energy(options.flow, state); }

  EvolutionOptions options;
  Objective objective;
  Patch start;
  EvolutionState state;
  Stencil stencil = Stencil::two_ring;  ///< of the state's fits
  PatchStatus status = PatchStatus::ready;
  Message message;
  std::vector<StepRecord> history;
  double initial_energy = 0;  ///< of `start`, by the state's stencil
  Eigen::AlignedBox3d room;   ///< no vertex may leave it (docs/math/energy_to_matrix.md, "Bubbles")
  int start_folds = 0;
  int allowed_folds = 0;  ///< on the way; whoever takes the result looks at what is left
};

/// One method to step a patch.
class Stepper {
 public:
  virtual ~Stepper() = default;
  /// One accepted step, or EvolvingPatch::status says why there was none. Called while that is `ready`.
  virtual void step(EvolvingPatch& patch, const CancelToken& cancel) = 0;
};

}  // namespace loopmend
