#include "evolution/evolution.h"

#include "core/error.h"
#include "energy/curvature_energy.h"
#include "evolution/coarse_patch.h"
#include "evolution/linear_start.h"
#include "evolution/mesh_care.h"
#include "evolution/state.h"
#include "evolution/stopwatch.h"
#include "flows/decay_rate.h"
#include "flows/gauss_newton.h"
#include "mesh/quality.h"
#include "solvers/linear_solver.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace loopmend {

namespace {

constexpr double steady_sigma = 1e4;  ///< a step that jumps to the steady state of the linear part
constexpr double first_gauss_newton_sigma = 500;
constexpr int most_fairings = 6;  ///< linear steps before the first Gauss-Newton step
constexpr int most_trials = 12;   ///< before the step is given up
constexpr int steps_with_mesh_care = 15;
constexpr double flow_tolerance = 1.05;  ///< NUMERICS §10: the semi-implicit fixed point is not the discrete minimum
constexpr int most_dampings = 6;         ///< of the trials of a step, because it would go too far
constexpr double longest_move = 0.3;     ///< of a Gauss-Newton step, in patch radii: further off the fits mean nothing
constexpr double near_move = 1;          ///< in mean edge lengths
constexpr double smooth_unevenness = 0.1;  ///< RimRoughness::unevenness of a smooth surface on a fair mesh is below
constexpr double room_beyond_start = 1;    ///< on all sides, in diagonals of the patch's box
constexpr double room_beyond_fairing = 0.35;
constexpr double newton_tolerance = 1 + 1e-9;
constexpr int rough_passes = 4;        ///< of rim_blend: one of second order, three that weigh the rim
constexpr int most_passes = 12;        ///< of the fairings for position or tangent, which are iterated to their end
constexpr double small_move = 1e-3;    ///< in mean edge lengths: no eye sees it
constexpr double settled_move = 5e-5;  ///< in patch radii: what such a bold step leaves is a few hundredths of it
constexpr double near_the_end_move = 0.05;  ///< in mean edge lengths: the next bold step would go a hundredth of that
constexpr double least_coarsening = 0.7;    ///< of the free vertices
constexpr std::size_t most_coarse_steps = 12;  ///< straight ways take fewer; a longer one may lead to a bubble
constexpr double creeping_move = 1e-2;         ///< in mean edge lengths, with next to no fall of the energy:
constexpr double creeping_fall = 1e-4;         ///< relative; the frozen fits lead no further down
constexpr int most_creeping_steps = 8;         ///< in a row
constexpr double smallest_step = 1e-6;         ///< relative to the step that was asked for: below, the flow has stalled

/// Power of length that the flow's time has: tau in mesh units = tau in the frame × scale^order.
int order_of(FlowKind flow) { return flow == FlowKind::mcf ? 2 : flow == FlowKind::mmcvf ? 6 : 4; }

bool has_energy(FlowKind flow) { return flow == FlowKind::mmcvf || flow == FlowKind::wf; }

EnergyWeights energy_of(const Objective& objective) {
  return objective.flow == FlowKind::wf ? EnergyWeights{0, 1} : EnergyWeights{1, objective.bending};
}

/// The box of the patch, grown by a share of its diagonal.
Eigen::AlignedBox3d room_around(const Patch& patch, double share) {
  Eigen::AlignedBox3d box;
  for (int i = 0; i < patch.free_count; ++i) box.extend(patch.positions[i]);
  for (const auto& loop : patch.loops)
    for (int v : loop) box.extend(patch.positions[v]);
  const Vec3 margin = Vec3::Constant(share * box.diagonal().norm());
  return {box.min() - margin, box.max() + margin};
}

/// How far the middle of the free vertices has come, patch frame: where vertices come and go, the only way to tell.
double way_of_centroid(const Patch& from, const Patch& to) {
  const auto centroid = [](const Patch& patch) {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < patch.free_count; ++i) sum += patch.positions[i];
    return Vec3(sum / patch.free_count);
  };
  return (centroid(from) - centroid(to)).norm();
}

