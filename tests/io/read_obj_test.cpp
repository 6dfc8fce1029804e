// SPDX-License-Identifier: GPL-3.0-or-later
// OBJ: indices of all kinds, colours, continuations, what is left out, and each way of being broken.
#include "io_test_support.h"
#include "mesh/scan_attributes.h"

namespace loopmend {
namespace {

class ReadObj : public ReadTest {};

const std::string square_vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(ReadObj, NegativeIndicesCountFromWhereTheyStand) {
  const ImportedMesh mesh = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -1 -3 -2\nf +1 2 4\n", "a.obj");
  EXPECT_EQ(mesh.soup.triangles, (Triangles{{0, 1, 2}, {3, 1, 2}, {0, 1, 3}}));
}

TEST_F(ReadObj, ANameThatEndsWithABackslashDoesNotGoOn) {
  EXPECT_EQ(read("g C:\\\n" + square_vertices + "f 1 2 3\n", "a.obj").soup.points.size(), 4U);
}

TEST_F(ReadObj, GroupsAndOtherStatementsAreSteppedOver) {
  const std::string text = "mtllib a.mtl\no thing\ng f Three v Others\ns off\nusemtl none\n" + square_vertices +
                           "vp 1 2\nf 1 2 3\nl 1 2 3\np 1\nl 3 4\n";
  const ImportedMesh mesh = read(text, "a.obj");
  EXPECT_EQ(mesh.soup.triangles.size(), 1U);
  EXPECT_EQ(mesh.report.skipped_elements, 3U);
}

TEST_F(ReadObj, ColorsOfFractionsAndOfBytes) {
  const ImportedMesh mesh = read("v 0 0 0 0 0.5 1\nv 1 0 0 1 1 1\nv 0 1 0\nv 2 2 2 nan 0 0\nf 1 2 3\n", "a.obj");
  EXPECT_EQ(mesh.soup.colors,
            (std::vector<Color>{{0, 128, 255, 255}, {255, 255, 255, 255}, {255, 255, 255, 255}, {255, 255, 255, 255}}));
  EXPECT_EQ(mesh.report.missing_colors, 2U);
  EXPECT_EQ(read("v 0 0 0 0 128 255\nv 1 0 0 1 1 1\nv 0 1 0 0 0 0\nf 1 2 3\n", "a.obj").soup.colors[0],
            (Color{0, 128, 255, 255}));
  EXPECT_TRUE(read("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n", "a.obj").soup.colors.empty());
}

TEST_F(ReadObj, RefusesBrokenVertices) {
  const std::string rest = "v 1 0 0\nv 0 1 0\nf 1 2 3\n";
  expect_refused("v 0 0\n" + rest, "a.obj", {"vertex 1", "3 coordinates", "line 1"});
  expect_refused("v 0 0 0 1 1\n" + rest, "a.obj", {"vertex 1", "line 1"});
  expect_refused("v 0 0 0 1 1 1 1 1\n" + rest, "a.obj", {"vertex 1", "line 1"});
  expect_refused("v 0 0 0abc\n" + rest, "a.obj", {"0abc", "coordinate", "line 1"});
  expect_refused("v 0 0,5 0\n" + rest, "a.obj", {"0,5", "comma", "line 1"});
  expect_refused("v 0 nan 0\n" + rest, "a.obj", {"vertex 1", "finite", "line 1"});
  expect_refused("v 0 1e400 0\n" + rest, "a.obj", {"vertex 1", "finite", "line 1"});
}

TEST_F(ReadObj, RefusesBrokenFaces) {
  for (const char* bad : {"x3", "3x", "3/x", "3//x", "3/1/1/1", "3.0", "/3", "1e0"}) {
    expect_refused(square_vertices + "f 1 2 " + bad + "\n", "a.obj", {bad, "vertex index", "line 5"});
  }
  expect_refused(square_vertices + "f 1 2\nf\n", "a.obj", {"points but no faces"});
  expect_refused(square_vertices + "f 1 2 3\nf 1 2 0\n", "a.obj", {"face 2", "vertex 0", "counts from 1", "line 6"});
  expect_refused(square_vertices + "f 1 2 3\nf 1 2 5\nf 1 2 9\n", "a.obj",
                 {"face 3", "vertex 9", "there are 4", "line 7"});
  expect_refused(square_vertices + "f 1 2 -5\n", "a.obj", {"face 1", "vertex -5", "line 5"});
  expect_refused(square_vertices + "f 1 2 99999999999\n", "a.obj", {"face 1", "vertex 99999999999", "line 5"});
  expect_refused(square_vertices + "f 1 2 99999999999999999999\n", "a.obj", {"vertex index", "line 5"});
}

TEST_F(ReadObj, RefusesUnknownStatementsAndMissingFaces) {
  // A damaged "v" must not be stepped over: all later indices would silently mean other vertices.
  expect_refused("v 0 0 0\nw 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\n", "a.obj", {"\"w\"", "statement", "line 2"});
  expect_refused(square_vertices + "ff 1 2 3\n", "a.obj", {"\"ff\""});
  expect_refused(square_vertices, "a.obj", {"points but no faces", "4 points"});
  expect_refused("# nothing\n", "a.obj", {"no points and no faces"});
}

TEST_F(ReadObj, LongRunsAreTheSameByBlocksAndLineByLine) {
  constexpr int count = 30000;
  const auto strip = [](const std::string& after_each_vertex, const std::string& after_each_face) {
    std::string text = "# a strip\no first\n";
    for (int v = 0; v < count + 2; ++v)
      text += "v " + std::to_string(v / 4) + "." + std::to_string(25 * (v % 4) + 100).substr(1) + " " +
              std::to_string(v % 2) + " -1e-3" + after_each_vertex;
    for (int f = 1; f <= count; ++f) {
      if (f == count / 2) text += "o second\n";
      text += "f " + std::to_string(f) + " " + std::to_string(f + 1) + " " + std::to_string(f + 2) + after_each_face;
    }
    return text + "f 1 2 -1\nf 1 2 3 4\n";
  };
  const ImportedMesh by_blocks = read(strip("\n", " \r\n"), "a.obj"),
                     by_lines = read(strip(" # x\n", " # x\n"), "b.obj");
  ASSERT_EQ(by_lines.soup.triangles.size(), count + 3U);
  EXPECT_EQ(by_lines.soup.triangles[count - 1], (Triangle{count - 1, count, count + 1}));
  EXPECT_EQ(by_blocks.soup.points, by_lines.soup.points);
  EXPECT_EQ(by_blocks.soup.triangles, by_lines.soup.triangles);
  ASSERT_EQ(by_blocks.soup.attributes->names.size(), 1U);
  EXPECT_EQ(by_blocks.soup.attributes->names[0].of_face, by_lines.soup.attributes->names[0].of_face);
  std::string wrong = strip("\n", "\n");
  wrong.replace(wrong.find("f 20000 "), 8, "f 2000x ");
  expect_refused(wrong, "a.obj", {"2000x", "line 50005"});
}

}  // namespace
}  // namespace loopmend
