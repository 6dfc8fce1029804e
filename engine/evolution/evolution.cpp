// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/evolution.h"

#include "core/error.h"
#include "evolution/multilevel.h"
#include "evolution/robust_fairing.h"
#include "evolution/semi_implicit.h"

#include <cmath>

namespace loopmend {

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
  constexpr const char* how = "; --boundary exact runs the flow itself";
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

namespace {

constexpr double smooth_unevenness = 0.1;  ///< RimRoughness::unevenness of a smooth surface on a fair mesh is below

/// What the options and the boundary data lead to.
struct Plan {
  Method method = Method::flow;
  Objective objective;
  double bending = 0;                     ///< β in force
  std::optional<RimRoughness> roughness;  ///< MMCVF to the steady state only
};

bool to_steady_mmcvf(const EvolutionOptions& options) {
  return options.flow == FlowKind::mmcvf && options.mode == EvolutionMode::steady;
}

Plan plan_for(const EvolutionOptions& options, const Patch& patch) {
  Plan plan;
  plan.objective.flow = options.flow;
  if (!to_steady_mmcvf(options)) return plan;
  plan.roughness = options.roughness ? options.roughness : rim_roughness(patch);
  const double scale = plan.roughness->radius * plan.roughness->radius;
  const bool automatic = options.boundary == BoundaryTrust::automatic;
  const bool rough = automatic && !options.bending && plan.roughness->kind == Surroundings::rough;
  if (options.continuity != SeamContinuity::curvature) {
    plan.method = Method::linear_fairing;
  } else if (rough || options.boundary == BoundaryTrust::robust) {
    plan.method = Method::robust_fairing;
    plan.bending = rough_bending;
  } else {
    plan.bending = options.bending.value_or(automatic ? plan.roughness->bending : 0);
    if (plan.bending > 0) plan.method = Method::mixed_order;
    plan.objective.reach = energy_reach;
  }
  if (plan.bending > 0) plan.objective.bending = plan.bending / scale;
  return plan;
}

std::unique_ptr<Stepper> stepper_for(const Plan& plan, const EvolvingPatch& patch) {
  if (!plan.roughness) return std::make_unique<SemiImplicit>(patch);
  if (plan.method == Method::linear_fairing || plan.method == Method::robust_fairing)
    return std::make_unique<RobustFairing>(patch, plan.roughness->radius);
  const bool smooth = plan.bending == 0 && plan.roughness->unevenness < smooth_unevenness;
  return std::make_unique<Multilevel>(patch, smooth ? NearConvergence::cubic_fits : NearConvergence::quadratic_fits);
}

}  // namespace

struct Evolution::Impl {
  EvolvingPatch patch;
  Plan plan;
  std::unique_ptr<Stepper> stepper;

  void begin(const EvolutionOptions& options) {
    check(options);
    plan = plan_for(options, patch.state.patch);
    patch.begin(options, plan.objective);
    stepper = stepper_for(plan, patch);
  }
};

Evolution::Evolution(Patch start, EvolutionOptions options) {
  check(options);
  impl_ = std::make_unique<Impl>(Impl{EvolvingPatch(std::move(start)), {}, nullptr});
  impl_->begin(options);
  impl_->patch.initial_energy = energy();
}

Evolution::~Evolution() = default;
Evolution::Evolution(Evolution&&) noexcept = default;
Evolution& Evolution::operator=(Evolution&&) noexcept = default;

void Evolution::step(const CancelToken& cancel) {
  EvolvingPatch& patch = impl_->patch;
  if (patch.status == PatchStatus::step_limit) patch.stop(PatchStatus::ready, "");
  if (patch.status == PatchStatus::ready && !patch.stop_if(cancel)) impl_->stepper->step(patch, cancel);
}

PatchStatus Evolution::run(const OnStep& on_step, const CancelToken& cancel) {
  EvolvingPatch& patch = impl_->patch;
  for (int k = 0; k < patch.options.max_steps; ++k) {
    const std::size_t before = patch.history.size();
    step(cancel);
    if (on_step && patch.history.size() > before) on_step(*this, patch.history.back());
    if (patch.status != PatchStatus::ready) return patch.status;
  }
  patch.stop(PatchStatus::step_limit,
             "stopped after " + std::to_string(patch.options.max_steps) + " steps, before the steady state");
  return patch.status;
}

void Evolution::set_options(const EvolutionOptions& options) { impl_->begin(options); }
const Patch& Evolution::patch() const { return impl_->patch.state.patch; }
const EvolutionOptions& Evolution::options() const { return impl_->patch.options; }
PatchStatus Evolution::status() const { return impl_->patch.status; }
const std::string& Evolution::message() const { return impl_->patch.message; }
const std::vector<StepRecord>& Evolution::history() const { return impl_->patch.history; }
double Evolution::initial_energy() const { return impl_->patch.initial_energy; }
double Evolution::energy() const { return impl_->patch.energy(); }
Method Evolution::method() const { return impl_->plan.method; }
double Evolution::bending() const { return impl_->plan.bending; }
const std::optional<RimRoughness>& Evolution::roughness() const { return impl_->plan.roughness; }

}  // namespace loopmend
