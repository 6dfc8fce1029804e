// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a surface could be printed, cutting out what stands against it, and patches without the scan.
#include "cli/run_program.h"

#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "mesh/boundary_loops.h"
#include "samples/analytic_surfaces.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loopmend {
namespace {

using nlohmann::json;
using test::loopmend_program;
using test::Outcome;
using testing::HasSubstr;

class CheckTest : public test::ProgramTest {
 protected:
  json info() const { return json::parse(loopmend_program("info " + path("in.ply") + "--check --json -").out); }
  Outcome fill(const std::string& options) const {
    return loopmend_program("fill " + path("in.ply") + "-o " + path("out.ply") + "--report " + path("r.json") +
                            options);
  }
  json report() const { return json::parse(test::text_of(work / "r.json")); }
};

TriangleSoup ball_with_two_holes() {
  return cut(make_icosphere(3), [](const Vec3& p) { return std::abs(p.z()) > 0.9; });
}

TEST_F(CheckTest, AHoleStandsAgainstPrintingUntilItIsFilled) {
  write_mesh(work / "in.ply", ball_with_two_holes());
  EXPECT_THAT(loopmend_program("info " + path("in.ply") + "--check").out,
              HasSubstr("Ready to print: no, because of 2 open boundaries.\n"));
  const json open = info()["check"];
  EXPECT_EQ(open["ready_to_print"], false);
  EXPECT_EQ(open["against_it"], json::array({"2 open boundaries"}));
  EXPECT_EQ(open["open_boundaries"], 2);
  EXPECT_TRUE(open["volume"].is_null());
  const Outcome run = fill("--check");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("Ready to print: yes, a volume of 4."));
  const json closed = report()["check"];
  EXPECT_EQ(closed["ready_to_print"], true);
  EXPECT_EQ(closed["against_it"], json::array());
  EXPECT_NEAR(closed["volume"], 4 * std::numbers::pi / 3, 0.05);
}

TEST_F(CheckTest, OnlyWhoAsksIsTold) {
  write_mesh(work / "in.ply", ball_with_two_holes());
  EXPECT_FALSE(json::parse(loopmend_program("info " + path("in.ply") + "--json -").out).contains("check"));
  fill("");
  EXPECT_FALSE(report().contains("check"));
}

/// A spike that goes in at one side of the ball and out at the other.
TEST_F(CheckTest, IntersectionsAreCutOutAndTheHolesFilled) {
  TriangleSoup ball = make_icosphere(3);
  const auto top = std::max_element(ball.points.begin(), ball.points.end(),
                                    [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  *top = {0.02, 0.03, -1.3};
  write_mesh(work / "in.ply", ball);
  EXPECT_GT(info()["check"]["intersecting_pairs"], 0);
  EXPECT_EQ(fill("--repair --check").code, 0);
  EXPECT_EQ(report()["check"]["ready_to_print"], false);
  EXPECT_EQ(report()["prepared"]["repaired"]["intersecting_faces"], 0);
  const Outcome run = fill("--cut-intersections --check");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_GT(report()["prepared"]["repaired"]["intersecting_faces"], 0);
  EXPECT_EQ(report()["check"]["ready_to_print"], true) << report()["check"].dump();
}

TEST_F(CheckTest, PatchesAlone) {
  const TriangleSoup ball = ball_with_two_holes();
  write_mesh(work / "in.ply", ball);
  EXPECT_EQ(fill("").code, 0);
  const std::size_t whole = read_mesh(work / "out.ply").soup.triangles.size();
  EXPECT_EQ(report()["output"]["content"], "surface");
  EXPECT_EQ(fill("--patches-only").code, 0);
  EXPECT_EQ(report()["output"]["content"], "patches");
  const TriangleSoup patches = read_mesh(work / "out.ply").soup;
  EXPECT_EQ(patches.triangles.size(), whole - ball.triangles.size());
  EXPECT_EQ(find_boundary_loops(make_surface_model(patches)).size(), 2U);
}

TEST_F(CheckTest, WithoutPatchesNothingIsWritten) {
  write_mesh(work / "in.ply", make_icosphere(2));
  const Outcome run = fill("--patches-only");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.err, HasSubstr("no loop was filled, so there are no patches"));
  EXPECT_FALSE(std::filesystem::exists(work / "out.ply"));
}

}  // namespace
}  // namespace loopmend