/// What came of one Gauss-Newton solve.
struct GaussNewtonTrial {
  bool accepted = false;
  double move = 0;      ///< largest displacement before the line search, in mean edge lengths; 0 if unsolved
  double promised = 0;  ///< fall of the energy that the quadratic model foresees
};

constexpr const char* stalled_words = "stopped early: no further step lowers the energy without folding the patch";

constexpr const char* collapsed_words = "stopped early: only vanishing time steps keep the flow stable here";

}  // namespace

void check(const EvolutionOptions& options) {
  if (!(options.sigma >= 1e-6 && options.sigma <= 1e8))
    throw InvalidArgument("the time step sigma must lie between 1e-6 and 1e8, not " + std::to_string(options.sigma));
  if (options.bending && !(*options.bending >= 0 && *options.bending <= 1e6))
    throw InvalidArgument("the share of bending energy must lie between 0 and 1e6, not " +
                          std::to_string(*options.bending));
  if (options.max_steps < 1)
    throw InvalidArgument("the number of steps must be at least 1, not " + std::to_string(options.max_steps));
}

const char* to_string(EvolutionStatus status) {
  switch (status) {
    case EvolutionStatus::ready: return "ready";
    case EvolutionStatus::converged: return "converged";
    case EvolutionStatus::step_limit: return "step_limit";
    case EvolutionStatus::cancelled: return "cancelled";
    case EvolutionStatus::failed: return "failed";
  }
  return "";
}

struct Evolution::Impl {
  EvolutionOptions options;
  Patch start;
  EvolutionState state;
  Stencil stencil = Stencil::two_ring;
  Objective objective;
  EvolutionStatus status = EvolutionStatus::ready;
  std::string message;
  std::vector<StepRecord> history;
  double initial_energy = 0;

  Eigen::AlignedBox3d room;  ///< no vertex may leave it: inflating a patch lowers the energy (NUMERICS §9.2)
  int start_folds = 0;
  int allowed_folds = 0;             ///< in between; whoever takes the result looks at what is left
  double start_edge_length = 0;      ///< mean, of the patch
  bool smooth_surroundings = false;  ///< fits of all widths agree on the curvature: it can be trusted to high order
  double blend = 0;                  ///< αR² of the order blend in force
  std::optional<RimRoughness> rim;   ///< of the surroundings; MMCVF to the steady state only
  int blends_left = 0;    ///< linear fairings that are the whole way: on rough rims, or for less than curvature
  double decay_rate = 0;  ///< patch frame
  double sigma = 0;       ///< of the next semi-implicit step; falls on rejection, recovers
  double mu = 0;          ///< of the next Gauss-Newton step
  bool coarse_start_left = false;  ///< the steady state of a coarse copy may still be tried
  int fairings_left = 0;           ///< linear fairing steps that may still be tried before Gauss-Newton
  double last_bold_move = 0;  ///< of the last step, in mean edge lengths, if that was a Gauss-Newton step taken whole
  int creeping_steps = 0;     ///< Gauss-Newton steps in a row that neither move nor gain anything to speak of
  int small_moves = 0;        ///< Gauss-Newton steps in a row that moved nothing to speak of
  double start_measure = 0;   ///< at the last set_options
  double lowest_measure = 0;  ///< since then
  std::unique_ptr<GeneralSolver> general;
  std::unique_ptr<SpdSolver> spd;

