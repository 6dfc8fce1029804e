// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/evolution.h"

#include "core/error.h"
#include "evolution/coarse_patch.h"
#include "evolution/evolution_impl.h"
#include "evolution/mesh_care.h"
#include "evolution/stopwatch.h"
#include "flows/decay_rate.h"
#include "flows/symmetric_part.h"
#include "rim/rim_blend.h"
#include "solvers/diagonal.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace loopmend {

namespace {

constexpr double steady_sigma = 1e4;  ///< a step that jumps to the steady state of the linear part
constexpr int most_fairings = 6;      ///< linear steps before the first Gauss-Newton step
constexpr int steps_with_mesh_care = 15;
constexpr double fair_angle = 25;        ///< degrees: triangles no worse than this are left as they are
constexpr double flow_tolerance = 1.05;  ///< docs/dev/numerics.md, "Semi-implicit step"
/// Of the linear system of a semi-implicit step. Such a step is off by a tenth of itself, being of first order in time.
constexpr double flow_step_tolerance = 1e-4;
constexpr double smooth_unevenness = 0.1;  ///< RimRoughness::unevenness of a smooth surface on a fair mesh is below
constexpr double room_beyond_start = 1;    ///< on all sides, in diagonals of the patch's box
constexpr double smallest_step = 1e-6;     ///< relative to the step that was asked for: below, the flow has stalled
constexpr int semi_implicit_trials = 2;  ///< of a step, before Gauss-Newton takes it
constexpr const char* collapsed_words = "stopped early: only vanishing time steps keep the flow stable here";

/// Power of length that the flow's time has: tau in mesh units = tau in the frame × scale^order.
int order_of(FlowKind flow) { return flow == FlowKind::mcf ? 2 : flow == FlowKind::mmcvf ? 6 : 4; }

bool has_energy(FlowKind flow) { return flow == FlowKind::mmcvf || flow == FlowKind::wf; }

}  // namespace

Eigen::AlignedBox3d room_around(const Patch& patch, double share) {
  Eigen::AlignedBox3d box;
  for (int i = 0; i < patch.free_count; ++i) box.extend(patch.positions[i]);
  for (const auto& loop : patch.loops)
    for (int v : loop) box.extend(patch.positions[v]);
  const Vec3 margin = Vec3::Constant(share * box.diagonal().norm());
  return {box.min() - margin, box.max() + margin};
}

void check(const EvolutionOptions& options) {
  if (!(options.sigma >= 1e-6 && options.sigma <= 1e8))
    throw InvalidArgument("the time step sigma must lie between 1e-6 and 1e8, not " + std::to_string(options.sigma));
  if (options.bending && !(*options.bending >= 0 && *options.bending <= 1e6))
    throw InvalidArgument("the share of bending energy must lie between 0 and 1e6, not " +
                          std::to_string(*options.bending));
  if (options.max_steps < 1)
    throw InvalidArgument("the number of steps must be at least 1, not " + std::to_string(options.max_steps));
}

bool is_judged(const EvolutionOptions& options) {
  return options.flow == FlowKind::mmcvf && options.mode == EvolutionMode::steady &&
         options.boundary == BoundaryTrust::automatic && !options.bending &&
         options.continuity == SeamContinuity::curvature;
}

std::string reason_for(const RimRoughness& boundary) {
  constexpr const char* how = "; boundary exact asks for the flow itself";
  if (boundary.rough_share >= 1)
    return std::string(
               "the curvature around the hole changes abruptly, by roughness or an edge, and tells little about "
               "the hole") +
           how;
  if (boundary.rough_share > 0)
    return "the curvature around the hole changes abruptly in part and counts for " +
           std::to_string(std::lround(100 * (1 - boundary.rough_share))) + " % at most" + how;
  if (boundary.noise_share > 0)
    return std::string("the scan around the hole is noisy, and the flow meets the surface without the noise") + how;
  if (boundary.bending > 0)
    return std::string("the curvature around the hole changes over lengths shorter than the hole") + how;
  return "";
}

std::string method_name(Method method, FlowKind flow) {
  const std::string name = to_string(flow);
  switch (method) {
    case Method::initial_patch: return "initial_patch";
    case Method::flow: return name;
    case Method::mixed_order: return name + "_mixed_order";
    case Method::denoised_flow: return name + "_denoised";
    case Method::robust_fairing: return "robust_fairing";
    case Method::linear_fairing: return "linear_fairing";
    case Method::interpolated: return name + "_and_robust_fairing";
  }
  return "";
}

