// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighborhood/weighted_fairing.h"

#include "core/quantile.h"
#include "filling/fairing.h"
#include "operators/curvature_energy.h"
#include "operators/operator_set.h"
#include "operators/topology.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

constexpr double confidence_in_median = 8, confidence_in_radius = 8;
constexpr double known_well_enough = 2;  ///< σ_H R from which a curvature counts half
constexpr int data_rings = 2;  ///< rings 1 and 2: from their Laplacians tangent and curvature run into the patch

SparseMatrix stiffness(const Patch& patch) {
  std::vector<int> all(patch.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return clamped_cotan_stiffness(patch.positions, patch.triangles, all, robust_clamp);
}

/// ∫ w ‖∇f‖² over the triangles with a Laplacian at each corner that the patch can change.
SparseMatrix trusted_stiffness(const Patch& patch, const Eigen::VectorXd& confidence) {
  std::vector<Eigen::Triplet<double>> triplets;
  for (const Triangle& t : patch.triangles) {
    const auto [nearest, farthest] = std::minmax({patch.ring[t[0]], patch.ring[t[1]], patch.ring[t[2]]});
    if (farthest > data_rings || nearest > 1) continue;
    const double weight = std::min({confidence[t[0]], confidence[t[1]], confidence[t[2]]});
    const auto cotangents = half_cotangents(patch.positions, t);
    for (int k = 0; k < 3; ++k) {
      const int i = t[(k + 1) % 3], j = t[(k + 2) % 3];
      const double value = weight * std::clamp(cotangents[k], robust_clamp.low / 2, robust_clamp.high / 2);
      triplets.emplace_back(i, i, value);
      triplets.emplace_back(j, j, value);
      triplets.emplace_back(i, j, -value);
      triplets.emplace_back(j, i, -value);
    }
  }
  SparseMatrix C(patch.vertex_count(), patch.vertex_count());
  C.setFromTriplets(triplets.begin(), triplets.end());
  return C;
}

bool has_data(const Patch& patch, int i) { return patch.ring[i] >= 1 && patch.ring[i] <= data_rings; }

}  // namespace

Eigen::VectorXd data_confidence(const Patch& patch, double radius, const std::vector<std::vector<BoundaryFit>>& fits) {
  Eigen::VectorXd all = Eigen::VectorXd::Ones(patch.vertex_count());
  for (std::size_t l = 0; l < fits.size(); ++l)
    for (std::size_t k = 0; k < fits[l].size(); ++k) {
      const double doubt = fits[l][k].H_sigma * radius / known_well_enough;
      if (fits[l][k].valid) all[patch.loops[l][k]] = 1 / (1 + doubt * doubt);
    }
  const Topology topology(patch.vertex_count(), patch.triangles);
  for (int i = patch.free_count; i < patch.vertex_count(); ++i) {
    if (patch.ring[i] != 2) continue;
    double sum = 0, count = 0;
    for (int j : topology.neighbors(i))
      if (patch.ring[j] == 1) {
        sum += all[j];
        ++count;
      }
    if (count > 0) all[i] = sum / count;
  }
  return all.tail(patch.vertex_count() - patch.free_count);
}

Eigen::VectorXd data_confidence(const Patch& patch, double radius) {
  return data_confidence(patch, radius, boundary_fits(patch, FixedSurface(patch)));
}

Eigen::VectorXd confidence_weights(const Patch& patch, double radius, const Eigen::VectorXd& data) {
  Eigen::MatrixX3d x(patch.vertex_count(), 3);
  for (int i = 0; i < patch.vertex_count(); ++i) x.row(i) = patch.positions[i].transpose();
  const Eigen::VectorXd mass = barycentric_areas(patch.positions, patch.triangles);
  const Eigen::VectorXd bend =
      (mass.cwiseInverse().asDiagonal() * Eigen::MatrixX3d(stiffness(patch) * x)).rowwise().norm();
  std::vector<double> boundary;
  for (int i = patch.free_count; i < patch.vertex_count(); ++i)
    if (has_data(patch, i)) boundary.push_back(bend[i]);
  Eigen::VectorXd confidence = Eigen::VectorXd::Ones(patch.vertex_count());
  confidence.tail(data.size()) = data;
  const double usual = median(std::move(boundary));
  if (!(usual > 0)) return confidence;
  const double limit = 1 / (1 / (confidence_in_median * usual) + radius / confidence_in_radius);
  for (int i = patch.free_count; i < patch.vertex_count(); ++i)
    if (has_data(patch, i) && bend[i] > limit)
      confidence[i] = std::min(confidence[i], (limit / bend[i]) * (limit / bend[i]));
  return confidence;
}

bool blend_once(Patch& patch, SeamContinuity continuity, const Eigen::VectorXd& confidence, double radius,
                const CancelToken& cancel) {
  const SparseMatrix C = stiffness(patch);
  if (continuity == SeamContinuity::position)
    return minimise_quadratic_form(C, patch.positions, 0, patch.free_count, cancel);
  const Eigen::VectorXd mass = barycentric_areas(patch.positions, patch.triangles);
  Eigen::VectorXd rows = mass.cwiseInverse(), bending = mass;
  for (int i = 0; i < patch.vertex_count(); ++i) {
    if (patch.ring[i] > data_rings) rows[i] = 0;
    if (patch.ring[i] > 1) bending[i] = 0;
  }
  const SparseMatrix L = rows.asDiagonal() * C;
  const SparseMatrix transposed = L.transpose();
  if (continuity == SeamContinuity::tangent) {
    const SparseMatrix Q = transposed * SparseMatrix(bending.asDiagonal()) * L;
    return minimise_quadratic_form(Q, patch.positions, 0, patch.free_count, cancel);
  }
  bending = rough_bending / (radius * radius) * bending.cwiseProduct(confidence);
  SparseMatrix Q = transposed * trusted_stiffness(patch, confidence) * L;
  Q += SparseMatrix(transposed * SparseMatrix(bending.asDiagonal()) * L);
  return minimise_quadratic_form(Q, patch.positions, 0, patch.free_count, cancel);
}

}  // namespace loopmend
