// SPDX-License-Identifier: GPL-3.0-or-later
// Files as people bring them: what is joined, turned and named before any hole is filled.
#include "cli/run_program.h"

#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "mesh/boundary_loops.h"
#include "mesh/scan_attributes.h"
#include "repair/watertight.h"
#include "samples/analytic_surfaces.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <utility>

namespace loopmend {
namespace {

using test::loopmend_program;
using test::Outcome;
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;
using json = nlohmann::json;

/// What a message says between 'loopmend fill' or 'loopmend blend' and the quotation mark.
std::string advised(const std::string& text) {
  const std::size_t begin = text.find("'loopmend ");
  if (begin == std::string::npos) return "";
  const std::size_t first = begin + std::string("'loopmend ").size();
  return text.substr(first, text.find('\'', first) - first);
}

class PreparationCommands : public test::ProgramTest {
 protected:
  Outcome info(const std::string& name, const std::string& options = "") {
    return loopmend_program("info " + path(name) + options);
  }
  Outcome fill(const std::string& name, const std::string& options = "") {
    std::filesystem::remove(work / "out.ply");
    return loopmend_program("fill " + path(name) + "-o " + path("out.ply") + options);
  }
  Watertightness written() { return watertightness(read_mesh(work / "out.ply").soup); }

  /// Of the surface as the file joins its faces.
  int open_edges_written() {
    int edges = 0;
    for (const BoundaryLoop& loop : find_boundary_loops(make_surface_model(read_mesh(work / "out.ply").soup)))
      edges += loop.edges();
    return edges;
  }

