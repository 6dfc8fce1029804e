// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/fill_holes.h"

#include "core/error.h"
#include "io/read_mesh.h"
#include "mesh/self_intersections.h"
#include "samples/mesh_facts.h"
#include "samples/sample_scan.h"
#include "support/filled_surface.h"
#include "support/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <mutex>
#include <numbers>
#include <set>

namespace loopmend {
namespace {

/// Several holes, two of them three edges apart.
SurfaceModel holey_sphere() {
  return make_surface_model(trim_boundaries(cut(make_icosphere(5), [](const Vec3& p) {
    for (const Vec3& c : {Vec3(0, 0, 1), Vec3(0.5, 0, 0.86), Vec3(0, -1, 0), Vec3(-1, 0, 0)})
      if ((p - c).norm() < 0.2) return true;
    return false;
  })));
}

std::vector<BoundaryLoop> holes_of(const SurfaceModel& model) {
  std::vector<BoundaryLoop> holes;
  for (const BoundaryLoop& loop : find_boundary_loops(model))
    if (loop.kind == LoopKind::hole) holes.push_back(loop);
  return holes;
}

void expect_input_first(const TriangleSoup& before, const TriangleSoup& after) {
  ASSERT_GE(after.points.size(), before.points.size());
  EXPECT_EQ(std::memcmp(before.points.data(), after.points.data(), before.points.size() * sizeof(Vec3)), 0);
  EXPECT_TRUE(std::equal(before.triangles.begin(), before.triangles.end(), after.triangles.begin()));
}

TEST(GroupLoops, NeighboursBelongTogether) {
  const SurfaceModel model = holey_sphere();
  const std::vector<BoundaryLoop> holes = holes_of(model);
  ASSERT_EQ(holes.size(), 4u);
  const auto groups = group_loops(model, holes);
  ASSERT_EQ(groups.size(), 3u);
  std::size_t largest = 0;
  for (const auto& group : groups) largest = std::max(largest, group.size());
  EXPECT_EQ(largest, 2u);
}

TEST(FillLoops, WhatNeedsTooMuchMemoryIsLeftWithItsReasonAndTheRestIsFilled) {
  // A wide hole and a narrow one, far apart: some 2500 and 20 new vertices.
  SurfaceModel model = make_surface_model(trim_boundaries(
      cut(make_icosphere(5), [](const Vec3& p) { return p.z() > 0.5 || (p - Vec3(0, 0, -1)).norm() < 0.1; })));
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  ASSERT_EQ(loops.size(), 2u);
  FillOptions options;
  options.most_memory_mb = 5;
  const std::vector<HoleResult> results = fill_holes(model, loops, options, nullptr, {});
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].status, PatchStatus::failed);
  EXPECT_NE(results[0].message.english().find("5 MB are free for it"), std::string::npos) << results[0].message;
  EXPECT_TRUE(is_filled(results[1].status)) << results[1].message;
}

TEST(FillLoops, ABoundOfMemoryThatSufficesChangesNothing) {
  SurfaceModel bounded = holey_sphere(), free = holey_sphere();
  FillOptions options;
  options.most_memory_mb = 40;  // less than two of the holes at once would take by the estimate, so that some wait
  fill_holes(bounded, holes_of(bounded), options, nullptr, {});
  fill_holes(free, holes_of(free), {}, nullptr, {});
  ASSERT_EQ(bounded.soup.points.size(), free.soup.points.size());
  EXPECT_GT(free.soup.points.size(), holey_sphere().soup.points.size());
  EXPECT_EQ(bounded.soup.points, free.soup.points);
  EXPECT_EQ(bounded.soup.triangles, free.soup.triangles);
}

TEST(FillLoops, NoMemoryAtAllIsRefused) {
  SurfaceModel model = holey_sphere();
  FillOptions options;
  options.most_memory_mb = 0;
  EXPECT_THROW(fill_holes(model, holes_of(model), options, nullptr, {}), InvalidArgument);
}

