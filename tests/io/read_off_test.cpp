// SPDX-License-Identifier: GPL-3.0-or-later
// OFF: header variants, colours, and each way of being broken.
#include "io_test_support.h"

namespace loopmend {
namespace {

class ReadOff : public ReadTest {};

const std::string body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

TEST_F(ReadOff, FaceColorsAndCommentsAreLeftOut) {
  const std::string text = "OFF\n4 2 0\n0 0 0# a\n1 0 0\n\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 3 0.1 0.2 0.3 1 # b\n";
  const ImportedMesh mesh = read(text, "a.off");
  EXPECT_EQ(mesh.soup.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_FALSE(mesh.report.has_colors);
}

TEST_F(ReadOff, VertexColors) {
  EXPECT_EQ(read("COFF\n3 1 0\n0 0 0 255 0 10 128\n1 0 0 1 1 1 255\n0 1 0 0 0 0 255\n3 0 1 2\n", "a.off").soup.colors,
            (std::vector<Color>{{255, 0, 10, 128}, {1, 1, 1, 255}, {0, 0, 0, 255}}));
  EXPECT_EQ(read("OFF\n3 1 0\n0 0 0 1 0 0.5\n1 0 0 1 1 1\n0 1 0\n3 0 1 2\n", "a.off").soup.colors,
            (std::vector<Color>{{255, 0, 128, 255}, {255, 255, 255, 255}, {255, 255, 255, 255}}));
}

TEST_F(ReadOff, NormalsAndTextureCoordinates) {
  const std::string rows =
      "0 0 0  0 0 1  255 0 0  0.5 0.5\n1 0 0  0 0 1  0 255 0  0 0\n0 1 0  0 0 1  0 0 255  1 1\n3 0 1 2\n";
  EXPECT_EQ(read("STCNOFF\n3 1 0\n" + rows, "a.off").soup.colors[1], (Color{0, 255, 0, 255}));
}

TEST_F(ReadOff, Refuses) {
  expect_refused("OFF\n3 2 0\n" + body, "a.off", {"too early", "face 1 of 2"});
  expect_refused("OFF\n3 1 0\n" + body + "3 0 1 2\n", "a.off", {"more data", "line 7"});
  expect_refused("OFF\n353535235358 1 0\n" + body, "a.off", {"announces 353535235358 vertices", "line 2"});
  expect_refused("OFF\n3 353535235358 0\n" + body, "a.off", {"announces 353535235358 faces", "line 2"});
  expect_refused("OFF\n-3 1 0\n" + body, "a.off", {"-3", "number of vertices", "line 2"});
  expect_refused("OFF\n3 1 0 5\n" + body, "a.off", {"\"5\"", "line 2"});
  expect_refused("OFF\n3 1 0\n0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.off", {"coordinate", "missing", "line 3"});
  expect_refused("OFF\n3 1 0\n0 0 0x\n1 0 0\n0 1 0\n3 0 1 2\n", "a.off", {"0x", "line 3"});
  expect_refused("OFF\n3 1 0\n0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n", "a.off", {"vertex 0", "finite", "line 3"});
  expect_refused("OFF\n3 1 0\n0 0 0 7\n1 0 0\n0 1 0\n3 0 1 2\n", "a.off", {"vertex 0", "line 3"});
  expect_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off",
                 {"face 0", "vertex 3", "there are 3", "line 6"});
  expect_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "a.off", {"face 0", "vertex -1"});
  expect_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n", "a.off", {"points but no faces"});
  expect_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", "a.off", {"vertex index", "missing", "line 6"});
  expect_refused("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "a.off", {"points but no faces"});
  expect_refused("OFF BINARY\n3 1 0\n", "a.off", {"binary OFF"});
  expect_refused("4OFF\n3 1 0\n" + body, "a.off", {"3 coordinates"});
  expect_refused("hello\n", "a.off", {"does not begin with", "OFF"});
}

}  // namespace
}  // namespace loopmend
