// SPDX-License-Identifier: GPL-3.0-or-later
// What a fill says of itself must be what was done: status, method and reason, for each loop by itself.
#include "evolution/compare_flows.h"
#include "evolution/fill_loops.h"
#include "evolution/proportion.h"
#include "io/read_mesh.h"
#include "mesh/region.h"
#include "mesh/self_intersections.h"
#include "samples/random.h"
#include "support/patches.h"
#include "support/small_polyhedra.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace loopmend {
namespace {

std::vector<BoundaryLoop> loops_of_kind(const SurfaceModel& model, LoopKind kind) {
  std::vector<BoundaryLoop> loops;
  for (const BoundaryLoop& loop : find_boundary_loops(model))
    if (loop.kind == kind) loops.push_back(loop);
  return loops;
}

double relief_of_scans(const Vec3& p) {
  return 0.01 * std::sin(17 * p.x()) * std::sin(19 * p.y()) + 0.004 * std::sin(43 * p.x() + 7 * p.z()) +
         0.002 * std::cos(71 * p.y() - 23 * p.x());
}

/// A unit sphere with relief where x > 0.05 and two caps missing, whose rims are some edges apart: one in the smooth part,
/// one in the relief.
TriangleSoup half_rough_sphere() {
  TriangleSoup soup = trim_rims(cut(make_icosphere(5), [](const Vec3& p) {
    return (p - Vec3(-0.26, 0, 1).normalized()).norm() < 0.14 || (p - Vec3(0.26, 0, 1).normalized()).norm() < 0.14;
  }));
  for (Vec3& p : soup.points)
    if (p.x() > 0.05) p *= 1 + 2 * relief_of_scans(p);
  return soup;
}

TEST(Outcome, AnOpenBoxIsClosedByFairingAndSaysSo) {
  for (const test::NamedMesh& solid : {test::box(1), test::prism(4), test::prism(3), test::pyramid(4)})
    for (const test::NamedMesh& open : test::openings_of(solid)) {
      SurfaceModel model = make_surface_model(open.soup);
      const std::vector<LoopResult> results = fill_loops(model, loops_of_kind(model, LoopKind::hole), {}, nullptr, {});
      for (const LoopResult& r : results) {
        ASSERT_TRUE(is_filled(r.status)) << open.name << ": " << r.message;
        EXPECT_NE(r.status, LoopStatus::converged) << open.name << ": no flow can run on so few vertices";
        if (r.status == LoopStatus::faired) EXPECT_FALSE(r.reason.empty()) << open.name;
        EXPECT_FALSE(r.method.empty()) << open.name;
      }
    }
}

/// Remeshing once collapsed the only vertex that the flow could move, and the next step ran on a patch without any.
TEST(Outcome, ARegionOfOneVertexKeepsIt) {
  const test::NamedMesh open = test::openings_of(test::pyramid(6)).at(1);
  const SurfaceModel model = make_surface_model(open.soup);
  const Region region = make_region(model, {open.soup.triangles.back()[0], open.soup.triangles.back()[1]});
  ASSERT_EQ(region.patch.free_count, 1);
  for (FlowKind flow : {FlowKind::mmcvf, FlowKind::wf, FlowKind::sdf, FlowKind::mcf})
    for (EvolutionMode mode : {EvolutionMode::steady, EvolutionMode::steps}) {
      EvolutionOptions options;
      options.flow = flow;
      options.mode = mode;
      EXPECT_EQ(evolve_patch(region.patch, options, nullptr, {}).patch.free_count, 1);
    }
}

TEST(Outcome, ARobustFairingIsNotCalledConverged) {
  TriangleSoup soup = trim_rims(cut(make_icosphere(5), [](const Vec3& p) { return p.z() > 0.9; }));
  for (Vec3& p : soup.points) p *= 1 + 2 * relief_of_scans(p);
  for (BoundaryTrust boundary : {BoundaryTrust::automatic, BoundaryTrust::exact, BoundaryTrust::robust}) {
    SurfaceModel model = make_surface_model(soup);
    FillOptions options;
    options.evolution->boundary = boundary;
    const std::vector<LoopResult> results =
        fill_loops(model, loops_of_kind(model, LoopKind::hole), options, nullptr, {});
    ASSERT_EQ(results.size(), 1u);
    if (boundary == BoundaryTrust::exact) {
      EXPECT_EQ(results[0].method, "mmcvf");
      EXPECT_TRUE(results[0].reason.empty()) << results[0].reason;
      EXPECT_GT(results[0].steps, 0);
    } else {
      EXPECT_EQ(results[0].status, LoopStatus::faired);
      EXPECT_EQ(results[0].method, "robust_fairing");
      EXPECT_EQ(results[0].reason.empty(), boundary == BoundaryTrust::robust) << results[0].reason;
    }
  }
}

TEST(Outcome, OneRoughHoleDoesNotDecideForItsNeighbour) {
  const TriangleSoup soup = half_rough_sphere();
  SurfaceModel together = make_surface_model(soup);
  const std::vector<BoundaryLoop> holes = loops_of_kind(together, LoopKind::hole);
  ASSERT_EQ(holes.size(), 2u);
  ASSERT_EQ(group_loops(together, holes).size(), 1u) << "the neighborhoods must overlap";
  const std::vector<LoopResult> both = fill_loops(together, holes, {}, nullptr, {});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_NE(both[0].method, both[1].method);
  for (int k : {0, 1}) {
    SurfaceModel one = make_surface_model(soup);
    const std::vector<LoopResult> alone = fill_loops(one, {holes[k]}, {}, nullptr, {});
    EXPECT_EQ(alone.at(0).method, both[k].method);
    EXPECT_EQ(alone.at(0).reason, both[k].reason);
  }
}

TEST(Outcome, ComparisonsAreOfTheFlowsTheyName) {
  TriangleSoup soup = trim_rims(cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.9; }));
  for (Vec3& p : soup.points) p *= 1 + 2 * relief_of_scans(p);
  const Patch start = test::start_of(make_surface_model(soup));
  EvolutionOptions base;
  base.max_steps = 6;
  const FlowComparison comparison = compare_flows(start, base, nullptr, {});
  ASSERT_EQ(comparison.runs.size(), 4u);
  for (const FlowRun& run : comparison.runs) {
    EXPECT_EQ(run.evolved.method, Method::flow);
    EXPECT_NE(run.evolved.status, EvolutionStatus::faired);
  }
}