TEST(FillLoops, FillsEveryHoleAndLeavesTheRest) {
  const SurfaceModel before = holey_sphere();
  SurfaceModel model = before;
  std::mutex mutex;
  int last = 0;
  const std::vector<HoleResult> results = fill_holes(model, holes_of(model), {},
                                                     [&](const FillProgress& p) {
                                                       const std::lock_guard lock(mutex);
                                                       EXPECT_GT(p.loops_done, last);
                                                       EXPECT_EQ(p.loops_total, 4);
                                                       last = p.loops_done;
                                                     },
                                                     {});
  EXPECT_EQ(last, 4);
  for (const HoleResult& r : results) {
    EXPECT_EQ(r.status, PatchStatus::converged) << r.message;
    EXPECT_LT(r.seam_after().h_jump_rms_times_diameter, 0.05);
    EXPECT_LT(r.seam_after().h_jump_rms, 0.1 * r.seam_before().h_jump_rms);
    EXPECT_GT(r.free_vertices, 20);
  }
  EXPECT_TRUE(find_boundary_loops(model).empty());
  expect_input_first(before.soup, model.soup);
  for (std::size_t i = before.soup.points.size(); i < model.soup.points.size(); ++i)
    EXPECT_NEAR(model.soup.points[i].norm(), 1, 5e-5);
  EXPECT_TRUE(self_intersections(model.soup.points, model.soup.triangles, static_cast<int>(model.soup.triangles.size()))
                  .empty());
}

TEST(FillLoops, TheResultDoesNotDependOnTheNumberOfThreads) {
  FillOptions options;
  std::vector<Points> points;
  for (int threads : {1, 2, 4}) {
    SurfaceModel model = holey_sphere();
    options.threads = threads;
    fill_holes(model, holes_of(model), options, nullptr, {});
    EXPECT_TRUE(find_boundary_loops(model).empty());
    points.push_back(model.soup.points);
  }
  EXPECT_EQ(points[0], points[1]);
  EXPECT_EQ(points[0], points[2]);
}

TEST(FillLoops, OneHoleIsFilledTheSameByAnyNumberOfThreads) {
  std::vector<std::vector<HoleResult>> results;
  std::vector<Points> points;
  for (int threads : {1, 2}) {
    SurfaceModel model = test::rough_open_sphere(4, 0.7);
    FillOptions options;
    options.threads = threads;
    results.push_back(fill_holes(model, find_boundary_loops(model), options, nullptr, {}));
    points.push_back(model.soup.points);
  }
  EXPECT_EQ(points[0], points[1]);
  const HoleResult &one = results[0].at(0), &two = results[1].at(0);
  EXPECT_EQ(one.status, PatchStatus::converged);
  EXPECT_EQ(one.seam_before().h_jump_rms, two.seam_before().h_jump_rms);
  EXPECT_EQ(one.seam_after().h_jump_rms, two.seam_after().h_jump_rms);
  EXPECT_EQ(one.neighborhood().H_sigma, two.neighborhood().H_sigma);
}

TEST(FillLoops, NoFlowLeavesTheFiller) {
  SurfaceModel model = test::open_sphere(4, 0.8);
  FillOptions options;
  options.evolution.reset();
  const std::vector<HoleResult> results = fill_holes(model, holes_of(model), options, nullptr, {});
  EXPECT_EQ(results[0].status, PatchStatus::filled);
  EXPECT_EQ(results[0].steps(), 0);
  EXPECT_EQ(results[0].message.english(), "");
  EXPECT_TRUE(find_boundary_loops(model).empty());
}

TEST(FillLoops, KeepsWhatWasFinishedWhenAskedTo) {
  SurfaceModel model = holey_sphere();
  FillOptions options;
  options.on_cancel = FillOptions::OnCancel::keep_finished;
  options.threads = 1;
  const CancelToken cancel;
  const auto results = fill_holes(
      model, holes_of(model), options, [&](const FillProgress&) { cancel.cancel(); }, cancel);
  ASSERT_EQ(results.size(), 4u);
  const auto filled =
      std::count_if(results.begin(), results.end(), [](const HoleResult& result) { return is_filled(result.status); });
  EXPECT_GT(filled, 0);
  EXPECT_LT(filled, 4);
  for (const HoleResult& result : results)
    EXPECT_TRUE(is_filled(result.status) || result.status == PatchStatus::skipped);
  EXPECT_EQ(find_boundary_loops(model).size(), 4u - static_cast<std::size_t>(filled));
}

