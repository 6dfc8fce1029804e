// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run_program.h"

#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "mesh/boundary_loops.h"
#include "samples/analytic_surfaces.h"
#include "support/ragged_boundaries.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <set>

namespace loopmend {
namespace {

using nlohmann::json;
using test::loopmend_program;
using test::Outcome;

class BoundaryOptions : public testing::Test {
 protected:
  void SetUp() override {
    TriangleSoup sphere = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.8; });
    write_mesh(clean, sphere);
    // A triangle that stands on one edge of the boundary.
    const SurfaceModel model = make_surface_model(sphere);
    const BoundaryLoop loop = find_boundary_loops(model).front();
    const int a = model.soup_vertex[loop.vertices[0]], b = model.soup_vertex[loop.vertices[1]];
    sphere.points.push_back((0.5 * (sphere.points[a] + sphere.points[b]) + Vec3(0, 0, 0.06)).normalized());
    sphere.triangles.push_back({a, b, static_cast<int>(sphere.points.size()) - 1});
    dangling_face = static_cast<int>(sphere.triangles.size()) - 1;
    write_mesh(ragged, sphere);
  }
  json fill(const std::filesystem::path& in, const std::string& options) const {
    const Outcome run =
        loopmend_program("fill '" + in.string() + "' -o '" + out.string() + "' --quiet --report - " + options);
    EXPECT_EQ(run.code, 0) << run.err;
    return json::parse(run.out);
  }
  test::Workspace work;
  const std::filesystem::path clean = work / "clean.ply", ragged = work / "ragged.ply", out = work / "out.ply";
  int dangling_face = 0;
};

TEST_F(BoundaryOptions, ReportTellsOfTheBoundary) {
  const json boundary = fill(clean, "")["loops"][0]["neighborhood"];
  EXPECT_EQ(boundary["kind"], "smooth");
  EXPECT_NEAR(boundary["h_rms"].get<double>(), 1, 0.02);
  EXPECT_LT(boundary["noise_per_edge"].get<double>(), 1e-3);
  EXPECT_LT(boundary["h_sigma"].get<double>(), 0.05);
  EXPECT_EQ(boundary["fitted_vertices"], fill(clean, "")["loops"][0]["edges"]);
  EXPECT_TRUE(fill(clean, "--flow none")["loops"][0]["neighborhood"].is_null());
}

TEST_F(BoundaryOptions, InACleanNeighborhoodAutoAndExactGiveTheSameBits) {
  fill(clean, "--boundary auto");
  const Points automatic = read_mesh(out).soup.points;
  fill(clean, "--boundary exact");
  EXPECT_EQ(read_mesh(out).soup.points, automatic);
  EXPECT_EQ(fill(clean, "--boundary robust")["loops"][0]["steps"], 3);
}

TEST_F(BoundaryOptions, LowerContinuityLeavesWhatItDoesNotPromise) {
  const auto angle = [&](const char* word) {
    return fill(clean, std::string("--continuity ") + word)["loops"][0]["seam_after"]["g1_rms_deg"].get<double>();
  };
  EXPECT_GT(angle("position"), 10);
  EXPECT_LT(angle("tangent"), 3);
  EXPECT_LT(angle("curvature"), 0.1);
}

TEST_F(BoundaryOptions, TrimmingIsOffAndReportsFaceByFace) {
  const json left = fill(ragged, "");
  EXPECT_TRUE(left["trimmed_faces"].empty());
  ASSERT_EQ(left["bad_boundary_faces"].size(), 1U);
  EXPECT_EQ(left["bad_boundary_faces"][0]["face"], dangling_face);
  EXPECT_EQ(left["bad_boundary_faces"][0]["fault"], "dangling");
  EXPECT_EQ(left["loops"][0]["verdict"]["grade"], "good");
  EXPECT_FALSE(left.contains("suggestion"));

  const json trimmed = fill(ragged, "--trim-boundary 2");
  ASSERT_EQ(trimmed["trimmed_faces"].size(), 1U);
  EXPECT_EQ(trimmed["trimmed_faces"][0]["face"], dangling_face);
  EXPECT_TRUE(trimmed["bad_boundary_faces"].empty());
  EXPECT_FALSE(trimmed.contains("suggestion"));
  EXPECT_EQ(trimmed["exterior_unchanged"], true);
  const TriangleSoup before = read_mesh(clean).soup, after = read_mesh(out).soup;
  for (std::size_t f = 0; f < before.triangles.size(); ++f) ASSERT_EQ(after.triangles[f], before.triangles[f]);
}