void Evolution::Impl::prepare(Patch first) {
  start = std::move(first);
  if (start.free_count == 0) throw InvalidArgument("the patch has no free vertex to evolve");
  for (const Vec3& p : start.positions)
    if (!p.allFinite()) throw InvalidArgument("the patch has a vertex that is not finite");
  room = room_around(start, room_beyond_start);
  state = make_state(start, objective, stencil, nullptr, Fits::curvatures);
  start_folds = state.folds;
  start_edge_length = edge_length();
}

Objective Evolution::Impl::objective_for(const EvolutionOptions& new_options) {
  method = Method::flow;
  blend = 0;
  smooth_surroundings = false;
  cubic_start.reset();
  stencil = Stencil::two_ring;
  rim.reset();
  blends_left = 0;
  if (new_options.flow != FlowKind::mmcvf || new_options.mode != EvolutionMode::steady) return {new_options.flow, 0};
  rim = new_options.roughness ? new_options.roughness : rim_roughness(state.patch);
  const double scale = rim->radius * rim->radius;
  if (new_options.continuity != SeamContinuity::curvature) {
    method = Method::linear_fairing;
    blends_left = most_passes;
    return {new_options.flow, 0};
  }
  const bool automatic = new_options.boundary == BoundaryTrust::automatic;
  const bool rough = automatic && !new_options.bending && rim->kind == Surroundings::rough;
  if (rough || new_options.boundary == BoundaryTrust::robust) {
    method = Method::robust_fairing;
    blends_left = rough_passes;
    rim_data_trust = data_trust(state.patch, rim->radius);
    blend = rough_bending;
    return {new_options.flow, blend / scale};
  }
  blend = new_options.bending.value_or(automatic ? rim->bending : 0);
  if (blend > 0) method = Method::mixed_order;
  smooth_surroundings = blend == 0 && rim->unevenness < smooth_unevenness;
  return {new_options.flow, blend / scale, energy_reach};
}

void Evolution::Impl::take_options(const EvolutionOptions& new_options) {
  check(new_options);
  options = new_options;
  const Objective wanted = objective_for(options);
  objective = wanted;
  if (!history.empty() || wanted.flow != FlowKind::mmcvf || wanted.bending > 0)
    state = make_state(std::move(state.patch), objective, stencil, state.topology, Fits::curvatures);
  const bool newton = options.mode == EvolutionMode::steady && options.flow == FlowKind::mmcvf;
  allowed_folds = start_folds + (newton ? std::max(2, state.patch.free_count / 200) : 0);
  decay_rate = 0;
  damping_unit = 0;
  mu = 0;
  sigma = options.mode == EvolutionMode::steady ? steady_sigma : options.sigma;
  small_moves = 0;
  undamped_left = true;
  creeping_from.clear();
  last_bold_move = 0;
  fairings_left = history.empty() && options.start != SteadyStart::as_given ? most_fairings : 0;
  coarse_start_left = history.empty() && newton && options.start == SteadyStart::faired &&
                      options.triangles == PatchTriangles::free && worth_coarsening(state.patch);
  start_measure = lowest_measure = state.measure;
  cared_edge_length = edge_length();
  cared_angle = 0;
  general = make_general_solver(options.solver, flow_step_tolerance);
  spd = make_spd_solver();
  stop(PatchStatus::ready, "");
}

/// The slowest decay rate, found when it is first asked for.
double Evolution::Impl::decay() {
  if (decay_rate == 0) decay_rate = slowest_decay_rate(options.flow, state.patch);
  if (!(decay_rate > 0)) decay_rate = 1;
  return decay_rate;
}

bool Evolution::Impl::acceptable(const EvolutionState& next, double limit) const {
  if (!std::isfinite(next.measure) || next.folds > std::max(state.folds, allowed_folds)) return false;
  if (next.unfitted > state.unfitted) return false;
  for (int i = 0; i < next.patch.free_count; ++i)
    if (!room.contains(next.patch.positions[i])) return false;
  return next.measure <= limit;
}

void Evolution::Impl::accept(EvolutionState next, StepRecord record, const Eigen::VectorXd& s, double used_sigma,
                             double rate) {
  record.step = static_cast<int>(history.size()) + 1;
  record.max_move = s.cwiseAbs().maxCoeff() / edge_length();
  record.sigma = used_sigma;
  record.tau = used_sigma / rate * std::pow(state.patch.scale, order_of(options.flow));
  state = std::move(next);
  record.energy = shown_energy(options.flow, state);
  history.push_back(record);
}

bool Evolution::Impl::replace_if_good(Patch patch, double limit) {
  EvolutionState next = make_state(std::move(patch), objective, stencil);
  if (next.folds > state.folds || next.unfitted > state.unfitted || !(next.measure <= limit)) return false;
  state = std::move(next);
  return true;
}

