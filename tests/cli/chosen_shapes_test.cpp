// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes that a person asks for: a flat patch for one loop or all, a base below an outline.
#include "cli/run_program.h"

#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "mesh/boundary_loops.h"
#include "repair/watertight.h"
#include "samples/analytic_surfaces.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace loopmend {
namespace {

using test::Outcome;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using json = nlohmann::json;

class ChosenShapes : public test::ProgramTest {
 protected:
  Outcome fill(const std::string& name, const std::string& options) {
    return test::loopmend_program("fill " + path(name) + "-o " + path("out.ply") + options);
  }
  void write(const std::string& name, const TriangleSoup& soup) { write_mesh(work / name, soup, Encoding::ascii); }
};

TEST_F(ChosenShapes, ALoopTakesAShapeOfItsOwn) {
  write("a.ply", cut(make_icosphere(4), [](const Vec3& p) { return std::abs(p.z()) > 0.8; }));
  const auto heights = [&](const std::string& loops) {
    EXPECT_EQ(fill("a.ply", "--loops " + loops).code, 0) << loops;
    const TriangleSoup soup = read_mesh(work / "out.ply").soup;
    double low = 0, high = 0;
    for (const Vec3& p : soup.points) low = std::min(low, p.z()), high = std::max(high, p.z());
    return std::pair(low, high);
  };
  const auto [low, high] = heights("1:flat,2:smooth");
  const bool first_is_low = low > -0.85;
  EXPECT_NEAR(first_is_low ? high : -low, 1, 0.01);
  EXPECT_LT(first_is_low ? -low : high, 0.85);
  const auto [low_of_both, high_of_both] = heights("1:flat,2:flat");
  EXPECT_LT(std::max(-low_of_both, high_of_both), 0.85);
  const auto [plain_low, plain_high] = heights("1,2");
  EXPECT_NEAR(std::min(-plain_low, plain_high), 1, 0.01);
  for (const char* wrong : {"1:round", "1:", "flat", "1:flat:2"}) {
    const Outcome run = fill("a.ply", std::string("--loops ") + wrong);
    EXPECT_EQ(run.code, 2) << wrong;
  }
  EXPECT_THAT(fill("a.ply", "--loops 1:flat --flow wf").err, HasSubstr("only with --flow mmcvf"));
}

TEST_F(ChosenShapes, AllHolesAreClosedFlat) {
  write("ball.ply", cut(make_icosphere(4), [](const Vec3& p) { return std::abs(p.z()) > 0.8; }));
  EXPECT_EQ(fill("ball.ply", "--loops all:flat").code, 0);
  double highest = 0;
  for (const Vec3& p : read_mesh(work / "out.ply").soup.points) highest = std::max(highest, std::abs(p.z()));
  EXPECT_LT(highest, 0.82);
  EXPECT_EQ(fill("ball.ply", "--loops all:round").code, 2);
}

TEST_F(ChosenShapes, ABaseIsBuiltUnderTheLargestLoop) {
  write("a.ply", trim_boundaries(cut(make_icosphere(4), [](const Vec3& p) { return p.z() < 0.3 || p.z() > 0.95; })));
  const Outcome run = fill("a.ply", "--base 0.5 --check --report " + path("r.json"));
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("A base closes loop 1"), HasSubstr("1 filled, 0 failed"),
                             HasSubstr("Ready to print: yes")));
  EXPECT_EQ(json::parse(test::text_of(work / "r.json"))["prepared"]["base_loop"], 1);
  EXPECT_EQ(fill("a.ply", "--base 1:0.5").code, 0);
  EXPECT_EQ(watertightness(read_mesh(work / "out.ply").soup).open_edges, 0U);
  EXPECT_THAT(fill("a.ply", "--base 3:0.5").err, HasSubstr("there is no loop 3"));
  for (const char* wrong : {"--base=0", "--base=-1", "--base=1:", "--base=x:1", "--base=1.5:1", "--base=nan"}) {
    const Outcome refused = fill("a.ply", wrong);
    EXPECT_EQ(refused.code, 2) << wrong;
    EXPECT_THAT(refused.err, HasSubstr("--base takes a length")) << wrong;
  }
}

/// A cap in the plane of the outline would cut the waves.
TEST_F(ChosenShapes, ABaseIsNamedWhereNoPatchOfAnOutlineIsClear) {
  write("a.ply", make_graph([](double x, double y) { return 0.1 * std::sin(9 * x) * std::cos(8 * y); }, 0.5, 24));
  const Outcome run = fill("a.ply", "--include-outer-rim");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.out, HasSubstr("--base 1:0.071 closes it below the surface"));
  EXPECT_EQ(fill("a.ply", "--base 1:0.071").code, 0);
  EXPECT_EQ(watertightness(read_mesh(work / "out.ply").soup).open_edges, 0U);
}

/// An arch of teeth as scans of jaws have it, open below and at both ends: long, and nearly plane at its outline.
TriangleSoup jaw() {
  constexpr int along = 60, across = 12;
  TriangleSoup soup;
  for (int k = 0; k < along; ++k)
    for (int i = 0; i < across; ++i) {
      const double angle = -3 + 6.0 * k / (along - 1), side = -1 + 2.0 * i / (across - 1), radius = 3 + 0.7 * side;
      soup.points.emplace_back(radius * std::cos(angle), 1.3 * radius * std::sin(angle), 0.9 * (1 - std::pow(side, 4)));
    }
  for (int k = 0; k + 1 < along; ++k)
    for (int i = 0; i + 1 < across; ++i) {
      const int a = k * across + i, b = a + across;
      soup.triangles.push_back({a, a + 1, b + 1});
      soup.triangles.push_back({a, b + 1, b});
    }
  for (Triangle& t : soup.triangles) std::swap(t[1], t[2]);
  return soup;
}

TEST_F(ChosenShapes, ADomeBelowAJawIsToLookAtAndFlatIsNamed) {
  write("a.ply", jaw());
  const Outcome run = fill("a.ply", "--include-outer-rim");
  EXPECT_THAT(run.out, HasSubstr("diameters high over a flat loop"));
  EXPECT_THAT(run.out, HasSubstr("--loops 1:flat closes it flat"));
  const Outcome flat = fill("a.ply", "--loops 1:flat");
  EXPECT_EQ(flat.code, 0) << flat.out;
  EXPECT_THAT(flat.out, Not(HasSubstr("over a flat loop")));
}

}  // namespace
}  // namespace loopmend
