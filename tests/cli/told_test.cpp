// SPDX-License-Identifier: GPL-3.0-or-later
// What a fill loses and what it leaves is told, and the exit code follows from it.
#include "cli/run_program.h"

#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "mesh/boundary_loops.h"
#include "samples/analytic_surfaces.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <functional>
#include <numbers>

namespace loopmend {
namespace {

using nlohmann::json;
using test::loopmend_program;
using test::Outcome;
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

class Told : public test::ProgramTest {
 protected:
  Outcome fill(const std::string& options = "") const {
    return loopmend_program("fill " + path("in.ply") + "-o " + path("out.ply") + "--flow none " + options);
  }
  Outcome info(const std::string& options = "") const { return loopmend_program("info " + path("in.ply") + options); }
};

/// A square sheet of 8 by 8 squares over (−1..1)² without those that `gone` names by column and row.
TriangleSoup sheet(const std::function<bool(int, int)>& gone) {
  TriangleSoup soup;
  for (int j = 0; j <= 8; ++j)
    for (int i = 0; i <= 8; ++i) soup.points.emplace_back(i / 4.0 - 1, j / 4.0 - 1, 0);
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < 8; ++i) {
      if (gone(i, j)) continue;
      const int v = 9 * j + i;
      soup.triangles.push_back({v, v + 1, v + 10});
      soup.triangles.push_back({v, v + 10, v + 9});
    }
  return soup;
}

/// Normals for every vertex of an OBJ file.
void add_normals(const std::filesystem::path& obj, std::size_t count) {
  std::ofstream file(obj, std::ios::app);
  for (std::size_t k = 0; k < count; ++k) file << "vn 0 0 1\n";
  file << "usemtl skin\n";
}

TEST_F(Told, WhatIsNotInTheOutputWithItsCount) {
  TriangleSoup soup = cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.9; });
  soup.colors.assign(soup.points.size(), {10, 20, 30, 255});
  write_mesh(work / "in.obj", soup);
  add_normals(work / "in.obj", 642);
  EXPECT_THAT(
      loopmend_program("info " + path("in.obj")).out,
      AllOf(HasSubstr("also holds: normals (642)"), HasSubstr("in no file that Loopmend writes: names of no face (1)"),
            HasSubstr("not in STL: vertex colours (" + std::to_string(soup.points.size()) + "), normals (642)")));
  const std::string command = "fill " + path("in.obj") + "--flow none -o ";
  EXPECT_THAT(loopmend_program(command + path("out.ply")).out,
              HasSubstr("Not in " + (work / "out.ply").string() + ": names of no face (1), normals (642).\n"));
  const Outcome stl = loopmend_program(command + path("out.stl") + "--report " + path("r.json"));
  const json report = json::parse(test::text_of(work / "r.json"));
  EXPECT_EQ(report["input"]["import"]["not_kept"][0], (json{{"what", "names of no face"}, {"count", 1}}));
  ASSERT_EQ(report["output"]["not_kept"].size(), 3u);
  EXPECT_EQ(report["output"]["not_kept"][1]["what"], "vertex colours");
  EXPECT_EQ(report["output"]["not_kept"][2]["what"], "normals");
  EXPECT_THAT(stl.out, HasSubstr("vertex colours"));
}

TEST_F(Told, StlAtLargeCoordinatesHasMovedTheScan) {
  TriangleSoup soup = cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.9; });
  write_mesh(work / "in.ply", soup);
  for (Vec3& p : soup.points) p.x() += 16777216;  // floats are 2 apart there
  write_mesh(work / "far.ply", soup);
  const auto report = [&](const std::string& words) {
    return json::parse(loopmend_program("fill " + words + "--flow none --report -").out);
  };
  const json far = report(path("far.ply") + "-o " + path("far.stl"));
  EXPECT_EQ(far["exterior_unchanged"], false);
  // Vertices at x − 2^24 = −1 .. 1: floats are 1 apart below, 2 above; the farthest lie just below 1.
  EXPECT_GT(far["output"]["largest_rounding"].get<double>(), 0.9);
  EXPECT_LT(far["output"]["largest_rounding"].get<double>(), 1.01);
  const json kept = report(path("far.ply") + "-o " + path("far_out.ply"));
  EXPECT_EQ(kept["exterior_unchanged"], true);
  EXPECT_EQ(kept["output"]["largest_rounding"], 0);
  // A mesh of floats is unchanged in STL, but for the patch.
  report(path("in.ply") + "-o " + path("floats.stl"));
  const json floats = report(path("floats.stl") + "-o " + path("again.stl"));
  EXPECT_EQ(floats["exterior_unchanged"], true);
}

