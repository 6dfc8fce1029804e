// SPDX-License-Identifier: GPL-3.0-or-later
// Files as people bring them: what is joined, turned and named before any hole is filled.
#include "cli/run_program.h"

#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "mesh/boundary_loops.h"
#include "mesh/scan_attributes.h"
#include "mesh/watertight.h"
#include "samples/analytic_surfaces.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
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
      for (int v : t) height += soup.points[static_cast<std::size_t>(v)].z();
      for (int& v : t) {
        if (height < 0 || std::abs(soup.points[static_cast<std::size_t>(v)].z()) > 1e-9) continue;
        const auto [at, is_new] = twin.emplace(v, static_cast<int>(soup.points.size()));
        if (is_new) soup.points.push_back(soup.points[static_cast<std::size_t>(v)] + Vec3(0, 0, gap));
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
        labelled += of >= 0 && names.names[static_cast<std::size_t>(of)] == "loopmend_patch";
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
  const Vec3 middle = (soup.points[static_cast<std::size_t>(a)] + soup.points[static_cast<std::size_t>(b)]) / 2;
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
              HasSubstr("Only PLY has room"));
}

}  // namespace
}  // namespace loopmend
