// SPDX-License-Identifier: GPL-3.0-or-later
// What files hold beside the shape, what the readers leave out, and what a format has no room for.
#include "io/not_kept.h"

#include "io/write_mesh.h"
#include "io_test_support.h"

#include <cstring>

namespace loopmend {
namespace {

class NotKeptTest : public ReadTest {
 protected:
  /// What is kept beside the shape, and what is not.
  std::string found(std::string_view bytes, const std::string& name) {
    const ImportedMesh mesh = read(bytes, name);
    return to_string(carried_attributes(mesh.soup)) + " | " + to_string(mesh.report.not_kept);
  }
};

TEST_F(NotKeptTest, ObjNamesAllThatIsNeitherVertexNorFace) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
  EXPECT_EQ(found(corners + "f 1 2 3\n", "plain.obj"), " | ");
  EXPECT_EQ(
      found("mtllib a.mtl\no thing\n" + corners +
                "vt 0 0\nvt 1 0\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\ng left\nusemtl red\ns 1\nf 1/1/1 2/2/2 3/1/3\n"
                "g right\nusemtl blue\ns off\nf 2 4 3\nusemtl red\nl 1 2\nl 2 3 4\np 1\n",
            "rich.obj"),
      "texture coordinates (2), normals (3), objects (1), groups (2), materials (2), smoothing groups (1), material "
      "libraries (1) | lines (2), points (1)");
  EXPECT_EQ(found(corners + "vt 0 x\nvt 0 1\nvn 1 2 ind\nusemap a\nf 1/1/1 2/1/1 3/2/1\n", "odd.obj"),
            "texture coordinates (2), normals (1) | texture coordinates that are no numbers (1), normals that are no "
            "numbers (1), display statements (1)");
}

TEST_F(NotKeptTest, AnIntegerOfPlyIsNoTextureCoordinate) {
  EXPECT_EQ(found("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                  "property short s\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                  "0 0 0 7\n1 0 0 7\n0 1 0 7\n3 0 1 2\n",
                  "labels.ply"),
            "vertex properties \"s\" (3) | ");
}

TEST_F(NotKeptTest, PlyNamesPropertiesAndElements) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\nproperty float quality\nproperty uchar red\n"
      "property uchar green\nproperty uchar blue\nproperty float s\nproperty float t\n"
      "element face 1\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n"
      "property uchar blue\nproperty float flags\nelement edge 2\nproperty int vertex1\nproperty int "
      "vertex2\nend_header\n"
      "0 0 0 0 0 1 0.5 1 2 3 0 0\n1 0 0 0 0 1 0.5 1 2 3 0 0\n0 1 0 0 0 1 0.5 1 2 3 0 0\n3 0 1 2 9 9 9 1\n0 1\n1 2\n";
  const ImportedMesh mesh = read(text, "rich.ply");
  EXPECT_EQ(to_string(carried_attributes(mesh.soup)),
            "normals (3), vertex properties \"quality\" (3), texture coordinates (3), face colours (1), "
            "face properties \"flags\" (1), elements \"edge\" (2)");
  EXPECT_TRUE(mesh.report.not_kept.empty());
  EXPECT_EQ(mesh.report.skipped_elements, 0U);
  EXPECT_TRUE(mesh.report.has_colors);
}

TEST_F(NotKeptTest, PlyColoursWithoutBlueAreProperties) {
  const ImportedMesh mesh = read(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n",
      "red.ply");
  EXPECT_TRUE(mesh.soup.colors.empty());
  EXPECT_EQ(to_string(not_kept_by_format("a.obj", mesh.soup)), "vertex properties \"red\" (3)");
}

TEST_F(NotKeptTest, OffNamesNormalsTextureAndFaceColours) {
  EXPECT_EQ(found("STNOFF\n4 2 0\n0 0 0 0 0 1 0 0\n1 0 0 0 0 1 1 0\n0 1 0 0 0 1 0 1\n1 1 0 0 0 1 1 1\n"
                  "3 0 1 2 255 0 0\n3 1 3 2\n",
                  "rich.off"),
            "normals (4), texture coordinates (4), face colours (2) | ");
}

TEST_F(NotKeptTest, StlNamesAttributesAndSolids) {
  std::string bytes(84, ' ');
  const std::uint32_t count = 2;
  std::memcpy(&bytes[80], &count, 4);
  for (int facet = 0; facet < 2; ++facet) {
    const float values[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, static_cast<float>(1 + facet), 0};
    bytes.append(reinterpret_cast<const char*>(values), sizeof values);
    bytes.append(facet == 0 ? std::string("\0\0", 2) : std::string("\x1f\x80", 2));
  }
  EXPECT_EQ(found(bytes, "colored.stl"), "face attributes (2) | ");
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  EXPECT_EQ(found("solid a\n" + facet + "endsolid a\nsolid b\n" + facet + "endsolid b\n", "two.stl"),
            "separate solids (2) | ");
  EXPECT_EQ(found("solid a\n" + facet + "endsolid a\n", "one.stl"), " | ");
}

TEST_F(NotKeptTest, FormatsHaveRoomForDifferentThings) {
  TriangleSoup soup = colored_soup();  // the fourth of five points has no face
  soup.colors[1][3] = 100;
  const auto words = [&](const char* name) { return to_string(not_kept_by_format(name, soup)); };
  EXPECT_EQ(words("a.ply"), "");
  EXPECT_EQ(words("a.off"), "");
  EXPECT_EQ(words("a.obj"), "alpha values (1)");
  EXPECT_EQ(words("a.STL"), "vertex colours (5), vertices without faces (1)");
  EXPECT_THROW(not_kept_by_format("a.xyz", soup), WriteError);
}

TEST_F(NotKeptTest, StlRoundingIsTheLargestWayOfAVertex) {
  // 2^24 + 1 is the first whole number that a float has not; 0.1 is off by 1.5e-9.
  const TriangleSoup soup{{{0.1, 0.5, 2}, {16777217, 0, 0}}};
  EXPECT_EQ(largest_rounding("a.stl", soup, Encoding::binary), 1);
  EXPECT_EQ(largest_rounding("a.stl", soup, Encoding::binary, 1), static_cast<double>(0.1F) - 0.1);
  EXPECT_EQ(largest_rounding("a.stl", soup, Encoding::ascii), 0);
  for (const char* name : {"a.ply", "a.obj", "a.off"}) EXPECT_EQ(largest_rounding(name, soup, Encoding::binary), 0);
}

TEST_F(NotKeptTest, WeldingJoinsWhatLiesAtOnePlaceAndKeepsTheOrder) {
  write_bytes(folder_ / "split.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n1 0 0\n1 1 0\n-0.0 1 0\n3 0 1 2\n3 3 4 5\n");
  const ImportedMesh kept = read_mesh(folder_ / "split.off");
  EXPECT_EQ(kept.soup.points.size(), 6U);
  EXPECT_EQ(kept.report.coincident_vertices, 2U);
  const ImportedMesh welded = read_mesh(folder_ / "split.off", CoincidentVertices::weld);
  EXPECT_EQ(welded.soup.points, (Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(welded.soup.triangles, (Triangles{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_EQ(welded.report.vertices_welded, 2U);
  EXPECT_EQ(welded.report.coincident_vertices, 0U);
  EXPECT_EQ(welded.report.vertices, 4U);
}

}  // namespace
}  // namespace loopmend