/// A chain of holes of which each lies near the next is no problem of its own size.
TEST(GroupLoops, BoundsWhatIsSolvedAtOnce) {
  TriangleSoup soup = make_torus(10, 1, 600, 40);
  soup = cut(soup, [](const Vec3& p) {
    const double turn = std::atan2(p.y(), p.x()) * 60 / std::numbers::pi;  // 120 holes
    return p.z() > 0.9 && std::abs(turn - std::round(turn)) < 0.2;
  });
  const SurfaceModel model = make_surface_model(soup);
  const std::vector<BoundaryLoop> holes = find_boundary_loops(model);
  ASSERT_GT(holes.size(), 100u);
  std::size_t loops = 0;
  for (const std::vector<int>& group : group_loops(model, holes)) {
    EXPECT_LE(group.size(), 24u);
    loops += group.size();
  }
  EXPECT_EQ(loops, holes.size());
}

TEST(FillLoops, HolesThatTouchAndIslandsThatTouchTheirHoleAreClosed) {
  // Two caps of a sphere that meet at one vertex; and an island whose one vertex is its hole's.
  SurfaceModel chain = make_surface_model(read_mesh(LOOPMEND_TEST_DATA "/touching_holes.obj").soup);
  for (const HoleResult& result : fill_all_holes(chain)) EXPECT_TRUE(is_filled(result.status)) << result.message;
  EXPECT_EQ(find_boundary_loops(chain).size(), 1u);  // the sheet's outline

  // A sheet in which a ring of squares is missing; the piece within it hangs on the sheet by one vertex.
  TriangleSoup soup;
  constexpr int side = 13;
  const auto number = [](int x, int y) { return y * (side + 1) + x; };
  for (int y = 0; y <= side; ++y)
    for (int x = 0; x <= side; ++x) soup.points.emplace_back(x, y, 0.3 * std::sin(0.4 * x) * std::cos(0.3 * y));
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const bool within = x >= 4 && x <= 8 && y >= 4 && y <= 8, island = x >= 5 && x <= 7 && y >= 5 && y <= 7;
      if (within && !island) continue;
      soup.triangles.push_back({number(x, y), number(x + 1, y), number(x + 1, y + 1)});
      soup.triangles.push_back({number(x, y), number(x + 1, y + 1), number(x, y + 1)});
    }
  for (Triangle& t : soup.triangles)
    for (int& v : t)
      if (v == number(5, 5)) v = number(4, 4);
  SurfaceModel model = make_surface_model(soup);
  ASSERT_EQ(find_boundary_loops(model).size(), 2u);
  for (const HoleResult& result : fill_all_holes(model)) EXPECT_TRUE(is_filled(result.status)) << result.message;
  EXPECT_EQ(find_boundary_loops(model).size(), 1u);
  const test::MeshFacts facts = test::mesh_facts(model.soup);
  EXPECT_TRUE(facts.oriented);
  EXPECT_TRUE(facts.vertex_manifold);
}

/// A small plate as an island of a hole in a ball: at its place on the ball, and high above it, as debris of a scan.
TEST(FillLoops, IslandFarAboveItsHoleIsToBeLookedAt) {
  const TriangleSoup ball = cut(make_icosphere(4), [](const Vec3& p) {
    const double from_axis = p.head<2>().norm();
    return p.z() > 0 && from_axis > 0.12 && from_axis < 0.45;
  });
  for (const double above : {0.0, 0.36}) {
    TriangleSoup soup = ball;
    for (Vec3& p : soup.points)
      if (p.z() > 0 && p.head<2>().norm() < 0.2) p.z() += above;
    SurfaceModel model = make_surface_model(soup);
    const std::vector<HoleResult> results = fill_all_holes(model);
    ASSERT_EQ(results.front().loop.kind, LoopKind::hole);
    const Verdict verdict = results.front().verdict();
    EXPECT_EQ(verdict.grade, above > 0 ? Grade::look : Grade::good) << verdict.message();
    if (above > 0) {
      EXPECT_EQ(verdict.findings.front().code, NoticeCode::high_over_loop) << verdict.message();
    }
  }
}