TEST_F(BoundaryOptions, EveryBadFaceOfARaggedBoundaryIsReportedAndTrimmingSuggested) {
  const test::RaggedBoundary boundary = test::ragged_boundary();
  write_mesh(ragged, boundary.ragged);
  const json left = fill(ragged, "");
  EXPECT_NE(left["loops"][0]["verdict"]["grade"], "good");
  EXPECT_THAT(left["suggestion"].get<std::string>(), testing::HasSubstr("--trim-boundary"));
  const json report = fill(ragged, "--trim-boundary 3");
  std::map<int, std::pair<std::string, int>> told, expected;
  for (const json& face : report["trimmed_faces"]) told[face["face"]] = {face["fault"], face["ring"]};
  for (const BadBoundaryFace& bad : boundary.bad) expected[bad.face] = {to_string(bad.fault), bad.ring};
  EXPECT_EQ(told, expected);
  EXPECT_EQ(report["loops"][0]["verdict"]["grade"], "good");
  EXPECT_EQ(report["exterior_unchanged"], true);
}

/// A ball torn along a zigzag of edges, the sides a few percent of an edge apart and across each other.
TEST_F(BoundaryOptions, TrimmingIsNotSuggestedWhereStitchingIsTheCure) {
  TriangleSoup ball = make_icosphere(4);
  std::map<int, int> twin;
  std::set<int> below;
  const auto is_above = [&](const Triangle& t) {
    return (ball.points[t[0]] + ball.points[t[1]] + ball.points[t[2]]).dot(Vec3(0.3, 0.4, 1)) > 0.5;
  };
  for (const Triangle& t : ball.triangles)
    if (!is_above(t)) below.insert(t.begin(), t.end());
  const std::vector<char> above = [&] {
    std::vector<char> flags;
    for (const Triangle& t : ball.triangles) flags.push_back(is_above(t) ? 1 : 0);
    return flags;
  }();
  for (std::size_t f = 0; f < above.size(); ++f)
    for (int& v : ball.triangles[f]) {
      if (above[f] == 0 || !below.contains(v)) continue;
      const auto [at, is_new] = twin.emplace(v, static_cast<int>(ball.points.size()));
      if (is_new) ball.points.push_back(ball.points[v] + 0.003 * Vec3(std::sin(v), std::sin(3 * v), std::cos(5 * v)));
      v = at->second;
    }
  write_mesh(ragged, ball);
  const std::string fill = "fill '" + ragged.string() + "' -o '" + out.string() + "' --report -";
  EXPECT_THAT(loopmend_program(fill).out, testing::HasSubstr("--stitch joins them"));
  const Outcome run = loopmend_program(fill + " --loops 1,2");
  EXPECT_EQ(run.code, 1);
  const json report = json::parse(run.out.substr(run.out.find('{')));
  EXPECT_FALSE(report["bad_boundary_faces"].empty());
  EXPECT_FALSE(report.contains("suggestion"));
  EXPECT_THAT(run.out, testing::HasSubstr("--stitch"));
}

TEST_F(BoundaryOptions, ASingleVertexOffASmoothBoundaryIsToldAndNotTakenForShape) {
  TriangleSoup sphere = read_mesh(clean).soup;
  const SurfaceModel model = make_surface_model(sphere);
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  sphere.points[model.soup_vertex[loops.front().vertices[5]]] *= 1.05;
  write_mesh(ragged, sphere);
  EXPECT_THAT(fill(ragged, "")["loops"][0]["message"].get<std::string>(),
              testing::HasSubstr("one boundary vertex is an outlier"));
  EXPECT_EQ(read_mesh(out).soup.points[model.soup_vertex[loops.front().vertices[5]]],
            sphere.points[model.soup_vertex[loops.front().vertices[5]]]);
}

TEST_F(BoundaryOptions, WrongWordsAreRefused) {
  for (const char* wrong : {"--boundary rough", "--continuity g2", "--trim-boundary -1", "--trim-boundary 101"})
    EXPECT_EQ(loopmend_program("fill '" + clean.string() + "' -o '" + out.string() + "' " + wrong).code, 2) << wrong;
}

}  // namespace
}  // namespace loopmend
