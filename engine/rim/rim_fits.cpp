// SPDX-License-Identifier: GPL-3.0-or-later
#include "rim/rim_fits.h"

#include "rim/cubic_fit.h"
#include "rim/quantile.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace loopmend {

namespace {

constexpr int narrowest = 3, widest = 5;
constexpr double white_growth = 1.5;  ///< docs/dev/numerics.md, "Rough boundaries"

/// Curvature of the graph z(u, v) at the origin, and its uncertainty to first order, the slopes taken as exact: H hardly
/// depends on them, since the plane of the graph is nearly tangential.
RimFit at_origin(const CubicFit& cubic) {
  const auto& c = cubic.coefficients;
  const Eigen::Matrix<double, 10, 10> covariance = cubic.covariance();
  const double g = std::sqrt(1 + c[1] * c[1] + c[2] * c[2]);
  RimFit fit;
  fit.valid = true;
  fit.normal = (cubic.normal - c[1] * cubic.e1 - c[2] * cubic.e2) / g;
  fit.normal_sigma = std::sqrt(covariance(1, 1) + covariance(2, 2)) / (g * g);
  Eigen::Matrix<double, 10, 1> slope = Eigen::Matrix<double, 10, 1>::Zero();  // ∂H/∂c
  slope[3] = (1 + c[2] * c[2]) / (g * g * g);
  slope[4] = -c[1] * c[2] / (g * g * g);
  slope[5] = (1 + c[1] * c[1]) / (g * g * g);
  fit.H = slope.dot(c);
  fit.H_sigma = std::sqrt(slope.dot(covariance * slope));
  Eigen::Matrix<double, 10, 1> along_u = Eigen::Matrix<double, 10, 1>::Zero(), along_v = along_u;
  along_u[6] = along_v[9] = 3;
  along_u[8] = along_v[7] = 1;
  fit.gradient = std::hypot(along_u.dot(c), along_v.dot(c));
  fit.gradient_sigma = std::sqrt(along_u.dot(covariance * along_u) + along_v.dot(covariance * along_v));
  return fit;
}

double median_residual(const std::vector<std::optional<CubicFit>>& fits) {
  std::vector<double> residuals;
  for (const auto& fit : fits)
    if (fit) residuals.push_back(fit->residual);
  return median(std::move(residuals));
}

/// Of the surroundings, loop by loop.
class Around {
 public:
  Around(const Patch& patch, const FixedSurface& surface)
      : points_(patch.positions),
        surface_(surface),
        mark_(patch.vertex_count(), 0) {}

  /// At the given fixed vertices, all of one width.
  std::vector<RimFit> fits_at(const std::vector<int>& vertices) {
    std::vector<std::optional<CubicFit>> chosen;
    double smallest = 0;
    for (int rings = narrowest; rings <= widest; ++rings) {
      std::vector<std::optional<CubicFit>> fits;
      for (int v : vertices)
        fits.push_back(surface_.normals[v].isZero() ? std::nullopt
                                                    : fit_cubic(points_, surface_.topology, v, surface_.normals[v],
                                                                rings, Outliers::weighted_down, mark_));
      const double residual = median_residual(fits);
      if (rings > narrowest && residual > white_growth * smallest) break;
      smallest = rings > narrowest ? std::min(smallest, residual) : residual;
      chosen = std::move(fits);
    }
    std::vector<RimFit> result;
    for (const auto& fit : chosen) result.push_back(fit ? at_origin(*fit) : RimFit{});
    return result;
  }

 private:
  const Points& points_;
  const FixedSurface& surface_;
  std::vector<char> mark_;
};

RimSummary summary_of(const Patch& patch, const std::vector<int>& rim, const std::vector<RimFit>& fits,
                      const RimRoughness& roughness) {
  RimSummary summary;
  summary.roughness = roughness;
  summary.noise = roughness.noise * patch.scale;
  double edges = 0;
  for (std::size_t k = 0; k < rim.size(); ++k)
    edges += (patch.positions[rim[(k + 1) % rim.size()]] - patch.positions[rim[k]]).norm();
  if (edges > 0) summary.noise_per_edge = roughness.noise * static_cast<double>(rim.size()) / edges;
  for (const RimFit& fit : fits) {
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

std::vector<RimFit> rim_fits(const Patch& patch, int loop) {
  const FixedSurface surface(patch);
  return Around(patch, surface).fits_at(patch.loops[loop]);
}

std::vector<std::vector<RimFit>> rim_fits(const Patch& patch, const FixedSurface& surface) {
  Around around(patch, surface);
  std::vector<std::vector<RimFit>> fits;
  for (const std::vector<int>& rim : patch.loops) fits.push_back(around.fits_at(rim));
  return fits;
}

std::vector<float> curvature_uncertainty(const Patch& patch) {
  constexpr int farthest = 4;
  std::vector<int> near;
  for (int i = patch.free_count; i < patch.vertex_count(); ++i)
    if (patch.ring[i] <= farthest) near.push_back(i);
  const FixedSurface surface(patch);
  const std::vector<RimFit> fits = Around(patch, surface).fits_at(near);
  std::vector<float> sigma(patch.vertex_count() - patch.free_count, std::numeric_limits<float>::quiet_NaN());
  for (std::size_t k = 0; k < fits.size(); ++k)
    if (fits[k].valid) sigma[near[k] - patch.free_count] = static_cast<float>(fits[k].H_sigma / patch.scale);
  return sigma;
}

std::vector<RimSummary> rim_summaries(const Patch& patch, const RimRoughness& roughness) {
  return rim_summaries(patch, roughness, rim_fits(patch, FixedSurface(patch)));
}

std::vector<RimSummary> rim_summaries(const Patch& patch, const RimRoughness& roughness,
                                      const std::vector<std::vector<RimFit>>& fits) {
  std::vector<RimSummary> summaries;
  for (std::size_t l = 0; l < patch.loops.size(); ++l)
    summaries.push_back(summary_of(patch, patch.loops[l], fits[l], roughness));
  return summaries;
}

}  // namespace loopmend
