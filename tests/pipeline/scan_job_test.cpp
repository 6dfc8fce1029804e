// SPDX-License-Identifier: GPL-3.0-or-later
// From a scan to a plan, and from the plan to a filled scan.
#include "pipeline/scan_job.h"

#include "core/error.h"
#include "samples/analytic_surfaces.h"
#include "samples/sample_scan.h"
#include "support/sharp_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>

namespace loopmend {
namespace {

ScanPlan planned(const TriangleSoup& soup, const ScanJob& job = {}) {
  return plan_scan(record_of(soup), make_surface_model(soup), job);
}

std::vector<HoleResult> filled(ScanPlan& plan, const ScanJob& job = {}) {
  const Deadline none(std::chrono::steady_clock::now(), {}, {});
  return fill_chosen(plan, job, none, nullptr, {});
}

int count(const ScanPlan& plan, LoopKind kind) {
  return static_cast<int>(
      std::count_if(plan.loops.begin(), plan.loops.end(), [&](const BoundaryLoop& loop) { return loop.kind == kind; }));
}

/// A ball with two round holes.
TriangleSoup open_ball() {
  return cut(make_icosphere(4), [](const Vec3& p) { return std::abs(p.z()) > 0.9; });
}

/// Two triangles of the ball's surface carry a third along one of their edges.
TriangleSoup ball_with_a_fin() {
  TriangleSoup soup = open_ball();
  const Triangle& t = soup.triangles[soup.triangles.size() / 2];
  soup.points.push_back(1.5 * soup.points[t[0]]);
  soup.triangles.push_back({t[0], t[1], static_cast<int>(soup.points.size()) - 1});
  return soup;
}

LoopSelection choice_of(const std::string& text) {
  LoopSelection selection;
  take_loops(text, selection);
  return selection;
}

TEST(ScanJob, HolesAreChosenAndTheOuterRimIsLeft) {
  const ScanPlan plan = planned(make_sample_scan());
  EXPECT_EQ(count(plan, LoopKind::outer_rim), 1);
  for (std::size_t k = 0; k < plan.loops.size(); ++k) {
    EXPECT_EQ(plan.choices[k].fill, plan.loops[k].kind == LoopKind::hole);
    EXPECT_EQ(plan.choices[k].fill, plan.choices[k].why_not.empty());
  }
  EXPECT_TRUE(plan.done.changed_nothing());
}

TEST(ScanJob, NamedLoopsAreFilledWithTheContinuityThatIsNamed) {
  ScanJob job;
  take_loops("2:flat, 1", job.loops);
  ScanPlan plan = planned(open_ball(), job);
  EXPECT_EQ(plan.choices[0].continuity, std::nullopt);
  EXPECT_EQ(plan.choices[1].continuity, SeamContinuity::position);
  const std::vector<HoleResult> results = filled(plan, job);
  const BoundaryLoop& loop = plan.loops[1];
  double highest = 0;  // of the flat patch over the plane through its loop
  const HoleResult& flat = results[1];
  for (int v = 0; v < flat.patch->patch.free_count; ++v)
    highest = std::max(highest, std::abs(plan.model.soup.points[flat.first_point + v].z() - loop.center.z()));
  EXPECT_LT(highest, 0.05 * loop.diameter);  // a cap of the ball is 0.24 diameters high
}

TEST(ScanJob, AllLoopsGetTheContinuityThatIsNamedForAll) {
  ScanJob job;
  take_loops("all:flat", job.loops);
  const ScanPlan plan = planned(make_sample_scan(), job);
  for (std::size_t k = 0; k < plan.loops.size(); ++k) {
    EXPECT_EQ(plan.choices[k].fill, plan.loops[k].kind == LoopKind::hole);  // as without it
    EXPECT_EQ(plan.choices[k].continuity, SeamContinuity::position);
  }
}

TEST(ScanJob, ALoopOrVertexThatIsNotThereIsRefused) {
  for (const char* numbers : {"3", "0", "1,7:flat"}) {
    ScanJob job;
    take_loops(numbers, job.loops);
    EXPECT_THROW(planned(open_ball(), job), InvalidArgument) << numbers;
  }
  for (const char* text : {"", "1,,2", "one", "1:round", "1.5"}) EXPECT_THROW(choice_of(text), InvalidArgument) << text;
  EXPECT_THROW(choice_of("all:round"), InvalidArgument);
  EXPECT_THROW(choice_of("all,3"), InvalidArgument);
  EXPECT_FALSE(choice_of("all").names_loops());
  ScanJob inside;
  inside.loops.at_vertices = {0, static_cast<int>(open_ball().points.size())};
  EXPECT_THROW(planned(open_ball(), inside), InvalidArgument);
}

TEST(ScanJob, PreparationWhereNeededChangesNothingOnASoundScan) {
  ScanJob job;
  job.prepare.extent = PrepareOptions::Extent::where_needed;
  const TriangleSoup soup = open_ball();
  const ScanPlan plan = planned(soup, job);
  EXPECT_TRUE(plan.done.changed_nothing());
  EXPECT_TRUE(plan.trimmed.empty());
  EXPECT_EQ(plan.model.soup.points, soup.points);
  EXPECT_EQ(plan.model.soup.triangles, soup.triangles);
}

/// Stitching is asked for, finds nothing to join, and hands back faces that agree with their neighbors.
TEST(ScanJob, AScanWithATurnedFaceIsFilledWhereNothingIsStitched) {
  TriangleSoup soup = open_ball();
  std::swap(soup.triangles[7][1], soup.triangles[7][2]);
  ScanJob job;
  job.prepare.extent = PrepareOptions::Extent::where_needed;
  job.prepare.stitch = PrepareOptions::Stitch::yes;
  ScanPlan plan = planned(soup, job);
  EXPECT_EQ(plan.turned_faces(), 1u);
  const std::vector<HoleResult> results = filled(plan, job);
  EXPECT_EQ(std::count_if(results.begin(), results.end(), [](const auto& r) { return is_filled(r.status); }), 2);
}

TEST(ScanJob, PreparationWhereNeededMakesHolesOfWhatRunsAlongEdgesOfThreeFaces) {
  const TriangleSoup soup = ball_with_a_fin();
  EXPECT_GT(count(planned(soup), LoopKind::cut), 0);
  ScanJob job;
  job.prepare.extent = PrepareOptions::Extent::where_needed;
  ScanPlan plan = planned(soup, job);
  EXPECT_EQ(count(plan, LoopKind::cut), 0);
  EXPECT_TRUE(plan.done.repaired);
  const std::vector<HoleResult> results = filled(plan, job);
  EXPECT_EQ(std::count_if(results.begin(), results.end(), [](const auto& r) { return is_filled(r.status); }), 2);
}

/// A repair removes faces and keeps the numbers of points.
TEST(ScanJob, EditedEdgesNamePointsOfTheScanBeforeARepair) {
  const TriangleSoup whole = test::make_cube(24);
  TriangleSoup scan = cut(whole, [](const Vec3& p) { return (p - Vec3(1, 1, 0.5)).norm() < 0.2; });
  const auto nearest = [&](const Vec3& place) {
    return static_cast<int>(
        std::min_element(scan.points.begin(), scan.points.end(),
                         [&](const Vec3& a, const Vec3& b) { return (a - place).norm() < (b - place).norm(); }) -
        scan.points.begin());
  };
  scan.triangles.insert(scan.triangles.begin(), {scan.triangles[5], {0, 0, 1}});  // one face twice, one without area
  ScanJob job;
  job.prepare.repair = harmless_repairs;
  ScanPlan plain = planned(scan, job);
  EXPECT_EQ(filled(plain, job).front().outcome().made_by, "sharp edges");
  job.fill.evolution->edge_edits.stopped = {nearest({1, 1, 0.29})};
  ScanPlan stopped = planned(scan, job);
  EXPECT_NE(filled(stopped, job).front().outcome().made_by, "sharp edges");
  job.fill.evolution->edge_edits.stopped = {nearest({0, 0, 0})};
  EXPECT_THROW(planned(scan, job), InvalidArgument);  // on no boundary
}

TEST(ScanJob, EachPatchStandsWhereItsResultSays) {
  ScanPlan plan = planned(open_ball());
  const std::size_t points = plan.given.points, triangles = plan.given.triangles;
  const std::vector<HoleResult> results = filled(plan);
  ASSERT_EQ(results.size(), 2u);
  std::size_t new_points = 0, new_triangles = 0;
  for (const HoleResult& result : results) {
    const Patch& patch = result.patch->patch;
    EXPECT_GE(result.first_point, static_cast<int>(points));
    EXPECT_GE(result.first_triangle, static_cast<int>(triangles));
    for (int v = 0; v < patch.free_count; ++v)
      EXPECT_LT((plan.model.soup.points[result.first_point + v] - patch.to_mesh(patch.positions[v])).norm(), 1e-12);
    new_points += static_cast<std::size_t>(patch.free_count);
    new_triangles += static_cast<std::size_t>(patch.patch_triangles);
  }
  EXPECT_EQ(plan.model.soup.points.size(), points + new_points);
  EXPECT_EQ(plan.model.soup.triangles.size(), triangles + new_triangles);
}

TEST(ScanJob, ToleranceAndBaseAreReadAsTheyAreWritten) {
  EXPECT_EQ(stitch_tolerance_of("0.5").length, 0.5);
  EXPECT_EQ(stitch_tolerance_of("5%").edges, 0.05);
  EXPECT_EQ(stitch_tolerance_of("5%").length, std::nullopt);
  for (const char* text : {"", "-1", "41%", "wide", "1e999", "nan"})
    EXPECT_THROW(stitch_tolerance_of(text), InvalidArgument) << text;
  EXPECT_EQ(base_of("5").loop, 0);
  EXPECT_EQ(base_of("2:5.5").loop, 2);
  EXPECT_EQ(base_of("2:5.5").distance, 5.5);
  for (const char* text : {"", "0", "0:5", "2:", ":5", "1.5:5", "2:-1"})
    EXPECT_THROW(base_of(text), InvalidArgument) << text;
}

/// Lids on the bores of a block are right only where the bores themselves are not.
TEST(ScanJob, LidsWhereWallsEndAreToBeLookedAt) {
  const auto tube = [](double radius, const Vec3& center, bool is_bore) {
    TriangleSoup soup = make_revolution([=](double) { return radius; }, 0, 1, 40, 8);
    for (Vec3& p : soup.points) p += center;
    for (Triangle& t : soup.triangles)
      if (is_bore) std::swap(t[1], t[2]);
    return soup;
  };
  const TriangleSoup block =
      joined({tube(2, {0, 0, 0}, false), tube(0.5, {1, 0, 0}, true), tube(0.4, {-1, 0, 0}, true)});
  ScanJob job;
  job.fill.islands = FillOptions::Islands::cover;
  ScanPlan plan = planned(block, job);
  const std::vector<HoleResult> results = filled(plan, job);
  ASSERT_EQ(results.size(), 6U);
  for (const HoleResult& result : results) {
    const Verdict verdict = result.verdict();
    EXPECT_NE(verdict.grade, Grade::good);
    EXPECT_EQ(std::ranges::count(verdict.findings, NoticeCode::wall_ends, &Notice::code), 1);
    EXPECT_NE(result.message.english().find("joins them by a face with holes"), std::string::npos) << result.message;
  }
}

}  // namespace
}  // namespace loopmend
