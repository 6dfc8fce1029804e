// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/attempt.h"

#include "core/threads.h"
#include "mesh/quality.h"
#include "rim/white_noise.h"

namespace loopmend {

namespace {

/// A single vertex off its place is of no account a few edges away.
double reach_of_outliers(const Patch& initial) {
  return mean_edge_length(initial.positions, initial.triangles, initial.patch_triangles);
}

/// What the flow sets out from, between the boundary data that it is to meet.
Patch with_boundary_data(const PatchProblem& problem, const BoundaryData& boundary, const Patch& start) {
  if (boundary.noise_share > 0) return without_noise(start, problem.scan.model, boundary.noise_share);
  if (boundary.calm == nullptr) return start;
  return with_noise_again(start, boundary.calm->patch, reach_of_outliers(problem.initial));
}

/// What it came to, between the neighborhood as it is.
Patch with_scan_data(const PatchProblem& problem, const BoundaryData& boundary, const Patch& evolved) {
  if (boundary.noise_share > 0) return with_noise_again(evolved, problem.initial);
  if (boundary.calm == nullptr) return evolved;
  return with_noise_again(evolved, problem.initial, reach_of_outliers(problem.initial));
}

}  // namespace

std::string message_on_outliers(const BoundaryData& boundary) {
  if (boundary.calm == nullptr) return "";
  return boundary.calm->strays == 1
             ? "one boundary vertex is an outlier: the patch meets it, but does not take its curvature from it"
             : std::to_string(boundary.calm->strays) +
                   " boundary vertices are outliers: the patch meets them, but does not take its curvature from them";
}

bool run_once(const AttemptContext& context, const Patch& start, const EvolutionOptions& options, PatchResult& result) {
  const PatchProblem& problem = context.problem;
  Evolution evolution(with_boundary_data(problem, context.boundary, start), options);
  const PatchStatus status = evolution.run(context.on_step, context.cancel);
  take_figures(evolution, result);
  if (status == PatchStatus::cancelled) return false;
  if (status == PatchStatus::stalled && evolution.history().empty()) {
    result.message = "the flow could not start: " + evolution.message();
    return false;
  }
  Patch patch = with_scan_data(problem, context.boundary, evolution.patch());
  Validity validity;
  std::vector<SeamReport> seams;
  parallel_invoke([&] { validity = validate(problem.scan, patch); }, [&] { seams = seam_reports(patch); });
  if (!validity.is_clean() && !no_worse(validity, validate(problem.scan, problem.initial))) {
    result.message = "the flow would have folded the patch or cut the surface";
    return false;
  }
  result.patch = std::move(patch);
  result.validity = std::move(validity);
  result.seams = std::move(seams);
  result.status = status;
  result.method = context.boundary.noise_share > 0 ? Method::denoised_flow : evolution.method();
  result.message = evolution.message().empty() ? message_on_outliers(context.boundary) : evolution.message();
  return true;
}

}  // namespace loopmend