  void prepare(Patch first);
  void take_options(const EvolutionOptions& new_options);
  Objective objective_for(const EvolutionOptions& new_options);
  bool acceptable(const EvolutionState& next, double limit) const;
  void accept(EvolutionState next, StepRecord record, const Eigen::VectorXd& s, double used_sigma);
  void care_for_mesh(double limit);
  bool replace_if_good(Patch patch, double limit);
  bool fairing_step(const CancelToken& cancel);
  void blend_step();
  bool coarse_step(const CancelToken& cancel);
  void take_start(EvolutionState next, StepRecord record, double move);
  double decay();
  bool near_the_end() const { return last_bold_move > 0 && last_bold_move < near_the_end_move; }
  bool go_over_to_cubic_fits();
  void finish();
  void gauss_newton_step(const CancelToken& cancel);
  GaussNewtonTrial try_gauss_newton(const GaussNewtonSystem& system, StepRecord& record, const CancelToken& cancel);
  void semi_implicit_step(const CancelToken& cancel);
  double edge_length() const {
    return mean_edge_length(state.patch.positions, state.patch.triangles, state.patch.patch_triangles);
  }
  double radius() const {
    return std::sqrt(patch_area(state.patch) / (std::numbers::pi * static_cast<double>(state.patch.loops.size())));
  }
  void stop(EvolutionStatus why, std::string words) {
    status = why;
    message = std::move(words);
  }
};

void Evolution::Impl::prepare(Patch first) {
  start = std::move(first);
  if (start.free_count == 0) throw InvalidArgument("the patch has no free vertex to evolve");
  for (const Vec3& p : start.positions)
    if (!p.allFinite()) throw InvalidArgument("the patch has a vertex that is not finite");
  room = room_around(start, room_beyond_start);
  state = make_state(start, objective, stencil);
  start_folds = state.folds;
  start_edge_length = edge_length();
}

Objective Evolution::Impl::objective_for(const EvolutionOptions& new_options) {
  blend = 0;
  smooth_surroundings = false;
  stencil = Stencil::two_ring;
  rim.reset();
  blends_left = 0;
  if (new_options.flow != FlowKind::mmcvf || new_options.mode != EvolutionMode::steady) return {new_options.flow, 0};
  rim = rim_roughness(state.patch);
  const double scale = rim->radius * rim->radius;
  if (new_options.continuity != SeamContinuity::curvature) {
    blends_left = most_passes;
    return {new_options.flow, 0};
  }
  const bool automatic = new_options.rim == RimTrust::automatic;
  const bool rough = automatic && !new_options.bending && rim->kind == Surroundings::rough;
  if (rough || new_options.rim == RimTrust::smooth) {
    blends_left = rough_passes;
    blend = rough_bending;
    return {new_options.flow, blend / scale};
  }
  blend = new_options.bending.value_or(automatic ? rim->bending : 0);
  smooth_surroundings = blend == 0 && rim->unevenness < smooth_unevenness;
  return {new_options.flow, blend / scale, energy_reach};
}

void Evolution::Impl::take_options(const EvolutionOptions& new_options) {
  check(new_options);
  options = new_options;
  const Objective wanted = objective_for(options);
  objective = wanted;
  if (!history.empty() || wanted.flow != FlowKind::mmcvf || wanted.bending > 0)
    state = make_state(std::move(state.patch), objective, stencil, state.topology);
  const bool newton = options.mode == EvolutionMode::steady && options.flow == FlowKind::mmcvf;
  allowed_folds = start_folds + (newton ? std::max(2, state.patch.free_count / 200) : 0);
  decay_rate = 0;
  mu = 0;
  sigma = options.mode == EvolutionMode::steady ? steady_sigma : options.sigma;
  small_moves = 0;
  creeping_steps = 0;
  last_bold_move = 0;
  fairings_left = history.empty() && options.start != SteadyStart::as_given ? most_fairings : 0;
  coarse_start_left = history.empty() && newton && options.start == SteadyStart::faired &&
                      options.triangles == PatchTriangles::free && worth_coarsening(state.patch);
  start_measure = lowest_measure = state.measure;
  general = make_general_solver(options.solver);
  spd = make_spd_solver();
  stop(EvolutionStatus::ready, "");
}

