// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/expected_deviation.h"

#include "neighborhood/weighted_fairing.h"
#include "operators/operator_set.h"
#include "pipeline/validate.h"

#include <algorithm>
#include <cmath>

namespace loopmend {

namespace {

/// ln(rms / D) = intercept + slope ln(second_order), and quantiles of the residuals: least squares over 299 holes of the 15
/// models of the tuning half of loopmend_cut_models, by loopmend_error_bar (docs/benchmarks/accuracy.md, "Error bar").
constexpr double intercept = -1.198, slope = 0.822;
constexpr double half_quantile = 0.088, likely_quantile = 0.671, most_quantile = 1.009;
constexpr double least_difference =
    1e-5;  ///< in loop diameters: differences below are of the fairing, not of the patch

double usual_deviation(double second_order) {
  return std::exp(intercept + slope * std::log(std::max(second_order, least_difference)));
}

}  // namespace

ExpectedDeviation expected_deviation(double second_order) {
  const double usual = usual_deviation(second_order);
  return {usual * std::exp(half_quantile), usual * std::exp(likely_quantile), usual * std::exp(most_quantile),
          second_order};
}

DeviationEstimate expected_deviation(const Patch& patch, const CancelToken& cancel) {
  DeviationEstimate estimate;
  if (patch.free_count == 0 || patch.loops.empty()) return estimate;
  Patch faired = patch;
  if (!blend_once(faired, SeamContinuity::tangent, {}, 1, cancel)) return estimate;
  const Eigen::VectorXd mass = barycentric_areas(patch.positions, patch.triangles);
  const std::vector<int> loop_of = loop_of_free_vertices(patch);
  const std::size_t loops = patch.loops.size();
  std::vector<double> diameter(loops), area(loops), differences(loops), deviations(loops);
  for (std::size_t l = 0; l < loops; ++l) diameter[l] = loop_diameter(patch, l);
  estimate.vertices.resize(patch.free_count);
  for (int v = 0; v < patch.free_count; ++v) {
    const int l = loop_of[v];
    const double difference = (patch.positions[v] - faired.positions[v]).norm() / diameter[l];
    estimate.vertices[v] = usual_deviation(difference);
    area[l] += mass[v];
    differences[l] += mass[v] * difference * difference;
    deviations[l] += mass[v] * estimate.vertices[v] * estimate.vertices[v];
  }
  for (std::size_t l = 0; l < loops; ++l) {
    ExpectedDeviation& bounds = estimate.loops.emplace_back();
    if (!(area[l] > 0)) continue;
    bounds = expected_deviation(std::sqrt(differences[l] / area[l]));
    for (double* bound : {&bounds.half, &bounds.likely, &bounds.most}) *bound *= diameter[l] * patch.scale;
  }
  // The bounds are of the whole patch, which at the seam is exact.
  const std::vector<int> loop_of_triangle = loop_of_triangles(patch);
  std::vector<double> whole_area(loops);
  for (int f = 0; f < patch.patch_triangles; ++f) {
    const auto& [a, b, c] = patch.triangles[f];
    whole_area[loop_of_triangle[f]] +=
        (patch.positions[b] - patch.positions[a]).cross(patch.positions[c] - patch.positions[a]).norm() / 2;
  }
  for (int v = 0; v < patch.free_count; ++v) {
    const int l = loop_of[v];
    estimate.vertices[v] *= estimate.loops[l].likely / std::sqrt(deviations[l] / whole_area[l]);
  }
  return estimate;
}

}  // namespace loopmend
