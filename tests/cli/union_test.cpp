// SPDX-License-Identifier: GPL-3.0-or-later
// fill --union: closed bodies that overlap become one.
#include "cli/run_program.h"

#include "core/single_precision.h"
#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "mesh/scan_attributes.h"
#include "repair/watertight.h"
#include "samples/analytic_surfaces.h"
#include "support/sharp_surfaces.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace loopmend {
namespace {

using test::loopmend_program;
using test::Outcome;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using json = nlohmann::json;

class UnionCommand : public test::ProgramTest {
 protected:
  Outcome fill(const std::string& in, const std::string& out, const std::string& options = "") {
    std::filesystem::remove(work / out);
    return loopmend_program("fill " + path(in) + "-o " + path(out) + "--report " + path("r.json") + options);
  }
  json united() { return json::parse(test::text_of(work / "r.json"))["prepared"]["repaired"]["union"]; }
  Watertightness written(const std::string& name) { return watertightness(read_mesh(work / name).soup); }

  static TriangleSoup ball(const Vec3& center) {
    TriangleSoup soup = make_icosphere(3);
    for (Vec3& p : soup.points) p += center;
    return soup;
  }

  void write(const std::string& name, const TriangleSoup& soup) { write_mesh(work / name, soup); }
};

TEST_F(UnionCommand, TheCheckIsOfWhatIsWritten) {
  TriangleSoup first = test::make_cube(9), second = test::make_cube(7);
  for (Vec3& p : first.points) p.x() *= 2;
  for (Vec3& p : second.points) p.x() = 1 + 2 * p.x();
  TriangleSoup bodies = joined({first, second});
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.7, 0.3, -0.5, 0.4).normalized();
  for (Vec3& p : bodies.points) p = 1000 * (turn * p);
  round_to_floats(bodies.points);
  write("a.stl", bodies);
  const Outcome run = fill("a.stl", "out.stl", "--union --check");
  EXPECT_EQ(united()["made"], 1);
  const Watertightness surface = written("out.stl");
  EXPECT_GT(surface.intersections, 0U);  // slivers of the common planes, rounded
  EXPECT_THAT(run.out, HasSubstr("Ready to print: no"));
}

TEST_F(UnionCommand, OverlappingBodiesAreNamedAndUnited) {
  write("a.ply", joined({ball({0, 0, 0}), ball({1, 0.1, 0.2})}));
  const Outcome cut = fill("a.ply", "out.ply", "--cut-intersections");
  EXPECT_EQ(cut.code, 0);
  EXPECT_EQ(written("out.ply").open_edges, 0U);
  EXPECT_THAT(cut.out,
              HasSubstr("2 bodies overlap others and stay whole: --union makes one of those that are closed."));
  for (const char* options : {"--union --check", "--union --cut-intersections --check"}) {
    const Outcome run = fill("a.ply", "out.ply", options);
    EXPECT_EQ(run.code, 0) << run.out << run.err;
    EXPECT_THAT(run.out, AllOf(HasSubstr("2 bodies united into 1 ("), HasSubstr("Ready to print: yes"),
                               Not(HasSubstr("--union makes"))));
    EXPECT_EQ(united()["bodies"], 2);
    EXPECT_EQ(united()["made"], 1);
    // Two balls but for a lens.
    const double distance = Vec3(1, 0.1, 0.2).norm(), height = 1 - distance / 2;
    EXPECT_NEAR(written("out.ply").volume, 8 * M_PI / 3 - 2 * M_PI * height * height * (3 - height) / 3, 0.1);
  }
  // A second run changes nothing.
  EXPECT_EQ(fill("out.ply", "again.ply", "--union").code, 0);
  EXPECT_EQ(united()["bodies"], 0);
  EXPECT_EQ(test::text_of(work / "again.ply"), test::text_of(work / "out.ply"));
  // By itself --auto does not do it.
  EXPECT_EQ(fill("a.ply", "out.ply", "--auto").code, 0);
  EXPECT_EQ(read_mesh(work / "out.ply").soup.triangles.size(), 2 * make_icosphere(3).triangles.size());
}

/// Of two bodies that overlap one has a small hole: neither is cut.
TEST_F(UnionCommand, ASmallHoleMakesNoneOpen) {
  const TriangleSoup open = cut(ball({1.2, 0, 0}), [](const Vec3& p) { return p.x() > 2.17; });
  write("a.ply", joined({ball({0, 0, 0}), open}));
  const Outcome filled = fill("a.ply", "filled.ply", "--cut-intersections");
  EXPECT_EQ(filled.code, 0) << filled.out;
  EXPECT_THAT(filled.out, HasSubstr("2 bodies overlap others and stay whole"));
  EXPECT_EQ(written("filled.ply").open_edges, 0U);
  const Outcome run = fill("filled.ply", "out.ply", "--union");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_TRUE(written("out.ply").printable());
}

