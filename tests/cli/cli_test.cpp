// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run_program.h"

#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "mesh/boundary_loops.h"
#include "mesh/join_parts.h"
#include "samples/analytic_surfaces.h"
#include "support/sharp_surfaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fstream>
#include <thread>

namespace loopmend {
namespace {

using nlohmann::json;
using test::loopmend_program;
using test::Outcome;
using testing::HasSubstr;

/// One line for a person: no stack, no second line but the hint at the help.
void expect_message(const Outcome& run, int code, const std::string& words) {
  EXPECT_EQ(run.code, code) << run.err;
  EXPECT_THAT(run.err, HasSubstr("loopmend: "));
  EXPECT_THAT(run.err, HasSubstr(words));
  EXPECT_LE(std::count(run.err.begin(), run.err.end(), '\n'), 2) << run.err;
}

class Cli : public testing::Test {
 protected:
  void SetUp() override {
    const TriangleSoup two_holes = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.9 || p.x() > 0.95; });
    write_mesh(holes, two_holes);
    write_mesh(closed, make_icosphere(2));
  }
  test::Workspace work;
  const std::filesystem::path holes = work / "two holes.ply", closed = work / "closed.ply", out = work / "out.ply";
  std::string in_out() const { return "'" + holes.string() + "' -o '" + out.string() + "' "; }
};

TEST_F(Cli, HelpAndVersion) {
  EXPECT_EQ(loopmend_program("--version").out, "loopmend 0.1.0\n");
  for (const char* command : {"", "info ", "fill ", "sample ", "render "}) {
    const Outcome run = loopmend_program(std::string(command) + "--help");
    EXPECT_EQ(run.code, 0);
    EXPECT_THAT(run.out, HasSubstr("loopmend"));
  }
  EXPECT_THAT(loopmend_program("fill --help").out, HasSubstr("Examples:"));
}

TEST_F(Cli, InfoListsLoopsByFallingSize) {
  const Outcome run = loopmend_program("info '" + holes.string() + "'");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, HasSubstr("2 boundary loops"));
  const json report = json::parse(loopmend_program("info '" + holes.string() + "' --json -").out);
  ASSERT_EQ(report["loops"].size(), 2u);
  EXPECT_EQ(report["loops"][0]["number"], 1);
  EXPECT_EQ(report["loops"][0]["kind"], "hole");
  EXPECT_GT(report["loops"][0]["perimeter"], report["loops"][1]["perimeter"]);
  EXPECT_EQ(report["input"]["path"], holes.string());
}

TEST_F(Cli, FillClosesAllHolesAndReports) {
  const Outcome run = loopmend_program("fill " + in_out() + "--report -");
  EXPECT_EQ(run.code, 0) << run.err;
  const json report = json::parse(run.out);
  EXPECT_EQ(report["version"], "0.1.0");
  EXPECT_THAT(report["command_line"].get<std::string>(), HasSubstr("'" + holes.string() + "'"));
  EXPECT_EQ(report["exterior_unchanged"], true);
  EXPECT_GT(report["peak_memory_mb"], 1);
  double stages = 0;
  for (const char* stage : {"reading", "planning", "filling", "writing"})
    stages += report["stage_seconds"][stage].get<double>();
  EXPECT_NEAR(stages, report["total_seconds"], 1e-9);
  ASSERT_EQ(report["loops"].size(), 2u);
  for (const json& loop : report["loops"]) {
    EXPECT_EQ(loop["status"], "converged");
    for (const char* key : {"number", "edges", "perimeter", "diameter", "kind", "message", "free_vertices", "steps"})
      EXPECT_TRUE(loop.contains(key)) << key;
    double sum = 0;
    for (const char* key : {"initial_patch", "survey", "choice", "assemble", "solve", "checks", "rejected",
                            "expected_deviation", "other"}) {
      ASSERT_TRUE(loop["seconds"].contains(key)) << key;
      sum += loop["seconds"][key].get<double>();
    }
    EXPECT_NEAR(sum, loop["seconds"]["total"].get<double>(), 1e-6);
    EXPECT_GT(loop["seconds"]["survey"].get<double>() + loop["seconds"]["expected_deviation"].get<double>(), 0);
    EXPECT_LT(loop["energy"]["final"], 1e-4 * loop["energy"]["initial"].get<double>());
    for (const char* side : {"seam_before", "seam_after"})
      for (const char* key : {"g1_rms_deg", "g1_max_deg", "h_jump_rms", "h_jump_max", "h_jump_rms_times_diameter"})
        EXPECT_TRUE(loop[side].contains(key)) << key;
    EXPECT_LT(loop["seam_after"]["g1_rms_deg"], 0.2);
  }
  const TriangleSoup before = read_mesh(holes).soup, after = read_mesh(out).soup;
  EXPECT_EQ(std::memcmp(before.points.data(), after.points.data(), before.points.size() * sizeof(Vec3)), 0);
  EXPECT_TRUE(std::equal(before.triangles.begin(), before.triangles.end(), after.triangles.begin()));
  EXPECT_TRUE(find_boundary_loops(make_surface_model(after)).empty());
}