/// The slowest decay rate, found when it is first asked for.
double Evolution::Impl::decay() {
  if (decay_rate > 0) return decay_rate;
  decay_rate = slowest_decay_rate(options.flow, state.patch);
  if (!(decay_rate > 0)) decay_rate = 1;
  return decay_rate;
}

bool Evolution::Impl::acceptable(const EvolutionState& next, double limit) const {
  if (!std::isfinite(next.measure) || next.folds > std::max(state.folds, allowed_folds)) return false;
  for (int i = 0; i < next.patch.free_count; ++i)
    if (!room.contains(next.patch.positions[i])) return false;
  return next.measure <= limit;
}

void Evolution::Impl::accept(EvolutionState next, StepRecord record, const Eigen::VectorXd& s, double used_sigma) {
  record.step = static_cast<int>(history.size()) + 1;
  record.max_move = s.cwiseAbs().maxCoeff() / edge_length();
  record.sigma = used_sigma;
  record.tau = used_sigma / decay() * std::pow(state.patch.scale, order_of(options.flow));
  state = std::move(next);
  record.energy = shown_energy(options.flow, state);
  history.push_back(record);
}

bool Evolution::Impl::replace_if_good(Patch patch, double limit) {
  EvolutionState next = make_state(std::move(patch), objective, stencil);
  if (next.folds > state.folds || !(next.measure <= limit)) return false;
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
    if (next.folds < state.folds && std::isfinite(next.measure)) state = std::move(next);
  }
  history.back().energy = shown_energy(options.flow, state);
}

/// A linear fairing instead of a Gauss-Newton step, while it pays: from its result large openings are reached too.
/// @returns false if that does not lower the energy any more; then the state is as it was.
bool Evolution::Impl::fairing_step(const CancelToken& cancel) {
  const bool worn = state.folds > 0 || edge_length() > 1.05 * start_edge_length ||
                    min_angle_deg(state.patch.positions, state.patch.triangles, state.patch.patch_triangles) < 30;
  const FairingMesh mesh = options.triangles == PatchTriangles::kept ? FairingMesh::fixed
                           : worn && !history.empty()                ? FairingMesh::remeshed
                                                                     : FairingMesh::kept;
  FairedState faired = linearly_faired(state, objective, stencil, mesh, options.start, cancel);
  if (!acceptable(faired.state, state.measure)) return false;
  if (faired.state.measure > 0.5 * state.measure && faired.state.folds == 0) fairings_left = 0;
  StepRecord record;
  record.assemble_seconds = faired.assemble_seconds;
  record.solve_seconds = faired.solve_seconds;
  take_start(std::move(faired.state), record, faired.move);
  return true;
}

/// A better start has been found: the way to the steady state goes on from there.
void Evolution::Impl::take_start(EvolutionState next, StepRecord record, double move) {
  state = std::move(next);
  room = room_around(state.patch, room_beyond_fairing);
  record.step = static_cast<int>(history.size()) + 1;
  record.max_move = move / edge_length();
  record.energy = shown_energy(options.flow, state);
  history.push_back(record);
}

/// The steady state of a coarse copy, in place of the linear fairings: near enough for one or two Gauss-Newton steps.
/// @returns false if there was none, or it does not lower the energy; then the state is as it was.
bool Evolution::Impl::coarse_step(const CancelToken& cancel) {
  Stopwatch watch;
  EvolutionOptions coarse_options = options;
  coarse_options.bending = blend;
  Patch copy = coarsened(state.patch);
  // Between tubes there may be nothing to take away; such a copy would ask for a coarse copy of its own, without end.
  if (copy.free_count > least_coarsening * state.patch.free_count) return false;
  Evolution coarse(std::move(copy), coarse_options);
  const Impl& there = *coarse.impl_;
  while (coarse.status() == EvolutionStatus::ready && there.history.size() < most_coarse_steps && !there.near_the_end())
    coarse.step(cancel);
  StepRecord record;
  record.solve_seconds = watch.lap();
  if (coarse.status() != EvolutionStatus::converged && !there.near_the_end()) return false;
  EvolutionState next = make_state(refined(there.state, state.patch.grading), objective, there.stencil);
  record.assemble_seconds = watch.lap();
  if (!acceptable(next, state.measure)) return false;
  if (there.stencil != stencil)
    initial_energy = shown_energy(options.flow, make_state(start, objective, there.stencil));
  stencil = there.stencil;
  decay_rate = there.decay_rate;
  fairings_left = 0;
  take_start(std::move(next), record, way_of_centroid(there.start, there.state.patch));
  return true;
}