  /// A ball torn open along its equator; one side is moved up.
  static TriangleSoup torn(double gap) {
    TriangleSoup soup = make_icosphere(3);
    std::map<int, int> twin;
    for (Triangle& t : soup.triangles) {
      double height = 0;
      for (int v : t) height += soup.points[v].z();
      for (int& v : t) {
        if (height < 0 || std::abs(soup.points[v].z()) > 1e-9) continue;
        const auto [at, is_new] = twin.emplace(v, static_cast<int>(soup.points.size()));
        if (is_new) soup.points.push_back(soup.points[v] + Vec3(0, 0, gap));
        v = at->second;
      }
    }
    return soup;
  }
  void write(const std::string& name, const TriangleSoup& soup) { write_mesh(work / name, soup, Encoding::ascii); }
};

TEST_F(PreparationCommands, CracksOfRoundingInStlAreJoined) {
  write("a.stl", torn(1e-6));
  EXPECT_THAT(info("a.stl").out, AllOf(HasSubstr("vertices were joined to others up to 1e-06 away along cracks"),
                                       HasSubstr("The surface is closed")));
  const Outcome run = fill("a.stl", "--report " + path("r.json"));
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(written().open_edges, 0U);
  const json report = json::parse(test::text_of(work / "r.json"));
  EXPECT_GT(report["input"]["import"]["near_vertices_joined"], 10);
  EXPECT_NEAR(report["input"]["import"]["largest_join"], 1e-6, 1e-12);
  // Formats with a topology of their own keep it.
  write("a.ply", torn(1e-6));
  EXPECT_THAT(info("a.ply").out, Not(HasSubstr("up to 1e-06 away")));
}

TEST_F(PreparationCommands, WiderCracksNameStitchAndNothingThatRemovesFaces) {
  write("a.stl", torn(1e-3));
  EXPECT_THAT(info("a.stl").out,
              AllOf(HasSubstr("lie within a tenth of the edges there of another"), HasSubstr("--stitch")));
  const Outcome run = fill("a.stl");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, AllOf(HasSubstr("--stitch"), Not(HasSubstr("--trim")), Not(HasSubstr("--cut"))));
  EXPECT_EQ(fill("a.stl", "--stitch").code, 0);
  EXPECT_EQ(written().open_edges, 0U);
}

/// Two halves of a ball, open at the poles too. Their gap is wider than --stitch reaches by itself.
TEST_F(PreparationCommands, AGapBetweenTwoHalvesNamesItsTolerance) {
  const auto radius = [](double z) { return std::sqrt(1 - z * z); };
  TriangleSoup upper = make_revolution(radius, 0, 0.95, 48, 12);  // edges of 0.13 at the equator
  for (Vec3& p : upper.points) p.z() += 0.03;
  write("a.ply", joined({make_revolution(radius, -0.95, 0, 48, 12), upper}));
  for (const char* options : {"", "--stitch", "--auto"}) {
    const Outcome run = fill("a.ply", options);
    EXPECT_EQ(run.code, 1) << options;
    EXPECT_THAT(run.out, AllOf(HasSubstr("--stitch 30% joins them"), HasSubstr("2 filled"))) << options;
  }
  EXPECT_EQ(fill("a.ply", "--stitch 30%").code, 0);
  EXPECT_EQ(written().open_edges, 0U);
  // The ends of a short tube are as near to each other, and each is a hole.
  write("b.ply", make_revolution([](double) { return 1.0; }, 0, 0.1, 12, 1));
  EXPECT_THAT(fill("b.ply").out, HasSubstr("2 filled"));
}

/// The sides of the gap cross each other to and fro by a quarter of the edges: neither lies beside the other.
TEST_F(PreparationCommands, ARaggedGapNamesALengthThatClosesIt) {
  TriangleSoup ball = make_icosphere(4);
  const std::size_t given = ball.points.size();
  std::map<int, int> twin;
  std::set<int> below;
  const auto is_above = [&](const Triangle& t) {
    return (ball.points[t[0]] + ball.points[t[1]] + ball.points[t[2]]).dot(Vec3(0.3, 0.4, 1)) > 0.5;
  };
  std::vector<char> above;
  for (const Triangle& t : ball.triangles) {
    above.push_back(is_above(t) ? 1 : 0);
    if (!is_above(t)) below.insert(t.begin(), t.end());
  }
  for (std::size_t f = 0; f < above.size(); ++f)
    for (int& v : ball.triangles[f]) {
      if (above[f] == 0 || !below.contains(v)) continue;
      const auto [at, is_new] = twin.emplace(v, static_cast<int>(ball.points.size()));
      if (is_new)  // edges of 0.07
        ball.points.push_back(ball.points[v] +
                              0.018 * Vec3(std::sin(v), std::sin(3 * v), std::cos(5 * v)).normalized());
      v = at->second;
    }
  ASSERT_GT(ball.points.size(), given + 50);
  write("a.ply", ball);
  const Outcome run = fill("a.ply");
  EXPECT_EQ(run.code, 1);
  const std::size_t at = run.out.find("--stitch 0.0");
  ASSERT_NE(at, std::string::npos) << run.out;
  EXPECT_THAT(run.out, AllOf(HasSubstr("lies beside it all along"), Not(HasSubstr("tiles"))));
  EXPECT_EQ(fill("a.ply", run.out.substr(at, run.out.find(' ', at + 9) - at)).code, 0);
  EXPECT_EQ(written().open_edges, 0U);
}

TEST_F(PreparationCommands, StitchTakesATolerance) {
  write("a.ply", torn(0.01));  // edges of 0.15
  const auto is_closed = [&](const std::string& options) {
    fill("a.ply", options + " --max-edges 1");
    return written().open_edges == 0;
  };
  EXPECT_TRUE(is_closed("--stitch"));
  EXPECT_FALSE(is_closed("--stitch 5%"));
  EXPECT_TRUE(is_closed("--stitch 15%"));
  EXPECT_FALSE(is_closed("--stitch=0.009"));
  EXPECT_TRUE(is_closed("--stitch 0.011"));
  const Outcome first = loopmend_program("fill --stitch " + path("a.ply") + "-o " + path("out.ply"));
  EXPECT_EQ(first.code, 0) << first.err;
  for (const char* wrong : {"--stitch=wide", "--stitch -1", "--stitch 50%", "--stitch=nan"}) {
    const Outcome run = fill("a.ply", wrong);
    EXPECT_EQ(run.code, 2) << wrong;
    EXPECT_THAT(run.err, HasSubstr("--stitch takes a length")) << wrong;
  }
}

TEST_F(PreparationCommands, BodiesInsideOutAreNamedAndTurned) {
  TriangleSoup soup = make_icosphere(3);
  for (Triangle& t : soup.triangles) std::swap(t[1], t[2]);
  write("a.ply", soup);
  EXPECT_THAT(info("a.ply").out, HasSubstr("1 body or cavity is inside out; fill --repair turns it"));
  const json found = json::parse(info("a.ply", "--json -").out);
  EXPECT_EQ(found["inside_out"]["closed"], 1);
  const Outcome run = fill("a.ply", "--repair --report " + path("r.json"));
  EXPECT_THAT(run.out, HasSubstr("1280 faces turned (1 body inside out)"));
  EXPECT_GT(written().volume, 4);
  const json report = json::parse(test::text_of(work / "r.json"));
  EXPECT_EQ(report["prepared"]["repaired"]["turned_shells"], 1);
  EXPECT_EQ(report["prepared"]["repaired"]["turned_faces"], 1280);
}

/// A box of two triangles a side without its lid: all of its boundary would be called bad.
TEST_F(PreparationCommands, TrimmingIsNeitherProposedNorDoneWhereItWouldTakeThePart) {
  TriangleSoup box;
  for (int k = 0; k < 8; ++k) box.points.emplace_back(k & 1, (k >> 1) & 1, k >> 2);
  box.triangles = {{0, 3, 1}, {0, 2, 3}, {0, 1, 5}, {0, 5, 4}, {1, 3, 7},
                   {1, 7, 5}, {3, 2, 6}, {3, 6, 7}, {2, 0, 4}, {2, 4, 6}};
  write("a.stl", box);
  const Outcome run = fill("a.stl");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, Not(HasSubstr("--trim-boundary")));
  const Outcome trimmed = fill("a.stl", "--trim-boundary 3");
  EXPECT_EQ(written().open_edges, 0U);
  EXPECT_NEAR(written().volume, 1, 1e-6);
}

