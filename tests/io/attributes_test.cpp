// SPDX-License-Identifier: GPL-3.0-or-later
// What a file holds beside points and faces comes out as it went in.
#include "io/write_mesh.h"
#include "io_test_support.h"
#include "mesh/scan_attributes.h"
#include "mesh/surface_model.h"
#include "repair/repair_surface.h"

#include <sstream>

namespace loopmend {
namespace {

class AttributesTest : public ReadTest {
 protected:
  /// Reads a file and writes it again under another name.
  std::string round_trip(std::string_view bytes, const std::string& name, const std::string& out_name,
                         Encoding encoding = Encoding::ascii) {
    const ImportedMesh mesh = read(bytes, name);
    EXPECT_EQ(to_string(mesh.report.not_kept), "");
    write_mesh(folder_ / out_name, mesh.soup, encoding);
    return read_bytes(folder_ / out_name);
  }
  std::string round_trip(std::string_view bytes, const std::string& name) {
    return round_trip(bytes, name, "out_" + name);
  }
};

constexpr const char* rich_ply =
    "ply\nformat ascii 1.0\ncomment Loopmend\ncomment TextureFile  skin.png\nobj_info made by hand\n"
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\n"
    "property float nz\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty float quality\n"
    "property double exact\nproperty short label\nproperty uint id\nproperty list uchar float weights\n"
    "element face 2\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n"
    "property uchar blue\nproperty int patch\nproperty list uchar float texcoord\n"
    "element edge 2\nproperty int vertex1\nproperty int vertex2\nend_header\n"
    "0 0 0 0 0 1 1 2 3 0.1 0.1 -7 4294967295 0\n1 0 0.5 0 0 1 4 5 6 0.2 1e-300 300 1 2 0.5 0.25\n"
    "0 1 0 0 0 -1 7 8 9 nan 3 0 2 1 7\n1 1 0 0 1 0 10 11 12 -2.5 4 1 3 0\n"
    "3 0 1 2 255 0 9 -5 6 0 0 1 0 0 1\n3 1 3 2 1 2 3 77 0\n"
    "0 1\n2 3\n";

TEST_F(AttributesTest, PlyComesOutAsItWentIn) {
  EXPECT_EQ(round_trip(rich_ply, "rich.ply"), rich_ply);
  const std::string binary = round_trip(rich_ply, "rich.ply", "binary.ply", Encoding::binary);
  EXPECT_EQ(round_trip(binary, "again.ply", "again.ply", Encoding::binary), binary);
  EXPECT_EQ(round_trip(binary, "back.ply", "back.ply", Encoding::ascii), rich_ply);
}

/// Text of one triangle, with its first coordinate as it is given.
std::string text_ply(const std::string& type, const std::string& x) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty " + type + " x\nproperty " + type + " y\nproperty " + type +
         " z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" + x +
         " 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
}

TEST_F(AttributesTest, PlyHasThePrecisionThatItDeclares) {
  const auto coordinates = [&](const std::string& type, const std::string& x) {
    return read(text_ply(type, x), "a.ply").soup.attributes->coordinates;
  };
  EXPECT_EQ(coordinates("float", "0.5"), ScalarType::float32);
  EXPECT_EQ(coordinates("float", "0.1"), ScalarType::float32);
  EXPECT_EQ(coordinates("float", "0.123456789012"), ScalarType::float32);
  EXPECT_EQ(coordinates("float", "1e39"), ScalarType::float64) << "no float at all";
  EXPECT_EQ(coordinates("double", "0.5"), ScalarType::float64);
  EXPECT_EQ(coordinates("int", "5"), ScalarType::float64) << "patches have no whole coordinates";
}

TEST_F(AttributesTest, TextOfFloatsIsTheNearestFloats) {
  const ImportedMesh mesh = read(text_ply("float", "0.1"), "a.ply");
  EXPECT_EQ(mesh.soup.points[0].x(), static_cast<double>(0.1F));
  EXPECT_TRUE(mesh.report.oddities.empty()) << "0.1 is how a float is written";
  write_mesh(folder_ / "b.ply", mesh.soup);
  EXPECT_EQ(read_mesh(folder_ / "b.ply").soup.points, mesh.soup.points);
  write_mesh(folder_ / "c.ply", mesh.soup, Encoding::ascii);
  EXPECT_NE(read_bytes(folder_ / "c.ply").find("property float x"), std::string::npos);
  EXPECT_NE(read_bytes(folder_ / "c.ply").find("\n0.1 0 0\n"), std::string::npos);
}

TEST_F(AttributesTest, DigitsBeyondThoseOfFloatsAreCountedAndCanBeKept) {
  const ImportedMesh rounded = read(text_ply("float", "0.123456789012"), "a.ply");
  EXPECT_EQ(rounded.soup.points[0].x(), static_cast<double>(0.123456789012F));
  EXPECT_EQ(to_string(rounded.report.oddities),
            "vertices of more digits than the single precision that the file declares, rounded to it (--double keeps "
            "them) (1)");
  const ImportedMesh all = read_mesh(folder_ / "a.ply", CoincidentVertices::keep, FloatText::all_digits);
  EXPECT_EQ(all.soup.points[0].x(), 0.123456789012);
  EXPECT_EQ(all.soup.attributes->coordinates, ScalarType::float64);
  EXPECT_TRUE(all.report.oddities.empty());
  const ImportedMesh beyond = read(text_ply("float", "1e39"), "b.ply");
  EXPECT_EQ(beyond.soup.points[0].x(), 1e39);
  EXPECT_EQ(to_string(beyond.report.oddities),
            "vertices of more digits than the single precision that the file declares, kept (1)");
}

TEST_F(AttributesTest, PlyTakesWordsForNoNumberWhereNobodyNeedsTheNumber) {
  const ImportedMesh mesh = read(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property float quality\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 1.#QNAN\n1 0 0 -1.#IND\n0 1 0 -nan(ind)\n3 0 1 2\n",
      "nan.ply");
  for (std::size_t v = 0; v < 3; ++v) EXPECT_TRUE(std::isnan(mesh.soup.attributes->points.front().value(v)));
  expect_refused(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 1.#QNAN\n1 0 0\n0 1 0\n3 0 1 2\n",
      "bad.ply", {"vertex 0", "finite"});
}

TEST_F(AttributesTest, PlyStripsAreFaces) {
  const ImportedMesh mesh = read(
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n10 0 1 2 3 3 -1 3 5 2 4\n",
      "strips.ply");
  EXPECT_EQ(mesh.soup.triangles, (Triangles{{0, 1, 2}, {2, 1, 3}, {3, 5, 2}, {2, 5, 4}}));
}

constexpr const char* rich_obj =
    "# Loopmend\nmtllib a.mtl\nmtllib two words.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0.5\n"
    "vt 0 0\nvt 1 0\nvt 0 0.125\nvt 0.1 0.7\nvn 0 0 1\nvn 0 0 -1\n"
    "o thing\ng left hand\nusemtl red\ns 1\nf 1/1/1 2/2/1 3/4/2\n"
    "g right\nusemtl blue\ns off\nf 2/2 4/3 3/4\nusemtl red\nf 2//1 5//1 4//2\n";

TEST_F(AttributesTest, ObjComesOutAsItWentIn) { EXPECT_EQ(round_trip(rich_obj, "rich.obj"), rich_obj); }

TEST_F(AttributesTest, ObjNamesMayHoldTheSignOfComments) {
  const std::string text =
      "# Loopmend\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nusemtl Material #1\nf 1 2 3\nusemtl Material #2\nf 2 4 3\n";
  EXPECT_EQ(round_trip(text, "sharp.obj"), text);
}

/// After others, what has no material must not be taken for one of theirs.
TEST_F(AttributesTest, ObjFacesWithoutANameStayWithout) {
  ImportedMesh mesh = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nusemtl far\nf 2 4 3\n", "none.obj");
  const TriangleSoup whole = mesh.soup;
  std::swap(mesh.soup.triangles[0], mesh.soup.triangles[1]);
  copy_rows(whole, {0, 1, 2, 3}, {1, 0}, mesh.soup);
  write_mesh(folder_ / "out.obj", mesh.soup);
  EXPECT_NE(read_bytes(folder_ / "out.obj").find("usemtl far\nf 2 4 3\nusemtl default\nf 1 2 3\n"), std::string::npos);
}

TEST_F(AttributesTest, PlyListsFitTheirCount) {
  const auto with = [](const std::string& count, int items) {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nproperty list " +
        count + " int tags\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 " + std::to_string(items);
    for (int k = 0; k < items; ++k) text += " 7";
    return text + "\n";
  };
  expect_refused(with("uchar", 300), "long.ply", {"a list of 300 items", "line 14"});
  expect_refused(with("char", 200), "long.ply", {"a list of 200 items"});
  EXPECT_EQ(read(with("ushort", 300), "fits.ply").soup.attributes->faces[0].items(0), 300U);
}

TEST_F(AttributesTest, ObjCornersThatNameWhatIsNotThereHaveNothing) {
  const ImportedMesh mesh = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/-1 2/7 3/1\n", "far.obj");
  EXPECT_EQ(mesh.soup.attributes->texture.at, (std::vector<int>{0, -1, 0}));
  EXPECT_EQ(to_string(mesh.report.not_kept), "numbers of texture coordinates that are not there (1)");
}

TEST_F(AttributesTest, PolygonsStayPolygons) {
  const std::string obj =
      "# Loopmend\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 3 0.5 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
      "f 1/1 2/2 3/3 4/4\nf 2 5 7 6 3\n";
  EXPECT_EQ(round_trip(obj, "quad.obj"), obj);
  const std::string off = "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0.5 0\n4 0 1 2 3\n3 1 4 2\n";
  EXPECT_EQ(round_trip(off, "quad.off"), off);
  // One triangle of the square goes: the other stays a triangle, with its corners' values.
  ImportedMesh mesh = read(obj, "cut.obj");
  const TriangleSoup whole = mesh.soup;
  mesh.soup.triangles.erase(mesh.soup.triangles.begin());
  copy_rows(whole, {0, 1, 2, 3, 4, 5, 6}, {1, 2, 3, 4}, mesh.soup);
  write_mesh(folder_ / "cut_out.obj", mesh.soup);
  const std::string text = read_bytes(folder_ / "cut_out.obj");
  const Triangle& t = whole.triangles[1];
  std::ostringstream face;
  face << 'f';
  for (int v : t) face << ' ' << v + 1 << '/' << v + 1;
  EXPECT_NE(text.find(face.str() + "\nf 2 5 7 6 3\n"), std::string::npos) << text;
}

TEST_F(AttributesTest, OffComesOutAsItWentIn) {
  const std::string text =
      "STCNOFF\n4 2 0\n0 0 0 0 0 1 255 0 0 255 0 0\n1 0 0 0 0 1 0 255 0 255 1 0\n0 1 0 0 0 1 0 0 255 128 0 1\n"
      "1 1 0 0 0.5 1 1 2 3 4 1 1\n3 0 1 2 255 0 0\n3 1 3 2 0.5 0.25 0 1\n";
  EXPECT_EQ(round_trip(text, "rich.off"), text);
}

TEST_F(AttributesTest, StlKeepsHeaderAttributesAndNames) {
  std::string bytes = "COLOR=\xff\x80\x01\xff some scanner";
  bytes.resize(80, '\0');
  const std::uint32_t count = 2;
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  for (int facet = 0; facet < 2; ++facet) {
    const float height = facet == 0 ? 1.0F : -1.0F;
    const float values[12] = {0, 0, height, 0, 0, 0, 1, 0, 0, 0, height, 0};
    bytes.append(reinterpret_cast<const char*>(values), sizeof values);
    bytes.append(facet == 0 ? std::string("\0\0", 2) : std::string("\x1f\x80", 2));
  }
  EXPECT_EQ(round_trip(bytes, "colored.stl", "out.stl", Encoding::binary), bytes);
  const std::string facet =
      "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\nendfacet\n";
  const std::string other =
      "facet normal 0 0 -1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 -1 0\n endloop\nendfacet\n";
  const std::string text = "solid left hand\n" + facet + "endsolid left hand\nsolid b\n" + other + "endsolid b\n";
  EXPECT_EQ(round_trip(text, "two.stl"), text);
}

/// A face that was turned round keeps each corner's own values; so does one whose vertices have changed numbers.
TEST_F(AttributesTest, CornersFollowTheirVertices) {
  const std::string obj =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 9 9 9\nvt 0.1 0\nvt 0.2 0\nvt 0.3 0\nvt 0.4 0\n"
      "f 1/1 2/2 3/3\nf 2/2 3/3 4/4\n";
  SurfaceModel model = make_surface_model(read(obj, "turned.obj").soup);
  ASSERT_EQ(model.repairs.reoriented_faces, 1U);
  write_mesh(folder_ / "out.obj", model.soup);
  EXPECT_NE(read_bytes(folder_ / "out.obj").find("f 1/1 2/2 3/3\nf 2/2 4/4 3/3\n"), std::string::npos)
      << read_bytes(folder_ / "out.obj");
}

TEST_F(AttributesTest, RowsFollowWeldingAndRepair) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
      "property float quality\nelement face 3\nproperty list uchar int vertex_indices\nproperty int tag\n"
      "property list uchar float texcoord\n"
      "element edge 1\nproperty int vertex1\nend_header\n"
      "0 0 0 10\n1 0 0 11\n0 1 0 12\n1 0 0 13\n0 1 0 14\n1 1 0 15\n"
      "3 0 1 2 7 6 1 0 2 0 3 0\n3 0 1 1 8 0\n3 3 5 4 9 6 4 0 6 0 5 0\n5\n";
  write_bytes(folder_ / "split.ply", ply);
  const ImportedMesh welded = read_mesh(folder_ / "split.ply", CoincidentVertices::weld);
  EXPECT_EQ(to_string(not_kept_by_format("a.ply", welded.soup)), "elements \"edge\" (1)")
      << "its numbers of vertices no longer hold";
  const TriangleSoup repaired = repair_surface(welded.soup).soup;
  ASSERT_EQ(repaired.triangles.size(), 2U) << "the face without area is gone";
  write_mesh(folder_ / "out.ply", repaired, Encoding::ascii);
  const std::string text = read_bytes(folder_ / "out.ply");
  EXPECT_EQ(text.substr(text.find("end_header\n") + 11),
            "0 0 0 10\n1 0 0 11\n0 1 0 12\n1 1 0 15\n3 0 1 2 7 6 1 0 2 0 3 0\n3 1 3 2 9 6 4 0 6 0 5 0\n");
}

