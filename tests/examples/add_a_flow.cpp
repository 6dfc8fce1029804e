// SPDX-License-Identifier: GPL-3.0-or-later
// A flow beside the four of the engine, from its velocity to its steady state: docs/dev/add_a_flow.md, "Add a flow".
#include "evolution/state.h"
#include "flows/decay_rate.h"
#include "mesh/region.h"
#include "solvers/linear_solver.h"
#include "support/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace loopmend {
namespace {

/// V = Δ²H at the free vertices. ΔH is needed on the fixed rings as well, within the reach of the operators of a free vertex.
Eigen::VectorXd velocity_of(const OperatorSet& ops, int free_count) {
  Eigen::VectorXd laplacian_of_H(ops.H.size());
  for (int i = 0; i < laplacian_of_H.size(); ++i) laplacian_of_H[i] = ops.apply_laplacian(i, ops.H);
  Eigen::VectorXd velocity(free_count);
  for (int i = 0; i < free_count; ++i) velocity[i] = ops.apply_laplacian(i, laplacian_of_H);
  return velocity;
}

/// #V by #V, with an entry where the operators have one. @param value  of entry e of row i, which is in column ops.index[e]
template <class Value>
SparseMatrix matrix_of(const OperatorSet& ops, const Value& value) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < ops.H.size(); ++i)
    for (int e = ops.offset[i]; e < ops.offset[i + 1]; ++e) entries.emplace_back(i, ops.index[e], value(i, e));
  SparseMatrix matrix(ops.H.size(), ops.H.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// V' = ∂V/∂s, n by n, for displacements s along the normals and frozen operators: V' = L L B with B_ij = ½ w^Δ_ij ⟨n_i, n_j⟩.
SparseMatrix jacobian_of(const OperatorSet& ops, int free_count) {
  const SparseMatrix L = matrix_of(ops, [&](int, int e) { return ops.laplacian[e]; });
  const SparseMatrix B = matrix_of(
      ops, [&](int i, int e) { return 0.5 * ops.laplacian[e] * ops.normal[i].dot(ops.normal[ops.index[e]]); });
  const SparseMatrix on_H = L * L;
  return SparseMatrix(on_H * B).topLeftCorner(free_count, free_count);
}

/// The semi-implicit step (I − τV') s = τV. @returns s; empty if the system could not be solved.
Eigen::VectorXd step_of(const EvolutionState& state, double tau) {
  const int n = state.patch.free_count;
  GeneralSystem system;
  system.matrix = [&]() -> SparseMatrix {
    SparseMatrix identity(n, n);
    identity.setIdentity();
    return identity - tau * jacobian_of(state.ops, n);
  };
  Eigen::VectorXd s;
  const auto solver = make_general_solver(SolverKind::direct, 1e-9);
  return solver->solve(system, tau * velocity_of(state.ops, n), s).solved ? s : Eigen::VectorXd();
}

/// Steps of σ = 10 until no vertex moves by more than 1e-8 of the frame. @returns false if 40 steps do not suffice.
bool flow_to_steady_state(EvolutionState& state, Stencil stencil) {
  // To first order V is ½Δ³ of the displacement, as for MMCVF: the two flows share their slowest decay rate.
  const double tau = 10 / slowest_decay_rate(FlowKind::mmcvf, state.patch);
  for (int step = 0; step < 40; ++step) {
    const Eigen::VectorXd s = step_of(state, tau);
    if (s.size() == 0) return false;
    state = displaced(state, {}, stencil, s);
    if (s.cwiseAbs().maxCoeff() < 1e-8) return true;
  }
  return false;
}

double distance_from_unit_sphere(const Patch& patch) {
  double largest = 0;
  for (int i = 0; i < patch.free_count; ++i)
    largest = std::max(largest, std::abs(patch.to_mesh(patch.positions[i]).norm() - 1));
  return largest;
}

/// The unit sphere has H = −1 everywhere, so that V = 0: it is the steady state between its own boundary data. The initial
/// patch is nearly flat. Measured: from 0.22 to 4.4e-5, and from 0.21 to 2.3e-5 with half the edge length.
TEST(AddAFlow, TheCapOfASphereComesBack) {
  constexpr Stencil stencil = Stencil::two_ring;
  for (int level : {4, 5}) {
    EvolutionState state = make_state(test::start_of(test::open_sphere(level, 0.8)), {}, stencil);
    EXPECT_GT(distance_from_unit_sphere(state.patch), 0.1);
    ASSERT_TRUE(flow_to_steady_state(state, stencil));
    EXPECT_LT(distance_from_unit_sphere(state.patch), 1e-4);
    EXPECT_EQ(state.folds, 0);
  }
}

double harmonic(const Vec3& p) { return p.z() * p.z() - 1.0 / 3; }

/// The upper part of the surface r = 1 + amount · harmonic.
Patch harmonic_region(double amount) {
  TriangleSoup ball = make_icosphere(5);
  std::vector<int> upper;
  for (std::size_t i = 0; i < ball.points.size(); ++i) {
    if (ball.points[i].z() > 0.2) upper.push_back(static_cast<int>(i));
    ball.points[i] *= 1 + amount * harmonic(ball.points[i]);
  }
  return make_region(make_surface_model(ball), upper).patch;
}

/// ∫Vφ and ∫Pφ in mesh units, for a φ that vanishes towards the boundary. At single vertices V is noise: its order is six.
struct Integrals {
  double velocity = 0, harmonic = 0;
};

Integrals integrals_for(double amount) {
  const EvolutionState state = make_state(harmonic_region(amount), {}, Stencil::two_ring_cubic);
  const double scale = state.patch.scale;
  const Eigen::VectorXd V = velocity_of(state.ops, state.patch.free_count) / std::pow(scale, 5);  // as Δ²H, 1/length⁵
  const Eigen::VectorXd mass = barycentric_areas(state.patch.positions, state.patch.triangles) * std::pow(scale, 2);
  Integrals sum;
  for (int i = 0; i < V.size(); ++i) {
    const Vec3 p = state.patch.to_mesh(state.patch.positions[i]).normalized();
    const double weight = mass[i] * std::pow(std::max(0.0, p.z() - 0.4), 4);
    sum.velocity += weight * V[i];
    sum.harmonic += weight * harmonic(p);
  }
  return sum;
}

/// r = 1 + εP, P of degree l = 2, has H = −1 + ½ε(2 − l(l + 1))P to first order, and ΔP = −l(l + 1)P: V = −72 εP.
/// Measured: −72.1 and, with edges twice as long, −71.0.
TEST(AddAFlow, AHarmonicOfASphereDecaysAtTheKnownRate) {
  constexpr double amount = 0.002;
  const Integrals outward = integrals_for(amount), inward = integrals_for(-amount);
  const double rate = (outward.velocity - inward.velocity) / (amount * (outward.harmonic + inward.harmonic));
  EXPECT_NEAR(rate, -72, 0.01 * 72);
}

}  // namespace
}  // namespace loopmend