TEST_F(PreparationCommands, TextOfFloatsIsReadAsFloatsUnlessAllDigitsAreAskedFor) {
  std::ofstream(work / "a.ply") << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                                   "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                                   "end_header\n0.123456789012 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_THAT(info("a.ply").out, HasSubstr("1 vertices of more digits than the single precision"));
  EXPECT_THAT(info("a.ply", "--double").out, Not(HasSubstr("digits")));
  EXPECT_EQ(fill("a.ply", "--ascii --max-edges 1").code, 0);
  EXPECT_THAT(test::text_of(work / "out.ply"), AllOf(HasSubstr("property float x"), HasSubstr("\n0.12345679 0 0\n")));
  EXPECT_EQ(fill("a.ply", "--ascii --max-edges 1 --double").code, 0);
  EXPECT_THAT(test::text_of(work / "out.ply"),
              AllOf(HasSubstr("property double x"), HasSubstr("\n0.123456789012 0 0\n")));
}

/// A tube with two ends and a hole in its wall.
TEST_F(PreparationCommands, AllButTheLargestLoopsAreFilledAndLabelled) {
  write("a.ply", cut(make_cylinder(6, 32), [](const Vec3& p) { return (p - Vec3(1, 0, 3)).norm() < 0.5; }));
  const TriangleSoup before = read_mesh(work / "a.ply").soup;
  Outcome run = fill("a.ply", "--all-but-largest 2 --mark");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, AllOf(HasSubstr("1 filled, 0 failed, 2 left as asked"), HasSubstr("one of the largest loops")));
  const TriangleSoup after = read_mesh(work / "out.ply").soup;
  const AttributeColumn* patch = find_column(after.attributes->faces, "patch");
  ASSERT_TRUE(patch);
  for (std::size_t f = 0; f < after.triangles.size(); ++f)
    ASSERT_EQ(patch->value(f), f < before.triangles.size() ? 0 : 1);
  for (const auto& [name, keyword] : {std::pair("b.obj", "g"), std::pair("b.glb", "o"), std::pair("b.3mf", "o")}) {
    run = loopmend_program("fill " + path("a.ply") + "-o " + path(name) + "--all-but-largest 2 --mark");
    ASSERT_EQ(run.code, 0) << run.err;
    const TriangleSoup labelled_soup = read_mesh(work / name).soup;
    const ScanAttributes& scan = *labelled_soup.attributes;
    std::size_t labelled = 0;
    for (const FaceNames& names : scan.names)
      for (int of : names.keyword == keyword ? names.of_face : std::vector<int>{})
        labelled += of >= 0 && names.names[of] == "loopmend_patch";
    EXPECT_EQ(labelled, after.triangles.size() - before.triangles.size()) << name;
  }
  EXPECT_THAT(loopmend_program("fill " + path("a.ply") + "-o " + path("b.stl") + "--mark").out, HasSubstr("no label"));
  EXPECT_THAT(fill("a.ply", "--all-but-largest 3").out, HasSubstr("3 left as asked"));
}