TEST_F(AttributesTest, OtherFormatsHoldWhatTheyCan) {
  const ImportedMesh obj = read(rich_obj, "rich.obj"), ply = read(rich_ply, "rich.ply");
  const auto lost = [](const ImportedMesh& mesh, const char* name) {
    return to_string(not_kept_by_format(name, mesh.soup));
  };
  EXPECT_EQ(lost(obj, "a.ply"),
            "normals (2), objects (1), groups (2), materials (2), smoothing groups (1), material libraries (2)");
  EXPECT_EQ(lost(ply, "a.obj"),
            "vertex properties \"quality\" (4), vertex properties \"exact\" (4), vertex properties \"label\" (4), "
            "vertex properties \"id\" (4), vertex properties \"weights\" (4), face colours (2), face properties "
            "\"patch\" (2), pictures (1), comments (1), elements \"edge\" (2)");
  write_mesh(folder_ / "a.ply", obj.soup, Encoding::ascii);
  EXPECT_NE(read_bytes(folder_ / "a.ply").find("3 0 1 2 6 0 0 1 0 0.1 0.7\n"), std::string::npos)
      << read_bytes(folder_ / "a.ply");
  write_mesh(folder_ / "a.obj", ply.soup);
  EXPECT_NE(read_bytes(folder_ / "a.obj")
                .find("vn 0 0 -1\nvn 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1/1 2/2/2 3/3/3\nf 2//2 4//4 3//3\n"),
            std::string::npos)
      << read_bytes(folder_ / "a.obj");
}

}  // namespace
}  // namespace loopmend