TEST_F(Cli, LoopsAreChosenByNumberVertexAndSize) {
  const auto status = [&](const std::string& options) {
    const Outcome run = loopmend_program("fill " + in_out() + options + " --flow none --quiet --report -");
    EXPECT_EQ(run.code, 0) << run.err;
    const json report = json::parse(run.out);
    return report["loops"][0]["status"].get<std::string>() + " " + report["loops"][1]["status"].get<std::string>();
  };
  EXPECT_EQ(status("--loops all"), "filled filled");
  EXPECT_EQ(status("--loops 2"), "skipped filled");
  EXPECT_EQ(status("--loops 1,2"), "filled filled");
  EXPECT_EQ(status("--max-diameter 0.85"), "skipped filled");
  EXPECT_EQ(status("--max-edges 5"), "skipped skipped");
  const SurfaceModel model = make_surface_model(read_mesh(holes).soup);
  const int vertex = model.soup_vertex[find_boundary_loops(model)[1].vertices[3]];
  EXPECT_EQ(status("--at-vertex " + std::to_string(vertex)), "skipped filled");
}

TEST_F(Cli, OuterRimIsLeftUnlessAskedFor) {
  // A bowl with a hole in its bottom: a lid on its boundary cuts nothing.
  write_mesh(holes, cut(make_icosphere(4), [](const Vec3& p) { return p.z() < 0.75 || p.z() > 0.97; }));
  const auto kinds = [&](const std::string& options) {
    const json report = json::parse(loopmend_program("fill " + in_out() + options + " --flow none --report -").out);
    EXPECT_EQ(report["loops"][0]["kind"], "outer rim");
    return report["loops"][0]["status"].get<std::string>() + " " + report["loops"][1]["status"].get<std::string>();
  };
  EXPECT_EQ(kinds(""), "skipped filled");
  EXPECT_EQ(find_boundary_loops(make_surface_model(read_mesh(out).soup)).size(), 1u);
  EXPECT_EQ(kinds("--include-outer-rim"), "filled filled");
  EXPECT_TRUE(find_boundary_loops(make_surface_model(read_mesh(out).soup)).empty());
}

TEST_F(Cli, IslandsAreJoinedByDefault) {
  // A cap of the sphere is missing but for two small pieces of it; another hole is ordinary.
  write_mesh(holes, cut(make_icosphere(5), [](const Vec3& p) {
               return (p.z() > 0.6 && (p - Vec3(0.4, 0, 0.9).normalized()).norm() > 0.15 &&
                       (p - Vec3(-0.4, 0.1, 0.9).normalized()).norm() > 0.15) ||
                      p.z() < -0.95;
             }));
  const Outcome run = loopmend_program("fill " + in_out() + "--report -");
  ASSERT_EQ(run.code, 0) << run.err;
  const json report = json::parse(run.out);
  ASSERT_EQ(report["loops"].size(), 4u);
  for (const json& loop : report["loops"]) EXPECT_EQ(loop["status"], "converged");
  EXPECT_THAT(report["loops"][2]["message"].get<std::string>() + report["loops"][3]["message"].get<std::string>(),
              HasSubstr("joined to hole 1"));
  const TriangleSoup before = read_mesh(holes).soup, after = read_mesh(out).soup;
  EXPECT_TRUE(find_boundary_loops(make_surface_model(after)).empty());
  for (std::size_t i = before.points.size(); i < after.points.size(); ++i) EXPECT_NEAR(after.points[i].norm(), 1, 1e-4);
  // On request they are left as they are: boundaries of sheets.
  const json left = json::parse(loopmend_program("fill " + in_out() + "--islands cover --report - --flow none").out);
  EXPECT_EQ(left["loops"][3]["status"], "skipped");
}

