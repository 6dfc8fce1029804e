// SPDX-License-Identifier: GPL-3.0-or-later
// What is proposed for a loop that failed was tried before.
#include "pipeline/tried_advice.h"

#include "pipeline/scan_job.h"
#include "samples/analytic_surfaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace loopmend {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A ball with a round hole at its top, and a closed rod through the hole.
TriangleSoup ball_with_rod(double radius, int sides) {
  TriangleSoup rod;
  for (const double z : {-3.0, 3.0})
    for (int k = 0; k < sides; ++k) {
      const double angle = 2 * std::numbers::pi * k / sides;
      rod.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  for (int k = 0; k < sides; ++k) {
    const int next = (k + 1) % sides;
    rod.triangles.push_back({k, next, sides + next});
    rod.triangles.push_back({k, sides + next, sides + k});
    if (k > 0 && next > 0) {
      rod.triangles.push_back({0, next, k});
      rod.triangles.push_back({sides, sides + k, sides + next});
    }
  }
  return joined({cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.85; }), rod});
}

/// A triangle at the hole's boundary that runs through the ball, and nothing else that is wrong.
TriangleSoup ball_with_a_flap() {
  TriangleSoup soup = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.85; });
  const SurfaceModel model = make_surface_model(soup);
  const BoundaryLoop loop = find_boundary_loops(model).front();
  const int a = model.soup_vertex[loop.vertices[0]], b = model.soup_vertex[loop.vertices[1]];
  soup.points.push_back(soup.points[a] + Vec3(0.5 * soup.points[a].x(), 0.5 * soup.points[a].y(), -0.3));
  soup.triangles.push_back({a, b, static_cast<int>(soup.points.size()) - 1});
  return soup;
}

struct Filled {
  std::vector<HoleResult> holes;
  ScanPlan plan;
};

Filled filled(const TriangleSoup& soup, const ScanJob& job = {}) {
  Filled run;
  run.plan = plan_scan(record_of(soup), make_surface_model(soup), job);
  const Deadline none(std::chrono::steady_clock::now(), {}, {});
  run.holes = fill_chosen(run.plan, job, none, nullptr, {});
  return run;
}

TEST(TriedAdvice, TheBridgeThatIsNamedClosesTheHole) {
  const TriangleSoup soup = ball_with_rod(0.02, 3);
  const Filled first = filled(soup);
  ASSERT_EQ(first.holes.size(), 1U);
  ASSERT_EQ(first.holes[0].status, PatchStatus::failed);
  const std::string said = first.holes[0].message.english();
  const std::size_t at = said.find("--bridge ");
  ASSERT_NE(at, std::string::npos) << said;
  EXPECT_THAT(said, Not(HasSubstr("--trim"))) << "it would not help";
  ScanJob job;
  int a = 0, b = 0;
  ASSERT_EQ(std::sscanf(said.c_str() + at, "--bridge %d,%d closes it", &a, &b), 2) << said;
  job.prepare.bridges = {{a, b}};
  const Filled second = filled(soup, job);
  EXPECT_EQ(second.holes.size(), 2U);
  for (const HoleResult& hole : second.holes) EXPECT_TRUE(is_filled(hole.status)) << hole.message;
}

TEST(TriedAdvice, WhatWouldNotCloseTheHoleIsSaidToBeOfNoUse) {
  const TriangleSoup soup = ball_with_rod(0.3, 24);
  const std::string said = filled(soup).holes.at(0).message.english();
  EXPECT_THAT(said, HasSubstr("--trim-crossing, --trim-boundary 3, --repair, --cut-intersections, --bridge would not"));
  EXPECT_THAT(said, Not(HasSubstr("may help")));
  // Options that the run used are not named.
  ScanJob job;
  job.prepare.trim_rounds = 3;
  job.prepare.repair = harmless_repairs;
  const std::string again = filled(soup, job).holes.at(0).message.english();
  EXPECT_THAT(again, Not(HasSubstr("--trim")));
  EXPECT_THAT(again, Not(HasSubstr("--repair")));
}

TEST(TriedAdvice, TrimmingIsNamedWhereItCloses) {
  const TriangleSoup soup = ball_with_a_flap();
  const Filled run = filled(soup);
  ASSERT_EQ(run.holes.at(0).status, PatchStatus::failed) << run.holes[0].message;
  EXPECT_THAT(run.holes[0].message.english(), HasSubstr("--trim-crossing closes it"));
  ScanJob job;
  job.prepare.trim_pierced = PrepareOptions::TrimPierced::yes;
  EXPECT_TRUE(is_filled(filled(soup, job).holes.at(0).status));
}

/// One loop edge of some forty beside a fragment: joining the two would not end that the flap crosses the ball.
TEST(TriedAdvice, StitchingIsNotNamedForTheSakeOfOneEdge) {
  TriangleSoup soup = ball_with_a_flap();
  const SurfaceModel model = make_surface_model(soup);
  const BoundaryLoop loop = find_boundary_loops(model).front();
  const std::size_t across = loop.vertices.size() / 2;
  const Vec3 a = soup.points[model.soup_vertex[loop.vertices[across]]],
             b = soup.points[model.soup_vertex[loop.vertices[across + 1]]];
  const int first = static_cast<int>(soup.points.size());
  const Vec3 aside = 0.05 * (b - a).norm() * Vec3::UnitZ();
  for (const Vec3& p : {Vec3(b + aside), Vec3(a + aside), Vec3((a + b) / 2 + 20 * aside)}) soup.points.push_back(p);
  soup.triangles.push_back({first + 1, first, first + 2});
  const Filled run = filled(soup);
  const int closing = closing_edges(run.plan.model, run.holes.at(0).loop, run.plan.coincident);
  EXPECT_EQ(closing, 1);
  EXPECT_THAT(run.holes[0].message.english(), HasSubstr("--trim-crossing closes it"));
  EXPECT_THAT(run.holes[0].message.english(), Not(HasSubstr("--stitch")));
}

}  // namespace
}  // namespace loopmend