/// What the messages propose works.
TEST_F(UnionCommand, OpenPiecesAreLeftAndUnitedOnceTheyAreFilled) {
  const TriangleSoup open = cut(ball({1.2, 0, 0}), [](const Vec3& p) { return p.x() > 2; });
  write("a.ply", joined({ball({0, 0, 0}), open}));
  const Outcome left = fill("a.ply", "filled.ply", "--union");
  EXPECT_EQ(left.code, 1);
  EXPECT_THAT(left.out, HasSubstr("1 open piece of surface crosses others, holds a body or lies in one"));
  EXPECT_THAT(left.out, HasSubstr("fill their holes, then use --union on what was written"));
  EXPECT_EQ(united()["open_pieces"], 1);
  EXPECT_GT(written("filled.ply").intersections, 0U);
  const Outcome run = fill("filled.ply", "out.ply", "--union");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_TRUE(written("out.ply").printable());
}

TEST_F(UnionCommand, BodiesThatCrossThemselvesAreLeftAndUnitedOnceTheyAreCut) {
  TriangleSoup spiked = ball({0, 0, 0});
  const auto top = std::max_element(spiked.points.begin(), spiked.points.end(),
                                    [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  *top = {0.02, 0.03, -1.3};
  write("a.ply", joined({spiked, ball({1.5, 0, 0})}));
  const Outcome left = fill("a.ply", "out.ply", "--union");
  EXPECT_EQ(left.code, 1);
  EXPECT_THAT(left.out, HasSubstr("1 closed body crosses itself, and crosses others, holds one or lies in one"));
  EXPECT_EQ(united()["crossing_bodies"], 1);
  EXPECT_EQ(fill("a.ply", "cut.ply", "--cut-intersections").code, 0);
  EXPECT_EQ(fill("cut.ply", "out.ply", "--union").code, 0);
  EXPECT_TRUE(written("out.ply").printable());
}

/// Two boxes of quads, each of its own material, with texture coordinates that are the place: so they are in all parts.
TEST_F(UnionCommand, PartsKeepMaterialAndTexture) {
  std::ofstream obj(work / "a.obj");
  int first = 1;
  for (const auto& [low, high, material] : {std::tuple(0.0, 1.0, "stone"), std::tuple(0.5, 1.5, "wood")}) {
    for (int k = 0; k < 8; ++k)
      obj << "v " << (k & 1 ? high : low) << ' ' << (k & 2 ? high : low) << ' ' << (k & 4 ? high : low) << '\n';
    for (int k = 0; k < 8; ++k)
      obj << "vt " << (k & 1 ? high : low) + 2 * (k & 4 ? high : low) << ' ' << (k & 2 ? high : low) << '\n';
    obj << "usemtl " << material << '\n';
    for (const auto& q : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
                          std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
      obj << 'f';
      for (int k : q) obj << ' ' << first + k << '/' << first + k;
      obj << '\n';
    }
    first += 8;
  }
  obj.close();
  const Outcome run = fill("a.obj", "out.obj", "--union");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  const TriangleSoup soup = read_mesh(work / "out.obj").soup;
  EXPECT_NEAR(watertightness(soup).volume, 2 - 0.125, 1e-12);
  const ScanAttributes& scan = *soup.attributes;
  ASSERT_EQ(scan.texture.dimension, 2);
  ASSERT_EQ(scan.names.size(), 1U);
  std::size_t faces = 0;
  for (std::size_t f = 0; f < scan.names[0].of_face.size(); ++f) {
    for (std::size_t c = scan.first_corner(f); c < scan.corner_end(f); ++c) {
      const Vec3& p = soup.points[scan.corners[c]];
      ASSERT_GE(scan.texture.at[c], 0);
      const double* uv = &scan.texture.values[2 * static_cast<std::size_t>(scan.texture.at[c])];
      EXPECT_NEAR(uv[0], p.x() + 2 * p.z(), 1e-12);
      EXPECT_NEAR(uv[1], p.y(), 1e-12);
      const bool is_stone = scan.names[0].names[scan.names[0].of_face[f]] == "stone";
      EXPECT_TRUE(is_stone ? p.maxCoeff() <= 1 : p.minCoeff() >= 0.5) << p.transpose();
      ++faces;
    }
  }
  EXPECT_GT(faces, 60U);
  // Quads that stay whole are still quads: three of each box.
  const std::string text = test::text_of(work / "out.obj");
  std::istringstream lines(text);
  int quads = 0;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("f ")) quads += std::count(line.begin(), line.end(), ' ') == 4;
  EXPECT_EQ(quads, 6);
}

}  // namespace
}  // namespace loopmend