TEST_F(Cli, DebrisAboveAHoleIsNamedWithTheOptionThatHelps) {
  TriangleSoup soup = cut(make_icosphere(4), [](const Vec3& p) {
    const double from_axis = p.head<2>().norm();
    return p.z() > 0 && from_axis > 0.12 && from_axis < 0.45;
  });
  for (Vec3& p : soup.points)
    if (p.z() > 0 && p.head<2>().norm() < 0.2) p.z() += 0.36;
  write_mesh(holes, soup);
  const Outcome joined = loopmend_program("fill " + in_out());
  EXPECT_THAT(joined.out,
              AllOf(HasSubstr("If the islands in loop 1 are debris, --islands cover"), Not(HasSubstr(":flat"))));
  const Outcome covered = loopmend_program("fill " + in_out() + "--islands cover");
  EXPECT_THAT(covered.out, AllOf(HasSubstr("good"), Not(HasSubstr("debris"))));
}

TEST_F(Cli, EveryFlowModeAndSolverRuns) {
  for (const char* flow : {"mmcvf", "wf", "sdf", "mcf"})
    for (const char* mode : {"steady", "steps --sigma 1 --steps 40", "steps --solver gmres --steps 5"}) {
      const Outcome run =
          loopmend_program("fill " + in_out() + "--flow " + flow + " --mode " + mode + " --quiet --report -");
      EXPECT_EQ(run.code, 0) << flow << mode << run.err;
      EXPECT_THAT(json::parse(run.out)["loops"][0]["status"], testing::AnyOf("converged", "step_limit"));
    }
}

TEST_F(Cli, QuietSaysNothing) {
  const Outcome run = loopmend_program("fill " + in_out() + "--quiet");
  EXPECT_EQ(run.out + run.err, "");
}

TEST_F(Cli, AClosedMeshIsASentenceAndExitZero) {
  const Outcome run = loopmend_program("fill '" + closed.string() + "' -o '" + out.string() + "'");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, HasSubstr("closed"));
  EXPECT_EQ(read_mesh(out).soup.triangles.size(), 320u);
  EXPECT_THAT(loopmend_program("info '" + closed.string() + "'").out, HasSubstr("closed"));
}

TEST_F(Cli, FailedLoopsGiveExitOneAndTheRestIsWritten) {
  // A lone triangle beside the sphere: asked for by name, it cannot be filled.
  TriangleSoup soup = read_mesh(holes).soup;
  const int base = static_cast<int>(soup.points.size());
  soup.points.insert(soup.points.end(), {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}});
  soup.triangles.push_back({base, base + 1, base + 2});
  write_mesh(holes, soup);
  const Outcome run = loopmend_program("fill " + in_out() + "--include-outer-rim");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, HasSubstr("boundary of a single triangle"));
  EXPECT_EQ(find_boundary_loops(make_surface_model(read_mesh(out).soup)).size(), 1u);
}

/// Spheres without a cap, side by side.
TriangleSoup many_spheres(int count) {
  std::vector<TriangleSoup> parts;
  for (int k = 0; k < count; ++k) {
    TriangleSoup part = cut(make_icosphere(1), [](const Vec3& p) { return p.z() > 0.8; });
    for (Vec3& p : part.points) p = p * (1 + 0.01 * k) + Vec3(5 * k, 0, 0);
    parts.push_back(part);
  }
  return joined(parts);
}

