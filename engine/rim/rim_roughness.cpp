// SPDX-License-Identifier: GPL-3.0-or-later
#include "rim/rim_roughness.h"

#include "core/quantile.h"
#include "mesh/quality.h"
#include "operators/curvature_energy.h"
#include "operators/polynomial_fit.h"
#include "rim/fixed_surface.h"

#include <algorithm>
#include <cmath>

namespace loopmend {

namespace {

/// H from narrow and from wide fits.
void fit_around(const Patch& patch, const FixedSurface& around, SurroundingFits& fits) {
  FitScratch scratch(patch.vertex_count());
  PolynomialFit narrow, wide;
  FitOptions four_rings;
  four_rings.rings = four_rings.most_rings = 4;
  for (int i = patch.free_count; i < patch.vertex_count(); ++i) {
    if (!fit_polynomial(patch.positions, around.topology, i, around.normals[i], FitOptions{}, scratch, narrow) ||
        !fit_polynomial(patch.positions, around.topology, i, around.normals[i], four_rings, scratch, wide))
      continue;
    fits.vertices.push_back(i - patch.free_count);
    fits.H2.push_back(narrow.H);
    fits.H4.push_back(wide.H);
  }
}

/// Of cubic fits at the four rings next to the patch; negative where there is no fit.
std::vector<double> residuals_of(const Patch& patch, const FixedSurface& around, int rings) {
  constexpr int fitted_rings = 4;
  FitScratch scratch(patch.vertex_count());
  PolynomialFit fit;
  const FitOptions options = cubic_height_field(rings, Outliers::count, FitOutput::uncertainty);
  std::vector<double> residuals;
  for (int i = patch.free_count; i < patch.vertex_count(); ++i) {
    if (patch.ring[i] > fitted_rings || around.normals[i].isZero()) continue;
    const bool found = fit_polynomial(patch.positions, around.topology, i, around.normals[i], options, scratch, fit);
    residuals.push_back(found ? fit.residual : -1);
  }
  return residuals;
}

/// Median of log₂(wide / narrow) over the vertices that have both; 0 if none has.
double growth_of(const std::vector<double>& narrow, const std::vector<double>& wide) {
  std::vector<double> growth;
  for (std::size_t k = 0; k < narrow.size(); ++k)
    if (narrow[k] > 0 && wide[k] > 0) growth.push_back(std::log2(wide[k] / narrow[k]));
  return growth.empty() ? 0 : median(growth);
}

/// Of the surroundings, patch frame.
double mean_edge_around(const Patch& patch) {
  double length = 0;
  for (std::size_t f = patch.patch_triangles; f < patch.triangles.size(); ++f)
    for (int k = 0; k < 3; ++k)
      length += (patch.positions[patch.triangles[f][k]] - patch.positions[patch.triangles[f][(k + 1) % 3]]).norm();
  const auto sides = 3 * (patch.triangles.size() - patch.patch_triangles);
  return sides > 0 ? length / static_cast<double>(sides) : 0;
}

void measure_residuals(const SurroundingFits& fits, RimRoughness& rim) {
  const auto [narrow, middle, wide] = fits.residual;
  rim.noise = narrow;
  rim.spread = fits.spread;
  if (!(rim.noise > 0 && middle > 0 && wide > 0)) return;
  rim.growth = std::log2(wide / rim.noise);
  rim.local_growth = fits.local_growth;
  const double outer = std::log(wide / middle) / std::log(4.0 / 3);
  if (outer > 0) rim.evenness = std::max(0.0, std::log(middle / rim.noise) / std::log(1.5) / outer);
}

// What a cubic leaves over grows with the fourth power of the neighbourhood's width on a smooth surface, not at all under
// white noise, and about linearly on the scans. Measured: 3.0 to 3.9, 0.0 to 0.26, 0.37 to 2.7 but for two scans of 283.
// Each test has a band in which the kinds pass into one another. It lies on the side where the rough or the noisy kind
// begins, so that what is smooth stays so to the last bit; few scans are within.
struct Band {
  double off, on;  ///< in that order or the other way round
};
constexpr Band not_white_growth{0.27, 0.37};
constexpr Band not_smooth_growth{2.8, 2.65};
constexpr Band alike_everywhere{2.6, 1.9};        ///< of the residuals' spread: noise that is not is not white
constexpr Band uneven_curvature{0.005, 0.01};     ///< of unevenness: below, noise does not matter
constexpr Band plain_roughness{0.3, 0.45};        ///< of unevenness: above, growth is that of large features
constexpr Band uncorrelated{0.985, 0.97};         ///< C: above, the rim's curvature tells that of the hole,
constexpr Band even_growth{0.72, 0.85};           ///< but for relief of all scales, smooth as it may be,
constexpr Band plain_growth{0.8, 1.3};            ///< which shows where the residual grows enough to tell
constexpr Band noise_that_matters{0.001, 0.003};  ///< in edges: below, fits err by more than the noise
constexpr Band residual_of_scans{3e-4,
                                 1e-3};  ///< in edges: below, there is nothing that could be roughness. Scans have
                                         ///< 1.5e-3 and more
constexpr Band residual_of_features{3e-3, 1e-2};  ///< in edges: below, uneven curvature is that of a clean surface

/// 0 at band.off and before, 1 at band.on and beyond, smooth in between.
double passage(double value, const Band& band) {
  const double t = std::clamp((value - band.off) / (band.on - band.off), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// 0..1: how far what fits leave over is white noise, which does not grow with their width and is alike everywhere.
double whiteness(const RimRoughness& rim) {
  return (1 - passage(rim.growth, not_white_growth)) * passage(rim.spread, alike_everywhere);
}

double rough_share_of(const RimRoughness& rim) {
  const double features = passage(rim.unevenness, plain_roughness) * passage(rim.noise_per_edge, residual_of_features);
  const double plain = std::max(passage(rim.local_growth, not_smooth_growth), features);
  const double relief = passage(rim.evenness, even_growth) * passage(rim.growth, plain_growth);
  const double unlike = std::max(passage(rim.correlation, uncorrelated), relief);
  const double not_clean = passage(rim.noise_per_edge, residual_of_scans);
  return (1 - whiteness(rim)) * not_clean * std::min({passage(rim.unevenness, uneven_curvature), unlike, plain});
}

void judge_kind(RimRoughness& rim) {
  rim.rough_share = rough_share_of(rim);
  rim.noise_share = whiteness(rim) * passage(rim.noise_per_edge, noise_that_matters);
  rim.kind = whiteness(rim) == 1   ? Surroundings::noisy
             : rim.rough_share > 0 ? Surroundings::rough
                                   : Surroundings::smooth;
}

/// Correlation of H₄ between vertices at 0.8 to 1.2 of the distance.
double correlation_at(const Patch& patch, const SurroundingFits& fits, double distance) {
  const auto squared = [](double x) { return x * x; };
  const double nearest = squared(0.8 * distance), farthest = squared(1.2 * distance);
  double product = 0, square = 0;
  const Vec3* const fixed = patch.positions.data() + patch.free_count;
  const std::size_t stride = 1 + fits.vertices.size() / 1500;
  for (std::size_t a = 0; a < fits.vertices.size(); a += stride)
    for (std::size_t b = 0; b < a; b += stride) {
      const double d = (fixed[fits.vertices[a]] - fixed[fits.vertices[b]]).squaredNorm();
      if (d < nearest || d > farthest) continue;
      product += fits.H4[a] * fits.H4[b];
      square += (fits.H4[a] * fits.H4[a] + fits.H4[b] * fits.H4[b]) / 2;
    }
  return square > 0 ? std::clamp(product / square, 0.01, 1.0) : 1.0;
}

/// αR² from a = (R / correlation length)², docs/dev/numerics.md, "Rough boundaries".
double bending_for(double a) {
  if (a <= 0.01) return 0;
  if (a <= 0.1) return (a - 0.01) / 0.9;
  const double rough = std::clamp(2 * a, 60.0, 300.0);
  if (a >= 1) return rough;
  return 0.1 * std::pow(60 / 0.1, std::log(a / 0.1) / std::log(10.0));
}

}  // namespace

const char* to_string(Surroundings surroundings) {
  switch (surroundings) {
    case Surroundings::smooth: return "smooth";
    case Surroundings::noisy: return "noisy";
    case Surroundings::rough: return "rough";
  }
  return "";
}

SurroundingFits fit_surroundings(const Patch& patch, const FixedSurface& around) {
  SurroundingFits fits;
  fit_around(patch, around, fits);
  std::array<std::vector<double>, 3> residuals;
  for (int k : {0, 1, 2}) residuals[k] = residuals_of(patch, around, 2 + k);
  fits.local_growth = growth_of(residuals[0], residuals[2]);
  for (int k : {0, 1, 2}) {
    std::erase_if(residuals[k], [](double residual) { return residual < 0; });
    fits.residual[k] = median(residuals[k]);
    const double low = quantile(residuals[k], 0.16);
    if (k == 1 && low > 0) fits.spread = quantile(residuals[k], 0.84) / low;
  }
  return fits;
}

RimRoughness rim_roughness(const Patch& patch) {
  return rim_roughness(patch, fit_surroundings(patch, FixedSurface(patch)));
}

RimRoughness rim_roughness(const Patch& patch, const SurroundingFits& fits) {
  RimRoughness rim;
  rim.radius = patch_radius(patch);
  if (fits.vertices.empty() || !(rim.radius > 0)) return rim;
  double sum = 0;
  for (std::size_t k = 0; k < fits.H2.size(); ++k) sum += (fits.H2[k] - fits.H4[k]) * (fits.H2[k] - fits.H4[k]);
  rim.unevenness = rim.radius * std::sqrt(sum / static_cast<double>(fits.H2.size()));

  const double edge = mean_edge_length(patch.positions, patch.triangles, patch.patch_triangles);
  double distance = rim.radius / 4;
  while (distance < edge && distance < rim.radius) distance *= 2;
  rim.correlation = correlation_at(patch, fits, distance);
  const double per_length = rim.radius / distance * std::log(rim.correlation);
  const double gate = std::clamp(std::log(rim.unevenness / 0.1) / std::log(3.0), 0.0, 1.0);
  rim.bending = bending_for(per_length * per_length * gate);
  measure_residuals(fits, rim);
  const double edge_around = mean_edge_around(patch);
  rim.noise_per_edge = edge_around > 0 ? rim.noise / edge_around : 0;
  judge_kind(rim);
  return rim;
}

}  // namespace loopmend
