// SPDX-License-Identifier: GPL-3.0-or-later
// The evolution of one patch under one flow: a start in, accepted states out.
#pragma once

#include "core/cancel.h"
#include "core/message.h"
#include "evolution/edge_edits.h"
#include "evolution/patch_status.h"
#include "flows/flow_kind.h"
#include "mesh/patch.h"
#include "neighborhood/weighted_fairing.h"
#include "solvers/solver_kind.h"
#include "split/continue_relief.h"
#include "split/split_energy.h"
#include "split/split_estimate.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace loopmend {

enum class EvolutionMode {
  steady,  ///< straight to the steady state: Gauss-Newton on the energy (MMCVF), very large steps (WF, SDF, MCF)
  steps,   ///< the paper's semi-implicit scheme, §4, one step of size sigma after another
};

/// What may become of the patch's triangles on the way to the steady state of MMCVF. A flow flips edges in any case.
enum class PatchTriangles {
  free,   ///< a patch that grows is remeshed
  kept,   ///< vertices neither come nor go, but to repair folds
  fixed,  ///< and fairings in a rough neighborhood leave the edges as they are
};

/// From where MMCVF sets out for the steady state.
enum class SteadyStart {
  faired,         ///< from linear fairings while they lower the energy; large patches from the end of a coarse copy
  evenly_faired,  ///< the same, as if all triangles were equilateral: where slivers spoil the first
  as_given,
};

/// How MMCVF on its way to the steady state treats the boundary data.
enum class BoundaryTrust {
  automatic,  ///< as SplitEstimate says: the flow itself where they are exact, else its split form; very large patches
              ///< robust fairing
  exact,      ///< literally, whatever it is: the flow itself
  robust,     ///< as on rough scans, whatever it is: robust fairing in place of the flow (weighted_fairing.h)
};

/// What a patch does with sharp edges that end at its hole.
enum class SharpEdges {
  continued,  ///< they run on, where the sides of the neighborhood say how (edges/sharp_patch.h)
  rounded,    ///< one smooth patch
};

struct EvolutionOptions {
  FlowKind flow = FlowKind::mmcvf;
  EvolutionMode mode = EvolutionMode::steady;
  double sigma =
      10;  ///< time step, dimensionless, 1e-6..1e8: tau = sigma / (slowest decay rate of the flow); steps only
  int max_steps = 60;  ///< accepted steps of one run()
  SolverKind solver = SolverKind::automatic;
  PatchTriangles triangles = PatchTriangles::free;
  SteadyStart start = SteadyStart::faired;
  /// MMCVF to the steady state minimises ∫‖∇H‖² + β/R² ∫H², R the patch's radius: β = 0 is the pure flow, 60 to 150 suits
  /// rough scans. Empty: the pure flow.
  std::optional<double> bending;
  BoundaryTrust boundary =
      BoundaryTrust::automatic;  ///< MMCVF to the steady state; `bending`, where given, counts more than automatic
  /// MMCVF to the steady state. Below curvature the patch is the linear fairing of that order, iterated.
  SeamContinuity continuity = SeamContinuity::curvature;
  /// MMCVF to the steady state with `automatic` boundary: relief that it takes literally, in boundary edges.
  double literal_relief = SplitEstimate::exact_construction;
  std::optional<SplitEstimate>
      split;  ///< of the neighborhood, where the caller has it; else it is made where it is wanted
  /// The same, of the loops: see boundary_fits().
  std::shared_ptr<const std::vector<std::vector<BoundaryFit>>> fits;
  /// Of holes, to the steady state: added when the patch is done (pipeline/patch_relief.h). An Evolution by itself has no use for it.
  ReliefChoice relief;
  SharpEdges edges = SharpEdges::continued;  ///< of holes, with `automatic` boundary (pipeline/candidates.h)
  EdgeEdits edge_edits;                      ///< of these, by hand; see continues_edges()
};

/// @throws InvalidArgument if an option is out of range.
void check(const EvolutionOptions& options);

/// True if the boundary data decide how far the flow itself runs: nothing in the options does.
bool is_judged(const EvolutionOptions& options);
/// True if sharp edges run on, and edges that are drawn or stopped by hand count: nothing in the options asks for one smooth patch.
bool continues_edges(const EvolutionOptions& options);