int lines_of(const std::string& text) { return static_cast<int>(std::count(text.begin(), text.end(), '\n')); }

TEST_F(Cli, ManyLoopsAreSummedUpUnlessAskedFor) {
  const std::filesystem::path scan = work / "many.ply";
  const std::string words = "'" + scan.string() + "' ";
  const std::string to = "-o '" + out.string() + "' --flow none ";
  write_mesh(scan, many_spheres(50));
  EXPECT_GE(lines_of(loopmend_program("info " + words).out), 50);
  EXPECT_GE(lines_of(loopmend_program("fill " + words + to).out), 50);
  write_mesh(scan, many_spheres(51));
  const Outcome info = loopmend_program("info " + words);
  EXPECT_LT(lines_of(info.out), 25);
  EXPECT_THAT(info.out, HasSubstr("  51 holes\n"));
  EXPECT_THAT(info.out, HasSubstr("... and 41 smaller ones"));
  EXPECT_GE(lines_of(loopmend_program("info --verbose " + words).out), 51);
  const Outcome fill = loopmend_program("fill " + words + to + "--max-edges 4");
  EXPECT_LT(lines_of(fill.out), 25);
  EXPECT_THAT(fill.out, HasSubstr("51 loops skipped: has more than 4 edges (--max-edges)\n"));
  EXPECT_GE(lines_of(loopmend_program("fill --verbose " + words + to).out), 51);
}

TEST_F(Cli, ASummaryOfManyLoopsKeepsTheNumbersOfItsReasons) {
  TriangleSoup strips;  // 26 pairs, of 2 to 6 squares, that abut along their whole length
  for (int pair = 0; pair < 26; ++pair)
    for (const int side : {0, 1})
      for (int i = 0; i <= 2 + pair % 5; ++i) {
        const int first = static_cast<int>(strips.points.size());
        for (const int j : {0, 1}) strips.points.emplace_back(10 * pair + i, side + j, 0);
        if (i == 0) continue;
        strips.triangles.push_back({first - 2, first, first + 1});
        strips.triangles.push_back({first - 2, first + 1, first - 1});
      }
  const std::filesystem::path scan = work / "strips.ply";
  write_mesh(scan, strips);
  const Outcome fill = loopmend_program("fill '" + scan.string() + "' -o '" + out.string() + "'");
  EXPECT_THAT(fill.out, HasSubstr("52 loops skipped: boundary that coincides with another along 2 to 6 edges"));
}

TEST_F(Cli, ReportsOfThousandsOfLoopsHaveOneLineForEachAndAllFiguresOfTheLongest) {
  const std::filesystem::path scan = work / "many.ply";
  write_mesh(scan, many_spheres(1001));
  const std::string words = "fill '" + scan.string() + "' -o '" + out.string() + "' --flow none --report - ";
  const Outcome brief = loopmend_program(words), all = loopmend_program(words + "--verbose");
  const json of_brief = json::parse(brief.out), of_all = json::parse(all.out);
  ASSERT_EQ(of_brief["loops"].size(), 1001u);
  ASSERT_EQ(of_all["loops"].size(), 1001u);
  EXPECT_TRUE(of_brief["loops"][999].contains("neighborhood"));
  const json& last = of_brief["loops"][1000];
  EXPECT_EQ(last.size(), 12u);
  for (const auto& [name, value] : last.items())
    EXPECT_EQ(value, name == "grade" ? of_all["loops"][1000]["verdict"][name] : of_all["loops"][1000][name]) << name;
  EXPECT_TRUE(of_all["loops"][1000].contains("neighborhood"));
  for (const Outcome& run : {brief, all})
    EXPECT_LT(lines_of(run.out), 1001 + 30) << "one line for each loop, and for each field beside them";
  EXPECT_LT(lines_of(loopmend_program("info '" + scan.string() + "' --json -").out), 1001 + 10);
}