TEST_F(Told, InfoWarnsOfStlOnlyFarFromTheOrigin) {
  TriangleSoup soup = cut(make_icosphere(2), [](const Vec3& p) { return p.z() > 0.9; });
  write_mesh(work / "in.ply", soup);
  EXPECT_THAT(info().out, Not(HasSubstr("binary STL")));
  for (Vec3& p : soup.points) p.x() += 1e5;
  write_mesh(work / "in.ply", soup);
  EXPECT_THAT(info().out, HasSubstr("binary STL would move vertices by up to 0.00"));
}

TEST_F(Told, ColoursThatAreMissing) {
  std::ofstream(work / "in.obj") << "v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0 0 1 0\nf 1 2 3\n";
  EXPECT_THAT(loopmend_program("info " + path("in.obj")).out, HasSubstr("1 vertex has no colour"));
  const json report = json::parse(loopmend_program("info " + path("in.obj") + "--json -").out);
  EXPECT_EQ(report["input"]["import"]["missing_colors"], 1);
  EXPECT_EQ(report["input"]["import"]["skipped_elements"], 0);
}

/// Two halves of a sheet that meet along x = 0 in vertices of their own, and a hole across the seam.
TriangleSoup split_sheet() {
  const auto half = [](bool left) {
    return sheet([left](int i, int j) { return (i < 4) != left || ((i == 3 || i == 4) && (j == 3 || j == 4)); });
  };
  TriangleSoup halves = joined({half(true), half(false)});
  std::vector<char> used(halves.points.size(), 0);  // no lone points: they would lie on others too
  for (const Triangle& t : halves.triangles)
    for (int v : t) used[v] = 1;
  std::vector<int> number(halves.points.size(), -1);
  TriangleSoup soup;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v]) {
      number[v] = static_cast<int>(soup.points.size());
      soup.points.push_back(halves.points[v]);
    }
  for (const Triangle& t : halves.triangles) soup.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  return soup;
}

TEST_F(Told, AMeshSplitAtSeamsIsNoSilentZero) {
  write_mesh(work / "in.ply", split_sheet());
  // Three squares above the hole and three below: 12 edges in pairs, 8 vertices in pairs.
  const std::string words = "12 boundary edges lie exactly on another one, and 8 vertices on an earlier one";
  EXPECT_THAT(info().out, AllOf(HasSubstr(words), HasSubstr("--stitch")));
  const Outcome split = fill();
  EXPECT_EQ(split.code, 1);
  EXPECT_THAT(split.out, AllOf(HasSubstr(words), HasSubstr("fill again with --stitch"), HasSubstr("0 filled")));
  EXPECT_THAT(info("--weld").out, AllOf(HasSubstr("8 vertices were welded"), Not(HasSubstr("lie exactly"))));
  const Outcome welded = fill("--weld --report -");
  EXPECT_EQ(welded.code, 0) << welded.err;
  const json report = json::parse(welded.out);
  EXPECT_EQ(report["input"]["import"]["vertices_welded"], 8);
  EXPECT_EQ(report["exterior_unchanged"], true);
  EXPECT_THAT(welded.err, HasSubstr("8 vertices were welded"));
  EXPECT_THAT(welded.err, HasSubstr("1 filled, 0 failed, 1 left as asked"));
}

TEST_F(Told, AnOuterRimThatTouchesAHoleIsLeftAsAsked) {
  // The corner square and the next one on the diagonal are gone: outer rim and hole meet at a vertex.
  write_mesh(work / "in.ply", sheet([](int i, int j) { return i == j && i < 2; }));
  const Outcome run = fill();
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, AllOf(HasSubstr("1 filled, 0 failed, 1 left as asked"), HasSubstr("outline of an open sheet")));
}

TEST_F(Told, HolesThatTouchAreBothFilled) {
  write_mesh(work / "in.ply", sheet([](int i, int j) { return i == j && (i == 3 || i == 4); }));
  const Outcome run = fill();
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, HasSubstr("2 filled, 0 failed, 1 left as asked"));
}

TEST_F(Told, AOneSidedSurfaceGetsNoAdviceThatDoesNotHelp) {
  constexpr int around = 24, across = 3;
  TriangleSoup strip;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j <= across; ++j) {
      const double t = 2 * std::numbers::pi * i / around, v = 0.4 * (2.0 * j / across - 1);
      const double r = 1 + v * std::cos(t / 2);
      strip.points.emplace_back(r * std::cos(t), r * std::sin(t), v * std::sin(t / 2));
    }
  // Half a turn later the strip meets itself upside down.
  const auto at = [&](int i, int j) { return i < around ? (across + 1) * i + j : across - j; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      strip.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      strip.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  write_mesh(work / "in.ply", strip);
  for (const char* options : {"", "--auto"}) {
    const Outcome run = fill(options);
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.out, AllOf(HasSubstr("the surface is one-sided there"), HasSubstr("Nothing was filled")));
    EXPECT_THAT(run.out, Not(AnyOf(HasSubstr("--auto"), HasSubstr("--repair"))));
  }
}

