#include "flows/flow_terms.h"

#include "energy/curvature_energy.h"
#include "evolution/state.h"
#include "filling/fairing.h"
#include "flows/decay_rate.h"
#include "support/patches.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

const FlowKind all_flows[] = {FlowKind::mcf, FlowKind::sdf, FlowKind::wf, FlowKind::mmcvf};

EvolutionState disturbed_state() {
  Patch patch = test::exact_sphere_patch(4, 0.85);
  test::disturb(patch, 0.01);
  return make_state(std::move(patch), {}, Stencil::two_ring);
}

Eigen::VectorXd masses(const EvolutionState& state) {
  return barycentric_areas(state.patch.positions, state.patch.triangles).head(state.patch.free_count);
}

TEST(FlowTerms, ConstantMeanCurvatureIsStationaryForMmcvfSdfAndTheSphereForWf) {
  const EvolutionState exact = make_state(test::exact_sphere_patch(4, 0.85), {}, Stencil::two_ring);
  const FlowState sphere(exact.ops, exact.patch.free_count);
  const EvolutionState bumpy = disturbed_state();
  const FlowState bumps(bumpy.ops, bumpy.patch.free_count);
  for (FlowKind flow : {FlowKind::sdf, FlowKind::wf, FlowKind::mmcvf})
    EXPECT_LT(flow_velocity(flow, sphere).norm(), 0.02 * flow_velocity(flow, bumps).norm()) << to_string(flow);
  // MCF does move it: inwards with speed 1/R, H = −1/R and n outward.
  EXPECT_NEAR(flow_velocity(FlowKind::mcf, sphere).mean(), -exact.patch.scale, 0.01 * exact.patch.scale);
}

/// V is minus the L² gradient of the flow's energy: dE/ds·φ = −c ∫Vφ for φ that vanishes towards the seam.
void expect_descent(FlowKind flow, const Objective& objective, double factor) {
  const EvolutionState state = make_state(disturbed_state().patch, objective, Stencil::two_ring);
  Eigen::VectorXd phi(state.patch.free_count);
  for (int i = 0; i < phi.size(); ++i) {
    double distance = 1;
    for (int v : state.patch.loops[0])
      distance = std::min(distance, (state.patch.positions[i] - state.patch.positions[v]).norm());
    phi[i] = std::pow(distance, 4) * (1 + state.patch.positions[i].x());
  }
  constexpr double step = 1e-5;
  const double difference = (displaced(state, objective, Stencil::two_ring, step * phi).measure -
                             displaced(state, objective, Stencil::two_ring, -step * phi).measure) /
                            (2 * step);
  const Eigen::VectorXd V = flow_velocity(flow, FlowState(state.ops, state.patch.free_count));
  const double predicted = -factor * V.cwiseProduct(masses(state)).dot(phi);
  EXPECT_NEAR(predicted, difference, 0.15 * std::abs(difference)) << to_string(flow);
}

TEST(FlowTerms, McfDescendsArea) { expect_descent(FlowKind::mcf, {FlowKind::mcf, 0}, 2); }
TEST(FlowTerms, WfDescendsBendingEnergy) { expect_descent(FlowKind::wf, {FlowKind::wf, 0}, 1); }
TEST(FlowTerms, MmcvfDescendsTheVariationOfH) { expect_descent(FlowKind::mmcvf, {FlowKind::mmcvf, 0}, 1); }