/// A ball with a hole, at one edge of which another sheet passes: three faces meet there.
TriangleSoup ball_with_sheet_at_its_hole() {
  TriangleSoup soup = trim_boundaries(cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.8; }));
  std::map<std::pair<int, int>, int> faces;
  for (const Triangle& t : soup.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++faces[std::minmax(t[k], t[(k + 1) % 3])];
  const auto [a, b] =
      std::find_if(faces.begin(), faces.end(), [](const auto& edge) { return edge.second == 1; })->first;
  const Vec3 middle = (soup.points[a] + soup.points[b]) / 2;
  const int outer = static_cast<int>(soup.points.size()), inner = outer + 1;
  soup.points.push_back(1.2 * middle);
  soup.points.push_back(0.8 * middle);
  soup.triangles.push_back({a, b, outer});
  soup.triangles.push_back({b, a, inner});
  return soup;
}

TEST_F(PreparationCommands, AutoRepairsWhereALoopRunsAlongAnEdgeOfThreeFaces) {
  write("a.ply", ball_with_sheet_at_its_hole());
  const Outcome plain = fill("a.ply");
  EXPECT_EQ(plain.code, 1);
  EXPECT_THAT(plain.out, AnyOf(HasSubstr("--auto"), HasSubstr("--repair")));
  const Outcome run = fill("a.ply", "--auto");
  EXPECT_EQ(run.code, 0) << run.out;
  EXPECT_THAT(run.out, AllOf(HasSubstr("Repaired: 1 edge separated"), HasSubstr("filled, 0 failed")));
}

/// Triangles that cannot be oriented without a cut, which parts sides that can be joined again.
TEST_F(PreparationCommands, AutoStitchesAgainWhatItsRepairParted) {
  TriangleSoup soup;
  soup.points = {{2, 3, 0}, {3, 1, 0}, {3, 0, 4}, {4, 0, 0}, {2, 4, 1}, {3, 2, 3}};
  soup.triangles = {{0, 2, 3}, {0, 4, 5}, {1, 4, 5}, {3, 1, 0}, {4, 0, 3}, {4, 3, 1}, {5, 3, 0}};
  write("a.ply", soup);
  EXPECT_THAT(fill("a.ply", "--repair").out, HasSubstr("the mesh is split there (--stitch joins them)"));
  const int parted = open_edges_written();
  const Outcome run = fill("a.ply", "--auto --report " + path("r.json"));
  EXPECT_THAT(run.out, AllOf(HasSubstr("Stitched again: 2 vertices were joined"), Not(HasSubstr("--stitch"))));
  EXPECT_LT(open_edges_written(), parted);
  EXPECT_EQ(written().non_manifold_edges, 0U);
  EXPECT_EQ(json::parse(test::text_of(work / "r.json"))["prepared"]["joined_again"], 2);
}

TEST_F(PreparationCommands, AutoStitchesCracks) {
  write("a.ply", torn(0.01));
  const Outcome run = fill("a.ply", "--auto");
  EXPECT_EQ(run.code, 0) << run.out;
  EXPECT_THAT(run.out, HasSubstr("Stitched: "));
  EXPECT_EQ(written().open_boundaries, 0U);
}

TEST_F(PreparationCommands, AutoChangesNothingOfASoundMesh) {
  write("a.ply", cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.8; }));
  ASSERT_EQ(fill("a.ply").code, 0);
  const TriangleSoup plain = read_mesh(work / "out.ply").soup;
  const Outcome run = fill("a.ply", "--auto");
  ASSERT_EQ(run.code, 0);
  EXPECT_THAT(run.out, Not(AnyOf(HasSubstr("Stitched"), HasSubstr("Repaired"))));
  const TriangleSoup prepared = read_mesh(work / "out.ply").soup;
  EXPECT_EQ(prepared.points, plain.points);
  EXPECT_EQ(prepared.triangles, plain.triangles);
}