/// One linear fairing of those that are the whole way. The first on rough surroundings is of second order, from which the
/// rim vertices are judged.
void Evolution::Impl::blend_step() {
  Stopwatch watch;
  const bool judged = options.continuity == SeamContinuity::curvature;
  const bool first = judged && blends_left == rough_passes;
  const double R = rim->radius;
  Patch patch = state.patch;
  const bool solved = first
                          ? blend_once(patch, SeamContinuity::tangent, {}, R)
                          : blend_once(patch, options.continuity, judged ? rim_trust(patch, R) : Eigen::VectorXd(), R);
  if (!solved) return stop(EvolutionStatus::failed, "stopped early: the patch is too degenerate to be faired");
  StepRecord record;
  record.step = static_cast<int>(history.size()) + 1;
  record.solve_seconds = watch.lap();
  double move = 0;
  for (int i = 0; i < patch.free_count; ++i)
    move = std::max(move, (patch.positions[i] - state.patch.positions[i]).norm());
  record.max_move = move / edge_length();
  --blends_left;
  state = make_state(std::move(patch), objective, stencil, state.topology);
  if (state.folds > start_folds && options.triangles == PatchTriangles::free)
    replace_if_good(remeshed(state.patch), std::numeric_limits<double>::max());
  record.energy = shown_energy(options.flow, state);
  record.assemble_seconds = watch.lap();
  history.push_back(record);
  const bool at_rest = !judged && record.max_move < small_move;
  if (blends_left == 0 || at_rest) stop(EvolutionStatus::converged, "");
}

/// Near the steady state of smooth surroundings: the same energy from fits whose H is more accurate by an order. Not
/// where these find the start better than what came of it: then the mesh is too coarse for them.
bool Evolution::Impl::go_over_to_cubic_fits() {
  if (stencil == Stencil::two_ring_cubic || !smooth_surroundings || state.folds > start_folds) return false;
  const EvolutionState cubic_start = make_state(start, objective, Stencil::two_ring_cubic);
  EvolutionState cubic = make_state(state.patch, objective, Stencil::two_ring_cubic, state.topology);
  if (!(cubic.measure < cubic_start.measure)) {
    smooth_surroundings = false;
    return false;
  }
  stencil = Stencil::two_ring_cubic;
  state = std::move(cubic);
  small_moves = 0;
  creeping_steps = 0;
  initial_energy = shown_energy(options.flow, cubic_start);
  history.back().energy = shown_energy(options.flow, state);
  return true;
}

/// At the minimum: done, unless more accurate fits can still refine it.
void Evolution::Impl::finish() {
  if (!go_over_to_cubic_fits()) stop(EvolutionStatus::converged, "");
}

