// SPDX-License-Identifier: GPL-3.0-or-later
// What a fill says of itself must be what was done: status, method and reason, for each loop by itself.
#include "core/error.h"
#include "core/random.h"
#include "io/read_mesh.h"
#include "mesh/region.h"
#include "pipeline/compare.h"
#include "pipeline/evolve_patch.h"
#include "pipeline/fill_holes.h"
#include "pipeline/proportion.h"
#include "support/patches.h"
#include "support/small_polyhedra.h"

#include "operators/curvature_energy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>

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

TEST(Outcome, AnOpenBoxIsClosedByFairingAndSaysSo) {
  int filled = 0;
  for (const test::NamedMesh& solid : {test::box(1), test::prism(4), test::prism(3), test::pyramid(4)})
    for (const test::NamedMesh& open : test::openings_of(solid)) {
      SurfaceModel model = make_surface_model(open.soup);
      const std::vector<HoleResult> results = fill_holes(model, loops_of_kind(model, LoopKind::hole), {}, nullptr, {});
      for (const HoleResult& r : results) {
        ASSERT_TRUE(is_filled(r.status)) << open.name << ": " << r.message;
        if (r.status == PatchStatus::faired) {
          EXPECT_FALSE(r.reason().empty()) << open.name;
        }
        EXPECT_FALSE(r.method().empty()) << open.name;
        ++filled;
      }
    }
  EXPECT_GE(filled, 12);
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

TEST(Outcome, TheAttemptsAreNamed) {
  FillOptions none;
  none.evolution.reset();
  SurfaceModel flat = test::open_sphere(3, 0.8), model = flat;
  const HoleResult initial = fill_holes(flat, find_boundary_loops(flat), none, nullptr, {}).at(0);
  EXPECT_TRUE(initial.outcome().attempts.empty());
  EXPECT_EQ(initial.outcome().made_by, "");
  const HoleResult flow = fill_holes(model, find_boundary_loops(model), {}, nullptr, {}).at(0);
  EXPECT_EQ(flow.outcome().attempts, std::vector<std::string>{"flow"});
  EXPECT_EQ(flow.outcome().made_by, "flow");
}

TEST(Outcome, ARobustFairingIsNotCalledConverged) {
  TriangleSoup soup = trim_boundaries(cut(make_icosphere(5), [](const Vec3& p) { return p.z() > 0.9; }));
  const std::vector<double> relief = test::random_relief(soup, 3);
  for (std::size_t i = 0; i < soup.points.size(); ++i) soup.points[i] *= 1 + 0.005 * relief[i];
  for (BoundaryTrust boundary : {BoundaryTrust::automatic, BoundaryTrust::exact, BoundaryTrust::robust}) {
    SurfaceModel model = make_surface_model(soup);
    FillOptions options;
    options.evolution->boundary = boundary;
    const std::vector<HoleResult> results =
        fill_holes(model, loops_of_kind(model, LoopKind::hole), options, nullptr, {});
    ASSERT_EQ(results.size(), 1u);
    if (boundary == BoundaryTrust::exact) {
      EXPECT_EQ(results[0].method(), "mmcvf");
      EXPECT_TRUE(results[0].reason().empty()) << results[0].reason();
      EXPECT_GT(results[0].steps(), 0);
    } else if (boundary == BoundaryTrust::robust) {
      EXPECT_EQ(results[0].status, PatchStatus::faired);
      EXPECT_EQ(results[0].method(), "robust_fairing");
      EXPECT_EQ(results[0].reason().english(), "");
    } else {
      EXPECT_TRUE(is_at_end(results[0].status)) << to_string(results[0].status);
      EXPECT_EQ(results[0].method(), "mmcvf_split");
      EXPECT_NE(results[0].reason().english().find("has relief"), std::string::npos) << results[0].reason();
    }
  }
}

/// Each hole has the method and the reason that it has alone, although the neighborhoods overlap.
void expect_methods_of_their_own(const std::filesystem::path& file, std::size_t count, std::size_t most_groups) {
  const SurfaceModel scan = make_surface_model(read_mesh(file).soup);
  const std::vector<BoundaryLoop> holes = loops_of_kind(scan, LoopKind::hole);
  ASSERT_EQ(holes.size(), count);
  ASSERT_LE(group_loops(scan, holes).size(), most_groups) << "the neighborhoods must overlap";
  SurfaceModel together = scan;
  const std::vector<HoleResult> all = fill_holes(together, holes, {}, nullptr, {});
  for (std::size_t k = 0; k < holes.size(); ++k) {
    SurfaceModel one = scan;
    const HoleResult alone = fill_holes(one, {holes[k]}, {}, nullptr, {}).at(0);
    EXPECT_EQ(alone.method(), all[k].method()) << "hole " << holes[k].number;
    EXPECT_EQ(alone.reason(), all[k].reason()) << "hole " << holes[k].number;
  }
}

TEST(Outcome, OneRoughHoleDoesNotDecideForItsNeighbour) {
  expect_methods_of_their_own(std::filesystem::path(LOOPMEND_TEST_DATA) / "ball.obj", 3, 2);
}

/// The windows of a model plane lie close together, some in smooth parts of its skin.
TEST(Outcome, OneRoughHoleDoesNotDecideForItsNeighbourOnAPlane) {
  const std::filesystem::path file = std::filesystem::path(LOOPMEND_SHARED_DIR) / "data" / "plane_holes.obj";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
  expect_methods_of_their_own(file, 27, 9);
}

TEST(Outcome, ComparisonsAreOfTheFlowsTheyName) {
  TriangleSoup soup = trim_boundaries(cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.9; }));
  for (Vec3& p : soup.points) p *= 1 + 2 * relief_of_scans(p);
  const Patch start = test::start_of(make_surface_model(soup));
  EvolutionOptions base;
  base.max_steps = 6;
  const FlowComparison comparison = compare_flows(start, base, nullptr, {});
  ASSERT_EQ(comparison.runs.size(), 4u);
  for (const ComparedFlow& run : comparison.runs) {
    EXPECT_EQ(run.outcome.method, Method::flow);
    EXPECT_NE(run.outcome.status, PatchStatus::faired);
  }
}

