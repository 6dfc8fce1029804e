// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/evolution.h"

#include "core/error.h"
#include "flows/flow_terms.h"
#include "mesh/quality.h"
#include "mesh/self_intersections.h"
#include "support/patches.h"

#include <gtest/gtest.h>

#include <map>

namespace loopmend {
namespace {

double to_sphere(const Vec3& p) { return std::abs(p.norm() - 1); }
double to_cylinder(const Vec3& p) { return std::abs(std::hypot(p.x(), p.y()) - 1); }

template <class Distance>
double rms(const Patch& patch, const Distance& distance) {
  double sum = 0;
  for (int i = 0; i < patch.free_count; ++i) sum += std::pow(distance(patch.to_mesh(patch.positions[i])), 2);
  return std::sqrt(sum / patch.free_count);
}

/// A cylinder with three pieces missing (Fig. 5.1a); its two ends are left open.
SurfaceModel pierced_cylinder() {
  return make_surface_model(cut(make_cylinder(6, 60), [](const Vec3& p) {
    for (int k = 0; k < 3; ++k)
      if ((p - Vec3(std::cos(2.1 * k), std::sin(2.1 * k), 2 + k)).norm() < 0.7) return true;
    return false;
  }));
}

std::vector<BoundaryLoop> holes_without_tube_ends(const SurfaceModel& model) {
  std::vector<BoundaryLoop> loops;
  for (const BoundaryLoop& loop : find_boundary_loops(model))
    if (loop.turning < -0.5) loops.push_back(loop);
  return loops;
}

struct Recovery {
  EvolutionMode mode;
  double bound;  ///< rms distance to the exact surface in diameters of the hole
};

class Recovers : public testing::TestWithParam<Recovery> {};
INSTANTIATE_TEST_SUITE_P(Modes, Recovers,
                         testing::Values(Recovery{EvolutionMode::steady, 2e-5}, Recovery{EvolutionMode::steps, 4e-5}));

TEST_P(Recovers, SphereFromThirtyPercentOfItsDiameter) {
  for (int level : {4, 5}) {
    EvolutionOptions options;
    options.mode = GetParam().mode;
    Evolution evolution(test::start_of(test::open_sphere(level, std::sqrt(1 - 0.09))), options);
    EXPECT_EQ(evolution.run(nullptr, {}), PatchStatus::converged);
    EXPECT_LT(rms(evolution.patch(), to_sphere), GetParam().bound * 0.6);
    EXPECT_LT(evolution.energy(), 1e-5 * evolution.initial_energy());
  }
}

TEST_P(Recovers, CylinderWithThreeMissingPieces) {
  const SurfaceModel model = pierced_cylinder();
  const std::vector<BoundaryLoop> holes = holes_without_tube_ends(model);
  ASSERT_EQ(holes.size(), 3u);
  EvolutionOptions options;
  options.mode = GetParam().mode;
  for (const BoundaryLoop& hole : holes) {
    Evolution evolution(*make_initial_patch(model, {hole}, {}, {}).patch, options);
    EXPECT_EQ(evolution.run(nullptr, {}), PatchStatus::converged);
    EXPECT_LT(rms(evolution.patch(), to_cylinder), GetParam().bound * hole.diameter);
  }
}

TEST_P(Recovers, SphereOnAnIrregularMesh) {
  EvolutionOptions options;
  options.mode = GetParam().mode;
  Evolution evolution(test::start_of(test::rough_open_sphere(4, 0.8)), options);
  EXPECT_EQ(evolution.run(nullptr, {}), PatchStatus::converged);
  EXPECT_LT(rms(evolution.patch(), to_sphere), 1e-4 * 1.2);
}

TEST(Evolution, HalfASphereComesBack) {
  Evolution evolution(test::start_of(test::open_sphere(4, 0.01)), {});
  EXPECT_EQ(evolution.run(nullptr, {}), PatchStatus::converged);
  EXPECT_LT(rms(evolution.patch(), to_sphere), 1e-5 * 2);
}

TEST(Evolution, EnergyNeverRisesInGaussNewtonAndTheExteriorStands) {
  const Patch start = test::start_of(test::rough_open_sphere(4, 0.5));
  EvolutionOptions exact;
  exact.boundary = BoundaryTrust::exact;
  Evolution evolution(start, exact);
  double last = evolution.initial_energy();
  evolution.run(
      [&](const Evolution& e, const StepRecord& record) {
        EXPECT_LE(record.energy, last * (1 + 1e-9));
        last = record.energy;
        const Patch& now = e.patch();
        const int shift = now.free_count - start.free_count;
        for (int i = start.free_count; i < start.vertex_count(); ++i)
          ASSERT_EQ(now.positions[i + shift], start.positions[i]);
        EXPECT_EQ(count_folds(now.positions, now.triangles, now.patch_triangles), 0);
      },
      {});
  EXPECT_GE(evolution.history().size(), 2u);
  EXPECT_LT(last, 1e-3 * evolution.initial_energy());
  const Patch& end = evolution.patch();
  EXPECT_TRUE(self_intersections(end.positions, end.triangles, end.patch_triangles).empty());
  EXPECT_GT(min_angle_deg(end.positions, end.triangles, end.patch_triangles), 10);
}

TEST(Evolution, TheFourFlowsFindTheirOwnSteadyStates) {
  const SurfaceModel model = test::open_sphere(4, 0.8);
  std::map<FlowKind, double> distance;
  for (FlowKind flow : {FlowKind::mcf, FlowKind::sdf, FlowKind::wf, FlowKind::mmcvf}) {
    EvolutionOptions options;
    options.flow = flow;
    Evolution evolution(test::start_of(model), options);
    EXPECT_EQ(evolution.run(nullptr, {}), PatchStatus::converged) << to_string(flow);
    distance[flow] = rms(evolution.patch(), to_sphere);
  }
  // The sphere is Willmore, SDF-stationary and MMCVF-stationary; it is no minimal surface.
  EXPECT_LT(distance[FlowKind::mmcvf], 5e-5);
  EXPECT_LT(distance[FlowKind::wf], 3e-4);
  EXPECT_LT(distance[FlowKind::sdf], 3e-4);
  EXPECT_GT(distance[FlowKind::mcf], 0.05);
}

TEST(Evolution, SurfaceDiffusionLowersTheAreaAtEveryStep) {
  Patch start = test::exact_sphere_patch(4, 0.8);
  test::disturb(start, 0.05);
  EvolutionOptions options;
  options.flow = FlowKind::sdf;
  options.mode = EvolutionMode::steps;
  options.sigma = 0.1;
  options.max_steps = 5;
  Evolution evolution(start, options);
  double last = evolution.energy();
  evolution.run(
      [&](const Evolution&, const StepRecord& record) {
        EXPECT_LT(record.energy, last);
        last = record.energy;
      },
      {});
  EXPECT_EQ(evolution.history().size(), 5u);
}

TEST(Evolution, GmresAndDirectTakeTheSameSteps) {
  EvolutionOptions direct, gmres;
  direct.mode = gmres.mode = EvolutionMode::steps;
  direct.solver = SolverKind::direct;
  gmres.solver = SolverKind::gmres;
  const Patch start = test::start_of(test::open_sphere(4, 0.8));
  Evolution a(start, direct), b(start, gmres);
  a.run(nullptr, {});
  b.run(nullptr, {});
  ASSERT_GE(a.history().size(), 2u);
  ASSERT_EQ(a.history().size(), b.history().size());
  double way = 0;
  for (int i = 0; i < start.free_count; ++i) way = std::max(way, (a.patch().positions[i] - start.positions[i]).norm());
  EXPECT_GT(way, 0.01);
  for (int i = 0; i < a.patch().free_count; ++i)
    ASSERT_LT((a.patch().positions[i] - b.patch().positions[i]).norm(), 2e-6);  // of the way, 1e-4
}

EvolutionOptions flow_steps(double sigma, int steps) {
  EvolutionOptions options;
  options.mode = EvolutionMode::steps;
  options.sigma = sigma;
  options.max_steps = steps;
  return options;
}

Patch bumpy_sphere_patch() {
  Patch patch = test::exact_sphere_patch(5, 0.8);
  test::disturb(patch, 0.01);
  return patch;
}

TEST(Evolution, OneFactorServesAllFlowStepsForAnySigma) {
  for (double sigma : {1e-4, 0.1, 10.0, 1e4}) {
    const Patch start = bumpy_sphere_patch();
    Evolution evolution(start, flow_steps(sigma, 5));
    evolution.run(nullptr, {});
    int factorizations = 0;
    for (const StepRecord& step : evolution.history()) {
      factorizations += step.factorizations;
      EXPECT_LE(step.iterations, 20) << sigma;
      EXPECT_GT(step.iterations, 1) << sigma;
    }
    EXPECT_EQ(factorizations, 1) << sigma;
  }
}

TEST(Evolution, TheSolversErrorIsFarBelowThatOfTheStep) {
  const Patch start = bumpy_sphere_patch();
  EvolutionOptions direct = flow_steps(10, 1), halves = flow_steps(5, 2);
  direct.solver = halves.solver = SolverKind::direct;
  Evolution iterated(start, flow_steps(10, 1)), exact(start, direct), finer(start, halves);
  for (Evolution* evolution : {&iterated, &exact, &finer}) evolution->run(nullptr, {});
  double solver_error = 0, step_error = 0;
  for (int i = 0; i < start.free_count; ++i) {
    const Vec3& p = exact.patch().positions[i];
    solver_error += (iterated.patch().positions[i] - p).squaredNorm();
    step_error += (finer.patch().positions[i] - p).squaredNorm();
  }
  EXPECT_GT(solver_error, 0);
  EXPECT_LT(std::sqrt(solver_error), 0.01 * std::sqrt(step_error));
  EXPECT_NEAR(iterated.energy(), exact.energy(), 0.01 * exact.energy());
}

TEST(Evolution, AWornMeshIsCaredForBetweenFlowSteps) {
  Patch start = bumpy_sphere_patch();
  for (int i = 0; i < start.free_count; i += 7) start.positions[i] += Vec3(0.6, 0.2, 0) / std::sqrt(start.free_count);
  const auto worst_angle = [](const Patch& p) { return min_angle_deg(p.positions, p.triangles, p.patch_triangles); };
  ASSERT_LT(worst_angle(start), 22);
  Evolution evolution(start, flow_steps(10, 4));
  evolution.run(nullptr, {});
  EXPECT_GT(worst_angle(evolution.patch()), 1.3 * worst_angle(start));
}

TEST(Evolution, SmallSigmaTakesSmallSteps) {
  EvolutionOptions options;
  options.mode = EvolutionMode::steps;
  options.sigma = 0.1;
  options.max_steps = 3;
  Evolution evolution(test::start_of(test::open_sphere(4, 0.8)), options);
  EXPECT_EQ(evolution.run(nullptr, {}), PatchStatus::step_limit);
  EXPECT_NE(evolution.message().english(), "");
  EXPECT_EQ(evolution.history().size(), 3u);
  options.max_steps = 200;
  options.sigma = 100;
  evolution.set_options(options);
  EXPECT_EQ(evolution.run(nullptr, {}), PatchStatus::converged);
}

TEST(Evolution, CancelKeepsTheLastAcceptedState) {
  const CancelToken cancel;
  EvolutionOptions options;
  options.mode = EvolutionMode::steps;
  options.sigma = 0.01;
  Evolution evolution(test::start_of(test::open_sphere(4, 0.8)), options);
  Points last;
  const PatchStatus status = evolution.run(
      [&](const Evolution& e, const StepRecord& record) {
        last = e.patch().positions;
        if (record.step == 2) cancel.cancel();
      },
      cancel);
  EXPECT_EQ(status, PatchStatus::cancelled);
  EXPECT_EQ(evolution.history().size(), 2u);
  EXPECT_EQ(evolution.patch().positions, last);
}

TEST(Evolution, OptionsOutOfRangeThrow) {
  const Patch patch = test::start_of(test::open_sphere(3, 0.8));
  EvolutionOptions options;
  options.sigma = 0;
  EXPECT_THROW(Evolution(patch, options), InvalidArgument);
  options = {};
  options.max_steps = 0;
  EXPECT_THROW(Evolution(patch, options), InvalidArgument);
  options = {};
  options.bending = -1;
  EXPECT_THROW(Evolution(patch, options), InvalidArgument);
  Patch empty = patch;
  empty.free_count = 0;
  EXPECT_THROW(Evolution(empty, {}), InvalidArgument);
}

TEST(Evolution, DoesNotDependOnTheUnit) {
  const auto solve = [](double unit) {
    TriangleSoup soup = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.8; });
    for (Vec3& p : soup.points) p *= unit;
    Evolution evolution(test::start_of(make_surface_model(soup)), {});
    EXPECT_EQ(evolution.run(nullptr, {}), PatchStatus::converged);
    Points points;
    for (int i = 0; i < evolution.patch().free_count; ++i)
      points.push_back(evolution.patch().to_mesh(evolution.patch().positions[i]) / unit);
    return points;
  };
  // A power of two, so that the coordinates have the same bits but for the exponent: ties fall alike.
  const Points millimetres = solve(1), metres = solve(0x1p-10);
  ASSERT_EQ(millimetres.size(), metres.size());
  ASSERT_GT(metres.size(), 100u);
  for (std::size_t i = 0; i < metres.size(); ++i) EXPECT_LT((millimetres[i] - metres[i]).norm(), 1e-9);
}

}  // namespace
}  // namespace loopmend
