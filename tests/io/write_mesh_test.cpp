// SPDX-License-Identifier: GPL-3.0-or-later
// Writing, and reading back the same bits.
#include "io/write_mesh.h"

#include "io_test_support.h"

#include <limits>

namespace loopmend {
namespace {

class WriteMesh : public ReadTest {
 protected:
  ImportedMesh round_trip(const std::string& name, const TriangleSoup& soup, Encoding encoding = Encoding::binary) {
    write_mesh(folder_ / name, soup, encoding);
    ImportedMesh mesh = read_mesh(folder_ / name);
    expect_valid(mesh);
    return mesh;
  }
};

TEST_F(WriteMesh, IndexedFormatsKeepEveryBit) {
  for (const char* name : {"a.ply", "a.PLY", "a.obj", "a.off"}) {
    for (const Encoding encoding : {Encoding::binary, Encoding::ascii}) {
      const TriangleSoup soup = awkward_soup();
      const TriangleSoup back = round_trip(name, soup, encoding).soup;
      EXPECT_TRUE(same_bits(back.points, soup.points)) << name;
      EXPECT_EQ(back.triangles, soup.triangles) << name;
      EXPECT_TRUE(back.colors.empty()) << name;
    }
  }
}

TEST_F(WriteMesh, ColorsComeBack) {
  for (const char* name : {"a.ply", "a.obj", "a.off"}) {
    for (const Encoding encoding : {Encoding::binary, Encoding::ascii}) {
      EXPECT_EQ(round_trip(name, colored_soup(), encoding).soup.colors, colored_soup().colors) << name;
    }
  }
}

TEST_F(WriteMesh, EveryColorValueComesBackFromText) {
  TriangleSoup soup = awkward_soup();
  soup.points.assign(256, Vec3(1, 2, 3));
  for (int i = 0; i < 256; ++i) {
    const auto c = static_cast<unsigned char>(i);
    soup.colors.push_back({c, static_cast<unsigned char>(255 - c), 0, 255});
  }
  EXPECT_EQ(round_trip("a.obj", soup).soup.colors, soup.colors);
  EXPECT_EQ(round_trip("a.off", soup).soup.colors, soup.colors);
}

TEST_F(WriteMesh, AlphaComesBackFromPlyAndOff) {
  TriangleSoup soup = colored_soup();
  soup.colors[2][3] = 17;
  EXPECT_EQ(round_trip("a.ply", soup).soup.colors, soup.colors);
  EXPECT_EQ(round_trip("a.off", soup).soup.colors, soup.colors);
}

TEST_F(WriteMesh, StlTextKeepsDoublesAndBinaryFloats) {
  TriangleSoup soup = awkward_soup();
  soup.points.erase(soup.points.begin() + 3);  // STL knows no points of their own
  soup.triangles = {{0, 1, 2}, {2, 1, 3}};
  EXPECT_TRUE(same_bits(round_trip("a.stl", soup, Encoding::ascii).soup.points, soup.points));
  soup.points[1][0] = 1e30;
  const TriangleSoup back = round_trip("a.stl", soup).soup;
  EXPECT_EQ(back.triangles, soup.triangles);
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    EXPECT_EQ(back.points[i], soup.points[i].cast<float>().cast<double>());
  }
}

TEST_F(WriteMesh, BinaryStlRefusesWhatAFloatCannotHold) {
  try {
    write_mesh(folder_ / "a.stl", awkward_soup());
    FAIL();
  } catch (const WriteError& error) {
    EXPECT_NE(std::string(error.what()).find("too large"), std::string::npos);
  }
  EXPECT_EQ(folder_.file_count(), 0U);
}

TEST_F(WriteMesh, PlyHeaderIsAsDocumented) {
  write_mesh(folder_ / "a.ply", colored_soup());
  const std::string bytes = read_bytes(folder_ / "a.ply");
  const std::string head =
      "ply\nformat binary_little_endian 1.0\ncomment Loopmend\nelement vertex 5\nproperty double x\nproperty double y\n"
      "property double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n"
      "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
  EXPECT_EQ(bytes.substr(0, head.size()), head);
  EXPECT_EQ(bytes.size(), head.size() + 5 * 28 + 2 * 13);
}

TEST_F(WriteMesh, RefusesUnknownExtensions) {
  for (const char* name : {"a.xyz", "a", ".ply", "ply"}) {
    try {
      write_mesh(folder_ / name, awkward_soup());
      ADD_FAILURE() << name;
    } catch (const WriteError& error) {
      EXPECT_NE(std::string(error.what()).find(".off, .glb, .gltf, .3mf, .vtp or .vtk"), std::string::npos)
          << error.what();
    }
  }
  EXPECT_EQ(folder_.file_count(), 0U);
}

TEST_F(WriteMesh, RefusesSoupsThatCouldNotBeReadAgain) {
  TriangleSoup soup = awkward_soup();
  soup.triangles[0][0] = 5;
  EXPECT_THROW(write_mesh(folder_ / "a.ply", soup), InvalidArgument);
  soup = awkward_soup();
  soup.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(write_mesh(folder_ / "a.ply", soup), InvalidArgument);
  soup = colored_soup();
  soup.colors.pop_back();
  EXPECT_THROW(write_mesh(folder_ / "a.ply", soup), InvalidArgument);
  EXPECT_EQ(folder_.file_count(), 0U);
}

}  // namespace
}  // namespace loopmend