/// Row i of the paper's system before it is reduced: V_i as a linear form in all coordinates r_m^{k+1} (3 #V), by the
/// splits of §4 written out with the weights, H_l = ½ ⟨n_l, Σ_m w_lm r_m⟩ and K_i = Σ_m ⟨w^K_im, r_m⟩.
Eigen::RowVectorXd papers_row(const FlowState& s, int i) {
  const OperatorSet& ops = s.ops;
  const Eigen::Index vertices = ops.H.size();
  Eigen::RowVectorXd on_H = Eigen::RowVectorXd::Zero(vertices), row = Eigen::RowVectorXd::Zero(3 * vertices);
  const double H = ops.H[i], K = ops.K[i], lap = ops.apply_laplacian(i, ops.H);
  const Vec3 grad = ops.apply_gradient(i, ops.H), dia = ops.apply_diamond(i, ops.H);
  for (int e = ops.offset[i]; e < ops.offset[i + 1]; ++e) {
    const int j = ops.index[e];
    for (int f = ops.offset[j]; f < ops.offset[j + 1]; ++f) on_H[ops.index[f]] += ops.laplacian[e] * ops.laplacian[f];
    on_H[j] += (2 * H * H - K) * ops.laplacian[e] + ops.gradient[e].dot(dia) +
               grad.dot(ops.diamond(i, ops.gradient[e])) - H * ops.gradient[e].dot(grad);
    row.segment<3>(3 * j) -= lap * ops.gauss[e] * ops.normal[i].transpose();
  }
  on_H[i] += 2 * H * lap - grad.squaredNorm();
  for (int l = 0; l < vertices; ++l)
    for (int e = ops.offset[l]; e < ops.offset[l + 1]; ++e)
      row.segment<3>(3 * ops.index[e]) += on_H[l] * 0.5 * ops.laplacian[e] * ops.normal[l].transpose();
  return row;
}

/// The paper's unknowns are the r_j^{k+1} in R³; its 3n × 3n system gives the same step as ours for s (NUMERICS §3).
TEST(FlowTerms, ReducedStepEqualsThePapersThreeByThreeBlocks) {
  const EvolutionState state = disturbed_state();
  const int n = state.patch.free_count;
  const FlowState flow_state(state.ops, n);
  const FlowSystem reduced = FlowSystem(FlowKind::mmcvf, flow_state);
  const double tau = 10 / slowest_decay_rate(FlowKind::mmcvf, state.patch);
  const Eigen::MatrixXd small = Eigen::MatrixXd::Identity(n, n) - tau * Eigen::MatrixXd(reduced.jacobian());
  const Eigen::VectorXd s = small.partialPivLu().solve(tau * reduced.velocity());

  Eigen::VectorXd now(3 * state.patch.vertex_count());
  for (int v = 0; v < state.patch.vertex_count(); ++v) now.segment<3>(3 * v) = state.patch.positions[v];
  Eigen::MatrixXd full = Eigen::MatrixXd::Identity(3 * n, 3 * n);
  Eigen::VectorXd rhs(3 * n);
  for (int i = 0; i < n; ++i) {
    const Eigen::RowVectorXd row = papers_row(flow_state, i);
    // The splits add up to the whole velocity when both levels are the present one.
    ASSERT_NEAR(row.dot(now), reduced.velocity()[i], 1e-8 * reduced.velocity().cwiseAbs().maxCoeff());
    full.middleRows<3>(3 * i) -= tau * state.ops.normal[i] * row.head(3 * n);
    rhs.segment<3>(3 * i) = now.segment<3>(3 * i) +
                            tau * state.ops.normal[i] * row.tail(row.size() - 3 * n).dot(now.tail(row.size() - 3 * n));
  }
  const Eigen::VectorXd next = full.partialPivLu().solve(rhs);
  for (int i = 0; i < n; ++i)
    ASSERT_LT((next.segment<3>(3 * i) - state.patch.positions[i] - s[i] * state.ops.normal[i]).norm(),
              1e-6 * s.cwiseAbs().maxCoeff());
}

TEST(FlowTerms, JacobianPredictsTheNextVelocity) {
  // V(r + εφn) ≈ V + ε Jφ up to the frozen operators; the leading terms must agree.
  const EvolutionState state = disturbed_state();
  const FlowState flow_state(state.ops, state.patch.free_count);
  for (FlowKind flow : {FlowKind::sdf, FlowKind::mmcvf}) {
    const FlowSystem system = FlowSystem(flow, flow_state);
    Eigen::VectorXd phi(state.patch.free_count);
    for (int i = 0; i < phi.size(); ++i) phi[i] = std::sin(12 * state.patch.positions[i].x() + 0.3 * i);
    const EvolutionState next = displaced(state, {}, Stencil::two_ring, 1e-6 * phi);
    const Eigen::VectorXd change =
        (flow_velocity(flow, FlowState(next.ops, next.patch.free_count)) - system.velocity()) / 1e-6;
    const Eigen::VectorXd predicted = system.times_jacobian(phi);
    EXPECT_LT((change - predicted).norm(), 0.1 * change.norm()) << to_string(flow);
  }
}