TEST_F(PreparationCommands, ExpectedDeviationOfEachNewVertexIsAPropertyOfPly) {
  write("a.ply", cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.8; }));
  const std::size_t given = read_mesh(work / "a.ply").soup.points.size();
  const Outcome run = fill("a.ply", "--deviation --report " + path("r.json"));
  ASSERT_EQ(run.code, 0) << run.err;
  const nlohmann::json report = nlohmann::json::parse(std::ifstream(work / "r.json"));
  const double likely = report["loops"][0]["expected_deviation"]["likely"];
  EXPECT_GT(likely, 0);
  const TriangleSoup after = read_mesh(work / "out.ply").soup;
  const AttributeColumn* column = find_column(after.attributes->points, "expected_deviation");
  ASSERT_TRUE(column);
  double largest = 0;
  for (std::size_t v = 0; v < after.points.size(); ++v) {
    if (v < given) {
      ASSERT_EQ(column->value(v), 0) << v;
    }
    largest = std::max(largest, column->value(v));
  }
  EXPECT_GT(largest, likely);
  EXPECT_THAT(loopmend_program("fill " + path("a.ply") + "-o " + path("b.obj") + "--deviation").out,
              HasSubstr("Only PLY and polydata have room"));
}

constexpr int sides = 48;
const double pipe_volume = 4 * (sides * std::sin(2 * std::acos(-1.0) / sides) / 2) * (1 - 0.64);

/// A tube of two walls, open at both ends.
TriangleSoup pipe() {
  TriangleSoup outer = make_cylinder(4, sides), inner = make_cylinder(4, sides);
  for (Vec3& p : inner.points) p.head<2>() *= 0.8;
  for (Triangle& t : inner.triangles) std::swap(t[1], t[2]);
  return joined({outer, inner});
}

TEST_F(PreparationCommands, ThePlaneEndsOfAPipeAreClosed) {
  write("a.ply", pipe());
  const std::string out = fill("a.ply").out;
  EXPECT_THAT(out, HasSubstr("a wall ends here, too: joined to hole"));
  EXPECT_THAT(out, Not(HasSubstr("blend")));
  EXPECT_EQ(written().open_edges, 0U);
  EXPECT_EQ(written().intersections, 0U);
  EXPECT_NEAR(written().volume, pipe_volume, 1e-6);
}

/// What is proposed closes the pipe.
TEST_F(PreparationCommands, RingsOfAWallAreNamedAndBlendClosesThem) {
  write("a.ply", pipe());
  const std::string out = fill("a.ply", "--islands cover").out;
  std::vector<std::string> proposed;
  for (std::size_t at = 0; (at = out.find("blend --loops ", at)) != std::string::npos; ++at) {
    const std::string loops = out.substr(at + 14, out.find('\'', at) - at - 14);
    if (std::find(proposed.begin(), proposed.end(), loops) == proposed.end()) proposed.push_back(loops);
  }
  ASSERT_EQ(proposed.size(), 2U) << out;
  ASSERT_EQ(loopmend_program("blend " + path("a.ply") + "-o " + path("b.ply") + "--loops " + proposed.front()).code, 0);
  const std::string second = fill("b.ply", "--islands cover").out;  // the other end, whose loops are 1 and 2 now
  EXPECT_THAT(second, HasSubstr("blend --loops 1:1,1:2"));
  ASSERT_EQ(loopmend_program("blend " + path("b.ply") + "-o " + path("out.ply") + "--loops 1:1,1:2").code, 0);
  EXPECT_EQ(written().open_edges, 0U);
  EXPECT_EQ(written().intersections, 0U);
  EXPECT_NEAR(written().volume, pipe_volume, 1e-6);
}