TEST(FillLoops, CancelledLeavesTheModel) {
  SurfaceModel model = holey_sphere();
  const TriangleSoup before = model.soup;
  const CancelToken cancel;
  const auto results = fill_holes(
      model, holes_of(model), {}, [&](const FillProgress&) { cancel.cancel(); }, cancel);
  EXPECT_TRUE(results.empty());
  EXPECT_EQ(model.soup.points.size(), before.points.size());
  EXPECT_EQ(model.soup.triangles, before.triangles);
}

TEST(FillLoops, ALoopThatCannotBeFilledSaysSoAndTheOthersAreFilled) {
  SurfaceModel model = holey_sphere();
  std::vector<BoundaryLoop> holes = holes_of(model);
  holes[1].kind = LoopKind::crack;
  const std::vector<HoleResult> results = fill_holes(model, holes, {}, nullptr, {});
  ASSERT_EQ(results.size(), 4u);
  EXPECT_EQ(results[1].status, PatchStatus::failed);
  EXPECT_NE(results[1].message.english(), "");
  for (int k : {0, 2, 3}) EXPECT_EQ(results[k].status, PatchStatus::converged);
  EXPECT_EQ(find_boundary_loops(model).size(), 1u);
}

/// A loop that does not exist makes the engine throw; it must not take the neighbour of its own group with it.
TEST(FillLoops, AFaultInOneLoopLeavesItsNeighbourFilled) {
  const SurfaceModel scan = holey_sphere();
  const std::vector<BoundaryLoop> holes = holes_of(scan);
  for (const std::vector<int>& group : group_loops(scan, holes)) {
    if (group.size() < 2) continue;
    std::vector<BoundaryLoop> loops{holes[group[0]], holes[group[1]]};
    std::reverse(loops[1].vertices.begin(), loops[1].vertices.end());  // the wrong way round: no boundary edge
    SurfaceModel model = scan;
    const std::vector<HoleResult> results = fill_holes(model, loops, {}, nullptr, {});
    ASSERT_EQ(results.size(), 2u);
    EXPECT_TRUE(is_filled(results[0].status)) << results[0].message;
    EXPECT_EQ(results[1].status, PatchStatus::failed);
    EXPECT_FALSE(results[1].message.empty());
    EXPECT_TRUE(results[1].method().empty());
    return;
  }
  FAIL() << "no two loops belong together";
}

TEST(FillLoops, PatchesThatWouldCutEachOtherAreNotBothPasted) {
  // Two open spheres so close that the missing caps, put back, would overlap.
  const auto open_half = [](double shift, double sign) {
    TriangleSoup soup = cut(make_icosphere(4), [=](const Vec3& p) { return sign * p.x() > 0.8; });
    for (Vec3& p : soup.points) p.x() += shift;
    return soup;
  };
  TriangleSoup both = open_half(0, 1);
  const TriangleSoup other = open_half(1.9, -1);
  const int shift = static_cast<int>(both.points.size());
  both.points.insert(both.points.end(), other.points.begin(), other.points.end());
  for (Triangle t : other.triangles) {
    for (int& v : t) v += shift;
    both.triangles.push_back(t);
  }
  SurfaceModel model = make_surface_model(both);
  const std::vector<HoleResult> results = fill_holes(model, holes_of(model), {}, nullptr, {});
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ((results[0].status == PatchStatus::failed) + (results[1].status == PatchStatus::failed), 1);
  EXPECT_TRUE(self_intersections(model.soup.points, model.soup.triangles, static_cast<int>(model.soup.triangles.size()))
                  .empty());
}

TEST(FillLoops, OptionsOutOfRangeThrowBeforeAnyWork) {
  SurfaceModel model = test::open_sphere(3, 0.8);
  FillOptions options;
  options.initial.density = std::nan("");
  EXPECT_THROW(fill_holes(model, holes_of(model), options, nullptr, {}), InvalidArgument);
  options = {};
  options.evolution->sigma = std::nan("");
  EXPECT_THROW(fill_holes(model, holes_of(model), options, nullptr, {}), InvalidArgument);
}

