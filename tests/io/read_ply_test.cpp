// SPDX-License-Identifier: GPL-3.0-or-later
// PLY: text and both binaries, all number types, colours, and each way of being broken.
#include "io/write_mesh.h"
#include "io_test_support.h"
#include "mesh/scan_attributes.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

namespace loopmend {
namespace {

class ReadPly : public ReadTest {};

std::string header(const std::string& format, const std::string& vertex_properties, int vertices = 3, int faces = 1) {
  return "ply\nformat " + format + " 1.0\ncomment test\nelement vertex " + std::to_string(vertices) + "\n" +
         vertex_properties + "element face " + std::to_string(faces) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string three_points = "0 0 0\n1 0 0\n0 1 0\n";

template <class T>
std::string bytes_of(T value, bool big_endian = false) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

std::string binary_body(bool big_endian) {
  std::string body;
  for (const float x : {0.1F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) body += bytes_of(x, big_endian);
  body += '\3';
  for (const std::int32_t v : {0, 1, 2}) body += bytes_of(v, big_endian);
  return body;
}

TEST_F(ReadPly, TextCoordinatesAreTheNearestDoubles) {
  const ImportedMesh mesh = read(header("ascii", "property double x\nproperty double y\nproperty double z\n") +
                                     "0.1 -1e-5 +2\n1 0 0\n0 1 0\n3 0 1 2\n",
                                 "a.ply");
  EXPECT_EQ(mesh.soup.points[0], Vec3(0.1, -1e-5, 2.0));
  EXPECT_EQ(mesh.soup.triangles, (Triangles{{0, 1, 2}}));
  EXPECT_EQ(mesh.report.format, "PLY");
}

TEST_F(ReadPly, BinaryFloatsAreWidenedInBothByteOrders) {
  for (const bool big : {false, true}) {
    const std::string format = big ? "binary_big_endian" : "binary_little_endian";
    const ImportedMesh mesh = read(header(format, xyz) + binary_body(big), "a.ply");
    EXPECT_EQ(mesh.soup.points[0][0], static_cast<double>(0.1F));
    EXPECT_EQ(mesh.soup.triangles, (Triangles{{0, 1, 2}}));
  }
}

TEST_F(ReadPly, UnreferencedVerticesAreKeptInOrder) {
  const ImportedMesh mesh = read(header("ascii", xyz, 5) + "9 9 9\n0 0 0\n1 0 0\n8 8 8\n0 1 0\n3 1 2 4\n", "a.ply");
  EXPECT_EQ(mesh.soup.points.size(), 5U);
  EXPECT_EQ(mesh.soup.points[3], Vec3(8, 8, 8));
  EXPECT_EQ(mesh.report.unreferenced_vertices, 2U);
}

TEST_F(ReadPly, LineEndsBlankLinesAndWrappedRowsDoNotMatter) {
  std::string text = header("ascii", xyz) + "0 0 0\n\n1\n0 0\n0 1 0 \n3 0\n1 2";
  EXPECT_EQ(read(text, "a.ply").soup.points[1], Vec3(1, 0, 0));
  for (const std::string& line_end : {std::string("\r\n"), std::string("\r")}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? line_end : std::string(1, c);
    EXPECT_EQ(read(other, "a.ply").soup.triangles.size(), 1U);
  }
}

TEST_F(ReadPly, BinaryBodyMayBeginWithALineEndByte) {
  std::string body = binary_body(false);
  body[0] = '\n';
  for (const std::string& line_end : {std::string("\n"), std::string("\r\n"), std::string("\r")}) {
    std::string head;
    for (const char c : header("binary_little_endian", xyz)) head += c == '\n' ? line_end : std::string(1, c);
    EXPECT_EQ(read(head + body, "a.ply").soup.points[1], Vec3(1, 0, 0));
  }
}

TEST_F(ReadPly, ColorsOfBytesFloatsAndShorts) {
  const std::string bytes = xyz + "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  EXPECT_EQ(read(header("ascii", bytes) + "0 0 0 1 2 3\n1 0 0 4 5 6\n0 1 0 7 8 255\n3 0 1 2\n", "a.ply").soup.colors,
            (std::vector<Color>{{1, 2, 3, 255}, {4, 5, 6, 255}, {7, 8, 255, 255}}));
  const std::string floats =
      xyz + "property float red\nproperty float green\nproperty float blue\nproperty float alpha\n";
  const ImportedMesh mesh =
      read(header("ascii", floats) + "0 0 0 0 0.5 1 0\n1 0 0 nan 0 0 1\n0 1 0 9 -9 0 1\n3 0 1 2\n", "a.ply");
  EXPECT_EQ(mesh.soup.colors, (std::vector<Color>{{0, 128, 255, 0}, {255, 255, 255, 255}, {255, 0, 0, 255}}));
  EXPECT_EQ(mesh.report.missing_colors, 1U);
  const std::string shorts = xyz + "property ushort red\nproperty ushort green\nproperty ushort blue\n";
  EXPECT_EQ(
      read(header("ascii", shorts) + "0 0 0 65535 0 257\n1 0 0 0 0 0\n0 1 0 0 0 0\n3 0 1 2\n", "a.ply").soup.colors[0],
      (Color{255, 0, 1, 255}));
}

TEST_F(ReadPly, OtherElementsAndPropertiesMayStandAnywhere) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement camera 1\nproperty list int float view\nelement face 1\nproperty float quality\n"
      "property list uchar uint vertex_index\nproperty list uchar float uv\nelement vertex 3\nproperty double z\n"
      "property double y\nproperty double x\nproperty list uchar int more\nelement edge 2\nproperty int vertex1\n"
      "property int vertex2\nend_header\n2 0.5 0.5\n0.25 3 0 1 2 2 0.5 0.5\n3 2 1 0\n6 5 4 1 9\n9 8 1 2 9 9\n0 1\n1 "
      "2\n";
  const ImportedMesh mesh = read(text, "a.ply");
  EXPECT_EQ(mesh.soup.points, (Points{{1, 2, 3}, {4, 5, 6}, {1, 8, 9}}));
  EXPECT_EQ(mesh.soup.attributes->elements.size(), 2U);
}

TEST_F(ReadPly, TrianglesKeepTheOrderOfTheirPolygons) {
  const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  const ImportedMesh mesh = read(header("ascii", xyz, 4, 3) + square + "3 0 1 2\n4 0 1 2 3\n3 0 2 3\n", "a.ply");
  EXPECT_EQ(mesh.soup.triangles, (Triangles{{0, 1, 2}, {0, 1, 2}, {0, 2, 3}, {0, 2, 3}}));
  EXPECT_EQ(mesh.report.faces, 3U);
  EXPECT_EQ(mesh.report.triangles, 4U);
  EXPECT_EQ(mesh.report.polygons_triangulated, 1U);
  EXPECT_EQ(mesh.report.duplicate_faces, 2U);
}

TEST_F(ReadPly, ReportCountsDegenerateAndCoincident) {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n-0 0 0\n2 0 0\n";
  const ImportedMesh mesh = read(header("ascii", xyz, 5, 3) + points + "3 0 1 2\n3 0 1 4\n3 1 1 2\n", "a.ply");
  EXPECT_EQ(mesh.report.degenerate_faces, 2U);
  EXPECT_EQ(mesh.report.coincident_vertices, 1U);
  EXPECT_EQ(mesh.report.unreferenced_vertices, 1U);
  EXPECT_EQ(mesh.report.vertices_welded, 0U);
}

TEST_F(ReadPly, PropertiesStayWithTheirFaces) {
  std::string head = header("ascii", xyz, 3, 2);
  head.insert(head.find("end_header"), "property float quality\n");
  const ImportedMesh mesh = read(head + three_points + "2 0 1 0.5\n3 0 1 2 0.25\n", "a.ply");
  ASSERT_EQ(mesh.soup.attributes->faces.size(), 1U);
  ASSERT_EQ(mesh.soup.attributes->faces[0].rows(), 1U);
  EXPECT_EQ(mesh.soup.attributes->faces[0].value(0), 0.25);
}

TEST_F(ReadPly, RefusesBrokenHeaders) {
  const std::string good = header("ascii", xyz) + three_points + "3 0 1 2\n";
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  ASSERT_EQ(read(good, "a.ply").soup.triangles.size(), 1U);
  expect_refused(with("ascii", "asci"), "a.ply", {"format", "asci", "line 2"});
  expect_refused(with("1.0", "2.0"), "a.ply", {"version", "2.0", "line 2"});
  expect_refused(with("float x", "flaot x"), "a.ply", {"type", "flaot", "line 5"});
  expect_refused(with("float x", "float"), "a.ply", {"name", "line 5"});
  expect_refused(with("property float x", "proprety float x"), "a.ply", {"proprety", "line 5"});
  expect_refused(with("property float x", "property float y"), "a.ply", {"second property", "line 6"});
  expect_refused(with("float z", "float w"), "a.ply", {"x, y and z"});
  expect_refused(with("vertex 3", "vertex -3"), "a.ply", {"-3", "count", "line 4"});
  expect_refused(with("vertex 3", "vertex"), "a.ply", {"count", "missing", "line 4"});
  expect_refused(with("element face 1", "element vertex 1"), "a.ply", {"second element", "line 8"});
  expect_refused(with("vertex_indices", "corners"), "a.ply", {"vertex_indices", "line 8"});
  expect_refused(with("uchar int vertex", "uchar float vertex"), "a.ply", {"whole numbers"});
  expect_refused(with("uchar int vertex", "float int vertex"), "a.ply", {"fraction", "line 9"});
  expect_refused(with("end_header", "endheader"), "a.ply", {"endheader", "line 10"});
  expect_refused("ply\nformat ascii 1.0\nelement vertex 3\n", "a.ply", {"end_header", "too early"});
  expect_refused(with("element face 1", std::string("element f\0\x1B 2", 13)), "a.ply", {"too early", "f?? 1 of 2"});
  expect_refused("ply\nend_header\n", "a.ply", {"format line"});
  expect_refused("plyformat ascii\n", "a.ply", {"does not begin with", "ply"});
}

TEST_F(ReadPly, RefusesCountsThatTheFileCannotHold) {
  const std::string text_file = header("ascii", xyz) + three_points + "3 0 1 2\n";
  const std::string binary_file = header("binary_little_endian", xyz) + binary_body(false);
  for (const std::string& good : {text_file, binary_file}) {
    for (const std::string count : {"4000000000", "9223372036854775807", "20"}) {
      std::string bytes = good;
      expect_refused(bytes.replace(bytes.find("vertex 3"), 8, "vertex " + count), "a.ply",
                     {"announces", count.c_str(), "line 4"});
      bytes = good;
      const char* word = good == binary_file && count == "20" ? "too early" : "announces";
      expect_refused(bytes.replace(bytes.find("face 1"), 6, "face " + count), "a.ply", {word, count.c_str()});
    }
  }
  // An element without properties takes no bytes: neither time nor memory may follow its count.
  const std::string text = "ply\nformat ascii 1.0\nelement nothing 9223372036854775807\nelement vertex 3\n" + xyz +
                           "element face 1\nproperty list uchar int vertex_indices\nend_header\n" + three_points +
                           "3 0 1 2\n";
  EXPECT_EQ(read(text, "a.ply").soup.triangles.size(), 1U);
}

TEST_F(ReadPly, RefusesListsThatTheFileCannotHold) {
  std::string head = header("binary_little_endian", xyz);
  head.replace(head.find("uchar int"), 9, "uint int");
  const std::string points = binary_body(false).substr(0, 36);
  expect_refused(head + points + bytes_of<std::uint32_t>(0xFFFFFFFFU) + "abcdefgh", "a.ply", {"4294967295", "byte"});
  expect_refused(header("ascii", xyz) + three_points + "2000000000 0 1 2\n", "a.ply", {"2000000000", "line 14"});
  expect_refused(header("ascii", xyz) + three_points + "-3 0 1 2\n", "a.ply", {"-3", "line 14"});
}

TEST_F(ReadPly, RefusesBrokenRows) {
  const std::string head = header("ascii", xyz);
  expect_refused(head + "0 0 0\n1 abc 0\n0 1 0\n3 0 1 2\n", "a.ply", {"abc", "line 12"});
  expect_refused(head + "0 0 0\n1 0,5 0\n0 1 0\n3 0 1 2\n", "a.ply", {"0,5", "line 12", "comma"});
  expect_refused(head + "0 0 0\n1 0 0 7\n0 1 0\n3 0 1 2\n", "a.ply", {"more values", "\"7\"", "line 12"});
  expect_refused(head + "0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.ply", {"more values", "line 12"});
  expect_refused(head + three_points + "3 0 1.5 2\n", "a.ply", {"1.5", "whole number", "line 14"});
  expect_refused(head + three_points + "3 0 1\n", "a.ply", {"too early", "face 0 of 1"});
  expect_refused(head + three_points, "a.ply", {"too early", "face 0 of 1"});
  expect_refused(head + three_points + "3 0 1 2\n3 0 1 2\n", "a.ply", {"more data", "line 15"});
}

TEST_F(ReadPly, RefusesBadVerticesAndFaces) {
  const std::string head = header("ascii", xyz);
  for (const char* bad : {"nan", "inf", "-INF", "1e999"}) {
    expect_refused(head + "0 0 0\n0 " + bad + " 0\n0 1 0\n3 0 1 2\n", "a.ply", {"vertex 1", "finite", "line 12"});
  }
  expect_refused(head + three_points + "3 0 1 3\n", "a.ply", {"face 0", "vertex 3", "there are 3", "line 14"});
  expect_refused(head + three_points + "3 0 -1 2\n", "a.ply", {"face 0", "vertex -1", "line 14"});
  expect_refused(head + three_points + "2 0 1\n", "a.ply", {"points but no faces"});
  std::string binary = header("binary_little_endian", xyz) + binary_body(false);
  binary[binary.size() - 1] = '\x7F';
  expect_refused(binary, "a.ply", {"face 0", "vertex 2130706434", "byte"});
}

TEST_F(ReadPly, RefusesMissingFacesAndStripsOfNothing) {
  expect_refused(header("ascii", xyz, 3, 0) + three_points, "a.ply", {"points but no faces", "3 points"});
  expect_refused("ply\nformat ascii 1.0\nelement vertex 3\n" + xyz + "end_header\n" + three_points, "a.ply",
                 {"points but no faces"});
  expect_refused("ply\nformat ascii 1.0\nelement vertex 3\n" + xyz +
                     "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" + three_points +
                     "3 0 1 3\n",
                 "a.ply", {"vertex 3", "line 13"});
  expect_refused("ply\nformat ascii 1.0\nelement point 1\nproperty int x\nend_header\n1\n", "a.ply", {"\"vertex\""});
}

TEST_F(ReadPly, BinaryMayEndWithPaddingButNotWithMoreRows) {
  const std::string good = header("binary_little_endian", xyz) + binary_body(false);
  EXPECT_EQ(read(good + "\n", "a.ply").soup.triangles.size(), 1U);
  EXPECT_EQ(read(good + std::string(100, '\0'), "a.ply").soup.triangles.size(), 1U);
  expect_refused(good + binary_body(false).substr(36), "a.ply", {"13 bytes more"});
}

/// GCC 12 can leave neighbouring doubles as they are that become floats and doubles again (core/single_precision.h).
TEST_F(ReadPly, DigitsBeyondThoseOfFloatsAreSeenInEveryCoordinate) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  for (const char* first : {"0.1 0 0\n", "0 0.1 0\n", "0 0 0.1\n"}) {
    const ImportedMesh mesh = read(head + first + "1 0 0\n0 1 0\n3 0 1 2\n", "a.ply");
    EXPECT_EQ(mesh.soup.attributes->coordinates, ScalarType::float32) << first;
    EXPECT_EQ(mesh.soup.points[0].maxCoeff(), static_cast<double>(0.1F)) << first;
    const ImportedMesh all = read_mesh(folder_ / "a.ply", CoincidentVertices::keep, FloatText::all_digits);
    EXPECT_EQ(all.soup.attributes->coordinates, ScalarType::float64) << first;
    EXPECT_NEAR(largest_rounding("a.stl", all.soup, Encoding::binary), 1.4901161193847656e-09, 1e-15) << first;
  }
}

/// A strip of so many triangles, more than are read in one block.
std::string long_strip(bool binary, bool swap_last_two_lines) {
  constexpr int count = 70000;
  std::string text = header(binary ? "binary_little_endian" : "ascii", xyz, count + 2, count);
  for (int v = 0; v < count + 2; ++v) {
    const float x = static_cast<float>(v) / 16, y = static_cast<float>(v % 2);
    if (binary)
      text += bytes_of(x) + bytes_of(y) + bytes_of(0.5F);
    else
      text += std::to_string(v / 16) + "." + std::to_string(625 * (v % 16) + 10000).substr(1) + " " +
              std::to_string(v % 2) + (swap_last_two_lines && v == count ? "\n0.5\n" : " 0.5\n");
  }
  for (int f = 0; f < count; ++f) {
    if (binary)
      text += '\3' + bytes_of(f) + bytes_of(f + 1) + bytes_of(f + 2);
    else
      text += "3 " + std::to_string(f) + " " + std::to_string(f + 1) + " " + std::to_string(f + 2) + "\n";
  }
  return text;
}

TEST_F(ReadPly, LongBodiesAreTheSameByBlocksAndRowByRow) {
  const ImportedMesh by_blocks = read(long_strip(false, false), "a.ply"),
                     by_rows = read(long_strip(false, true), "b.ply"), binary = read(long_strip(true, false), "c.ply");
  ASSERT_EQ(binary.soup.triangles.size(), 70000U);
  EXPECT_EQ(binary.soup.triangles[69999], (Triangle{69999, 70000, 70001}));
  EXPECT_EQ(binary.soup.points[70001], Vec3(70001.0 / 16, 1, 0.5));
  for (const ImportedMesh* mesh : {&by_blocks, &by_rows}) {
    EXPECT_EQ(mesh->soup.points, binary.soup.points);
    EXPECT_EQ(mesh->soup.triangles, binary.soup.triangles);
    EXPECT_EQ(mesh->soup.attributes->coordinates, ScalarType::float32);
  }
}

TEST_F(ReadPly, FaultsInLongBodiesAreToldWithTheirPlace) {
  const std::string text = long_strip(false, false), binary = long_strip(true, false);
  std::string wrong = text;
  wrong.replace(wrong.rfind("70001"), 5, "70002");
  expect_refused(wrong, "a.ply", {"70002", "line 140012"});
  wrong = text;
  wrong.replace(wrong.rfind(" 0.5"), 4, " 0,5");
  expect_refused(wrong, "a.ply", {"0,5", "line 70012"});
  wrong = binary;
  wrong[wrong.size() - 13] = 4;
  expect_refused(wrong, "a.ply", {"ends too early", "byte 1750202"});
  wrong = binary;
  wrong.replace(wrong.size() - 4, 4, bytes_of(70002));
  expect_refused(wrong, "a.ply", {"70002", "face 69999"});
  wrong = binary;
  const std::size_t body = wrong.find("end_header\n") + 11;
  wrong.replace(body + 12 * 65536, 4, bytes_of(std::numeric_limits<float>::quiet_NaN()));
  expect_refused(wrong, "a.ply", {"vertex 65536"});
}

}  // namespace
}  // namespace loopmend
