// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run_program.h"

#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "pipeline/problem.h"
#include "samples/paper_inputs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace loopmend {
namespace {

using nlohmann::json;
using test::loopmend_program;
using test::Outcome;
using testing::HasSubstr;

class CliPaper : public test::ProgramTest {
 protected:
  Outcome run(const std::string& command, const std::string& input, const std::string& arguments) const {
    std::string line = command;
    line.append(" ").append(path(input)).append("-o ").append(path("out.ply")).append(arguments);
    return loopmend_program(line);
  }
};

TEST_F(CliPaper, InterpolateReportsAndKeepsTheVertices) {
  write_mesh(work / "poly.off", make_dodecahedron());
  const Outcome outcome = run("interpolate", "poly.off", "--subdivide 2 --report -");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report["status"], "converged");
  EXPECT_EQ(report["fixed_vertices"], 20);
  EXPECT_EQ(report["free_vertices"], 270);
  EXPECT_EQ(read_mesh(work / "out.ply").soup.points[7], make_dodecahedron().points[7]);
}

// The window solves what pose_points poses.
TEST_F(CliPaper, InterpolateIsTheWindowsToTheLastBit) {
  TriangleSoup open = make_dodecahedron();
  open.triangles.resize(33);
  write_mesh(work / "open.off", open);
  ASSERT_EQ(run("interpolate", "open.off", "--open --subdivide 2 --quiet").code, 0);
  SubdivisionOptions options;
  options.subdivisions = 2;
  options.boundary = PolyhedronBoundary::smooth;
  const auto polyhedron = std::make_shared<const SurfaceModel>(make_surface_model(read_mesh(work / "open.off").soup));
  const Solution solution = pose_points(polyhedron, options).solve(EvolutionOptions{}, nullptr, CancelToken());
  const TriangleSoup written = read_mesh(work / "out.ply").soup;
  EXPECT_EQ(written.points, solution.surface.points);
  EXPECT_EQ(written.triangles, solution.surface.triangles);
  EXPECT_TRUE(solution.refusal.empty());
}

TEST_F(CliPaper, InterpolateRefusesHolesAndTooFewVertices) {
  TriangleSoup open = make_dodecahedron();
  open.triangles.resize(33);
  write_mesh(work / "open.off", open);
  expect_refused(run("interpolate", "open.off", ""), 2, "1 hole");
  std::ofstream(work / "three.txt") << "0 1 2\n";
  write_mesh(work / "poly.off", make_dodecahedron());
  std::string fixed = "--fixed ";
  expect_refused(run("interpolate", "poly.off", fixed.append(path("three.txt"))), 2, "too few");
  TriangleSoup triangle;
  triangle.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  write_mesh(work / "triangle.off", triangle);
  expect_refused(run("interpolate", "triangle.off", "--open"), 2, "too few");
  expect_refused(run("interpolate", "poly.off", "--subdivide 12"), 2, "between 1 and 8");
  EXPECT_EQ(run("interpolate", "open.off", "--open --subdivide 2 --quiet").code, 0);
}

TEST_F(CliPaper, EvolveByConditionAndByFile) {
  const TriangleSoup bumps = make_bumps();
  write_mesh(work / "bumps.ply", bumps);
  const Outcome outcome = run("evolve", "bumps.ply", "--where 'z>0.725' --report -");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report["free_vertices"], 840);
  EXPECT_EQ(report["seams_after"].size(), 4u);
  EXPECT_LT(report["energy"]["final"], 0.6 * report["energy"]["initial"].get<double>());
  const TriangleSoup result = read_mesh(work / "out.ply").soup;
  ASSERT_EQ(result.points.size(), bumps.points.size());
  for (std::size_t i = 0; i < bumps.points.size(); ++i)
    if (bumps.points[i].z() <= 0.725) {
      EXPECT_EQ(result.points[i], bumps.points[i]);
    }
  std::ofstream(work / "region.txt") << "# the middle of a bump\n1860, 1861\n1862 1921";
  std::string region = "--region ";
  EXPECT_EQ(run("evolve", "bumps.ply", region.append(path("region.txt"))).code, 0);
}

TEST_F(CliPaper, ARegionUpToTheSurfacesEndHasNothingBeyondToBeComparedWith) {
  write_mesh(work / "bumps.ply", make_bumps());
  const Outcome outcome = run("evolve", "bumps.ply", "--where 'z>-9' --steps 2");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("nothing beyond to compare with"));
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr("nan")));
}

TEST_F(CliPaper, EvolveRefusesRegionsThatAreNone) {
  write_mesh(work / "bumps.ply", make_bumps());
  std::ofstream(work / "words.txt") << "one two\n";
  std::string region = "--region ";
  expect_refused(run("evolve", "bumps.ply", region.append(path("words.txt"))), 3, "'one' is no vertex number (line 1)");
  expect_refused(run("evolve", "bumps.ply", ""), 2, "one of the two");
  expect_refused(run("evolve", "bumps.ply", "--where 'z>7'"), 2, "no vertex is so");
  expect_refused(run("evolve", "bumps.ply", "--where 'w>7'"), 2, "over x, y, z, H and K");
}

}  // namespace
}  // namespace loopmend