/// One trial with the present mu: the whole step, a half, a quarter.
GaussNewtonTrial Evolution::Impl::try_gauss_newton(const GaussNewtonSystem& system, StepRecord& record,
                                                   const CancelToken& cancel) {
  Stopwatch watch;
  GaussNewtonTrial trial;
  SparseMatrix A = system.curvature;
  const SparseMatrix M(system.mass.asDiagonal());
  A += mu * M;
  Eigen::MatrixXd s;
  const bool solved = spd->factorize(A) && spd->solve(-system.half_gradient, s);
  record.solve_seconds += watch.lap();
  if (!solved) return trial;
  trial.move = s.cwiseAbs().maxCoeff() / edge_length();
  trial.promised = -system.half_gradient.dot(s.col(0));
  // So far the linear model is worth nothing: more damping first, which smooths what is rough; then a part of the way.
  const double reach = longest_move * radius() / (trial.move * edge_length());
  if (reach < 1 && record.rejections < most_dampings) return trial;
  for (double share : {1.0, 0.5, 0.25}) {
    if (cancel.cancelled()) return trial;
    const Eigen::VectorXd move = std::min(1.0, reach) * share * s.col(0);
    EvolutionState next = displaced(state, objective, stencil, move);
    const bool good = acceptable(next, newton_tolerance * state.measure);
    record.assemble_seconds += watch.lap();
    if (!good) continue;
    accept(std::move(next), record, move, decay() / (2 * mu));
    trial.accepted = true;
    return trial;
  }
  return trial;
}

void Evolution::Impl::gauss_newton_step(const CancelToken& cancel) {
  Stopwatch watch;
  const GaussNewtonSystem system = assemble_gauss_newton(state.patch, state.ops, energy_of(objective));
  StepRecord record;
  record.assemble_seconds = watch.lap();
  if (!(mu > 0)) mu = decay() / (2 * first_gauss_newton_sigma);
  double promised = 0;  // by the first, boldest trial
  for (int k = 0; k < most_trials; ++k) {
    if (cancel.cancelled()) return stop(EvolutionStatus::cancelled, "cancelled");
    const double energy_before = state.measure;
    const GaussNewtonTrial trial = try_gauss_newton(system, record, cancel);
    if (trial.accepted) {
      const double move = history.back().max_move;
      // Gauss-Newton steps shrink ever faster: two bold ones tell how far the next would go.
      const bool next_small = mu <= decay() && record.rejections == 0 && move < 0.1 * last_bold_move &&
                              move * move / last_bold_move < 0.1 * small_move;
      last_bold_move = mu <= decay() && record.rejections == 0 ? move : 0;
      const double settled = std::max(0.1 * small_move, settled_move * radius() / edge_length());
      const bool small = move < settled || next_small;
      small_moves = small ? small_moves + 1 : 0;
      const bool bold = mu <= decay();
      mu = std::max(0.2 * mu, 1e-8 * decay());
      const bool creeping = move < creeping_move && energy_before - state.measure < creeping_fall * energy_before;
      creeping_steps = creeping ? creeping_steps + 1 : 0;
      if ((small && (bold || small_moves >= 3)) || creeping_steps >= most_creeping_steps) return finish();
      if (history.back().max_move < near_move && go_over_to_cubic_fits()) return;
      return care_for_mesh(std::min(1.2 * state.measure, energy_before));
    }
    if (k == 0) promised = trial.promised;
    ++record.rejections;
    if (trial.move > 0 && trial.move < small_move) {
      // The gradient is that of frozen fits, exact to a few percent: close to the minimum it cannot lead further down.
      const bool at_minimum = k == 0 || promised < 1e-2 * energy_before || promised < 1e-6 * start_measure;
      return at_minimum ? finish() : stop(EvolutionStatus::failed, stalled_words);
    }
    mu *= 10;
  }
  if (cancel.cancelled()) return stop(EvolutionStatus::cancelled, "cancelled");
  stop(EvolutionStatus::failed, stalled_words);
}