TEST_F(Cli, OneOfSomethingIsSaidInTheSingular) {
  TriangleSoup soup = make_icosphere(0);
  soup.points.push_back(Vec3(0, 0, 9));
  soup.triangles.push_back({soup.triangles[0][0], soup.triangles[0][1], static_cast<int>(soup.points.size()) - 1});
  write_mesh(work / "fin.ply", soup);
  EXPECT_THAT(loopmend_program("info '" + (work / "fin.ply").string() + "'").out,
              HasSubstr("  1 edge has more than two faces\n"));
}

TEST_F(Cli, OptionsWithoutEffectAreRefused) {
  const std::string fill = "fill '" + holes.string() + "' -o '" + out.string() + "' ";
  for (const char* words :
       {"--flow wf --boundary exact", "--flow none --continuity tangent", "--mode steps --boundary auto",
        "--continuity position --flow mcf", "--flow none --relief continued", "--mode steps --relief continued",
        "--flow none --mirror", "--flow none --mirror-plane 0,0,0,1,0,0"}) {
    const Outcome run = loopmend_program(fill + words);
    EXPECT_EQ(run.code, 2) << words;
    EXPECT_THAT(run.err, HasSubstr("has no effect with --flow")) << words;
  }
  EXPECT_EQ(loopmend_program(fill + "--boundary exact --continuity tangent").code, 0);
  for (const char* words : {"--stop-edge 1 --edges round", "--draw-edge 1,5 --flow wf",
                            "--draw-edge 1,5 --boundary exact", "--draw-edge 1", "--stop-edge one"})
    EXPECT_EQ(loopmend_program(fill + words).code, 2) << words;
  for (const char* words : {"--mirror-plane 0,0,0,1,0", "--mirror-plane 0,0,0,0,0,0", "--mirror-plane 0,0,0,1,0,0,0",
                            "--mirror --mirror-plane 0,0,0,1,0,0"})
    EXPECT_EQ(loopmend_program(fill + words).code, 2) << words;
}

