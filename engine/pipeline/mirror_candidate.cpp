// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/mirror_candidate.h"

#include <algorithm>
#include <cmath>

namespace loopmend {

namespace {

constexpr const char* mirror_name = text_to_say("mirror image");

/// ln(rms / D) = intercept + slope ln(misfit), and quantiles of the residuals: least squares over 64 holes of 11 models
/// (docs/math/mirror_image.md, "How far off").
constexpr double mirror_intercept = -1.115, mirror_slope = 0.823;
constexpr double mirror_half = -0.034, mirror_likely = 0.544, mirror_most = 0.872;
constexpr double least_mirror_misfit = 5e-4;  ///< below, the copy is as good as the meshes of both sides are

bool is_of_shape(NoticeCode code) {
  return code == NoticeCode::bubble || code == NoticeCode::high_over_loop || code == NoticeCode::dome_over_flat_loop ||
         code == NoticeCode::curvature_torn;
}

void drop_findings_on_shape(std::vector<Verdict>& verdicts) {
  for (Verdict& verdict : verdicts) {
    std::erase_if(verdict.findings, [](const Notice& finding) { return is_of_shape(finding.code); });
    verdict.grade = Grade::good;
    for (const Notice& finding : verdict.findings)
      verdict.grade = std::max(verdict.grade, finding.code == NoticeCode::crease ? Grade::look : Grade::bad);
  }
}

}  // namespace

PatchResult mirrored_patch(const PatchProblem& problem, const EvolutionOptions& options, const CancelToken& cancel) {
  const Judge judge(problem.initial, {}, Judge::Creases::unwanted);
  PatchResult result;
  result.flow = options.flow;
  result.attempts = {mirror_name};
  const auto is_sound = [&](const Patch& patch) {
    result.validity = validate(problem.scan, patch);
    result.seams = seam_reports(patch);
    result.verdicts = judge(patch, result.validity, result.seams);
    drop_findings_on_shape(result.verdicts);
    return worst(result.verdicts) != Grade::bad;
  };
  MirrorPatch made =
      mirror_patch(problem.scan.model, problem.scan.index, problem.initial, *problem.mirror_planes, is_sound, cancel);
  result.mirror = made.fit;
  result.reason = message_of(notice_on(made.fit));
  if (!made.patch) return result;
  result.status = PatchStatus::faired;
  result.method = Method::mirror_image;
  result.made_by = mirror_name;
  result.patch = std::move(*made.patch);
  result.seams_before = judge.initial_seams();
  return result;
}

ExpectedDeviation expected_mirror_deviation(double misfit) {
  const double usual = std::exp(mirror_intercept + mirror_slope * std::log(std::max(misfit, least_mirror_misfit)));
  return {usual * std::exp(mirror_half), usual * std::exp(mirror_likely), usual * std::exp(mirror_most), 0};
}

DeviationEstimate expected_mirror_deviation(const PatchResult& result) {
  DeviationEstimate estimate;
  ExpectedDeviation& bounds = estimate.loops.emplace_back(expected_mirror_deviation(result.mirror.misfit));
  const double diameter = loop_diameter(result.patch, 0) * result.patch.scale;
  for (double* bound : {&bounds.half, &bounds.likely, &bounds.most}) *bound *= diameter;
  estimate.vertices.assign(result.patch.free_count, bounds.likely);
  return estimate;
}

}  // namespace loopmend
