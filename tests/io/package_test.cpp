// SPDX-License-Identifier: GPL-3.0-or-later
// 3MF: packages read, written, and refused.
#include "io/write_mesh.h"
#include "io/zip_archive.h"
#include "io_test_support.h"
#include "mesh/material_table.h"
#include "mesh/scan_attributes.h"

#include <utility>

namespace loopmend {
namespace {

const std::string relations =
    "<Relationships><Relationship Target=\"/3D/main.model\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
    "</Relationships>";
const std::string square_mesh =
    "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0.1\"/><vertex x=\"1\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"1\" "
    "z=\"0\"/>"
    "<vertex x=\"0\" y=\"1\" z=\"0\"/></vertices><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/>"
    "<triangle v1=\"0\" v2=\"2\" v3=\"3\"/></triangles></mesh>";
const std::string square = "<object id=\"1\">" + square_mesh + "</object>";

std::string model(const std::string& resources, const std::string& build = "<item objectid=\"1\"/>",
                  const std::string& attributes = "") {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model " + attributes +
         " xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
         "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "
         "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\"><resources>" +
         resources + "</resources><build>" + build + "</build></model>";
}

std::string package(const std::string& text) {
  return zip_archive({{"_rels/.rels", relations}, {"3D/main.model", text}});
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

class Package : public ReadTest {
 protected:
  ImportedMesh read_model(const std::string& text) { return read(package(text), "a.3mf"); }
  void expect_model_refused(const std::string& text, std::initializer_list<const char*> words) {
    expect_refused(package(text), "a.3mf", words);
  }
  ImportedMesh again(const TriangleSoup& soup) {
    write_mesh(folder_ / "again.3mf", soup);
    return read_mesh(folder_ / "again.3mf");
  }
};

TEST_F(Package, ASquare) {
  for (const char* name : {"a.3mf", "a.zip", "a"}) {
    const ImportedMesh mesh = read(package(model(square, "<item objectid=\"1\"/>", "unit=\"inch\"")), name);
    expect_valid(mesh);
    EXPECT_EQ(mesh.report.format, "3MF");
    EXPECT_TRUE(same_bits(mesh.soup.points, {{0, 0, 0.1}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.soup.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(mesh.soup.attributes->unit, "inch");
    EXPECT_EQ(again(mesh.soup).soup.attributes->unit, "inch");
    EXPECT_TRUE(mesh.soup.attributes->names.empty());
    EXPECT_TRUE(mesh.report.not_kept.empty());
  }
}

TEST_F(Package, ItemsAndComponentsAreInPlace) {
  const std::string whole =
      "<object id=\"2\" name=\"two &amp; more\"><components><component objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 "
      "10 20 30\"/>"
      "<component objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/></components></object>";
  const ImportedMesh mesh = read_model(
      model(square + whole, "<item objectid=\"1\"/><item objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 1 0 0 5\"/>"));
  ASSERT_EQ(mesh.soup.points.size(), 12U);
  EXPECT_EQ(mesh.soup.points[5], Vec3(10, 21, 35)) << "x becomes y";
  EXPECT_EQ(mesh.soup.points[9], Vec3(-1, 0, 5));
  EXPECT_EQ(mesh.soup.triangles[4], (Triangle{8, 10, 9})) << "a mirror image is turned round";
  EXPECT_EQ(mesh.soup.attributes->names[0].of_face, (std::vector<int>{0, 0, 1, 1, 2, 2}));
  EXPECT_EQ(to_string(mesh.report.not_kept), "transforms of objects, which are applied (3)");
  EXPECT_TRUE(same_bits(again(mesh.soup).soup.points, mesh.soup.points));
}

/// As Bambu Studio and PrusaSlicer write it: objects in parts of their own.
TEST_F(Package, PartsOfTheProductionExtension) {
  const std::string root = model(
      "<object id=\"8\"><components><component p:path=\"/3D/Objects/a.model\" objectid=\"1\"/></components></object>",
      "<item objectid=\"8\"/>", "requiredextensions=\"p\"");
  const std::string bytes = zip_archive({{"_rels/.rels", relations},
                                         {"3D/main.model", root},
                                         {"3D/Objects/a.model", model(square, "")},
                                         {"Metadata/slice.config", "x"}});
  const ImportedMesh mesh = read(bytes, "a.3mf");
  EXPECT_EQ(mesh.soup.triangles.size(), 2U);
  EXPECT_EQ(to_string(mesh.report.not_kept), "further parts of the archive (1)");
}

TEST_F(Package, MaterialsComeBack) {
  const std::string materials =
      "<basematerials id=\"5\"><base name=\"red\" displaycolor=\"#FF0000\"/><base name=\"glass\" "
      "displaycolor=\"#00ff0080\"/></basematerials>";
  std::string object = replaced(square, "id=\"1\"", "id=\"1\" pid=\"5\" pindex=\"1\" name=\"part\"");
  object = replaced(object, "v3=\"3\"", "v3=\"3\" pid=\"5\" p1=\"0\"");
  const std::string metadata =
      "<metadata name=\"Designer\">A &lt; B</metadata><metadata name=\"Application\">X</metadata>";
  const ImportedMesh mesh = read_model(replaced(model(materials + object), "<resources>", metadata + "<resources>"));
  for (const ImportedMesh& now : {mesh, again(mesh.soup)}) {
    const ScanAttributes& scan = *now.soup.attributes;
    ASSERT_EQ(scan.names.size(), 2U);
    EXPECT_EQ(scan.names[0].names, std::vector<std::string>{"part"});
    EXPECT_EQ(scan.names[1].names, (std::vector<std::string>{"red", "glass"}));
    EXPECT_EQ(scan.names[1].of_face, (std::vector<int>{1, 0}));
    EXPECT_EQ(scan.materials->materials[1].color, (Color{0, 255, 0, 128}));
    ASSERT_EQ(scan.materials->metadata.size(), 1U);
    EXPECT_EQ(scan.materials->metadata[0], std::pair(std::string("Designer"), std::string("A < B")));
  }
}

TEST_F(Package, ColorsOfFacesAndOfVertices) {
  const std::string colors =
      "<m:colorgroup id=\"5\"><m:color color=\"#FF0000\"/><m:color color=\"#0102037F\"/></m:colorgroup>";
  const std::string faces =
      replaced(replaced(square, "v3=\"2\"", "v3=\"2\" pid=\"5\" p1=\"1\""), "v3=\"3\"", "v3=\"3\" pid=\"5\" p1=\"0\"");
  ImportedMesh mesh = read_model(model(colors + faces));
  for (const ImportedMesh& now : {mesh, again(mesh.soup)}) {
    EXPECT_TRUE(now.soup.colors.empty());
    const AttributeColumn* blue = find_column(now.soup.attributes->faces, "blue");
    const AttributeColumn* alpha = find_column(now.soup.attributes->faces, "alpha");
    ASSERT_TRUE(blue && alpha);
    EXPECT_EQ(blue->value(0), 3);
    EXPECT_EQ(alpha->value(0), 127);
    EXPECT_EQ(blue->value(1), 0);
  }
  const std::string corners = replaced(faces, "p1=\"1\"", "p1=\"1\" p2=\"0\" p3=\"1\"");
  mesh = read_model(model(colors + corners));
  EXPECT_EQ(mesh.soup.colors, (std::vector<Color>{{1, 2, 3, 127}, {255, 0, 0, 255}, {1, 2, 3, 127}, {255, 0, 0, 255}}));
  EXPECT_EQ(to_string(mesh.report.not_kept), "further colours at one vertex (2)");
  EXPECT_EQ(again(mesh.soup).soup.colors, mesh.soup.colors);
}

TEST_F(Package, DoublesKeepEveryBit) {
  const TriangleSoup soup = awkward_soup();
  const ImportedMesh mesh = again(soup);
  EXPECT_TRUE(same_bits(mesh.soup.points, soup.points));
  EXPECT_EQ(mesh.soup.triangles, soup.triangles);
  EXPECT_EQ(to_string(not_kept_by_format("a.3mf", soup)), "");
  const std::string bytes = read_bytes(folder_ / "again.3mf");
  again(soup);
  EXPECT_EQ(read_bytes(folder_ / "again.3mf"), bytes) << "no dates";
}

TEST_F(Package, NamesThatAreNoXml) {
  const ImportedMesh obj = read("o a<b>\"&'\xFF\xC3\xA9 x\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj");
  EXPECT_EQ(again(obj.soup).soup.attributes->names[0].names, std::vector<std::string>{"a<b>\"&'?\xC3\xA9 x"});
}

// -- Hostile files -----------------------------------------------------------------------------------------------------

TEST_F(Package, ArchivesThatAreNone) {
  const std::string bytes = package(model(square));
  for (std::size_t size = 4; size < bytes.size(); ++size)
    expect_refused(bytes.substr(0, size), "a.3mf", {"ZIP archive", "damaged"});
  expect_refused(zip_archive({{"holiday.txt", "x"}}), "a.zip", {"without a 3MF model", "Unpack it"});
  expect_refused(zip_archive({{"_rels/.rels", relations}}), "a.3mf",
                 {"a part of the archive is missing", "3d/main.model"});
  expect_refused("no archive", "a.3mf", {"does not begin as 3MF files do"});
}

TEST_F(Package, AChangedByteIsNoticed) {
  const std::string bytes = package(model(square));
  const TriangleSoup whole = read(bytes, "a.3mf").soup;
  const std::size_t begin = bytes.find("3D/main.model") + 13;
  for (std::size_t at = begin; at < begin + 200; ++at) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 4);
    try {
      EXPECT_TRUE(same_bits(read(damaged, "a.3mf").soup.points, whole.points)) << at;
    } catch (const ReadError&) {
    }
  }
}

TEST_F(Package, XmlThatIsNone) {
  expect_model_refused("<model>", {"XML is damaged", "line 1 of 3d/main.model"});
  expect_model_refused("", {"XML is damaged"});
  expect_model_refused("<a/>", {"holds no model"});
  expect_model_refused("<!DOCTYPE a [<!ENTITY b \"c\">]><model/>", {"document type"});
  std::string deep = "<model>";
  for (int k = 0; k < 100000; ++k) deep += "<a>";
  expect_model_refused(deep, {"nested more than 64 deep"});
  expect_model_refused("<model a=\"" + std::string(6 << 20, 'x'), {"has no end"});
  expect_model_refused(replaced(model(square), "x=\"1\"", "x=\"1,5\""),
                       {"\"1,5\" stands where a coordinate", "line 2"});
  expect_model_refused(replaced(model(square), "x=\"1\"", "x=\"nan\""), {"\"nan\" stands where a coordinate"});
  expect_model_refused(replaced(model(square), "x=\"1\"", ""), {"\"x\" is missing"});
  expect_model_refused(replaced(model(square), "v3=\"3\"", "v3=\"4\""), {"face 1 names vertex 4", "there are 4"});
  expect_model_refused(replaced(model(square), "v3=\"3\"", "v3=\"-1\""), {"\"-1\" stands where \"v3\""});
  expect_model_refused(replaced(model(square), "v3=\"3\"", "v3=\"3\" p1=\"0\" pid=\"9999999999\""), {"\"pid\""});
  expect_model_refused(model(square + square), {"two objects 1"});
  expect_model_refused(model("<vertex x=\"0\" y=\"0\" z=\"0\"/>"), {"outside an object"});
  expect_model_refused(model(square, "<item objectid=\"7\"/>"), {"object that is not there", "object 7"});
  expect_model_refused(model(square, "<item objectid=\"1\" transform=\"1 2 3\"/>"), {"3 numbers, not 12"});
  expect_model_refused(model(square, "<item objectid=\"1\"/>", "unit=\"mile\""), {"\"mile\" is no unit"});
  expect_model_refused(
      model(square, "<item objectid=\"1\"/>", "xmlns:b=\"http://x/beamlattice/2017\" requiredextensions=\"p b\""),
      {"beamlattice", "does not know"});
  expect_model_refused(model("", ""), {"no points and no faces"});
}

TEST_F(Package, ObjectsThatGoRoundInCirclesOrMultiply) {
  expect_model_refused(model("<object id=\"1\"><components><component objectid=\"1\"/></components></object>"),
                       {"64 deep"});
  std::string doubling = square;
  for (int k = 2; k < 40; ++k) {
    const std::string below = "<component objectid=\"" + std::to_string(k - 1) + "\"/>";
    doubling += "<object id=\"" + std::to_string(k) + "\"><components>" + below + below + "</components></object>";
  }
  expect_model_refused(model(doubling, "<item objectid=\"39\"/>"), {"copies"});
  expect_model_refused(model(replaced(doubling, square_mesh, ""), "<item objectid=\"39\"/>"),
                       {"more than 1000000 objects"});
}

/// Nothing but blanks, a thousandfold packed.
TEST_F(Package, AZipBomb) {
  expect_model_refused("<model>" + std::string(64 << 20, ' ') + "</model>", {"200 times", "trap"});
}

TEST_F(Package, PropertiesThatAreNotThere) {
  const std::string colors = "<m:colorgroup id=\"5\"><m:color color=\"#FF0000\"/></m:colorgroup>";
  expect_model_refused(model(colors + replaced(square, "v3=\"2\"", "v3=\"2\" pid=\"5\" p1=\"1\"")),
                       {"member 1 of property group 5", "has 1"});
  expect_model_refused(model(replaced(colors, "#FF0000", "red") + square), {"\"red\" is no colour"});
  expect_model_refused(model("<base name=\"a\" displaycolor=\"#FFFFFF\"/>"), {"outside \"basematerials\""});
  const ImportedMesh mesh = read_model(model(replaced(square, "v3=\"2\"", "v3=\"2\" pid=\"77\" p1=\"1\"")));
  EXPECT_EQ(to_string(mesh.report.not_kept), "faces with properties of other kinds (1)");
}

}  // namespace
}  // namespace loopmend