/// Two plane sheets beside each other: two strips make a hole of the gap, and it is filled flat.
TEST_F(PreparationCommands, AThinGapBetweenPlaneSheetsIsFilledBetweenTwoStrips) {
  TriangleSoup one = make_graph([](double, double) { return 0; }, 0.5, 20), other = one;
  for (Vec3& p : other.points) p.y() += 1.03;
  write("a.ply", joined({one, other}));
  const TriangleSoup soup = read_mesh(work / "a.ply").soup;
  const auto vertex_at = [&](double x, double y) {
    const auto found = std::find_if(soup.points.begin(), soup.points.end(),
                                    [&](const Vec3& p) { return (p - Vec3(x, y, 0)).norm() < 1e-4; });
    return std::to_string(found - soup.points.begin());
  };
  const Outcome run = fill("a.ply", "--bridge " + vertex_at(-0.45, 0.5) + "," + vertex_at(-0.45, 0.53) + " --bridge " +
                                        vertex_at(0.45, 0.5) + "," + vertex_at(0.45, 0.53));
  EXPECT_EQ(run.code, 0) << run.out;
  EXPECT_THAT(run.out, HasSubstr("1 filled, 0 failed"));
  const TriangleSoup after = read_mesh(work / "out.ply").soup;
  double area = 0;
  for (const Triangle& t : after.triangles) {
    const Vec3 a = after.points[t[0]], b = after.points[t[1]], c = after.points[t[2]];
    EXPECT_LT(std::abs(c.z()), 1e-6);
    area += (b - a).cross(c - a).norm() / 2;
  }
  EXPECT_NEAR(area, 2 + 0.03 * 0.95, 0.03 * 0.06);  // up to the strips, which end an edge beside the corners
}

TEST_F(PreparationCommands, LooseDebrisIsRemovedByAuto) {
  TriangleSoup ball = cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.9; });
  for (int k = 0; k < 20; ++k) {
    const int first = static_cast<int>(ball.points.size());
    const Vec3 place(2 + 0.1 * k, 0, 0);
    for (const Vec3& d : {Vec3(0, 0, 0), Vec3(0.02, 0, 0), Vec3(0, 0.02, 0)}) ball.points.push_back(place + d);
    ball.triangles.push_back({first, first + 1, first + 2});
  }
  write("debris.ply", ball);
  const Outcome run = fill("debris.ply", "--auto --check");
  EXPECT_EQ(run.code, 0) << run.out;
  EXPECT_THAT(run.out, AllOf(HasSubstr("20 fragments removed"), HasSubstr("Ready to print: yes")));
}

TEST_F(PreparationCommands, SpikesOfMissingDataAreNamedAndCut) {
  TriangleSoup terrain = make_graph([](double x, double y) { return 400 + 0.1 * x * y; }, 5, 30);
  for (int v : {200, 201, 480}) terrain.points[v].z() = -9999;
  write("a.ply", terrain);
  const std::string advice = "3 vertices lie at -9999, a mark for missing data: fill --cut-no-data";
  EXPECT_THAT(info("a.ply").out, HasSubstr(advice));
  EXPECT_EQ(json::parse(info("a.ply", "--json -").out)["no_data"]["vertices"], 3);
  EXPECT_THAT(fill("a.ply").out, HasSubstr(advice));
  const Outcome run = fill("a.ply", "--cut-no-data --report " + path("r.json"));
  EXPECT_EQ(run.code, 0) << run.out;
  EXPECT_THAT(run.out, AllOf(HasSubstr("removed at 3 vertices of missing data"), HasSubstr("2 filled, 0 failed")));
  EXPECT_GT(json::parse(test::text_of(work / "r.json"))["prepared"]["no_data_faces"], 10);
  const TriangleSoup after = read_mesh(work / "out.ply").soup;
  for (const Triangle& t : after.triangles)
    for (int v : t) ASSERT_GT(after.points[v].z(), 390);
  EXPECT_THAT(fill("a.ply", "--cut-no-data").out, Not(HasSubstr("--cut-no-data")));
  EXPECT_THAT(fill("a.ply", "--auto").out,
              AllOf(HasSubstr("removed at 3 vertices of missing data"), HasSubstr("2 filled, 0 failed")));
  write("sound.ply", make_graph([](double x, double y) { return 400 + 0.1 * x * y; }, 5, 30));
  EXPECT_THAT(fill("sound.ply", "--cut-no-data").out, HasSubstr("--cut-no-data removed nothing"));
}

