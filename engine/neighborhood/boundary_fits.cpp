// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighborhood/boundary_fits.h"

#include "core/quantile.h"
#include "operators/polynomial_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace loopmend {

namespace {

constexpr int narrowest = 3, widest = 5;
constexpr double white_growth = 1.5;  ///< docs/math/energy_to_matrix.md, "Rough boundaries"

/// At the given fixed vertices, all of one width.
std::vector<BoundaryFit> fits_at(const std::vector<int>& vertices, const Patch& patch, const FixedSurface& surface) {
  FitScratch scratch(patch.vertex_count());
  PolynomialFit fit;
  std::vector<BoundaryFit> chosen;
  double smallest = 0;
  for (int rings = narrowest; rings <= widest; ++rings) {
    const FitOptions options = cubic_height_field(rings, Outliers::weighted_down, FitOutput::uncertainty);
    std::vector<BoundaryFit> fits(vertices.size());
    std::vector<double> residuals;
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      const int v = vertices[k];
      if (!fit_polynomial(patch.positions, surface.topology, v, surface.normals[v], options, scratch, fit)) continue;
      fits[k] = {true, fit.normal, fit.normal_sigma, fit.H, fit.H_sigma, fit.H_slope, fit.H_slope_sigma};
      residuals.push_back(fit.residual);
    }
    const double residual = median(std::move(residuals));
    if (rings > narrowest && residual > white_growth * smallest) break;
    smallest = rings > narrowest ? std::min(smallest, residual) : residual;
    chosen = std::move(fits);
  }
  return chosen;
}

BoundarySummary summary_of(const Patch& patch, const std::vector<int>& boundary, const std::vector<BoundaryFit>& fits,
                           const SplitEstimate& split) {
  BoundarySummary summary;
  summary.split = split;
  summary.relief = split.relief_height * patch.scale;
  summary.noise = split.noise_height * patch.scale;
  double edges = 0;
  for (std::size_t k = 0; k < boundary.size(); ++k)
    edges += (patch.positions[boundary[(k + 1) % boundary.size()]] - patch.positions[boundary[k]]).norm();
  if (edges > 0) {
    summary.relief_per_edge = split.relief_height * static_cast<double>(boundary.size()) / edges;
    summary.noise_per_edge = split.noise_height * static_cast<double>(boundary.size()) / edges;
  }
  for (const BoundaryFit& fit : fits) {
    if (!fit.valid) continue;
    ++summary.fitted;
    summary.normal_sigma_deg += fit.normal_sigma * fit.normal_sigma;
    summary.H += fit.H * fit.H;
    summary.H_sigma += fit.H_sigma * fit.H_sigma;
    summary.gradient += fit.gradient * fit.gradient;
    summary.gradient_sigma += fit.gradient_sigma * fit.gradient_sigma;
  }
  if (summary.fitted == 0) return summary;
  const auto rms = [&](double squares, double unit) { return std::sqrt(squares / summary.fitted) / unit; };
  summary.normal_sigma_deg = rms(summary.normal_sigma_deg, std::numbers::pi / 180);
  summary.H = rms(summary.H, patch.scale);
  summary.H_sigma = rms(summary.H_sigma, patch.scale);
  summary.gradient = rms(summary.gradient, patch.scale * patch.scale);
  summary.gradient_sigma = rms(summary.gradient_sigma, patch.scale * patch.scale);
  return summary;
}

}  // namespace

std::vector<std::vector<BoundaryFit>> boundary_fits(const Patch& patch, const FixedSurface& surface) {
  std::vector<std::vector<BoundaryFit>> fits;
  for (const std::vector<int>& boundary : patch.loops) fits.push_back(fits_at(boundary, patch, surface));
  return fits;
}

std::vector<float> curvature_uncertainty(const Patch& patch) {
  std::vector<int> fixed(patch.vertex_count() - patch.free_count);
  std::iota(fixed.begin(), fixed.end(), patch.free_count);
  return curvature_uncertainty(patch, fixed);
}

std::vector<float> curvature_uncertainty(const Patch& patch, std::span<const int> vertices) {
  constexpr int farthest = 4;
  std::vector<int> fitted;
  for (int i : vertices)
    if (i >= patch.free_count && patch.ring[i] <= farthest) fitted.push_back(i);
  const std::vector<BoundaryFit> fits = fits_at(fitted, patch, FixedSurface(patch));
  std::vector<float> sigma(patch.vertex_count() - patch.free_count, std::numeric_limits<float>::quiet_NaN());
  for (std::size_t k = 0; k < fits.size(); ++k)
    if (fits[k].valid) sigma[fitted[k] - patch.free_count] = static_cast<float>(fits[k].H_sigma / patch.scale);
  return sigma;
}

std::vector<BoundarySummary> boundary_summaries(const Patch& patch, const SplitEstimate& split) {
  return boundary_summaries(patch, split, boundary_fits(patch, FixedSurface(patch)));
}

std::vector<BoundarySummary> boundary_summaries(const Patch& patch, const SplitEstimate& split,
                                                const std::vector<std::vector<BoundaryFit>>& fits) {
  std::vector<BoundarySummary> summaries;
  for (std::size_t l = 0; l < patch.loops.size(); ++l)
    summaries.push_back(summary_of(patch, patch.loops[l], fits[l], split));
  return summaries;
}

}  // namespace loopmend