void Evolution::Impl::semi_implicit_step(const CancelToken& cancel) {
  Stopwatch watch;
  const double wanted = options.mode == EvolutionMode::steady ? steady_sigma : options.sigma;
  const FlowSystem system = assemble_flow(options.flow, FlowState(state.ops, state.patch.free_count));
  SparseMatrix identity(state.patch.free_count, state.patch.free_count);
  identity.setIdentity();
  StepRecord record;
  record.assemble_seconds = watch.lap();
  for (int trial = 0; trial < most_trials; ++trial) {
    if (cancel.cancelled()) return stop(EvolutionStatus::cancelled, "cancelled");
    if (trial == 2 && has_energy(options.flow)) {
      mu = decay() / (2 * sigma);
      sigma = std::min(wanted, 100 * sigma);
      return gauss_newton_step(cancel);
    }
    const double tau = sigma / decay();
    Eigen::VectorXd s;
    const SolveReport report = general->solve(identity - tau * system.jacobian, tau * system.velocity, s);
    record.solve_seconds += watch.lap();
    if (report.solved) {
      EvolutionState next = displaced(state, objective, stencil, s);
      const bool good = acceptable(next, flow_tolerance * lowest_measure);
      record.assemble_seconds += watch.lap();
      if (good) {
        const double used = sigma;
        accept(std::move(next), record, s, used);
        sigma = std::min(wanted, sigma * 3);
        lowest_measure = std::min(lowest_measure, state.measure);
        const bool small = history.back().max_move < small_move * std::min(1.0, used);
        if (small && used >= 0.1 * wanted) return stop(EvolutionStatus::converged, "");
        if (used < smallest_step * wanted) return stop(EvolutionStatus::failed, collapsed_words);
        return care_for_mesh(flow_tolerance * lowest_measure);
      }
    }
    ++record.rejections;
    sigma /= 10;
  }
  stop(EvolutionStatus::failed, collapsed_words);
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
  if (impl_->status == EvolutionStatus::step_limit) impl_->stop(EvolutionStatus::ready, "");
  if (impl_->status != EvolutionStatus::ready) return;
  if (cancel.cancelled()) return impl_->stop(EvolutionStatus::cancelled, "cancelled");
  const bool newton = impl_->options.mode == EvolutionMode::steady && impl_->options.flow == FlowKind::mmcvf;
  if (!newton) return impl_->semi_implicit_step(cancel);
  if (impl_->blends_left > 0) return impl_->blend_step();
  if (std::exchange(impl_->coarse_start_left, false)) {
    if (impl_->coarse_step(cancel)) return;
    if (cancel.cancelled()) return impl_->stop(EvolutionStatus::cancelled, "cancelled");
  }
  if (impl_->fairings_left-- > 0) {
    if (impl_->fairing_step(cancel)) return;
    impl_->fairings_left = 0;
  }
  impl_->gauss_newton_step(cancel);
}

EvolutionStatus Evolution::run(const OnStep& on_step, const CancelToken& cancel) {
  for (int k = 0; k < impl_->options.max_steps; ++k) {
    const std::size_t before = impl_->history.size();
    step(cancel);
    if (on_step && impl_->history.size() > before) on_step(*this, impl_->history.back());
    if (impl_->status != EvolutionStatus::ready) return impl_->status;
  }
  impl_->stop(EvolutionStatus::step_limit,
              "stopped after " + std::to_string(impl_->options.max_steps) + " steps, before the steady state");
  return impl_->status;
}

void Evolution::set_options(const EvolutionOptions& options) { impl_->take_options(options); }
const Patch& Evolution::patch() const { return impl_->state.patch; }
const EvolutionOptions& Evolution::options() const { return impl_->options; }
EvolutionStatus Evolution::status() const { return impl_->status; }
const std::string& Evolution::message() const { return impl_->message; }
const std::vector<StepRecord>& Evolution::history() const { return impl_->history; }
double Evolution::initial_energy() const { return impl_->initial_energy; }
double Evolution::bending() const { return impl_->blend; }
const std::optional<RimRoughness>& Evolution::roughness() const { return impl_->rim; }
double Evolution::energy() const { return shown_energy(impl_->options.flow, impl_->state); }

}  // namespace loopmend
