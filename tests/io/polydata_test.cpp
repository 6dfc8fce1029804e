// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's polydata, read and written by VTK: arrays of several values, colours, strips, and files that are none.
#include "io/polydata.h"

#include "io/io_test_support.h"
#include "mesh/scan_attributes.h"

#include <gmock/gmock.h>

#include <fstream>
#include <string>

namespace loopmend {
namespace {

using ::testing::HasSubstr;

/// Two triangles and a strip of two, a point and a line.
const std::string legacy =
    "# vtk DataFile Version 3.0\nby hand\nASCII\nDATASET POLYDATA\nPOINTS 6 float\n"
    "0 0 0 1 0 0 0 1 0 1 1 0 0 2 0 1 2 0.1\n"
    "VERTICES 1 2\n1 0\nLINES 1 3\n2 0 1\nPOLYGONS 2 8\n3 0 1 2\n3 1 3 2\nTRIANGLE_STRIPS 1 5\n4 2 3 4 5\n"
    "CELL_DATA 5\nSCALARS label int 1\nLOOKUP_TABLE default\n10 11 12 13 14\n"
    "POINT_DATA 6\nCOLOR_SCALARS paint 3\n1 0 0 0 1 0 0 0 1 1 1 1 0 0 0 0.2 0.2 0.2\n"
    "VECTORS the%20flow double\n0 0 1 0 0 2 0 0 3 0 0 4 0 0 5 0.1 0.2 6\n"
    "NORMALS normals float\n0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1\n";

std::string xml(const std::string& connectivity, const std::string& offsets, const std::string& type = "PolyData") {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type + "\" version=\"0.1\" byte_order=\"LittleEndian\"><" +
         type +
         "><Piece NumberOfPoints=\"4\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
         "NumberOfPolys=\"2\">"
         "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 0.1 1 0"
         "</DataArray></Points><Polys><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" +
         connectivity + "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" + offsets +
         "</DataArray></Polys></Piece></" + type + "></VTKFile>\n";
}

class Polydata : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      require_polydata_program(folder_ / "x.vtp");
    } catch (const WriteError& error) {
      GTEST_SKIP() << error.what();
    }
  }

  ImportedMesh read(const std::string& name, const std::string& bytes) const {
    write_bytes(folder_ / name, bytes);
    return read_mesh(folder_ / name);
  }
  std::string refusal(const std::string& name, const std::string& bytes) const {
    try {
      read(name, bytes);
    } catch (const ReadError& error) {
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
};

std::vector<double> values(const AttributeColumn& column) {
  std::vector<double> list;
  for (std::size_t row = 0; row < column.rows(); ++row) list.push_back(column.value(row));
  return list;
}

TEST_F(Polydata, LegacyTextIsRead) {
  const ImportedMesh mesh = read("scan.vtk", legacy);
  EXPECT_EQ(mesh.report.format, "VTK");
  EXPECT_EQ(mesh.soup.points.size(), 6U);
  EXPECT_EQ(mesh.soup.points[5].z(), static_cast<double>(0.1F));
  const Triangles expected{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {4, 3, 5}};
  EXPECT_EQ(mesh.soup.triangles, expected);
  const ScanAttributes& scan = *mesh.soup.attributes;
  EXPECT_EQ(scan.coordinates, ScalarType::float32);
  ASSERT_TRUE(find_column(scan.faces, "label"));
  EXPECT_EQ(values(*find_column(scan.faces, "label")), (std::vector<double>{12, 13, 14, 14}));  // a strip has one row
  ASSERT_TRUE(find_column(scan.points, "nz"));
  const AttributeColumn* flow = find_column(scan.points, "the%20flow_2");
  ASSERT_TRUE(flow);
  EXPECT_EQ(flow->type(), ScalarType::float64);
  EXPECT_EQ(values(*flow), (std::vector<double>{1, 2, 3, 4, 5, 6}));
  ASSERT_EQ(mesh.soup.colors.size(), 6U);
  EXPECT_EQ(mesh.soup.colors[5], (Color{51, 51, 51, 255}));
  ASSERT_EQ(mesh.report.not_kept.size(), 1U);
  EXPECT_EQ(mesh.report.not_kept[0].what.english(), "points and lines");
  EXPECT_EQ(mesh.report.not_kept[0].count, 2U);
}

TEST_F(Polydata, BothFormatsBinaryTextAndGzipReadBackAsTheSame) {
  const ImportedMesh first = read("scan.vtk", legacy);
  for (const char* name : {"a.vtp", "a.vtk", "a.vtp.gz"})
    for (const Encoding encoding : {Encoding::binary, Encoding::ascii}) {
      SCOPED_TRACE(std::string(name) + (encoding == Encoding::ascii ? " as text" : ""));
      write_mesh(folder_ / name, first.soup, encoding);
      const ImportedMesh again = read_mesh(folder_ / name);
      EXPECT_EQ(again.soup.points, first.soup.points);
      EXPECT_EQ(again.soup.triangles, first.soup.triangles);
      EXPECT_EQ(again.soup.colors, first.soup.colors);
      EXPECT_EQ(again.soup.attributes->coordinates, ScalarType::float32);
      EXPECT_EQ(again.soup.attributes->points.size(), first.soup.attributes->points.size());
      for (const AttributeColumn& column : first.soup.attributes->points) {
        const AttributeColumn* other = find_column(again.soup.attributes->points, column.name());
        ASSERT_TRUE(other) << column.name();
        EXPECT_EQ(other->type(), column.type());
        EXPECT_EQ(values(*other), values(column));
      }
      EXPECT_EQ(values(*find_column(again.soup.attributes->faces, "label")), (std::vector<double>{12, 13, 14, 14}));
      EXPECT_TRUE(not_kept_by_format(folder_ / name, first.soup).empty());
    }
}

/// What VTK sees in our file: one array of three values under its name, not three.
TEST_F(Polydata, ColumnsOfOneArrayBecomeItAgain) {
  write_mesh(folder_ / "a.vtp", read("scan.vtk", legacy).soup, Encoding::ascii);
  std::ifstream stream(folder_ / "a.vtp");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_THAT(text, HasSubstr("Name=\"the flow\" NumberOfComponents=\"3\""));
  EXPECT_THAT(text, HasSubstr("Scalars=\"RGB\""));
  EXPECT_THAT(text, HasSubstr("Normals=\"Normals\""));
}

TEST_F(Polydata, PolygonsStayPolygons) {
  const ImportedMesh mesh = read("quad.vtp", xml("0 1 3 2 0 1 3", "4 7"));
  EXPECT_EQ(mesh.report.polygons_triangulated, 1U);
  EXPECT_EQ(mesh.soup.attributes->coordinates, ScalarType::float64);
  write_mesh(folder_ / "again.vtp", mesh.soup);
  EXPECT_EQ(read_mesh(folder_ / "again.vtp").report.faces, 2U);
}

TEST_F(Polydata, WhatIsNoMeshIsNamed) {
  EXPECT_THAT(refusal("a.vtp", xml("0 1 2 1 3 9", "3 6")), HasSubstr("names vertex 9, but there are 4"));
  EXPECT_THAT(refusal("a.vtp", xml("0 1 2 1 3 -1", "3 6")), HasSubstr("names vertex -1"));
  EXPECT_NE(refusal("a.vtp", xml("0 1 2 1 3 2", "6 3")), "");
  EXPECT_NE(refusal("a.vtp", xml("0 1 2 1 3 2", "3 600")), "");
  EXPECT_NE(refusal("a.vtp", xml("0 1 2 1 3 2", "-3 6")), "");
  EXPECT_THAT(refusal("a.vtu", xml("0 1 2 1 3 2", "3 6", "UnstructuredGrid")), HasSubstr("extract the surface"));
  EXPECT_THAT(refusal("a.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\n"),
              HasSubstr("extract the surface"));
  const std::string whole = xml("0 1 2 1 3 2", "3 6");
  EXPECT_NE(refusal("a.vtp", whole.substr(0, whole.size() / 2)), "");
  EXPECT_NE(refusal("a.vtk", legacy.substr(0, legacy.size() / 4)), "");
  EXPECT_NE(
      refusal("a.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 999999999999 float\n0 0 0\n"),
      "");
  // One sentence, without VTK's log.
  EXPECT_EQ(refusal("a.vtp", whole.substr(0, 60)),
            (folder_ / "a.vtp").string() +
                ": VTK: Error parsing XML in stream at line 2, column 0, byte index 22: unclosed token. Loopmend reads "
                "polydata: in ParaView, extract the surface and save it as .vtp.");
  EXPECT_THAT(refusal("a.vtp", "hello"), HasSubstr("does not begin as VTK files do"));
}

}  // namespace
}  // namespace loopmend