/// Only while the surface still moves: near the end the mesh must stand still for the solve to converge. The energy stays
/// within the limit, but where a folded patch is mended.
void Evolution::Impl::care_for_mesh(double limit) {
  if (history.size() > steps_with_mesh_care || history.back().max_move < 0.05) return;
  const Patch relaxed = tangentially_relaxed(state);
  if (!replace_if_good(with_delaunay_flips(relaxed), limit)) {
    replace_if_good(relaxed, limit);
    replace_if_good(with_delaunay_flips(state.patch), limit);
  }
  if (state.folds > 0) {
    EvolutionState next = make_state(remeshed(state.patch), objective, stencil);
    if (next.folds < state.folds && next.unfitted <= state.unfitted && std::isfinite(next.measure))
      state = std::move(next);
  }
  history.back().energy = shown_energy(options.flow, state);
}

/// Whether a flow that only moves along the normals has worn the mesh since it was last cared for. Moved vertices make the
/// factors of the steps before worth nothing, so they are not moved for their own sake.
bool Evolution::Impl::mesh_has_suffered() {
  const double length = edge_length();
  const double angle = min_angle_deg(state.patch.positions, state.patch.triangles, state.patch.patch_triangles);
  const bool stretched = std::abs(length - cared_edge_length) > 0.05 * cared_edge_length;
  const bool sharpened = angle < fair_angle && std::abs(angle - cared_angle) > 0.1 * cared_angle;
  if (state.folds == 0 && !stretched && !sharpened) return false;
  cared_edge_length = length;
  cared_angle = angle;
  return true;
}

/// M(I/τ − J) s = M V with τ = σ/λ, which is nearly symmetric.
SolveReport Evolution::Impl::solve_flow_step(const FlowSystem& system, Eigen::VectorXd& s) {
  const Eigen::VectorXd mass =
      barycentric_areas(state.patch.positions, state.patch.triangles).head(state.patch.free_count);
  GeneralSystem linear;
  linear.times = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
    return mass.cwiseProduct(decay() / sigma * x - system.times_jacobian(x));
  };
  linear.matrix = [&]() -> SparseMatrix {
    const SparseMatrix M(mass.asDiagonal());
    return decay() / sigma * M - M * system.jacobian();
  };
  linear.nearby = [&]() -> SparseMatrix {
    SparseMatrix K = symmetric_part(options.flow, state.patch, state.ops);
    store_diagonal(K);  // a vertex that no fit sees has no entry
    K.diagonal() += decay() / sigma * mass;
    return K;
  };
  return general->solve(linear, mass.cwiseProduct(system.velocity()), s);
}

/// One trial of the semi-implicit scheme (§4) with the present sigma.
FlowTrial Evolution::Impl::try_semi_implicit(const FlowSystem& system, StepRecord& record) {
  Stopwatch watch;
  FlowTrial trial;
  Eigen::VectorXd s;
  const SolveReport report = solve_flow_step(system, s);
  record.solve_seconds += watch.lap();
  record.iterations += report.iterations;
  record.factorizations += report.factored ? 1 : 0;
  if (!report.solved) return trial;
  EvolutionState next = displaced(state, objective, stencil, s);
  trial.accepted = acceptable(next, flow_tolerance * lowest_measure);
  record.assemble_seconds += watch.lap();
  if (!trial.accepted) return trial;
  accept(std::move(next), record, s, sigma, decay());
  trial.whole = true;
  trial.move = history.back().max_move;
  return trial;
}

