// SPDX-License-Identifier: GPL-3.0-or-later
#include "rim/white_noise.h"

#include "core/quantile.h"
#include "filling/fairing.h"
#include "operators/operator_set.h"
#include "operators/polynomial_fit.h"
#include "operators/vertex_normals.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace loopmend {

namespace {

constexpr int least_rings = 4, most_rings = 10;
/// Residual of wider fits over the least of narrower ones: up to the first figure it is noise alone, from the second on
/// shape shows in it.
constexpr double noise_alone = 1.05, more_than_noise = 1.15;

/// The surface around a patch, far enough for the widest fits at its outermost ring. Patch frame.
struct WideSurroundings {
  Points points;
  Triangles triangles;
  std::vector<int> place;  ///< of the patch's fixed vertex free_count + k in `points`
};

WideSurroundings wide_surroundings(const Patch& patch, const SurfaceModel& model) {
  WideSurroundings wide;
  std::unordered_map<int, int> index;
  const auto place_of = [&](int view_vertex) {
    const auto [entry, added] = index.try_emplace(view_vertex, static_cast<int>(wide.points.size()));
    if (added) wide.points.push_back(patch.to_frame(model.mesh.point(TriMesh::VertexHandle(view_vertex))));
    return entry->second;
  };
  std::vector<int> front;
  for (int i = patch.free_count; i < patch.vertex_count(); ++i) {
    wide.place.push_back(place_of(patch.view_vertex[i]));
    front.push_back(patch.view_vertex[i]);
  }
  for (int ring = 0; ring < most_rings; ++ring) {
    std::vector<int> next;
    for (int v : front)
      for (const auto w : model.mesh.vv_range(TriMesh::VertexHandle(v)))
        if (index.count(w.idx()) == 0) {
          place_of(w.idx());
          next.push_back(w.idx());
        }
    front = std::move(next);
  }
  for (const auto face : model.mesh.faces()) {
    Triangle t;
    int k = 0;
    for (const auto v : model.mesh.fv_range(face)) {
      const auto found = index.find(v.idx());
      if (found != index.end()) t[k++] = found->second;
    }
    if (k == 3) wide.triangles.push_back(t);
  }
  return wide;
}

/// Moves the fixed vertices to `places` (of vertex free_count + k) and carries the free ones along, within `reach`.
void move_fixed(Patch& patch, const Points& places, double reach) {
  Points offset(patch.vertex_count(), Vec3::Zero());
  for (std::size_t k = 0; k < places.size(); ++k)
    offset[patch.free_count + k] = places[k] - patch.positions[patch.free_count + k];
  std::vector<int> own(patch.patch_triangles);
  std::iota(own.begin(), own.end(), 0);
  SparseMatrix C = clamped_cotan_stiffness(patch.positions, patch.triangles, own, robust_clamp);
  if (std::isfinite(reach)) {
    const Eigen::VectorXd fading = barycentric_areas(patch.positions, patch.triangles) / (reach * reach);
    C += SparseMatrix(fading.asDiagonal());
  }
  minimise_quadratic_form(C, offset, 0, patch.free_count);
  for (int i = 0; i < patch.free_count; ++i) patch.positions[i] += offset[i];
  std::copy(places.begin(), places.end(), patch.positions.begin() + patch.free_count);
}

}  // namespace

Patch without_noise(const Patch& patch, const SurfaceModel& model, double share) {
  const WideSurroundings wide = wide_surroundings(patch, model);
  const Topology topology(static_cast<int>(wide.points.size()), wide.triangles);
  const Points normals = angle_weighted_normals(wide.points, wide.triangles);
  FitScratch scratch(static_cast<int>(wide.points.size()));
  PolynomialFit fit;
  Points best;
  double least = 0, weight = 1;  // of this width against the narrower ones
  for (int rings = least_rings; rings <= most_rings; rings += 2) {
    const FitOptions options = cubic_height_field(rings, Outliers::weighted_down, FitOutput::uncertainty);
    Points places;
    std::vector<double> residuals;
    for (int v : wide.place) {
      places.push_back(wide.points[v]);
      if (!fit_polynomial(wide.points, topology, v, normals[v], options, scratch, fit)) continue;
      places.back() += share * fit.derivatives.col(0);
      residuals.push_back(fit.residual);
    }
    if (residuals.empty()) return patch;
    const double left = median(std::move(residuals));
    if (rings == least_rings) {
      least = left;
      best = std::move(places);
      continue;
    }
    weight *= std::clamp((more_than_noise - left / least) / (more_than_noise - noise_alone), 0.0, 1.0);
    if (!(weight > 0)) break;
    least = std::min(least, left);
    for (std::size_t k = 0; k < best.size(); ++k) best[k] += weight * (places[k] - best[k]);
  }
  Patch result = patch;
  move_fixed(result, best, std::numeric_limits<double>::infinity());
  return result;
}

Patch with_noise_again(const Patch& solved, const Patch& original, double reach) {
  Patch result = solved;
  move_fixed(result, Points(original.positions.begin() + original.free_count, original.positions.end()), reach);
  return result;
}

}  // namespace loopmend