/// The initial patches of a smooth and a rough sphere, and of real holes where the scans are there.
std::vector<Patch> starts_of_all_kinds() {
  TriangleSoup rough = trim_boundaries(cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.85; }));
  for (Vec3& p : rough.points) p *= 1 + 3 * relief_of_scans(p);
  std::vector<Patch> starts{test::start_of(test::open_sphere(4, 0.9)), test::start_of(make_surface_model(rough))};
  for (const char* name : {"head_holes.ply", "demosthenes.obj"}) {
    const std::filesystem::path file = std::filesystem::path(LOOPMEND_SHARED_DIR) / "data" / name;
    if (!std::filesystem::exists(file)) continue;
    const SurfaceModel scan = make_surface_model(read_mesh(file).soup);
    starts.push_back(*make_initial_patch(scan, {loops_of_kind(scan, LoopKind::hole).front()}, {}, {}).patch);
  }
  return starts;
}

/// What was called converged must stay where it is when the same flow starts from there.
TEST(Outcome, ConvergedStaysWhereItIs) {
  const std::vector<Patch> starts = starts_of_all_kinds();
  int converged = 0;
  for (std::size_t k = 0; k < starts.size(); ++k)
    for (FlowKind flow : {FlowKind::mmcvf, FlowKind::wf, FlowKind::sdf, FlowKind::mcf})
      for (double sigma : {0.0, 1.0, 10.0, 1000.0}) {  // 0: straight to the steady state
        EvolutionOptions options;
        options.flow = flow;
        options.boundary = BoundaryTrust::exact;
        options.mode = sigma > 0 ? EvolutionMode::steps : EvolutionMode::steady;
        options.start = SteadyStart::as_given;
        if (sigma > 0) options.sigma = sigma;
        options.max_steps = 80;
        Evolution first(starts[k], options);
        if (first.run(nullptr, {}) != PatchStatus::converged) continue;
        ++converged;
        Evolution again(first.patch(), options);
        again.run(nullptr, {});
        ASSERT_EQ(again.patch().free_count, first.patch().free_count);
        double move = 0;
        for (int i = 0; i < first.patch().free_count; ++i)
          move = std::max(move, (again.patch().positions[i] - first.patch().positions[i]).norm());
        EXPECT_LT(move, 1e-2 * patch_radius(first.patch()))
            << static_cast<int>(flow) << ", sigma " << sigma << ", start " << k;
      }
  EXPECT_GE(converged, 15);
}

/// The nose of a scanned head: the flow grows there without end, and called that converged at any size of step.
TEST(Outcome, AGrowingNoseIsNotConverged) {
  const std::filesystem::path file = std::filesystem::path(LOOPMEND_SHARED_DIR) / "data" / "head_holes.ply";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
  const SurfaceModel scan = make_surface_model(read_mesh(file).soup);
  std::vector<BoundaryLoop> nose = loops_of_kind(scan, LoopKind::hole);
  std::erase_if(nose, [](const BoundaryLoop& loop) { return loop.number != 5; });
  ASSERT_EQ(nose.size(), 1u);
  for (double sigma : {1.0, 10.0, 1000.0}) {
    SurfaceModel model = scan;
    FillOptions options;
    options.evolution->mode = EvolutionMode::steps;
    options.evolution->sigma = sigma;
    options.evolution->max_steps = 100;
    const HoleResult result = fill_holes(model, nose, options, nullptr, {}).at(0);
    EXPECT_NE(result.status, PatchStatus::converged) << sigma << ": " << result.proportion().area;
    EXPECT_EQ(result.method(), "mmcvf");
    EXPECT_FALSE(result.message.empty());
  }
}