TEST_F(PreparationCommands, FacesWithAVertexTwiceAreNamedWithWhatRemovesThem) {
  TriangleSoup ball = make_icosphere(2);
  ball.triangles.push_back({3, 3, 7});
  write("a.stl", ball);
  EXPECT_THAT(fill("a.stl").out, HasSubstr("1 face has a vertex twice and stays; fill --repair removes such faces"));
  EXPECT_THAT(fill("a.stl", "--repair").out, Not(HasSubstr("a vertex twice")));
}

TEST_F(PreparationCommands, ClosedBodiesThatOverlapStayClosed) {
  TriangleSoup moved = make_icosphere(3);
  for (Vec3& p : moved.points) p += Vec3(1, 0.1, 0.2);
  write("a.ply", joined({make_icosphere(3), moved}));
  for (const char* options : {"", "--cut-intersections", "--auto"}) {
    EXPECT_EQ(fill("a.ply", options).code, 0) << options;
    EXPECT_EQ(written().open_edges, 0U) << options;
    EXPECT_GT(written().volume, 8) << options;
  }
}

TEST_F(PreparationCommands, ThePlateWithoutItsEdgeIsNamedAndTheCommandClosesIt) {
  TriangleSoup top = make_graph([](double, double) { return 0; }, 1, 20), bottom = top;
  for (Vec3& p : top.points) p.z() = 0.1;
  for (Triangle& t : bottom.triangles) std::swap(t[1], t[2]);
  write("plate.ply", joined({top, bottom}));
  const Outcome run = fill("plate.ply");
  EXPECT_EQ(run.code, 0);
  const std::string command = advised(run.out);
  ASSERT_EQ(command, "blend --loops 1:1,1:2") << run.out;
  EXPECT_EQ(loopmend_program(command + " " + path("plate.ply") + "-o " + path("out.ply")).code, 0);
  EXPECT_TRUE(written().printable());
  EXPECT_NEAR(written().volume, 0.4, 1e-9);
}

TEST_F(PreparationCommands, AnOpenScanInsideOutIsNamedAndTurnedAround) {
  TriangleSoup soup = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.75; });
  for (Triangle& t : soup.triangles) std::swap(t[1], t[2]);
  write("head.ply", soup);
  EXPECT_THAT(info("head.ply").out, HasSubstr("1 open body looks inward"));
  EXPECT_THAT(fill("head.ply").out, HasSubstr("fill --turn-around turns all faces"));
  const Outcome run = fill("head.ply", "--turn-around --report " + path("report.json"));
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.out, Not(HasSubstr("looks inward")));
  EXPECT_TRUE(written().printable());
  EXPECT_GT(written().volume, 3.5);
  std::ifstream report(work / "report.json");
  EXPECT_EQ(json::parse(report)["prepared"]["sides_turned"], soup.triangles.size());
}

TEST_F(PreparationCommands, TilesThatAbutOrOverlapAreNamedInOneSentence) {
  const auto two_tiles = [&](double begin) {
    const auto height = [](double x, double y) { return 0.1 * std::sin(2 * x) * std::cos(y); };
    TriangleSoup second = make_graph([&](double x, double y) { return height(x + begin, y) + 1e-4; }, 1, 20);
    for (Vec3& p : second.points) p.x() += begin;
    write("tiles.ply", joined({make_graph(height, 1, 20), second}));
  };
  two_tiles(2);
  EXPECT_THAT(fill("tiles.ply").out,
              HasSubstr("2 outlines of sheets run beside others: tiles that abut; fill --stitch"));
  EXPECT_THAT(fill("tiles.ply", "--stitch").out, Not(HasSubstr("tiles")));
  EXPECT_EQ(open_edges_written(), 6 * 20);
  two_tiles(1.3);
  EXPECT_THAT(fill("tiles.ply").out,
              HasSubstr("2 boundaries run over another part of the surface: tiles that overlap"));
  EXPECT_THAT(info("tiles.ply").out, HasSubstr("tiles that overlap"));
}

}  // namespace
}  // namespace loopmend