TEST_F(Told, NothingButCutSeamsIsNoSilentZero) {
  TriangleSoup soup = make_icosphere(2);
  const Triangle t = soup.triangles.front();  // a fin on one of its edges
  soup.points.push_back(2 * soup.points[t[0]]);
  soup.triangles.push_back({t[0], t[1], static_cast<int>(soup.points.size()) - 1});
  write_mesh(work / "in.ply", soup);
  const Outcome run = fill();
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("Nothing was filled"), HasSubstr("more than two faces: 1; fill again with --auto"),
                    HasSubstr("0 left as asked")));
  // With a hole beside it something was done.
  write_mesh(work / "in.ply", joined({soup, cut(make_icosphere(2), [](const Vec3& p) { return p.z() > 0.8; })}));
  EXPECT_EQ(fill().code, 0);
  // And who leaves that hole by name has asked for it.
  EXPECT_EQ(fill("--max-edges 3").code, 0);
}

TEST_F(Told, WhatTheSmallScansOfOurOwnAre) {
  const auto filled = [&](const std::string& name, const std::string& options = "") {
    return loopmend_program("fill '" LOOPMEND_TEST_DATA "/" + name + "' -o " + path("out.ply") + options);
  };
  const auto loops_left = [&] {
    return find_boundary_loops(make_surface_model(read_mesh(work / "out.ply").soup)).size();
  };
  const Outcome ring = filled("ring.obj");
  EXPECT_EQ(ring.code, 0);
  EXPECT_THAT(ring.out, AllOf(HasSubstr("1 filled, 0 failed"),
                              HasSubstr("outline of an open sheet (the surface lies inside the loop)")));
  EXPECT_EQ(loops_left(), 1u);

  const Outcome touching = filled("touching_holes.obj");
  EXPECT_EQ(touching.code, 0) << touching.out;
  EXPECT_THAT(touching.out, HasSubstr("2 filled, 0 failed"));

  const Outcome crack = filled("crack.obj");
  EXPECT_EQ(crack.code, 1);
  EXPECT_THAT(crack.out, HasSubstr("crack: nothing is missing, its sides are only not joined (--stitch joins them)"));
  for (const char* option : {"--weld", "--stitch"}) {
    EXPECT_EQ(filled("crack.obj", option).code, 0);
    EXPECT_EQ(loops_left(), 1u);
  }

  const Outcome tube = filled("tube_end.obj");
  EXPECT_EQ(tube.code, 0);
  EXPECT_THAT(tube.out, HasSubstr("2 filled, 0 failed"));
  EXPECT_EQ(loops_left(), 0u);
}

TEST_F(Told, TheSharedScansThatAreCutOrSplit) {
  const std::filesystem::path scans = std::filesystem::path(LOOPMEND_SHARED_DIR) / "scans2";
  if (!std::filesystem::exists(scans)) GTEST_SKIP() << "no shared scans here";
  const auto code = [&](const std::string& name, const std::string& options = "") {
    return loopmend_program("fill " + (scans / name).string() + " -o " + path("out.ply") + "--flow none " + options)
        .code;
  };
  EXPECT_EQ(code("skull_scp1.ply"), 1);
  EXPECT_EQ(code("hard/split_at_seams.ply"), 1);
  EXPECT_EQ(code("hard/split_at_seams.ply", "--weld"), 0);
  EXPECT_EQ(code("face_raw.ply"), 0);
}

TEST_F(Told, WhereAPictureIsTakenFrom) {
  write_mesh(work / "in.ply", sheet([](int i, int j) { return i == 3 && j == 3; }));
  const auto render = [&](const std::string& options) {
    return loopmend_program("render " + path("in.ply") + "-o " + path("out.png") + "--size 100x100 " + options);
  };
  for (const char* wrong : {"--view above", "--direction 0,0,0", "--direction 1,2", "--direction 1,2,x", "--loop 0",
                            "--loop 3", "--view top --direction 1,0,0"}) {
    EXPECT_EQ(render(wrong).code, 2) << wrong;
    EXPECT_FALSE(std::filesystem::exists(work / "out.png")) << wrong;
  }
  const auto picture = [&](const std::string& options) {
    EXPECT_EQ(render(options).code, 0) << options;
    return test::text_of(work / "out.png");
  };
  const std::string front = picture("--view front");
  EXPECT_EQ(picture("--direction 0,0,7"), front);
  EXPECT_NE(picture("--view iso"), front);
  EXPECT_NE(picture("--loop 2"), picture("--loop 2 --view iso"));
  EXPECT_NE(picture("--loop 2"), picture(""));
}

}  // namespace
}  // namespace loopmend
