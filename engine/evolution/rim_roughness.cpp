#include "evolution/rim_roughness.h"

#include "energy/curvature_energy.h"
#include "mesh/quality.h"
#include "operators/local_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loopmend {

namespace {

/// The surroundings of the patch by themselves, with H from narrow and from wide fits.
struct Exterior {
  std::vector<int> vertices;
  std::vector<double> H2, H4;
};

Exterior fit_exterior(const Patch& patch) {
  const Triangles around(patch.triangles.begin() + patch.patch_triangles, patch.triangles.end());
  const Topology topology(patch.vertex_count(), around);
  const Points normals = angle_weighted_normals(patch.positions, around);
  FitScratch scratch(patch.vertex_count());
  LocalFit fit;
  Exterior exterior;
  for (int i = patch.free_count; i < patch.vertex_count(); ++i) {
    if (normals[i].isZero()) continue;
    fit_quadratic(patch.positions, topology, i, normals[i], Stencil::two_ring, scratch, fit);
    if (!fit.valid) continue;
    const double narrow = fit.H;
    fit_quadratic(patch.positions, topology, i, normals[i], Stencil::four_ring, scratch, fit);
    if (!fit.valid) continue;
    exterior.vertices.push_back(i);
    exterior.H2.push_back(narrow);
    exterior.H4.push_back(fit.H);
  }
  return exterior;
}

/// Correlation of H₄ between vertices at 0.8 to 1.2 of the distance.
double correlation_at(const Patch& patch, const Exterior& exterior, double distance) {
  double product = 0, square = 0;
  const std::size_t stride = 1 + exterior.vertices.size() / 1500;
  for (std::size_t a = 0; a < exterior.vertices.size(); a += stride)
    for (std::size_t b = 0; b < a; b += stride) {
      const double d = (patch.positions[exterior.vertices[a]] - patch.positions[exterior.vertices[b]]).norm();
      if (d < 0.8 * distance || d > 1.2 * distance) continue;
      product += exterior.H4[a] * exterior.H4[b];
      square += (exterior.H4[a] * exterior.H4[a] + exterior.H4[b] * exterior.H4[b]) / 2;
    }
  return square > 0 ? std::clamp(product / square, 0.01, 1.0) : 1.0;
}

/// αR² from a = (R / correlation length)², NUMERICS §12.4.
double bending_for(double a) {
  if (a < 0.01) return 0;
  if (a <= 0.1) return a;
  const double rough = std::clamp(2 * a, 60.0, 300.0);
  if (a >= 1) return rough;
  return 0.1 * std::pow(60 / 0.1, std::log(a / 0.1) / std::log(10.0));
}

}  // namespace

RimRoughness rim_roughness(const Patch& patch) {
  RimRoughness rim;
  rim.radius = std::sqrt(patch_area(patch) / (std::numbers::pi * static_cast<double>(patch.loops.size())));
  const Exterior exterior = fit_exterior(patch);
  if (exterior.vertices.empty() || !(rim.radius > 0)) return rim;
  double sum = 0;
  for (std::size_t k = 0; k < exterior.H2.size(); ++k)
    sum += (exterior.H2[k] - exterior.H4[k]) * (exterior.H2[k] - exterior.H4[k]);
  rim.unevenness = rim.radius * std::sqrt(sum / static_cast<double>(exterior.H2.size()));

  const double edge = mean_edge_length(patch.positions, patch.triangles, patch.patch_triangles);
  double distance = rim.radius / 4;
  while (distance < edge && distance < rim.radius) distance *= 2;
  rim.correlation = correlation_at(patch, exterior, distance);
  const double per_length = rim.radius / distance * std::log(rim.correlation);
  const double gate = std::clamp(std::log(rim.unevenness / 0.1) / std::log(3.0), 0.0, 1.0);
  rim.bending = bending_for(per_length * per_length * gate);
  return rim;
}

}  // namespace loopmend