TEST(FillLoops, ColoursOfTheInputStayAndNewVerticesGetOne) {
  SurfaceModel model = test::open_sphere(3, 0.8);
  model.soup.colors.assign(model.soup.points.size(), Color{1, 2, 3, 255});
  const std::size_t before = model.soup.points.size();
  fill_holes(model, holes_of(model), {}, nullptr, {});
  ASSERT_GT(model.soup.points.size(), before);
  ASSERT_EQ(model.soup.colors.size(), model.soup.points.size());
  for (std::size_t i = 0; i < before; ++i) EXPECT_EQ(model.soup.colors[i], (Color{1, 2, 3, 255}));
  for (std::size_t i = before; i < model.soup.points.size(); ++i) EXPECT_EQ(model.soup.colors[i][3], 255) << i;
}

TEST(FillLoops, TheSampleIsFilledCloseToTheTruth) {
  SurfaceModel model = make_surface_model(make_sample_scan());
  const std::size_t first_new = model.soup.points.size();
  const std::vector<HoleResult> results = fill_holes(model, holes_of(model), {}, nullptr, {});
  EXPECT_EQ(results.size(), 5u);
  for (const HoleResult& r : results)
    EXPECT_EQ(r.verdict().grade, Grade::good) << r.loop.number << r.verdict().message();
  // The chin, a third of the new vertices, lost its whole bump: no method can know it. The other four holes must be met
  // to a tenth of the edge length of 1.2 mm.
  std::vector<double> errors;
  for (std::size_t i = first_new; i < model.soup.points.size(); ++i) {
    const Vec3& p = model.soup.points[i];
    errors.push_back(std::abs(p.z() - sample_relief_height(p.x(), p.y())));
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() * 6 / 10], 0.12) << errors.back();
  EXPECT_LT(errors.back(), 4);  // measured 3.4 mm, at the top of the lost chin
}

/// A patch has no boundary vertices of its own: that is why it meets the scan, and why no gap is measured.
TEST(FillLoops, PatchesJoinTheLoopsOwnVertices) {
  for (bool flow : {false, true}) {
    SurfaceModel model = holey_sphere();
    const TriangleSoup before = model.soup;
    const std::vector<BoundaryLoop> holes = holes_of(model);
    const std::set<test::DirectedEdge> edges = test::loop_edges(model, holes);
    ASSERT_GT(edges.size(), 40u);
    FillOptions options;
    if (!flow) options.evolution.reset();
    fill_holes(model, holes, options, nullptr, {});
    EXPECT_EQ(test::boundary_edges(test::added_triangles(before, model.soup)), edges);
  }
}

struct Scan {
  const char* folder;
  const char* file;
  int loops;
};
constexpr const char* own_data = LOOPMEND_TEST_DATA;
constexpr const char* shared_data = LOOPMEND_SHARED_DIR "/data";

class FillsRealScans : public testing::TestWithParam<Scan> {};
INSTANTIATE_TEST_SUITE_P(Data, FillsRealScans,
                         testing::Values(Scan{own_data, "ball.obj", 3}, Scan{shared_data, "bunny.ply", 5},
                                         Scan{shared_data, "head_holes.ply", 5},
                                         Scan{shared_data, "demosthenes.obj", 1},
                                         Scan{shared_data, "plane_holes.obj", 27}),
                         [](const auto& scan) {
                           const std::string name = scan.param.file;
                           return name.substr(0, name.find('.'));
                         });

/// The triangles of each loop's patch. No two loops of these scans have a vertex in common.
std::vector<Triangles> patch_of_each_loop(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                          const Triangles& added) {
  std::map<int, std::vector<const Triangle*>> at;
  for (const Triangle& t : added)
    for (int v : t) at[v].push_back(&t);
  std::vector<Triangles> patches;
  for (const BoundaryLoop& loop : loops) {
    std::set<int> seen{model.soup_vertex[loop.vertices.front()]};
    std::vector<int> queue(seen.begin(), seen.end());
    std::set<Triangle> patch;
    while (!queue.empty()) {
      const int from = queue.back();
      queue.pop_back();
      for (const Triangle* t : at[from]) {
        patch.insert(*t);
        for (int v : *t)
          if (seen.insert(v).second) queue.push_back(v);
      }
    }
    patches.emplace_back(patch.begin(), patch.end());
  }
  return patches;
}