TEST_F(Cli, WrongUsageIsTwo) {
  expect_message(loopmend_program(""), 2, "subcommand");
  expect_message(loopmend_program("fill"), 2, "IN");
  expect_message(loopmend_program("polish x"), 2, "no command 'polish'");
  expect_message(loopmend_program("fill " + in_out() + "--flow fast"), 2, "--flow");
  expect_message(loopmend_program("fill " + in_out() + "--sigma 0"), 2, "--sigma");
  expect_message(loopmend_program("fill " + in_out() + "--steps -3"), 2, "--steps");
  expect_message(loopmend_program("fill " + in_out() + "--density 99"), 2, "--density");
  expect_message(loopmend_program("fill " + in_out() + "--loops 7"), 2, "there is no loop 7");
  expect_message(loopmend_program("fill " + in_out() + "--loops first"), 2, "first");
  expect_message(loopmend_program("fill " + in_out() + "--at-vertex 999999"), 2, "there is no vertex 999999");
  expect_message(loopmend_program("fill " + in_out() + "--at-vertex 0"), 2, "lies on no boundary loop");
  expect_message(loopmend_program("fill " + in_out() + "--at-vertex ''"), 2, "--at-vertex");
  expect_message(loopmend_program("fill " + in_out() + "--loops 1,,2"), 2, "--loops");
  for (const char* option :
       {"--sigma nan", "--density nan", "--max-diameter nan", "--max-diameter -1", "--max-edges 0"})
    expect_message(loopmend_program("fill " + in_out() + option), 2, "takes a number");
  expect_message(loopmend_program("render '" + holes.string() + "' -o x.png --size 3"), 2, "--size");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(Cli, UnreadableInputIsThree) {
  const auto fails = [&](const std::filesystem::path& path, const std::string& words) {
    expect_message(loopmend_program("fill '" + path.string() + "' -o '" + out.string() + "'"), 3, words);
    expect_message(loopmend_program("info '" + path.string() + "'"), 3, path.filename().string());
  };
  const auto file = [&](const std::string& name, const std::string& text) {
    std::ofstream(work / name, std::ios::binary) << text;
    return work / name;
  };
  fails(work / "missing.ply", "missing.ply");
  fails(work.folder(), "folder");
  fails(file("empty.ply", ""), "empty");
  fails(file("notes.txt", "these are no triangles\n"), "notes.txt");
  fails(file("words.obj", "v 0 0 zero\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "line 1");
  fails(file("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "finite");
  fails(file("range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"), "4");
  fails(file("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), "no faces");
  const std::string whole = test::text_of(holes);
  fails(file("half.ply", whole.substr(0, whole.size() / 2)), "half.ply");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(Cli, AMeshUnderAWrongExtensionIsRead) {
  const std::filesystem::path disguised = work / "ply.obj";
  std::filesystem::copy_file(holes, disguised);
  EXPECT_EQ(loopmend_program("info '" + disguised.string() + "'").code, 0);
}

TEST_F(Cli, UnwritableOutputIsFourAndTheOldFileStays) {
  const std::string input = "fill '" + holes.string() + "' -o ";
  expect_message(loopmend_program(input + "'" + (work / "no/such/out.ply").string() + "'"), 4, "out.ply");
  expect_message(loopmend_program(input + "'" + work.folder().string() + ".xyz'"), 4, ".xyz");
  expect_message(loopmend_program(input + "/proc/out.ply"), 4, "/proc/out.ply");
  std::filesystem::create_directory(work / "folder.ply");
  expect_message(loopmend_program(input + "'" + (work / "folder.ply").string() + "'"), 4, "folder");
  expect_message(loopmend_program("fill " + in_out() + "--report /proc/report.json"), 4, "report.json");
  expect_message(loopmend_program("sample -o /proc/sample.ply"), 4, "sample.ply");
  // What stood there stays when the work fails after it began.
  std::ofstream(out) << "old";
  EXPECT_EQ(loopmend_program("fill " + in_out() + "--loops 9").code, 2);
  EXPECT_EQ(loopmend_program("fill '" + (work / "none.ply").string() + "' -o '" + out.string() + "'").code, 3);
  EXPECT_EQ(test::text_of(out), "old");
}

TEST_F(Cli, AReportNeverLandsOnAMesh) {
  const std::string before = test::text_of(holes);
  expect_message(loopmend_program("fill " + in_out() + "--report '" + holes.string() + "'"), 2, "overwrite");
  expect_message(loopmend_program("fill " + in_out() + "--report '" + out.string() + "'"), 2, "overwrite");
  expect_message(loopmend_program("info '" + holes.string() + "' --json '" + holes.string() + "'"), 2, "overwrite");
  EXPECT_EQ(test::text_of(holes), before);
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(Cli, OneFlippedFaceIsTurnedNotTheWholeScan) {
  TriangleSoup soup = read_mesh(holes).soup;
  std::swap(soup.triangles[0][1], soup.triangles[0][2]);
  write_mesh(holes, soup);
  const json report = json::parse(loopmend_program("fill " + in_out() + "--flow none --report -").out);
  EXPECT_EQ(report["input"]["import"]["reoriented_faces"], 1);
  EXPECT_EQ(report["exterior_unchanged"], true);
  const TriangleSoup after = read_mesh(out).soup;
  for (std::size_t f = 1; f < soup.triangles.size(); ++f) ASSERT_EQ(after.triangles[f], soup.triangles[f]);
}

TEST_F(Cli, AFullStandardOutputIsNoticed) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "/dev/full is not here";
  const std::string command = std::string(LOOPMEND_PROGRAM) + " info '" + holes.string() + "' >/dev/full 2>/dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 4);
}

TEST_F(Cli, FillWritesEveryFormat) {
  for (const char* name : {"a.ply", "a.stl", "a.obj", "a.off"})
    for (const char* encoding : {"", " --ascii"}) {
      const std::filesystem::path path = work / name;
      EXPECT_EQ(loopmend_program("fill '" + holes.string() + "' -o '" + path.string() + "' --quiet" + encoding).code,
                0);
      EXPECT_TRUE(find_boundary_loops(make_surface_model(read_mesh(path).soup)).empty()) << name;
    }
}

TEST_F(Cli, SampleIsWrittenAndFilled) {
  EXPECT_EQ(loopmend_program("sample -o '" + holes.string() + "'").code, 0);
  const Outcome run = loopmend_program("fill " + in_out() + "--report -");
  EXPECT_EQ(run.code, 0) << run.err;
  const json report = json::parse(run.out);
  int filled = 0, boundaries = 0;
  for (const json& loop : report["loops"]) {
    filled += loop.contains("verdict") && loop["verdict"]["grade"] == "good";
    boundaries += loop["kind"] == "outer rim";
  }
  EXPECT_EQ(filled, 5);
  EXPECT_EQ(boundaries, 1);
}

TEST_F(Cli, RenderNeedsNoDisplay) {
  const std::filesystem::path png = work / "picture.png";
  for (const std::string& words : {std::string("--color h"), std::string("--color plain --size 320x200"),
                                   std::string("--color zebra --size 320x200")}) {
    const Outcome run = loopmend_program("render '" + holes.string() + "' -o '" + png.string() + "' " + words);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(test::text_of(png).substr(1, 3), "PNG");
    std::filesystem::remove(png);
  }
}

/// No flow runs where sharp edges are continued.
TEST_F(Cli, AFilmSaysWhatMadeThePatch) {
  write_mesh(work / "cube.ply",
             cut(test::make_cube(24), [](const Vec3& p) { return (p - Vec3(1, 1, 0.5)).norm() < 0.2; }));
  const std::string folder = "'" + work.folder().string();
  const Outcome run =
      loopmend_program("render " + folder + "/cube.ply' --size 100x100 --film " + folder + "/cube.gif'");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, testing::HasSubstr("2 states of the patch on loop 1, made by sharp_edges"));
}

#ifdef LOOPMEND_PICTURES_MODULE
TEST_F(Cli, WithoutTheModuleForPicturesAllElseIsDone) {
  const std::filesystem::path alone = work / "alone";
  std::filesystem::create_directory(alone);
  std::filesystem::copy_file(LOOPMEND_PROGRAM, alone / "loopmend");
  const std::string program = (alone / "loopmend").string(),
                    scan = "'" + holes.string() + "' -o '" + work.folder().string();
  EXPECT_EQ(test::run_in_shell(program + " fill " + scan + "/filled.ply'").code, 0);
  const Outcome drawn = test::run_in_shell(program + " render " + scan + "/picture.png'");
  EXPECT_EQ(drawn.code, 5);
  EXPECT_THAT(drawn.err, testing::HasSubstr("loopmend-pictures"));
  EXPECT_FALSE(exists(work / "picture.png"));
}
#endif

/// Seconds of the processor that a running child has used; -1 where it is gone.
double processor_seconds(pid_t child) {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(child, &clock) != 0 || clock_gettime(clock, &time) != 0) return -1;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

TEST_F(Cli, InterruptEndsSoonWithNothingHalfWritten) {
  const std::filesystem::path big = work / "big.ply";
  write_mesh(big, cut(make_icosphere(7), [](const Vec3& p) { return p.z() > 0; }));
  const pid_t child = fork();
  if (child == 0) {
    if (!std::freopen("/dev/null", "w", stderr)) _exit(98);
    execl(LOOPMEND_PROGRAM, "loopmend", "fill", big.c_str(), "-o", out.c_str(), nullptr);
    _exit(99);
  }
  while (processor_seconds(child) >= 0 && processor_seconds(child) < 0.7)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  const double worked = processor_seconds(child);
  kill(child, SIGINT);
  int status = 0;
  rusage use{};
  wait4(child, &status, 0, &use);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  EXPECT_LT(seconds(use.ru_utime) + seconds(use.ru_stime) - worked, 1);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_FALSE(std::filesystem::exists(out));
  for (const auto& entry : std::filesystem::directory_iterator(work.folder()))
    EXPECT_EQ(entry.path().filename().string().find("loopmend-"), std::string::npos) << entry.path();
}

}  // namespace
}  // namespace loopmend