/// The filler of a hole in a flat sheet.
Patch flat_patch(const std::function<bool(const Vec3&)>& inside) {
  TriangleSoup grid = make_graph([](double, double) { return 0.0; }, 2, 56);
  const SurfaceModel model = make_surface_model(cut(grid, inside));
  std::vector<BoundaryLoop> holes;
  for (const BoundaryLoop& loop : find_boundary_loops(model))
    if (loop.kind == LoopKind::hole) holes.push_back(loop);
  EXPECT_EQ(holes.size(), 1u);
  return *start_patch(model, holes, {}, CancelToken()).patch;
}

Patch disc() {
  return flat_patch([](const Vec3& p) { return p.head<2>().norm() < 1 - 1e-9; });
}

TEST(DecayRate, OfADiscFollowsTheKnownEigenvalues) {
  // NUMERICS §4: disc of radius R, clamped: T = 1/λ₁ ≈ 2(R/2.41)² MCF, 2(R/3.2)⁴ SDF, 2(R/3.9)⁶ MMCVF.
  const Patch patch = disc();
  const double R = std::sqrt(patch_area(patch) / M_PI);
  EXPECT_NEAR(slowest_decay_rate(FlowKind::mcf, patch), std::pow(2.405 / R, 2) / 2, 0.03 * std::pow(2.405 / R, 2) / 2);
  EXPECT_NEAR(slowest_decay_rate(FlowKind::sdf, patch), std::pow(3.196 / R, 4) / 2, 0.25 * std::pow(3.196 / R, 4) / 2);
  EXPECT_NEAR(slowest_decay_rate(FlowKind::mmcvf, patch), std::pow(3.9 / R, 6) / 2, 0.5 * std::pow(3.9 / R, 6) / 2);
}

double exact_by_rough(FlowKind flow, const Patch& patch) {
  return slowest_decay_rate(flow, patch) / rough_decay_rate(flow, patch);
}

TEST(DecayRate, IsRoughlyForetoldByAreaAndRim) {
  for (FlowKind flow : all_flows) {
    const double of_disc = exact_by_rough(flow, disc());
    EXPECT_TRUE(of_disc > 0.5 && of_disc < 1.3) << to_string(flow) << ": " << of_disc;
  }
  // A long strip of width w has (2π/w)⁶ for (3.9/w)⁶; six cells across are fewer than the sixth order needs. A disc of this
  // slit's area would be off by another factor of 30.
  const Patch slit = flat_patch([](const Vec3& p) { return std::abs(p.x()) < 1.6 && std::abs(p.y()) < 0.21; });
  const double of_slit = exact_by_rough(FlowKind::mmcvf, slit);
  EXPECT_TRUE(of_slit > 1.2 && of_slit < 4) << of_slit;
  // A disc with as much area for its rim would be far wider than this bowl.
  const double of_bowl = exact_by_rough(FlowKind::mmcvf, test::exact_sphere_patch(4, -0.8));
  EXPECT_TRUE(of_bowl > 0.4 && of_bowl < 1.2) << of_bowl;
}

TEST(DecayRate, IsPositiveForEveryFlow) {
  const Patch patch = test::exact_sphere_patch(3, 0.8);
  for (FlowKind flow : all_flows) EXPECT_GT(slowest_decay_rate(flow, patch), 0) << to_string(flow);
}

TEST(DecayRate, ComesFromTheFactorsOfALinearFairingToo) {
  Patch patch = test::start_of(test::open_sphere(4, 0.8));
  test::disturb(patch, 0.05);
  const auto solver = make_spd_solver();
  linear_fairing(patch, Topology(patch.vertex_count(), patch.triangles), 0, robust_clamp, *solver);
  const Eigen::VectorXd mass = barycentric_areas(patch.positions, patch.triangles).head(patch.free_count);
  const double rate = slowest_decay_rate(FlowKind::mmcvf, patch);
  EXPECT_NEAR(slowest_decay_rate(*solver, mass), rate, 1e-6 * rate);
}

}  // namespace
}  // namespace loopmend
