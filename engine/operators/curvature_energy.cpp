// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/curvature_energy.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loopmend {

namespace {

/// H on rings 0..2 can depend on the patch (two-ring fits, and one-ring fits that had to be widened).
constexpr int active_rings = 2;
static_assert(energy_reach == active_rings + 1, "the triangles beyond ring 2 end on ring 3");

bool is_active(const Patch& patch, const Triangle& t) {
  return std::min({patch.ring[t[0]], patch.ring[t[1]], patch.ring[t[2]]}) <= active_rings;
}

bool is_known(const OperatorSet& ops, const Triangle& t) {
  return ops.valid[t[0]] && ops.valid[t[1]] && ops.valid[t[2]];
}

bool has_bending(const Patch& patch, const OperatorSet& ops, int vertex) {
  return patch.ring[vertex] <= active_rings && ops.valid[vertex];
}

}  // namespace

CurvatureEnergy curvature_energy(const Patch& patch, const OperatorSet& ops, const EnergyWeights& weights) {
  CurvatureEnergy energy;
  std::vector<int> known;
  for (std::size_t f = 0; f < patch.triangles.size(); ++f) {
    if (!is_active(patch, patch.triangles[f])) continue;
    energy.faces.push_back(static_cast<int>(f));
    if (is_known(ops, patch.triangles[f])) known.push_back(static_cast<int>(f));
  }
  energy.mass = barycentric_areas(patch.positions, patch.triangles);
  energy.Q = weights.variation * cotan_stiffness(patch.positions, patch.triangles, known);
  if (weights.bending > 0) {
    Eigen::VectorXd active = Eigen::VectorXd::Zero(patch.vertex_count());
    for (int i = 0; i < patch.vertex_count(); ++i)
      if (has_bending(patch, ops, i)) active[i] = weights.bending * energy.mass[i];
    const SparseMatrix diagonal(active.asDiagonal());
    energy.Q = energy.Q + diagonal;
  }
  return energy;
}

double energy_value(const Patch& patch, const OperatorSet& ops, const EnergyWeights& weights) {
  const Eigen::VectorXd& H = ops.H;
  double variation = 0, bending = 0;
  for (const Triangle& t : patch.triangles) {
    if (!is_active(patch, t) || !is_known(ops, t)) continue;
    const auto weight = half_cotangents(patch.positions, t);
    for (int k = 0; k < 3; ++k) {
      const double difference = H[t[(k + 1) % 3]] - H[t[(k + 2) % 3]];
      variation += weight[k] * difference * difference;
    }
  }
  if (weights.bending > 0) {
    const Eigen::VectorXd mass = barycentric_areas(patch.positions, patch.triangles);
    for (int i = 0; i < patch.vertex_count(); ++i)
      if (has_bending(patch, ops, i)) bending += mass[i] * H[i] * H[i];
  }
  return weights.variation * variation + weights.bending * bending;
}

RowSparseMatrix curvature_jacobian(const OperatorSet& ops, int free_count) {
  const int vertices = static_cast<int>(ops.H.size());
  RowSparseMatrix B(vertices, free_count);
  B.reserve(static_cast<Eigen::Index>(ops.index.size()));
  std::vector<std::pair<int, double>> row;
  for (int i = 0; i < vertices; ++i) {
    row.clear();
    for (int e = ops.offset[i]; e < ops.offset[i + 1]; ++e) {
      const int j = ops.index[e];
      if (j >= free_count) continue;
      const Vec3& n = ops.normal[j];
      row.emplace_back(j, 0.5 * ops.laplacian[e] * ops.normal[i].dot(n) -
                              (2 * ops.H[i] * ops.gradient[e] - ops.diamond(i, ops.gradient[e])).dot(n));
    }
    std::sort(row.begin(), row.end());
    B.startVec(i);
    for (const auto& [j, value] : row) B.insertBack(i, j) = value;
  }
  B.finalize();
  return B;
}

Eigen::VectorXd metric_gradient(const Patch& patch, const OperatorSet& ops, const EnergyWeights& weights,
                                const std::vector<int>& faces) {
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(patch.free_count);
  for (int f : faces) {
    const Triangle& t = patch.triangles[f];
    if (std::min({t[0], t[1], t[2]}) >= patch.free_count) continue;
    const Vec3 cross =
        (patch.positions[t[1]] - patch.positions[t[0]]).cross(patch.positions[t[2]] - patch.positions[t[0]]);
    const double twice_area = cross.norm();
    if (!(twice_area > 0)) continue;
    std::array<Vec3, 3> hat;  // gradients of the three linear basis functions
    Vec3 G = Vec3::Zero();    // gradient of H in this triangle
    double bending = 0;       // mean of H² over the corners that count
    for (int k = 0; k < 3; ++k) {
      const Vec3 edge = patch.positions[t[(k + 2) % 3]] - patch.positions[t[(k + 1) % 3]];
      hat[k] = cross.cross(edge) / (twice_area * twice_area);
      G += ops.H[t[k]] * hat[k];
      if (has_bending(patch, ops, t[k])) bending += weights.bending * ops.H[t[k]] * ops.H[t[k]] / 3;
    }
    if (!is_known(ops, t)) G.setZero();
    // A motion with linear velocity v changes area by A div v, and A‖G‖² by A(‖G‖² div v − 2⟨G, ∇v G⟩).
    for (int k = 0; k < 3; ++k) {
      if (t[k] >= patch.free_count) continue;
      const Vec3 force = weights.variation * (G.squaredNorm() * hat[k] - 2 * hat[k].dot(G) * G) + bending * hat[k];
      gradient[t[k]] += twice_area / 2 * force.dot(ops.normal[t[k]]);
    }
  }
  return gradient;
}

double patch_area(const Patch& patch) {
  double area = 0;
  for (int f = 0; f < patch.patch_triangles; ++f) {
    const Triangle& t = patch.triangles[f];
    area +=
        (patch.positions[t[1]] - patch.positions[t[0]]).cross(patch.positions[t[2]] - patch.positions[t[0]]).norm() / 2;
  }
  return area;
}

double patch_radius(const Patch& patch) {
  const double loops = static_cast<double>(std::max<std::size_t>(1, patch.loops.size()));
  return std::sqrt(patch_area(patch) / (std::numbers::pi * loops));
}

}  // namespace loopmend
