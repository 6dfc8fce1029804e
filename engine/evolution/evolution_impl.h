// SPDX-License-Identifier: GPL-3.0-or-later
// What an Evolution holds and how it steps: the plan in evolution.cpp, the starts in evolution_starts.cpp, Gauss-Newton in
// evolution_newton.cpp. For these alone.
#pragma once

#include "energy/curvature_energy.h"
#include "evolution/evolution.h"
#include "evolution/linear_start.h"
#include "evolution/state.h"
#include "flows/flow_terms.h"
#include "flows/gauss_newton.h"
#include "mesh/quality.h"
#include "rim/rim_roughness.h"
#include "solvers/linear_solver.h"

#include <Eigen/Geometry>

#include <deque>
#include <utility>

namespace loopmend {

inline constexpr int most_trials = 12;      ///< before the step is given up
inline constexpr int most_passes = 12;      ///< of the fairings for position or tangent
inline constexpr int rough_passes = 3;      ///< of rim_blend: one of second order, two that weigh the rim
inline constexpr double small_move = 1e-3;  ///< in mean edge lengths: no eye sees it
inline constexpr double near_move = 1;  ///< in mean edge lengths: smooth surroundings are worth finer fits from here
/// In mean edge lengths: the next bold step would go a hundredth of that.
inline constexpr double near_the_end_move = 0.05;

/// The box of the patch, grown by a share of its diagonal.
Eigen::AlignedBox3d room_around(const Patch& patch, double share);

inline constexpr const char* no_fits_words = "the surface around the hole has too few vertices to tell its curvature";

/// The curvature energy of a flow that has one.
inline EnergyWeights energy_of(const Objective& objective) {
  return objective.flow == FlowKind::wf ? EnergyWeights{0, 1} : EnergyWeights{1, objective.bending};
}

/// What came of one trial of a step.
struct FlowTrial {
  bool solved = false;
  bool accepted = false;
  bool whole = false;   ///< accepted as it was solved for, not a part of it
  double move = 0;      ///< largest displacement before the line search, in mean edge lengths; 0 if unsolved
  double promised = 0;  ///< fall of the energy that the quadratic model foresees; Gauss-Newton only
};

struct Evolution::Impl {
  EvolutionOptions options;
  Patch start;
  EvolutionState state;
  Stencil stencil = Stencil::two_ring;
  Objective objective;
  PatchStatus status = PatchStatus::ready;
  std::string message;
  std::vector<StepRecord> history;
  double initial_energy = 0;

  Eigen::AlignedBox3d room;  ///< no vertex may leave it (docs/dev/numerics.md, "Bubbles")
  int start_folds = 0;
  int allowed_folds = 0;                      ///< in between; whoever takes the result looks at what is left
  double start_edge_length = 0;               ///< mean, of the patch
  std::optional<EvolutionState> cubic_start;  ///< the start by cubic fits, once it is known; without weights
  bool smooth_surroundings = false;  ///< fits of all widths agree on the curvature: it can be trusted to high order
  Method method = Method::flow;      ///< what the present options lead to
  double blend = 0;                  ///< αR² of the order blend in force
  std::optional<RimRoughness> rim;   ///< of the surroundings; MMCVF to the steady state only
  Eigen::VectorXd rim_data_trust;    ///< data_trust of the surroundings, while blends are to come
  int blends_left = 0;    ///< linear fairings that are the whole way: on rough rims, or for less than curvature
  double decay_rate = 0;  ///< patch frame; 0 until it is first asked for
  double damping_unit = 0;         ///< of mu: about the decay rate; 0 before the first Gauss-Newton step
  double sigma = 0;                ///< of the next semi-implicit step; falls on rejection, recovers
  double mu = 0;                   ///< of the next Gauss-Newton step
  bool coarse_start_left = false;  ///< the steady state of a coarse copy may still be tried
  int fairings_left = 0;           ///< linear fairing steps that may still be tried before Gauss-Newton
  double last_bold_move = 0;  ///< of the last step, in mean edge lengths, if that was a Gauss-Newton step taken whole
  std::deque<double> creeping_from;  ///< measures before the last Gauss-Newton steps, all of which hardly moved
  bool undamped_left = true;         ///< damped steps that stand still may once be followed by an undamped one
  int small_moves = 0;               ///< Gauss-Newton steps in a row that moved nothing to speak of
  double cared_edge_length = 0;      ///< mean, when the mesh was last cared for
  double cared_angle = 0;            ///< smallest, degrees, before it was
  double start_measure = 0;          ///< at the last set_options
  double lowest_measure = 0;         ///< since then
  std::unique_ptr<GeneralSolver> general;
  std::unique_ptr<SpdSolver> spd;

  void prepare(Patch first);
  void take_options(const EvolutionOptions& new_options);
  Objective objective_for(const EvolutionOptions& new_options);
  bool acceptable(const EvolutionState& next, double limit) const;
  void accept(EvolutionState next, StepRecord record, const Eigen::VectorXd& s, double used_sigma, double rate);
  bool mesh_has_suffered();
  void care_for_mesh(double limit);
  bool replace_if_good(Patch patch, double limit);
  bool fairing_step(const CancelToken& cancel);
  void blend_step();
  bool coarse_step(const CancelToken& cancel);
  void take_start(EvolutionState next, StepRecord record, double move);
  double decay();
  bool near_the_end() const { return last_bold_move > 0 && last_bold_move < near_the_end_move; }
  EvolutionState state_of_start_by_cubic_fits() const;
  bool go_over_to_cubic_fits();
  bool only_creeps(double move, double energy_before);
  void finish();
  bool stand_still(bool undamped);
  void gauss_newton_step(const CancelToken& cancel);
  bool solve_gauss_newton(const GaussNewtonSystem& system, SparseMatrix& curvature, StepRecord& record,
                          Eigen::VectorXd& s);
  FlowTrial try_gauss_newton(const GaussNewtonSystem& system, SparseMatrix& curvature, StepRecord& record,
                             const CancelToken& cancel);
  FlowTrial try_semi_implicit(const FlowSystem& system, StepRecord& record);
  bool can_be_fitted() const;
  SolveReport solve_flow_step(const FlowSystem& system, Eigen::VectorXd& s);
  void semi_implicit_step(const CancelToken& cancel);
  double edge_length() const {
    return mean_edge_length(state.patch.positions, state.patch.triangles, state.patch.patch_triangles);
  }
  double radius() const { return patch_radius(state.patch); }
  void stop(PatchStatus why, std::string words) {
    status = why;
    message = std::move(words);
  }
};

}  // namespace loopmend
