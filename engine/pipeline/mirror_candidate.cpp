// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/mirror_candidate.h"

#include "mesh/surface_tree.h"
#include "mirror/symmetric_patch.h"

#include <algorithm>
#include <cmath>

namespace loopmend {

namespace {

constexpr const char* mirror_name = text_to_say("mirror image");

/// ln(rms / D) = intercept + slope_δ ln(difference) + slope_s ln(bend of the seam), and quantiles of the residuals:
/// least squares over 106 copies of 15 models (docs/math/mirror_image.md, "How far off").
constexpr double mirror_intercept = -6.73, difference_slope = 0.174, seam_slope = 0.909;
constexpr double mirror_half = -0.097, mirror_likely = 1.008, mirror_most = 1.432;
constexpr double least_difference_known = 1e-3, least_seam_deg = 0.5;  ///< the fit knows no smaller ones
/// Of the copy from the ordinary patch, in misfits: where it is less, noise and asymmetry may be all of it
/// (docs/math/mirror_image.md, "The test").
constexpr double least_difference = 3;
constexpr double most_misfit_of_deviation = 0.5;  ///< where it differs less: of what the ordinary patch is likely off

bool is_of_shape(NoticeCode code) {
  return code == NoticeCode::bubble || code == NoticeCode::high_over_loop || code == NoticeCode::dome_over_flat_loop ||
         code == NoticeCode::curvature_torn || code == NoticeCode::bent_inside;
}

/// Of the copy from the other patch, in diameters: rms over the area.
double difference(const Patch& copy, const Patch& other) {
  const SurfaceTree tree(other.positions, {other.triangles.begin(), other.triangles.begin() + other.patch_triangles});
  double squares = 0, area = 0;
  for (int f = 0; f < copy.patch_triangles; ++f) {
    const auto& [a, b, c] = copy.triangles[f];
    const Vec3 &p = copy.positions[a], &q = copy.positions[b], &r = copy.positions[c], middle = (p + q + r) / 3;
    const double own = (q - p).cross(r - p).norm();
    area += own;
    squares += own * (tree.closest(middle).place - middle).squaredNorm();
  }
  return std::sqrt(squares / area) / loop_diameter(copy, 0);
}

/// The bound within which half of all patches of this kind are, in diameters; 0 where it is not known.
double usual_deviation(const PatchResult& result, const CancelToken& cancel) {
  if (result.method != Method::flow && result.method != Method::split_flow && result.method != Method::robust_fairing)
    return 0;
  const DeviationEstimate deviation = expected_deviation(result.patch, result.seams, result.seams_before, cancel);
  return deviation.loops.empty() ? 0 : deviation.loops[0].half / (loop_diameter(result.patch, 0) * result.patch.scale);
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
  const AttemptContext context{problem, nullptr, judge, {}, cancel};
  const auto is_sound = [&](const Patch& patch) {
    result.patch = patch;
    result.validity = validate(problem.scan, patch);
    result.seams = seam_reports(patch);
    result.verdicts = judge(patch, result.validity, result.seams);
    open_folds(context, options.flow, result);
    drop_findings_on_shape(result.verdicts);
    return worst(result.verdicts) != Grade::bad;
  };
  result.mirror =
      mirror_patch(problem.scan.model, problem.scan.index, problem.initial, *problem.mirror_planes, is_sound, cancel);
  result.reason = message_of(notice_on(result.mirror));
  if (!result.mirror.is_proposed()) return result;
  result.status = PatchStatus::faired;
  result.method = Method::mirror_image;
  result.made_by = mirror_name;
  result.seams_before = judge.initial_seams();
  return result;
}

bool is_copied(const PatchResult& ordinary, const CancelToken& cancel, PatchResult& copy) {
  MirrorFit& fit = copy.mirror;
  fit.difference = difference(copy.patch, ordinary.patch);
  if (is_filled(ordinary.status) && worst(ordinary.verdicts) != Grade::bad &&
      !(fit.difference > least_difference * fit.misfit) &&
      !(fit.misfit < most_misfit_of_deviation * usual_deviation(ordinary, cancel)))
    fit.answer = MirrorFit::Answer::no_gain;
  return fit.is_proposed();
}

void make_symmetric(const PatchProblem& problem, const Judge& judge, const CancelToken& cancel, PatchResult& result) {
  if (result.mirror.answer != MirrorFit::Answer::across || !is_filled(result.status)) return;
  if (!(result.mirror.misfit < usual_deviation(result, cancel))) return;
  std::optional<Patch> symmetric =
      symmetric_patch(problem.scan.model, problem.scan.index, result.patch, result.mirror.plane, cancel);
  if (!symmetric) return;
  const Validity validity = validate(problem.scan, *symmetric);
  const std::vector<SeamReport> seams = seam_reports(*symmetric);
  const std::vector<Verdict> verdicts = judge(*symmetric, validity, seams);
  if (faults(result.verdicts) < faults(verdicts) || worst(result.verdicts) < worst(verdicts)) return;
  result.patch = std::move(*symmetric);
  result.validity = validity;
  result.seams = seams;
  result.verdicts = verdicts;
  result.energy.final = energy_of(result.patch, result.flow);
  result.status = PatchStatus::faired;
  result.mirror.answer = MirrorFit::Answer::symmetric;
}

ExpectedDeviation expected_mirror_deviation(double difference, double seam_deg, double misfit) {
  const double fitted =
      std::exp(mirror_intercept + difference_slope * std::log(std::max(difference, least_difference_known)) +
               seam_slope * std::log(std::max(seam_deg, least_seam_deg)));
  const double usual = std::max(fitted, misfit * std::exp(-mirror_likely));
  return {usual * std::exp(mirror_half), usual * std::exp(mirror_likely), usual * std::exp(mirror_most), {}};
}

DeviationEstimate expected_mirror_deviation(const PatchResult& result) {
  DeviationEstimate estimate;
  ExpectedDeviation& bounds = estimate.loops.emplace_back(
      expected_mirror_deviation(result.mirror.difference, result.seams[0].g1_rms_deg, result.mirror.misfit));
  const double diameter = loop_diameter(result.patch, 0) * result.patch.scale;
  for (double* bound : {&bounds.half, &bounds.likely, &bounds.most}) *bound *= diameter;
  estimate.vertices.assign(result.patch.free_count, bounds.likely);
  return estimate;
}

}  // namespace loopmend