/// What shaped a patch.
enum class Method {
  initial_patch,  ///< triangulation and remeshing; neither flow nor fairing
  flow,           ///< the flow that was asked for, with the boundary data as they are
  split_flow,     ///< MMCVF on the smooth part of the scan, relief and noise split off: SplitProblem
  mixed_order,  ///< MMCVF with bending energy mixed in: ∫‖∇H‖² + β/R² ∫H², see EvolutionOptions::bending
  robust_fairing,  ///< a few linear fairings that weigh the boundary data; no flow
  sharp_edges,     ///< sharp edges continued, each side on its own surface (edges/sharp_patch.h); no flow
  linear_fairing,  ///< linear fairing of the order that SeamContinuity asks for, up to twelve times; no flow
  mirror_image,    ///< the mirror image of the other side of the scan, its own triangles; no flow
  straight_base,   ///< an upright wall continued straight to a plane base (filling/straight_base.h); no flow
  sphere,          ///< the missing part of the sphere on which the surface around lies (filling/sphere_cap.h); no flow
};

/// Why the boundary data ask for something else than the flow, and how to get the flow nevertheless. Empty if they do not.
Message reason_for(const SplitEstimate& estimate, Method method);

/// The word of reports: "mmcvf", "mmcvf_mixed_order", "robust_fairing", ...
std::string method_name(Method method, FlowKind flow);

/// One accepted step. Energy in mesh units: MMCVF ∫‖∇H‖² dA (1/length²), WF ∫H² dA (1), SDF and MCF area (length²).
/// With bending blended in, what falls is the blend; the energy shown is still ∫‖∇H‖² dA alone, and may rise a little.
/// Near a smooth steady state the fits go over from quadratics to cubics, and the energy is measured again by these.
/// Linear fairings, and the coarse start of a large patch, are steps with sigma = tau = 0; the latter's max_move is that of
/// the middle of the patch. In a rough neighborhood all steps are such, and the energy shown need not fall.
struct StepRecord {
  int step = 0;            ///< from 1
  double energy = 0;       ///< after the step
  double sigma = 0;        ///< the step's size, dimensionless; of a Gauss-Newton step only roughly known
  double tau = 0;          ///< the step's size in the flow's own time, mesh units
  double max_move = 0;     ///< largest move of a vertex, in mean edge lengths of the patch
  SplitEnergy split;       ///< of a step of Method::split_flow, what the descent lowers; else zero
  int rejections = 0;      ///< trials thrown away before this one was accepted
  int iterations = 0;      ///< of GMRES or conjugate gradients over all trials; none in linear fairings
  int factorizations = 0;  ///< made for this step, since those of earlier steps were no good; not of linear fairings
  double assemble_seconds = 0;
  double solve_seconds = 0;
};

/// Holds the last accepted state at every moment. Not thread-safe: one thread steps, others get copies through the
/// callback. Fixed vertices are never moved.
class Evolution {
 public:
  /// @throws InvalidArgument if an option is out of range, or the patch has no free vertex.
  Evolution(Patch start, EvolutionOptions options);
  ~Evolution();
  Evolution(Evolution&&) noexcept;
  Evolution& operator=(Evolution&&) noexcept;

  /// Called after every accepted step, on the stepping thread.
  using OnStep = std::function<void(const Evolution&, const StepRecord&)>;

  /// One accepted step; status() has the result. Does nothing unless status() is ready or step_limit.
  void step(const CancelToken& cancel);
  /// Steps until converged, failed, cancelled, or max_steps more are taken.
  PatchStatus run(const OnStep& on_step, const CancelToken& cancel);
  /// Goes on from the present state with other options; status() is ready again.
  void set_options(const EvolutionOptions& options);

  const Patch& patch() const;
  const EvolutionOptions& options() const;
  PatchStatus status() const;
  /// In words, for a person: why it stopped, what was left out. Empty while ready.
  const Message& message() const;
  const std::vector<StepRecord>& history() const;
  double initial_energy() const;  ///< of the start, units as in StepRecord; by the same fits as energy()
  double energy() const;          ///< of the present state
  Method method() const;          ///< of the steps that the present options lead to
  double bending() const;         ///< β in force, see EvolutionOptions::bending; 0 for the pure flow
  /// Of the neighborhood of the patch as it was at the last set_options(). Empty but for MMCVF to the steady state.
  const std::optional<SplitEstimate>& split() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace loopmend
