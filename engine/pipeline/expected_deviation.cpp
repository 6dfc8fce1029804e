// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/expected_deviation.h"

#include "neighborhood/weighted_fairing.h"
#include "operators/operator_set.h"
#include "pipeline/validate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace loopmend {

namespace {

/// ln(rms / D) = the product of these and the regressors, and quantiles of the residuals: least squares over 473 holes of the 17
/// models of the tuning half of loopmend_cut_models, by loopmend_error_bar (docs/benchmarks/accuracy.md, "Error bar").
constexpr std::array coefficients{-5.119, 0.235, 0.734, 0.571, 0.345};
constexpr double half_quantile = 0.017, likely_quantile = 0.490, most_quantile = 0.757;
constexpr double least_difference = 1e-5;  ///< in loop diameters: below it, differences are of the fairing
constexpr double least_area = 1e-4;
/// Below it, bends at the seam are of the triangles, and vanish on a finer mesh.
constexpr double least_seam_deg = 2;
/// Of a vertex, its deviation grows with this power of its own difference (docs/math/filling.md, "Validity checks").
constexpr double power_at_vertex = 0.4;

double usual_deviation(const DeviationPredictors& predictors) {
  const std::array x = regressors(predictors);
  return std::exp(std::inner_product(x.begin(), x.end(), coefficients.begin(), 0.0));
}

}  // namespace

std::array<double, 5> regressors(const DeviationPredictors& predictors) {
  return {1, std::log(std::max(predictors.second_order, least_difference)),
          std::log(std::max(predictors.area, least_area)), std::log(std::max(predictors.seam_deg, least_seam_deg)),
          std::log(std::max(predictors.initial_seam_deg, least_seam_deg))};
}

ExpectedDeviation expected_deviation(const DeviationPredictors& predictors) {
  const double usual = usual_deviation(predictors);
  return {usual * std::exp(half_quantile), usual * std::exp(likely_quantile), usual * std::exp(most_quantile),
          predictors};
}

DeviationEstimate expected_deviation(const Patch& patch, const std::vector<SeamReport>& seams,
                                     const std::vector<SeamReport>& initial_seams, const CancelToken& cancel) {
  DeviationEstimate estimate;
  const std::size_t loops = patch.loops.size();
  if (patch.free_count == 0 || seams.size() != loops || initial_seams.size() != loops) return estimate;
  Patch faired = patch;
  if (!blend_once(faired, SeamContinuity::tangent, {}, 1, cancel)) return estimate;
  const Eigen::VectorXd mass = barycentric_areas(patch.positions, patch.triangles);
  const std::vector<int> loop_of = loop_of_free_vertices(patch);
  std::vector<double> diameter(loops), whole_area(loops), area(loops), squares(loops), deviations(loops);
  for (std::size_t l = 0; l < loops; ++l) diameter[l] = loop_diameter(patch, l);
  const std::vector<int> loop_of_triangle = loop_of_triangles(patch);
  for (int f = 0; f < patch.patch_triangles; ++f) {
    const auto& [a, b, c] = patch.triangles[f];
    const Vec3 &p = patch.positions[a], &q = patch.positions[b], &r = patch.positions[c];
    whole_area[loop_of_triangle[f]] += (q - p).cross(r - p).norm() / 2 / std::pow(diameter[loop_of_triangle[f]], 2);
  }
  estimate.vertices.resize(patch.free_count);
  for (int v = 0; v < patch.free_count; ++v) {
    const int l = loop_of[v];
    const double difference = (patch.positions[v] - faired.positions[v]).norm() / diameter[l];
    estimate.vertices[v] = std::pow(std::max(difference, least_difference), power_at_vertex);
    area[l] += mass[v];
    squares[l] += mass[v] * difference * difference;
    deviations[l] += mass[v] * estimate.vertices[v] * estimate.vertices[v];
  }
  for (std::size_t l = 0; l < loops; ++l) {
    ExpectedDeviation& bounds = estimate.loops.emplace_back();
    const bool is_measured = seams[l].g1_rms_deg >= 0 && initial_seams[l].g1_rms_deg >= 0;  // NaN: at no vertex
    if (!(area[l] > 0) || !is_measured) continue;
    bounds = expected_deviation(
        {std::sqrt(squares[l] / area[l]), whole_area[l], seams[l].g1_rms_deg, initial_seams[l].g1_rms_deg});
    for (double* bound : {&bounds.half, &bounds.likely, &bounds.most}) *bound *= diameter[l] * patch.scale;
  }
  for (int v = 0; v < patch.free_count; ++v) {
    const int l = loop_of[v];
    estimate.vertices[v] *= estimate.loops[l].likely / std::sqrt(deviations[l] / area[l]);
  }
  return estimate;
}

}  // namespace loopmend
