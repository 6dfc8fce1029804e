// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/rough_neighborhood.h"

#include "evolution/state.h"
#include "pipeline/local_rollback.h"
#include "rim/rim_blend.h"

#include <algorithm>

namespace loopmend {

namespace {

/// Those of the linear fairings for rough neighborhoods, whatever share the neighborhood asks for.
EvolutionOptions robust_options(EvolutionOptions options, const RimRoughness& roughness) {
  options.boundary = BoundaryTrust::robust;
  options.roughness = roughness;
  return options;
}

/// The share of the robust patch, raised where the literal one strays from it: sixth order that goes far from what the
/// neighborhood allows has been led astray by its roughness.
double share_between(const Patch& literal, const Patch& robust, const RimRoughness& roughness) {
  constexpr double near = 0.1, astray = 0.3;  // of the patch's radius
  double way = 0;
  for (int i = 0; i < literal.free_count; ++i) way = std::max(way, (literal.positions[i] - robust.positions[i]).norm());
  const double trust = std::clamp((astray - way / roughness.radius) / (astray - near), 0.0, 1.0);
  return 1 - (1 - roughness.rough_share) * trust;
}

double energy_of(const Patch& patch, FlowKind flow) {
  return shown_energy(flow, make_state(patch, {flow, 0}, Stencil::two_ring, nullptr, Fits::curvatures));
}

/// Both patches on the initial patch's vertices, and the interpolation between them. The robust one alone where that does
/// not exist, or the mesh had to be changed. @returns false if neither may be kept.
bool interpolate_to_flow(const AttemptContext& context, const Patch& start, const EvolutionOptions& options,
                         const RimRoughness& roughness, PatchResult& result) {
  const AttemptContext plain{context.problem, {}, context.on_step, context.cancel};
  if (!run_once(plain, start, robust_options(options, roughness), result)) return false;
  EvolutionOptions literal_options = options;
  literal_options.bending = (1 - context.boundary.noise_share) * roughness.bending;
  literal_options.triangles = PatchTriangles::kept;
  PatchResult literal;
  if (!run_once(context, start, literal_options, literal)) return true;
  if (literal.patch.free_count != result.patch.free_count) return true;
  const Eigen::VectorXd trust = rim_trust(result.patch, roughness.radius, data_trust(result.patch, roughness.radius));
  const double share = share_between(literal.patch, result.patch, roughness);
  Patch patch = passage_between(literal.patch, result.patch, share, trust);
  Validity validity = validate(context.problem.scan, patch);
  if (!no_worse(validity, result.validity)) return true;
  result.patch = std::move(patch);
  result.validity = std::move(validity);
  result.seams = seam_reports(result.patch);
  result.method = Method::interpolated;
  if (result.message.empty()) result.message = message_on_outliers(context.boundary);
  result.steps += literal.steps;
  result.seconds.assemble += literal.seconds.assemble;
  result.seconds.solve += literal.seconds.solve;
  result.bending = share * result.bending + (1 - share) * literal.bending;
  result.energy.final = energy_of(result.patch, options.flow);
  return true;
}

bool roll_back(const AttemptContext& context, const Patch& start, const EvolutionOptions& options,
               PatchResult& result) {
  Evolution evolution(start, options);
  const PatchStatus status = evolution.run(context.on_step, context.cancel);
  if (status == PatchStatus::cancelled || status == PatchStatus::stalled) return false;
  const PatchProblem& problem = context.problem;
  std::optional<LocalRollback> rollback = roll_back_locally(problem.scan, start, evolution.patch(),
                                                            validate(problem.scan, problem.initial), context.cancel);
  if (!rollback) return false;
  take_figures(evolution, result);
  result.patch = std::move(rollback->patch);
  result.validity = std::move(rollback->validity);
  result.seams = seam_reports(result.patch);
  result.status = status;
  result.method = evolution.method();
  result.energy.final = energy_of(result.patch, options.flow);
  result.message = rollback->moved == 0
                       ? ""
                       : "the patch would have folded or cut the surface at a few places: there, at " +
                             std::to_string(rollback->moved) + " of its " + std::to_string(result.patch.free_count) +
                             " vertices, it goes back towards what it set out from";
  return true;
}

}  // namespace

std::optional<JudgedNeighborhood> judge_neighborhood(const PatchProblem& problem, const EvolutionOptions& options) {
  if (!is_judged(options)) return std::nullopt;
  const Patch& initial = problem.initial;
  CalmSurroundings calm =
      problem.survey != nullptr ? without_strays(initial, problem.survey->strays) : without_strays(initial);
  if (calm.strays > 0) {
    const RimRoughness roughness = rim_roughness(calm.patch);
    // White noise is taken off by robust fits, and the rough patch doubts its rim, each with the outliers in it.
    if (roughness.noise_share == 0 && roughness.rough_share < 1) return JudgedNeighborhood{roughness, std::move(calm)};
  }
  return JudgedNeighborhood{options.roughness ? *options.roughness : rim_roughness(initial), std::nullopt};
}

bool run_robustly(const AttemptContext& context, const Patch& start, const EvolutionOptions& options,
                  const RimRoughness& roughness, PatchResult& result) {
  if (roughness.rough_share < 1) return interpolate_to_flow(context, start, options, roughness, result);
  const AttemptContext plain{context.problem, {}, context.on_step, context.cancel};
  return run_once(plain, start, robust_options(options, roughness), result);
}

bool run_with_rollback(const AttemptContext& context, const Patch& start, const EvolutionOptions& options,
                       const RimRoughness& roughness, PatchResult& result) {
  for (const PatchTriangles triangles : {PatchTriangles::kept, PatchTriangles::fixed}) {
    EvolutionOptions same_vertices = robust_options(options, roughness);
    same_vertices.triangles = triangles;
    if (roll_back(context, start, same_vertices, result)) return true;
  }
  return false;
}

}  // namespace loopmend
