// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run_program.h"

#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "repair/watertight.h"
#include "samples/analytic_surfaces.h"
#include "support/tubes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>

namespace loopmend {
namespace {

using nlohmann::json;
using test::loopmend_program;
using test::Outcome;
using testing::HasSubstr;

class CliBlend : public test::ProgramTest {
 protected:
  void write(const std::string& name, const TriangleSoup& soup) const { write_mesh(work / name, soup); }
  Outcome blend(const std::string& arguments) const {
    std::string line = "blend ";
    line.append(arguments).append(" -o ").append(path("out.ply"));
    return loopmend_program(line);
  }
  const TriangleSoup up = make_tube({{0, 0, 1}, {0, 0, 1}, 1, 2, 24});
  const TriangleSoup side = make_tube({{1.5, 0, 0}, {1, 0, 0}, 0.6, 2, 20});
};

TEST_F(CliBlend, JoinsTheFacingEndsOfTwoFiles) {
  write("up.ply", up);
  write("side.ply", side);
  const Outcome run = blend(path("up.ply") + path("side.ply") + "--report -");
  ASSERT_EQ(run.code, 0) << run.err;
  const json report = json::parse(run.out);
  EXPECT_EQ(report["status"], "converged");
  EXPECT_EQ(report["folds"], 0);
  EXPECT_EQ(report["self_intersections"], 0);
  ASSERT_EQ(report["loops"].size(), 2u);
  EXPECT_EQ(report["loops"][0]["edges"], 24);
  EXPECT_LT(report["loops"][0]["seam_after"]["h_jump_rms"], report["loops"][0]["seam_before"]["h_jump_rms"]);
  const TriangleSoup result = read_mesh(work / "out.ply").soup;
  ASSERT_GT(result.points.size(), up.points.size() + side.points.size());
  EXPECT_EQ(std::memcmp(result.points.data(), up.points.data(), up.points.size() * sizeof(Vec3)), 0);
  EXPECT_EQ(std::memcmp(result.points.data() + up.points.size(), side.points.data(), side.points.size() * sizeof(Vec3)),
            0);
}

TEST_F(CliBlend, ARingThatIsMissingInOneFileByNumbers) {
  // Wider towards the top, so that the loops are numbered from there.
  write("tube.ply", cut(make_revolution([](double z) { return 1 + 0.01 * z; }, 0, 6, 32, 30),
                        [](const Vec3& p) { return std::abs(p.z() - 3) < 0.7; }));
  expect_refused(blend(path("tube.ply")), 2, "4 loops, not two");
  const Outcome run = blend(path("tube.ply") + "--loops 1:2,1:3");
  EXPECT_EQ(run.code, 0) << run.err;
  const json info = json::parse(loopmend_program("info " + path("out.ply") + "--json -").out);
  EXPECT_EQ(info["loops"].size(), 2u);
}

/// A pipe whose wall is open at both ends.
TEST_F(CliBlend, BothEndsOfAPipeInOneCommand) {
  TriangleSoup inner = make_revolution([](double) { return 0.8; }, 0, 6, 32, 30);
  for (Triangle& t : inner.triangles) std::swap(t[1], t[2]);
  const TriangleSoup pipe = joined({make_revolution([](double) { return 1.0; }, 0, 6, 32, 30), inner});
  write("pipe.ply", pipe);
  const json plan = json::parse(loopmend_program("info " + path("pipe.ply") + "--json -").out);
  std::map<bool, std::string> pairs;  // by whether they are above
  for (const json& loop : plan["loops"]) {
    std::string& pair = pairs[pipe.points[loop["vertices"][0].get<std::size_t>()].z() > 3];
    pair += (pair.empty() ? "1:" : ",1:") + std::to_string(loop["number"].get<int>());
  }
  expect_refused(blend(path("pipe.ply") + "--loops " + pairs[false] + " --loops " + pairs[false]), 2, "two patches");
  const Outcome run =
      blend(path("pipe.ply") + "--loops " + pairs[false] + " --loops " + pairs[true] + " --report " + path("r.json"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(json::parse(std::ifstream(work / "r.json"))["patches"].size(), 2u);
  EXPECT_TRUE(watertightness(read_mesh(work / "out.ply").soup).printable());
}

/// What fill names for a block with two bores and no end faces closes it, and so says blend where one of the bores is forgotten.
TEST_F(CliBlend, TheEndFacesOfABlockWithBoresAsFillNamesThem) {
  const auto tube = [](double radius, double aside, bool is_bore) {
    TriangleSoup soup = make_revolution([=](double) { return radius; }, 0, 1, 40, 8);
    for (Vec3& p : soup.points) p.x() += aside;
    for (Triangle& t : soup.triangles)
      if (is_bore) std::swap(t[1], t[2]);
    return soup;
  };
  write("block.ply", joined({tube(2, 0, false), tube(0.5, 1, true), tube(0.4, -1, true)}));
  const std::string said = loopmend_program("fill " + path("block.ply") + "-o " + path("lids.ply") + "--islands cover").out;
  const std::regex command("'loopmend blend (--loops (1:\\d+,1:\\d+),1:\\d+)'");
  std::set<std::string> faces, pairs;
  for (std::sregex_iterator found(said.begin(), said.end(), command), end; found != end; ++found) {
    faces.insert((*found)[1]);
    pairs.insert((*found)[2]);
  }
  ASSERT_EQ(faces.size(), 2u) << said;
  const Outcome forgotten = blend(path("block.ply") + "--loops " + *pairs.begin());
  EXPECT_EQ(forgotten.code, 1);
  EXPECT_THAT(forgotten.err, HasSubstr(*faces.begin()));
  const Outcome run = blend(path("block.ply") + *faces.begin() + " " + *faces.rbegin());
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(watertightness(read_mesh(work / "out.ply").soup).printable());
}

/// Two sheets above each other, each with two square holes that touch at a corner.
TEST_F(CliBlend, LoopsThatTouchAreNotTakenForEachOther) {
  constexpr int side = 12;
  const auto sheet = [](double z, bool is_turned) {
    TriangleSoup soup;
    for (int x = 0; x <= side; ++x)
      for (int y = 0; y <= side; ++y) soup.points.emplace_back(x, y, z);
    for (int x = 0; x < side; ++x)
      for (int y = 0; y < side; ++y) {
        if (x / 3 == y / 3 && (x / 3 == 1 || x / 3 == 2)) continue;
        const int a = x * (side + 1) + y, b = a + 1, c = a + side + 1, d = c + 1;
        for (Triangle t : {Triangle{a, c, d}, Triangle{a, d, b}}) {
          if (is_turned) std::swap(t[1], t[2]);
          soup.triangles.push_back(t);
        }
      }
    return soup;
  };
  const TriangleSoup both = joined({sheet(0, true), sheet(2, false)});
  write("sheets.ply", both);
  const json plan = json::parse(loopmend_program("info " + path("sheets.ply") + "--json -").out);
  std::string far_ones;  // whose squares reach to 9
  for (const json& loop : plan["loops"]) {
    double most = 0;
    for (const json& v : loop["vertices"]) most = std::max(most, both.points[v.get<std::size_t>()].x());
    if (most == 9) far_ones += (far_ones.empty() ? "1:" : ",1:") + std::to_string(loop["number"].get<int>());
  }
  EXPECT_EQ(blend(path("sheets.ply") + "--loops " + far_ones).code, 0);
  const TriangleSoup result = read_mesh(work / "out.ply").soup;
  ASSERT_GT(result.triangles.size(), both.triangles.size());
  for (std::size_t f = both.triangles.size(); f < result.triangles.size(); ++f)
    for (const int v : result.triangles[f]) EXPECT_GE(result.points[v].x(), 6 - 1e-9);
}

/// Of sheets side by side only a strip between them makes sense.
TEST_F(CliBlend, AGapBetweenSheetsIsRefusedWithTheCommandThatClosesIt) {
  TriangleSoup left = make_graph([](double, double) { return 0; }, 1, 20), right = left;
  for (Vec3& p : right.points) p.x() += 2.15;
  write("sheets.ply", joined({left, right}));
  const Outcome refused = blend(path("sheets.ply"));
  EXPECT_EQ(refused.code, 1);
  const std::size_t begin = refused.err.find("'loopmend fill --bridge");
  ASSERT_NE(begin, std::string::npos) << refused.err;
  const std::size_t options = begin + std::string("'loopmend fill ").size();
  const std::string bridges = refused.err.substr(options, refused.err.find('\'', options) - options);
  const Outcome filled = loopmend_program("fill " + path("sheets.ply") + "-o " + path("out.ply") + bridges);
  EXPECT_EQ(filled.code, 0) << filled.err;
  EXPECT_THAT(filled.out, HasSubstr("1 filled, 0 failed, 1 left as asked"));
  for (const Vec3& p : read_mesh(work / "out.ply").soup.points) EXPECT_NEAR(p.z(), 0, 1e-9);
}

TEST_F(CliBlend, AnInsideOutPartIsTurnedRoundAndSaid) {
  TriangleSoup turned = side;
  for (Triangle& t : turned.triangles) std::swap(t[1], t[2]);
  write("up.ply", up);
  write("side.ply", turned);
  const Outcome run = blend(path("up.ply") + path("side.ply"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr(std::to_string(side.triangles.size()) + " faces were turned round"));
}

TEST_F(CliBlend, RefusesWhatCannotBeJoinedWithASentence) {
  write("up.ply", up);
  write("side.ply", side);
  write("across.ply", make_tube({{-2, 0, 2}, {1, 0, 0}, 0.5, 4, 20}));
  write("closed.ply", make_icosphere(2));
  expect_refused(blend(path("up.ply") + path("across.ply")), 2, "overlap");
  expect_refused(blend(path("up.ply") + path("closed.ply")), 2, "is closed");
  expect_refused(blend(path("up.ply") + path("side.ply") + "--loops 1:1,3:1"), 2, "there is no file 3");
  expect_refused(blend(path("up.ply") + path("side.ply") + "--loops 1:1,2:7"), 2, "has 2 loops");
  expect_refused(blend(path("up.ply") + path("side.ply") + "--loops 1:1,1:1"), 2, "twice");
  expect_refused(blend(path("up.ply") + path("side.ply") + "--loops 1:1"), 2, "at least two");
  expect_refused(blend(path("up.ply") + path("side.ply") + "--loops one"), 2, "FILE:LOOP");
  expect_refused(blend(path("up.ply") + path("missing.ply")), 3, "missing.ply");
}

TEST_F(CliBlend, OneSheetThatWouldHaveToFaceBothWaysIsRefused) {
  // A sheet folded like an S; its upper and its lower layer face the same way, and belong to one piece.
  constexpr double leg = 6, bend = 1.5707963267948966;
  const auto folded = [](double s) {
    const auto round = [](double angle, double middle, double way) {
      return Vec3(way * (3 + 0.5 * std::sin(angle)), 0, middle + 0.5 * std::cos(angle));
    };
    if (s < leg) return Vec3(s - 3, 0, 2);
    if (s < leg + bend) return round(2 * (s - leg), 1.5, 1);
    if (s < 2 * leg + bend) return Vec3(3 - (s - leg - bend), 0, 1);
    if (s < 2 * leg + 2 * bend) return round(2 * (s - 2 * leg - bend), 0.5, -1);
    return Vec3(s - 2 * leg - 2 * bend - 3, 0, 0);
  };
  const double half = (3 * leg + 2 * bend) / 2;
  TriangleSoup sheet = make_graph([](double, double) { return 0.0; }, half, 90);
  for (Vec3& p : sheet.points) p = folded(p.x() + half) + Vec3(0, p.y(), 0);
  write("sheet.ply", cut(sheet, [](const Vec3& p) {
          return p.head<2>().norm() < (p.z() == 1 ? 1.4 : p.z() == 2 ? 0.9 : p.z() == 0 ? 0.8 : 0);
        }));
  expect_refused(blend(path("sheet.ply") + "--loops 1:3,1:4"), 2, "no two-sided surface joins them");
}

TEST_F(CliBlend, LoopsThatCannotBeJoinedAreTold) {
  // A closed wall lies between the two boundaries: every bridge would run through it.
  write("inside.ply", make_tube({{0, 0, 0.2}, {0, 0, -1}, 0.3, 0.4, 24}));
  write("outside.ply", make_tube({{0, 0, 2}, {0, 0, 1}, 0.3, 1, 24}));
  write("wall.ply", make_icosphere(3));
  expect_refused(blend(path("inside.ply") + path("outside.ply") + path("wall.ply") + "--loops 1:1,2:1"), 1,
                 "would cut the surface");
}

}  // namespace
}  // namespace loopmend
