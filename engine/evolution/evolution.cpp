// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/evolution.h"

#include "core/error.h"
#include "evolution/multilevel.h"
#include "evolution/robust_fairing.h"
#include "evolution/semi_implicit.h"
#include "evolution/split_descent.h"
#include "operators/curvature_energy.h"

#include <cmath>

namespace loopmend {

void check(const EvolutionOptions& options) {
  if (!(options.sigma >= 1e-6 && options.sigma <= 1e8))
    throw InvalidArgument(say("the time step sigma must lie between 1e-6 and 1e8, not %1", options.sigma));
  if (options.bending && !(*options.bending >= 0 && *options.bending <= 1e6))
    throw InvalidArgument(say("the share of bending energy must lie between 0 and 1e6, not %1", *options.bending));
  if (options.max_steps < 1)
    throw InvalidArgument(say("the number of steps must be at least 1, not %1", options.max_steps));
}

bool is_judged(const EvolutionOptions& options) {
  return options.flow == FlowKind::mmcvf && options.mode == EvolutionMode::steady &&
         options.boundary == BoundaryTrust::automatic && !options.bending &&
         options.continuity == SeamContinuity::curvature;
}

bool continues_edges(const EvolutionOptions& options) {
  return is_judged(options) && options.edges == SharpEdges::continued;
}

Message reason_for(const SplitEstimate& estimate, Method method) {
  const bool is_known = std::isfinite(estimate.relief_height), is_noisy = estimate.kind() == NeighborhoodKind::noisy;
  Message scan = !is_known  ? say("the scan around the hole does not tell shape from relief")
                 : is_noisy ? say("the scan around the hole is noisy")
                            : say("the scan around the hole has relief");
  Message reason;
  if (method == Method::split_flow) reason = say("%1: the flow runs on the smooth surface under it", std::move(scan));
  if (method == Method::robust_fairing) reason = say("%1, so that its curvature counts little", std::move(scan));
  if (reason.empty()) return {};
  return joined(std::move(reason), "; ", say("--boundary exact runs the flow itself"))
      .with_code(!is_known  ? "relief_unknown"
                 : is_noisy ? "noisy"
                            : "relief");
}

std::string method_name(Method method, FlowKind flow) {
  const std::string name = to_string(flow);
  switch (method) {
    case Method::initial_patch: return "initial_patch";
    case Method::flow: return name;
    case Method::split_flow: return name + "_split";
    case Method::mixed_order: return name + "_mixed_order";
    case Method::robust_fairing: return "robust_fairing";
    case Method::sharp_edges: return "sharp_edges";
    case Method::straight_base: return "straight_base";
    case Method::sphere: return "sphere";
    case Method::linear_fairing: return "linear_fairing";
    case Method::mirror_image: return "mirror_image";
  }
  return "";
}

namespace {

/// Free vertices: above, the matrices of the split, twice as large, take too long, and robust fairing stands in.
constexpr int most_split = 30'000;

/// What the options and the boundary data lead to.
struct Plan {
  Method method = Method::flow;
  Objective objective;
  double bending = 0;                  ///< β in force
  double radius = 0;                   ///< of the patch, see patch_radius(); 0: not asked for
  std::optional<SplitEstimate> split;  ///< MMCVF to the steady state only
};

bool to_steady_mmcvf(const EvolutionOptions& options) {
  return options.flow == FlowKind::mmcvf && options.mode == EvolutionMode::steady;
}

/// Where the boundary data decide.
Method method_for(const SplitEstimate& split, double literal_relief, const Patch& patch) {
  if (split.is_exact(literal_relief)) return Method::flow;
  return patch.free_count <= most_split ? Method::split_flow : Method::robust_fairing;
}

Method method_for(const EvolutionOptions& options, const SplitEstimate& split, const Patch& patch) {
  if (options.continuity != SeamContinuity::curvature) return Method::linear_fairing;
  if (options.boundary == BoundaryTrust::robust) return Method::robust_fairing;
  if (options.bending.value_or(0) > 0) return Method::mixed_order;
  return is_judged(options) ? method_for(split, options.literal_relief, patch) : Method::flow;
}

Plan plan_for(const EvolutionOptions& options, const Patch& patch) {
  Plan plan;
  plan.objective.flow = options.flow;
  if (!to_steady_mmcvf(options)) return plan;
  plan.radius = patch_radius(patch);
  plan.split = options.split ? options.split : estimate_split(patch);
  plan.method = method_for(options, *plan.split, patch);
  if (plan.method == Method::robust_fairing) plan.bending = rough_bending;
  if (plan.method == Method::mixed_order) plan.bending = *options.bending;
  if (plan.method != Method::robust_fairing && plan.method != Method::linear_fairing)
    plan.objective.reach = energy_reach;
  plan.objective.bending = plan.bending / (plan.radius * plan.radius);
  return plan;
}

std::unique_ptr<Stepper> stepper_for(const Plan& plan, const EvolvingPatch& patch) {
  if (!plan.split) return std::make_unique<SemiImplicit>(patch);
  if (plan.method == Method::linear_fairing || plan.method == Method::robust_fairing)
    return std::make_unique<RobustFairing>(patch, plan.radius);
  if (plan.method == Method::split_flow) return std::make_unique<SplitDescent>(patch, *plan.split, plan.radius);
  const bool smooth = plan.bending == 0 && plan.split->is_exact(SplitEstimate::exact_construction);
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
  if (patch.status == PatchStatus::step_limit) patch.stop(PatchStatus::ready);
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
             say("stopped after %1 steps, before the steady state", patch.options.max_steps).with_code("step_limit"));
  return patch.status;
}

void Evolution::set_options(const EvolutionOptions& options) { impl_->begin(options); }
const Patch& Evolution::patch() const { return impl_->patch.state.patch; }
const EvolutionOptions& Evolution::options() const { return impl_->patch.options; }
PatchStatus Evolution::status() const { return impl_->patch.status; }
const Message& Evolution::message() const { return impl_->patch.message; }
const std::vector<StepRecord>& Evolution::history() const { return impl_->patch.history; }
double Evolution::initial_energy() const { return impl_->patch.initial_energy; }
double Evolution::energy() const { return impl_->patch.energy(); }
Method Evolution::method() const {
  const EvolvingPatch& patch = impl_->patch;
  if (impl_->plan.method != Method::split_flow || !is_at_end(patch.status) || patch.history.empty() ||
      patch.history.back().split.total() > 0)
    return impl_->plan.method;
  return patch.status == PatchStatus::faired ? Method::robust_fairing
                                             : Method::flow;  // no step of the split came below
}
double Evolution::bending() const { return impl_->plan.bending; }
const std::optional<SplitEstimate>& Evolution::split() const { return impl_->plan.split; }

}  // namespace loopmend