/// One step of the paper's scheme. Where it fails twice, Gauss-Newton takes the implicit step of the size that was asked
/// for, and a smaller one as long as that fails: it descends the same energy, and is stable where the scheme is not.
void Evolution::Impl::semi_implicit_step(const CancelToken& cancel) {
  if (!can_be_fitted()) return stop(PatchStatus::stalled, no_fits_words);
  Stopwatch watch;
  const double wanted = options.mode == EvolutionMode::steady ? steady_sigma : options.sigma;
  add_weights(state, objective, stencil);
  const FlowSystem system(options.flow, FlowState(state.ops, state.patch.free_count));
  StepRecord record;
  record.assemble_seconds = watch.lap();
  std::optional<GaussNewtonSystem> descent;
  SparseMatrix curvature;
  for (int k = 0; k < most_trials; ++k) {
    if (cancel.cancelled()) return stop(PatchStatus::cancelled, "cancelled");
    const bool descends = k >= semi_implicit_trials && has_energy(options.flow);
    if (descends && !descent) {
      descent = assemble_gauss_newton(state.patch, state.ops, energy_of(objective));
      damping_unit = decay();
      sigma = wanted;
    }
    if (descends) mu = damping_unit / (2 * sigma);
    const FlowTrial trial =
        descends ? try_gauss_newton(*descent, curvature, record, cancel) : try_semi_implicit(system, record);
    // Smaller steps move less: that is no rest. What counts is a step of the size that was asked for.
    const bool stands_still = trial.move < small_move * std::min(1.0, sigma) && sigma >= 0.1 * wanted;
    if (trial.accepted) {
      lowest_measure = std::min(lowest_measure, state.measure);
      if (trial.whole && stands_still) return stop(PatchStatus::converged, "");
      if (sigma < smallest_step * wanted) return stop(PatchStatus::stalled, collapsed_words);
      sigma = std::min(wanted, sigma * 3);
      if (mesh_has_suffered()) care_for_mesh(flow_tolerance * lowest_measure);
      return;
    }
    if (descends && trial.solved && stands_still) return stop(PatchStatus::converged, "");
    ++record.rejections;
    sigma /= 10;
  }
  if (cancel.cancelled()) return stop(PatchStatus::cancelled, "cancelled");
  stop(PatchStatus::stalled, collapsed_words);
}

/// The curvature must be known where the patch is free and at the loop, or there is nothing that a flow could follow.
bool Evolution::Impl::can_be_fitted() const {
  if (state.unfitted > 0) return false;
  int loop = 0, known = 0;
  for (int i = state.patch.free_count; i < state.patch.vertex_count() && state.patch.ring[i] == 1; ++i) {
    ++loop;
    known += state.ops.valid[i];
  }
  return loop == 0 || 2 * known > loop;
}

Evolution::Evolution(Patch start, EvolutionOptions options) : impl_(std::make_unique<Impl>()) {
  check(options);
  impl_->options = options;
  impl_->prepare(std::move(start));
  impl_->take_options(options);
  impl_->initial_energy = energy();
}

Evolution::~Evolution() = default;
Evolution::Evolution(Evolution&&) noexcept = default;
Evolution& Evolution::operator=(Evolution&&) noexcept = default;

void Evolution::step(const CancelToken& cancel) {
  if (impl_->status == PatchStatus::step_limit) impl_->stop(PatchStatus::ready, "");
  if (impl_->status != PatchStatus::ready) return;
  if (cancel.cancelled()) return impl_->stop(PatchStatus::cancelled, "cancelled");
  const bool newton = impl_->options.mode == EvolutionMode::steady && impl_->options.flow == FlowKind::mmcvf;
  if (!newton) return impl_->semi_implicit_step(cancel);
  if (impl_->blends_left > 0) return impl_->blend_step();
  // Before the starts: what they alone have shaped must not pass for the flow's work.
  if (!impl_->can_be_fitted()) return impl_->stop(PatchStatus::stalled, no_fits_words);
  if (std::exchange(impl_->coarse_start_left, false)) {
    if (impl_->coarse_step(cancel)) return;
    if (cancel.cancelled()) return impl_->stop(PatchStatus::cancelled, "cancelled");
  }
  if (impl_->fairings_left-- > 0) {
    if (impl_->fairing_step(cancel)) return;
    impl_->fairings_left = 0;
  }
  impl_->gauss_newton_step(cancel);
}

PatchStatus Evolution::run(const OnStep& on_step, const CancelToken& cancel) {
  for (int k = 0; k < impl_->options.max_steps; ++k) {
    const std::size_t before = impl_->history.size();
    step(cancel);
    if (on_step && impl_->history.size() > before) on_step(*this, impl_->history.back());
    if (impl_->status != PatchStatus::ready) return impl_->status;
  }
  impl_->stop(PatchStatus::step_limit,
              "stopped after " + std::to_string(impl_->options.max_steps) + " steps, before the steady state");
  return impl_->status;
}

void Evolution::set_options(const EvolutionOptions& options) { impl_->take_options(options); }
const Patch& Evolution::patch() const { return impl_->state.patch; }
const EvolutionOptions& Evolution::options() const { return impl_->options; }
PatchStatus Evolution::status() const { return impl_->status; }
const std::string& Evolution::message() const { return impl_->message; }
const std::vector<StepRecord>& Evolution::history() const { return impl_->history; }
double Evolution::initial_energy() const { return impl_->initial_energy; }
Method Evolution::method() const { return impl_->method; }
double Evolution::bending() const { return impl_->blend; }
const std::optional<RimRoughness>& Evolution::roughness() const { return impl_->rim; }
double Evolution::energy() const { return shown_energy(impl_->options.flow, impl_->state); }

}  // namespace loopmend
