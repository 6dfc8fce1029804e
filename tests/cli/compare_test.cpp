// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run_program.h"

#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "samples/analytic_surfaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace loopmend {
namespace {

using nlohmann::json;
using test::loopmend_program;
using test::Outcome;
using testing::HasSubstr;
using testing::Not;

class CliCompare : public test::ProgramTest {
 protected:
  Outcome run(const std::string& command, const std::string& arguments) const {
    std::string line = command;
    line.append(" -o '").append((work / "flows").string()).append("' ").append(arguments);
    return loopmend_program(line);
  }
};

TEST_F(CliCompare, WritesMeshesPictureProfileAndTables) {
  write_mesh(work / "ball.ply", cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.85; }));
  const Outcome outcome = run("compare", path("ball.ply") + "--report -");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* file : {"start.ply", "mcf.ply", "sdf.ply", "wf.ply", "mmcvf.ply", "compare.png", "profile.csv",
                           "profile.svg", "table.csv", "table.md"})
    EXPECT_GT(std::filesystem::file_size(work / "flows" / file), 100u) << file;
  const json report = json::parse(outcome.out);
  ASSERT_EQ(report["flows"].size(), 4u);
  EXPECT_EQ(report["flows"][3]["flow"], "mmcvf");
  // The sphere is a steady state of all but MCF.
  EXPECT_LT(report["flows"][3]["h_jump_wide"], 0.1 * report["flows"][0]["h_jump_wide"].get<double>());
  EXPECT_THAT(test::text_of(work / "flows" / "table.md"), HasSubstr("MMCVF | converged"));
  EXPECT_THAT(test::text_of(work / "flows" / "profile.svg"), HasSubstr("<svg"));
  // As many cells in each row as heads, and every one a number or a word.
  std::istringstream table(test::text_of(work / "flows" / "table.csv"));
  std::string row;
  int rows = 0;
  for (; std::getline(table, row); ++rows) {
    EXPECT_EQ(std::count(row.begin(), row.end(), ','), 11) << row;
    EXPECT_THAT(row, Not(HasSubstr("nan")));
  }
  EXPECT_EQ(rows, 6);  // the head, the start and the four flows
}

/// The patches of every file have the colours around them, not black ones.
TEST_F(CliCompare, ColoursRunOnInItsMeshes) {
  TriangleSoup ball = cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.85; });
  ball.colors.assign(ball.points.size(), {10, 20, 30, 255});
  write_mesh(work / "ball.ply", ball);
  ASSERT_EQ(run("compare", path("ball.ply")).code, 0);
  for (const char* file : {"start.ply", "mcf.ply", "mmcvf.ply"}) {
    const TriangleSoup filled = read_mesh(work / "flows" / file).soup;
    ASSERT_GT(filled.points.size(), ball.points.size()) << file;
    for (const Color& color : filled.colors) EXPECT_EQ(color, (Color{10, 20, 30, 255})) << file;
  }
}

TEST_F(CliCompare, RefusesASurfaceWithoutHoles) {
  write_mesh(work / "closed.ply", make_icosphere(2));
  const Outcome outcome = run("compare", path("closed.ply"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("no hole"));
  EXPECT_FALSE(std::filesystem::exists(work / "flows"));
}

}  // namespace
}  // namespace loopmend