/// A sphere of which an eighth is left: where the flow ends far from it, that is not called converged.
TEST(Outcome, ALargeOpeningIsRightOrNotConverged) {
  for (double opening : {1.8, 2.1, 2.4}) {
    SurfaceModel model = test::open_sphere(5, std::cos(opening));
    const std::size_t first = model.soup.points.size();
    const std::vector<HoleResult> results = fill_holes(model, find_boundary_loops(model), {}, nullptr, {});
    ASSERT_EQ(results.size(), 1u);
    double worst = 0;
    for (std::size_t i = first; i < model.soup.points.size(); ++i)
      worst = std::max(worst, std::abs(model.soup.points[i].norm() - 1));
    EXPECT_TRUE(worst < 0.01 || results[0].status != PatchStatus::converged)
        << opening << ": " << worst << " off, energy " << results[0].proportion().energy;
  }
}

/// The malformed files that can be read at all are tiny, and hold whatever no scanner would make.
TEST(Outcome, OddFilesAreFilledOrRefusedWithAReason) {
  const std::filesystem::path folder = std::filesystem::path(LOOPMEND_SHARED_DIR) / "malformed";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
  int files = 0, filled = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::optional<SurfaceModel> model;
    try {
      model = make_surface_model(read_mesh(entry.path()).soup);
    } catch (const Error&) {
      continue;
    }
    ++files;
    std::vector<BoundaryLoop> loops = find_boundary_loops(*model);
    std::erase_if(loops, [](const BoundaryLoop& loop) {
      return loop.kind != LoopKind::hole && loop.kind != LoopKind::outer_rim;
    });
    for (const HoleResult& r : fill_holes(*model, loops, {}, nullptr, {})) {
      filled += is_filled(r.status);
      EXPECT_TRUE(is_filled(r.status) || !r.message.empty()) << entry.path();
      EXPECT_EQ(is_filled(r.status), !r.method().empty()) << entry.path();
    }
  }
  EXPECT_GE(files, 20);
  EXPECT_GE(filled, 5);
}

TEST(Proportion, ASphereOfWhichMostIsMissingIsInProportionAndANoseIsNot) {
  SurfaceModel model = test::open_sphere(5, std::cos(2.0));
  const Patch initial = test::start_of(model);
  EXPECT_EQ(proportions_of(initial, initial).at(0).area, 1);
  const std::vector<HoleResult> results = fill_holes(model, find_boundary_loops(model), {}, nullptr, {});
  const Proportion sphere = results.at(0).proportion();
  EXPECT_GT(sphere.area, 2.5) << "else this test says nothing about large patches";
  EXPECT_LT(sphere.energy, 0.1);
  EXPECT_EQ(results[0].status, PatchStatus::converged);
  // About the same area as a nose: the energy tells.
  Patch nose = initial;
  const double boundary = std::sin(2.0);
  for (int i = 0; i < nose.free_count; ++i) {
    const Vec3 p = initial.to_mesh(initial.positions[i]);
    const double r = std::hypot(p.x(), p.y()) / boundary;
    nose.positions[i] = nose.to_frame(p + Vec3(0, 0, 4 * std::exp(-12 * r * r)));
  }
  const std::vector<Proportion> bulged = proportions_of(nose, initial);
  EXPECT_TRUE(is_out_of_proportion(bulged.at(0))) << bulged[0].area;
  // The same in any position of the scan.
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  Patch turned = nose, turned_initial = initial;
  for (Vec3& p : turned.positions) p = turn * p;
  for (Vec3& p : turned_initial.positions) p = turn * p;
  EXPECT_NEAR(proportions_of(turned, turned_initial).at(0).depth, bulged[0].depth, 1e-9);
}

TEST(Proportion, ATubeThatEndsOnACreaseGrowsNoLump) {
  for (const char* name : {"tube_on_flange.off", "tube_with_lip.off"}) {
    const std::filesystem::path file = std::filesystem::path(LOOPMEND_SHARED_DIR) / "scans2" / "hard" / name;
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
    SurfaceModel model = make_surface_model(read_mesh(file).soup);
    const std::vector<BoundaryLoop> holes = loops_of_kind(model, LoopKind::hole);
    ASSERT_FALSE(holes.empty());
    for (const HoleResult& r : fill_holes(model, holes, {}, nullptr, {})) {
      EXPECT_TRUE(is_filled(r.status)) << r.message;
      EXPECT_LT(r.proportion().area, 2.2) << name;
    }
  }
}

/// At ten vertices of the largest hole the flow goes back towards its start, which once left a needle there: the mean curvature
/// jumped by 190 times as much as it did before, and the status said "converged".
TEST(Outcome, NoPatchIsKeptWhoseCurvatureTearsAtTheSeam) {
  const std::filesystem::path file = std::filesystem::path(LOOPMEND_SHARED_DIR) / "data" / "doll.obj";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
  SurfaceModel model = make_surface_model(read_mesh(file).soup);
  const std::vector<HoleResult> results = fill_holes(model, loops_of_kind(model, LoopKind::hole), {}, nullptr, {});
  ASSERT_EQ(results.size(), 3U);
  for (const HoleResult& r : results) {
    EXPECT_TRUE(is_at_end(r.status)) << to_string(r.status) << r.message;
    EXPECT_NE(r.verdict().grade, Grade::bad) << r.verdict().message();
    EXPECT_LT(r.seam_after().h_jump_rms, 2 * r.seam_before().h_jump_rms) << r.loop.number;
  }
}

}  // namespace
}  // namespace loopmend