/// What was called converged must stay where it is when the same flow starts from there.
TEST(Outcome, ConvergedStaysWhereItIs) {
  TriangleSoup rough = trim_rims(cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.85; }));
  for (Vec3& p : rough.points) p *= 1 + 3 * relief_of_scans(p);
  const Patch starts[] = {test::start_of(test::open_sphere(4, 0.9)), test::start_of(make_surface_model(rough))};
  int converged = 0;
  for (const Patch& start : starts)
    for (FlowKind flow : {FlowKind::mmcvf, FlowKind::wf, FlowKind::sdf, FlowKind::mcf})
      for (double sigma : {1.0, 10.0, 1000.0}) {
        EvolutionOptions options;
        options.flow = flow;
        options.mode = EvolutionMode::steps;
        options.sigma = sigma;
        options.max_steps = 80;
        Evolution first(start, options);
        if (first.run(nullptr, {}) != EvolutionStatus::converged) continue;
        ++converged;
        Evolution again(first.patch(), options);
        again.run(nullptr, {});
        ASSERT_EQ(again.patch().free_count, first.patch().free_count);
        double move = 0;
        for (int i = 0; i < first.patch().free_count; ++i)
          move = std::max(move, (again.patch().positions[i] - first.patch().positions[i]).norm());
        const double radius = patch_radius(first.patch());
        EXPECT_LT(move, 5e-3 * radius) << static_cast<int>(flow) << ", sigma " << sigma << ", rough "
                                       << (&start - starts);
      }
  EXPECT_GE(converged, 12);
}

TEST(Outcome, StepsThatCollapseAreNotConverged) {
  // A saddle of relief as large as the hole: large semi-implicit steps fail there.
  TriangleSoup soup = trim_rims(cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.8; }));
  for (Vec3& p : soup.points) p *= 1 + 8 * relief_of_scans(p);
  const Patch start = test::start_of(make_surface_model(soup));
  for (double sigma : {1.0, 1000.0}) {
    EvolutionOptions options;
    options.mode = EvolutionMode::steps;
    options.sigma = sigma;
    options.max_steps = 40;
    Evolution evolution(start, options);
    const EvolutionStatus status = evolution.run(nullptr, {});
    if (status == EvolutionStatus::converged) EXPECT_GE(evolution.history().back().sigma, 0.1 * sigma);
  }
}

TEST(Proportion, ASphereOfWhichMostIsMissingIsInProportion) {
  const SurfaceModel model = test::open_sphere(5, std::cos(2.0));
  const Patch initial = test::start_of(model);
  Patch sphere = initial;  // every vertex on the sphere, spread over the cap by its height in the flat patch
  const double rim = std::sin(2.0);
  for (int i = 0; i < sphere.free_count; ++i) {
    const Vec3 p = initial.to_mesh(initial.positions[i]);
    const double share = std::min(1.0, std::hypot(p.x(), p.y()) / rim), angle = 2.0 * share;
    const double turn = std::atan2(p.y(), p.x());
    sphere.positions[i] =
        sphere.to_frame({std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), std::cos(angle)});
  }
  const std::vector<Proportion> round = proportions_of(sphere, initial);
  ASSERT_EQ(round.size(), 1u);
  EXPECT_GT(round[0].area, 2.5) << "else this test says nothing about large patches";
  EXPECT_LT(round[0].energy, 1);
  EXPECT_FALSE(is_out_of_proportion(round[0]));
  // The same area as a nose: the energy tells.
  Patch nose = initial;
  for (int i = 0; i < nose.free_count; ++i) {
    const Vec3 p = initial.to_mesh(initial.positions[i]);
    const double r = std::hypot(p.x(), p.y()) / rim;
    nose.positions[i] = nose.to_frame(p + Vec3(0, 0, 4 * std::exp(-12 * r * r)));
  }
  const std::vector<Proportion> bulged = proportions_of(nose, initial);
  EXPECT_TRUE(is_out_of_proportion(bulged.at(0))) << describe(bulged[0]);
  EXPECT_EQ(proportions_of(initial, initial).at(0).area, 1);
}

TEST(Proportion, ATubeThatEndsOnACreaseGrowsNoLump) {
  for (const char* name : {"tube_on_flange.off", "tube_with_lip.off"}) {
    const std::filesystem::path file = std::filesystem::path(LOOPMEND_SHARED_DIR) / "scans2" / "hard" / name;
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
    SurfaceModel model = make_surface_model(read_mesh(file).soup);
    const std::vector<BoundaryLoop> holes = loops_of_kind(model, LoopKind::hole);
    ASSERT_FALSE(holes.empty());
    for (const LoopResult& r : fill_loops(model, holes, {}, nullptr, {})) {
      EXPECT_TRUE(is_filled(r.status)) << r.message;
      EXPECT_LT(r.proportion.area, 1.5) << name << ": " << describe(r.proportion);
    }
  }
}

}  // namespace
}  // namespace loopmend