// What the status says is not asked: linear fairings reach their end whatever comes of them.
TEST_P(FillsRealScans, ClosedManifoldOrientedUncutAndTheInputFirst) {
  const std::filesystem::path path = std::filesystem::path(GetParam().folder) / GetParam().file;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
  const SurfaceModel open = make_surface_model(read_mesh(path).soup);
  const std::vector<BoundaryLoop> loops = find_boundary_loops(open);
  ASSERT_EQ(static_cast<int>(loops.size()), GetParam().loops);
  SurfaceModel model = open, flat = open;
  FillOptions no_flow;
  no_flow.evolution.reset();
  fill_holes(flat, loops, no_flow, nullptr, {});
  const std::vector<HoleResult> results = fill_holes(model, loops, {}, nullptr, {});
  for (const HoleResult& r : results) {
    EXPECT_NE(r.status, PatchStatus::failed) << r.loop.number << ": " << r.message;
    // A rough boundary is let go of where it says nothing about the hole: there H may jump a little more.
    const double room = r.neighborhood().split.kind() == NeighborhoodKind::smooth ? 1 : 1.2;
    EXPECT_LE(r.seam_after().h_jump_rms, room * r.seam_before().h_jump_rms) << r.loop.number;
  }
  expect_input_first(open.soup, model.soup);
  const test::MeshFacts facts = test::mesh_facts(model.soup);
  EXPECT_TRUE(facts.loops.empty());
  EXPECT_TRUE(facts.oriented);
  EXPECT_TRUE(facts.vertex_manifold);

  const Triangles added = test::added_triangles(open.soup, model.soup);
  EXPECT_EQ(test::boundary_edges(added), test::loop_edges(open, loops));
  EXPECT_EQ(test::count_self_intersections(open.soup, model.soup), 0u);
  const std::vector<Triangles> patches = patch_of_each_loop(open, loops, added),
                               flat_patches =
                                   patch_of_each_loop(open, loops, test::added_triangles(open.soup, flat.soup));
  for (std::size_t k = 0; k < loops.size(); ++k) {
    SCOPED_TRACE(loops[k].number);
    ASSERT_GE(patches[k].size() + 2, loops[k].vertices.size());
    EXPECT_LT(test::sharpest_fold_deg(model.soup.points, patches[k]), 150);  // measured: 61
    const double growth =
        test::area_of(model.soup.points, patches[k]) / test::area_of(flat.soup.points, flat_patches[k]);
    EXPECT_GT(growth, 0.5);
    // Measured: 1.37 at the tip of the head's nose; 1.48 at a hole in the base of the bunny, which is to be looked at.
    EXPECT_LT(growth, worst(results[k].outcome().verdicts) == Grade::good ? 1.45 : 2);
  }
}

TEST(RealScans, TheHeadsPatchesLieNearWhatWasCutOut) {
  const std::filesystem::path folder = std::filesystem::path(LOOPMEND_SHARED_DIR) / "data";
  if (!std::filesystem::exists(folder / "head.ply")) GTEST_SKIP() << folder << " is not here";
  const test::Truth truth(read_mesh(folder / "head.ply").soup);
  SurfaceModel model = make_surface_model(read_mesh(folder / "head_holes.ply").soup);
  const SurfaceModel open = model;
  const std::vector<BoundaryLoop> loops = find_boundary_loops(open);
  ASSERT_EQ(loops.size(), 5u);
  fill_holes(model, loops, {}, nullptr, {});
  const std::vector<Triangles> patches = patch_of_each_loop(open, loops, test::added_triangles(open.soup, model.soup));
  // Measured, in thousandths of the hole's diameter: 2.6, 8.2, 5.3, 4.9 and 30 at the tip of the nose.
  const double bounds[] = {0.0034, 0.0107, 0.0069, 0.0064, 0.039};
  for (std::size_t k = 0; k < loops.size(); ++k) {
    std::set<int> free;
    for (const Triangle& t : patches[k])
      for (int v : t)
        if (v >= static_cast<int>(open.soup.points.size())) free.insert(v);
    ASSERT_GT(free.size(), 20u);
    double sum = 0;
    for (int v : free) sum += std::pow(truth.distance(model.soup.points[v]) / loops[k].diameter, 2);
    EXPECT_LT(std::sqrt(sum / static_cast<double>(free.size())), bounds[k]) << "loop " << loops[k].number;
  }
}

}  // namespace
}  // namespace loopmend
