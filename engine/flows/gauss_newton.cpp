// SPDX-License-Identifier: GPL-3.0-or-later
#include "flows/gauss_newton.h"

#include "core/threads.h"
#include "flows/decay_rate.h"
#include "operators/congruence.h"

#include <utility>

namespace loopmend {

SparseMatrix GaussNewtonSystem::curvature() const { return lower_congruence(B, Q); }

Eigen::VectorXd GaussNewtonSystem::curvature_times(const Eigen::VectorXd& x) const {
  const Eigen::VectorXd QBx = Q * (B * x);
  return B.transpose() * QBx;
}

GaussNewtonSystem assemble_gauss_newton(const Patch& patch, const OperatorSet& ops, const EnergyWeights& weights) {
  CurvatureEnergy energy;
  GaussNewtonSystem system;
  parallel_invoke([&] { energy = curvature_energy(patch, ops, weights); },
                  [&] { system.B = curvature_jacobian(ops, patch.free_count); });
  const Eigen::VectorXd QH = energy.Q * ops.H;
  system.energy = ops.H.dot(QH);
  system.half_gradient = system.B.transpose() * QH + 0.5 * metric_gradient(patch, ops, weights, energy.faces);
  system.mass = energy.mass.head(patch.free_count);
  system.Q = std::move(energy.Q);
  return system;
}

SparseMatrix near_gauss_newton(const Patch& patch, const EnergyWeights& weights, double mu) {
  const SparseMatrix M(barycentric_areas(patch.positions, patch.triangles).head(patch.free_count).asDiagonal());
  SparseMatrix preconditioner = mu * M + 0.25 * weights.variation * clamped_polyharmonic(FlowKind::mmcvf, patch);
  if (weights.bending > 0) preconditioner += 0.25 * weights.bending * clamped_polyharmonic(FlowKind::wf, patch);
  return preconditioner.triangularView<Eigen::Lower>();
}

}  // namespace loopmend
