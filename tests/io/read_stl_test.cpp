// SPDX-License-Identifier: GPL-3.0-or-later
// STL: text and binary, welding of corners, and each way of being broken.
#include "io_test_support.h"

#include <cstdint>
#include <limits>

namespace loopmend {
namespace {

class ReadStl : public ReadTest {};

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return "facet normal 0 0 1\n outer loop\n  vertex " + a + "\n  vertex " + b + "\n  vertex " + c +
         "\n endloop\nendfacet\n";
}

std::string two_facets() { return facet("0 0 0", "1 0 0", "0 1 0") + facet("1 0 0", "1 1 0", "-0 1 0"); }

std::string binary_stl(const std::vector<float>& coordinates, const std::string& title = "binary") {
  std::string bytes = title;
  bytes.resize(80, ' ');
  const auto count = static_cast<std::uint32_t>(coordinates.size() / 9);
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  for (std::size_t f = 0; f < count; ++f) {
    bytes.append(12, '\0');
    bytes.append(reinterpret_cast<const char*>(&coordinates[9 * f]), 36);
    bytes.append(2, '\0');
  }
  return bytes;
}

const std::vector<float> two_triangles = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, -0.F, 1, 0};

TEST_F(ReadStl, TextCornersAreWeldedInOrderOfFirstOccurrence) {
  const ImportedMesh mesh = read("solid name\n" + two_facets() + "endsolid name\n", "a.stl");
  EXPECT_EQ(mesh.soup.points, (Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(mesh.soup.triangles, (Triangles{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_EQ(mesh.report.vertices_welded, 2U);
  EXPECT_EQ(mesh.report.coincident_vertices, 0U);
  EXPECT_EQ(mesh.report.format, "STL");
}

TEST_F(ReadStl, BinaryReadsTheSame) {
  // A title that begins like the text format does not mislead.
  for (const char* title :
       {"binary", "solid but binary", "solid\nfacet", "ply\n", "OFF", "version https://git-lfs.github.com/"}) {
    const ImportedMesh mesh = read(binary_stl(two_triangles, title), "a.stl");
    EXPECT_EQ(mesh.soup.points.size(), 4U);
    EXPECT_EQ(mesh.soup.triangles, (Triangles{{0, 1, 2}, {1, 3, 2}}));
  }
}

TEST_F(ReadStl, TextIsFreeOfFormAndOfCase) {
  const std::string text =
      "SOLID\nFACET\nOUTER LOOP\nVERTEX 0 0 0\nVertex 1 0 0\nvertex 0 1 0\nENDLOOP\nENDFACET\nENDSOLID\n"
      "solid two\nfacet normal nan nan nan outer loop vertex 5 0 0 vertex 6 0 0 vertex 5 1 0 endloop "
      "endfacet\nendsolid";
  EXPECT_EQ(read(text, "a.stl").soup.triangles.size(), 2U);
}

TEST_F(ReadStl, TextCoordinatesAreTheNearestDoubles) {
  EXPECT_EQ(read("solid\n" + facet("0.1 0 0", "1 0 0", "0 1e-17 0") + "endsolid", "a.stl").soup.points[0][0], 0.1);
}

TEST_F(ReadStl, RefusesBrokenText) {
  const std::string good = "solid\n" + two_facets() + "endsolid\n";
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  expect_refused(with("endfacet", "endfacte"), "a.stl", {"endfacte", "endfacet", "line 8"});
  expect_refused(with("  vertex 0 1 0\n", ""), "a.stl", {"endloop", "vertex", "line 6"});
  expect_refused(with(" endloop", "  vertex 4 4 4\n endloop"), "a.stl", {"vertex", "endloop", "line 7"});
  expect_refused(with("vertex 1 0 0", "vertex 1 0"), "a.stl", {"coordinate", "missing", "line 5"});
  expect_refused(with("vertex 1 0 0", "vertex 1 x 0"), "a.stl", {"\"x\"", "coordinate", "line 5"});
  expect_refused(with("vertex 1 0 0", "vertex 1 0 0 5"), "a.stl", {"\"5\"", "line 5"});
  expect_refused(with("vertex 1 0 0", "vertex 1 inf 0"), "a.stl", {"vertex 1", "finite", "line 5"});
  expect_refused(good + "junk\n", "a.stl", {"junk", "solid"});
  expect_refused(with("facet normal", "facte normal"), "a.stl", {"facte"});
  expect_refused("solid a\nendsolid a\n", "a.stl", {"no points and no faces"});
  expect_refused("hello\nthere\n", "a.stl", {"solid"});
}

TEST_F(ReadStl, RefusesBrokenBinary) {
  const std::string good = binary_stl(two_triangles);
  expect_refused(good.substr(0, good.size() - 1), "a.stl", {"announces 2", "184 bytes", "183"});
  std::string many = good;
  many[83] = '\x7F';
  expect_refused(many, "a.stl", {"announces 2130706434 triangles"});
  std::string fewer = good;
  fewer[80] = '\1';
  expect_refused(fewer, "a.stl", {"announces 1", "50 more bytes"});
  std::string many_more = binary_stl(std::vector<float>(9000, 1.F)) + "7 bytes";
  many_more.replace(80, 2, std::string("\1\0", 2));
  expect_refused(many_more, "a.stl", {"announces 1 "});
  EXPECT_EQ(read(good + "trailer", "a.stl").soup.triangles.size(), 2U);
  expect_refused(good.substr(0, 40) + std::string(1, '\0'), "a.stl", {"header", "too early"});
  std::vector<float> bad = two_triangles;
  bad[12] = std::numeric_limits<float>::quiet_NaN();
  expect_refused(binary_stl(bad), "a.stl", {"vertex 4", "finite", "byte 158"});
  expect_refused(binary_stl({}), "a.stl", {"no points and no faces"});
}

}  // namespace
}  // namespace loopmend
