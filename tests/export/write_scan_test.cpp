// SPDX-License-Identifier: GPL-3.0-or-later
// A textured scan is filled and written: pictures, materials and what they are named.
#include "export/write_scan.h"
#include "export/ramp.h"

#include "io/io_test_support.h"
#include "io/material_library.h"
#include "io/picture_file.h"
#include "mesh/boundary_loops.h"
#include "mesh/scan_attributes.h"
#include "pipeline/fill_holes.h"
#include "samples/analytic_surfaces.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <sstream>

namespace loopmend {
namespace {

class WriteScan : public ::testing::Test {
 protected:
  /// A bowl with a hole in its middle, its texture the view from above.
  void SetUp() override {
    std::filesystem::create_directories(folder_ / "in/pictures");
    std::filesystem::create_directories(folder_ / "out");
    const TriangleSoup bowl = cut(make_graph([](double x, double y) { return 0.3 * (x * x + y * y); }, 1, 40),
                                  [](const Vec3& p) { return p.head<2>().norm() < 0.4; });
    std::ofstream obj(folder_ / "in/bowl.obj");
    obj << "mtllib my skin.mtl\n";
    for (const Vec3& p : bowl.points) obj << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (const Vec3& p : bowl.points) obj << "vt " << (p.x() + 1) / 2 << ' ' << (p.y() + 1) / 2 << '\n';
    obj << "usemtl skin\n";
    for (const Triangle& t : bowl.triangles) {
      obj << 'f';
      for (int v : t) obj << ' ' << v + 1 << '/' << v + 1;
      obj << '\n';
    }
    std::ofstream(folder_ / "in/my skin.mtl") << "newmtl skin\nKd 0.5 0.5 0.5\nmap_Kd -s 1 1 1 pictures/a b.png\n";
    std::ofstream picture(folder_ / "in/pictures/a b.png", std::ios::binary);
    write_png(picture, ramp());
  }

  WrittenScan fill(const std::string& to, const WriteScanOptions& options = {}, const char* from = "in/bowl.obj") {
    SurfaceModel model = make_surface_model(read_mesh(folder_ / from).soup);
    std::vector<BoundaryLoop> holes;
    for (const BoundaryLoop& loop : find_boundary_loops(model))
      if (loop.kind == LoopKind::hole) holes.push_back(loop);
    fill_holes(model, holes, FillOptions{}, nullptr, CancelToken());
    OutputTransaction outputs;
    const WrittenScan written = write_scan(outputs, folder_ / to, model.soup, options);
    outputs.commit();
    return written;
  }

  /// Checks the colours of triangles against the ramp. @returns how many there are
  static std::size_t count_ramp_triangles(const TriangleSoup& soup, const Picture& picture,
                                          const std::function<bool(std::size_t)>& is_meant) {
    const CornerValues& texture = soup.attributes->texture;
    std::size_t count = 0;
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
      if (!is_meant(f)) continue;
      ++count;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& p = soup.points[soup.triangles[f][k]];
        const auto at = static_cast<std::size_t>(texture.at[3 * f + k]);
        const double u = texture.values[2 * at], v = texture.values[2 * at + 1];
        EXPECT_TRUE(u >= 0 && v >= 0 && u <= 1 && v <= 1);
        const int x = std::min(static_cast<int>(u * picture.width), picture.width - 1);
        const int y = std::min(static_cast<int>((1 - v) * picture.height), picture.height - 1);
        EXPECT_NEAR(picture.at(x, y)[0], 100 * (p.x() + 1), 6);
        EXPECT_NEAR(picture.at(x, y)[1], 100 * (p.y() + 1), 6);
      }
    }
    return count;
  }

  TemporaryFolder folder_;
};

/// Each new corner's colour in the painted picture is what the ramp has at its place.
TEST_F(WriteScan, ThePatchIsPaintedAsTheScanIs) {
  for (const TextureFill fill_kind : {TextureFill::smooth, TextureFill::grain}) {
    WriteScanOptions options;
    options.texture = fill_kind;
    const WrittenScan written = fill("out/bowl.obj", options);
    EXPECT_GT(written.painted, 200U);
    EXPECT_TRUE(written.remarks.empty());
    const TriangleSoup soup = read_mesh(folder_ / "out/bowl.obj").soup;
    const ScanAttributes& scan = *soup.attributes;
    EXPECT_EQ(scan.material_libraries, (std::vector<std::string>{"my skin.mtl", "bowl_patch.mtl"}));
    EXPECT_EQ(read_bytes(folder_ / "out/my skin.mtl"), read_bytes(folder_ / "in/my skin.mtl"));
    EXPECT_EQ(read_bytes(folder_ / "out/pictures/a b.png"), read_bytes(folder_ / "in/pictures/a b.png"));
    const MaterialLibrary library = read_material_library(folder_ / "out/bowl_patch.mtl");
    EXPECT_EQ(library.statements.at("loopmend_patch"), std::vector<std::string>{"Kd 0.5 0.5 0.5"});
    const Picture picture = read_picture(folder_ / ("out/" + library.color_pictures.at("loopmend_patch")));
    ASSERT_EQ(scan.names.size(), 1U);
    const auto is_of_patch = [&](std::size_t f) {
      return scan.names[0].names[scan.names[0].of_face[f]] == "loopmend_patch";
    };
    EXPECT_EQ(count_ramp_triangles(soup, picture, is_of_patch), written.painted);
  }
}

/// As MeshLab writes it; with one picture, its faces have no number of it.
TEST_F(WriteScan, PlyIsPaintedToo) {
  for (const char* number : {"", "property uchar texnumber\n"}) {
    const TriangleSoup bowl = read_mesh(folder_ / "in/bowl.obj").soup;
    std::ofstream ply(folder_ / "in/bowl.ply");
    ply << "ply\nformat ascii 1.0\ncomment TextureFile pictures/a b.png\nelement vertex " << bowl.points.size()
        << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << bowl.triangles.size()
        << "\nproperty list uchar int vertex_indices\n"
        << number << "property list uchar float texcoord\nend_header\n";
    for (const Vec3& p : bowl.points) ply << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (const Triangle& t : bowl.triangles) {
      ply << 3 << ' ' << t[0] << ' ' << t[1] << ' ' << t[2] << (*number ? " 0" : "") << " 6";
      for (int v : t) ply << ' ' << (bowl.points[v].x() + 1) / 2 << ' ' << (bowl.points[v].y() + 1) / 2;
      ply << '\n';
    }
    ply.close();
    const WrittenScan written = fill("out/bowl.ply", {}, "in/bowl.ply");
    EXPECT_GT(written.painted, 200U);
    const TriangleSoup soup = read_mesh(folder_ / "out/bowl.ply").soup;
    const std::vector<std::string> remarks = soup.attributes->remarks;
    EXPECT_EQ(remarks, (std::vector<std::string>{"comment Loopmend", "comment TextureFile pictures/a b.png",
                                                 "comment TextureFile bowl_patch.png"}));
    const AttributeColumn* texnumber = find_column(soup.attributes->faces, "texnumber");
    ASSERT_TRUE(texnumber);
    EXPECT_EQ(texnumber->type(), *number ? ScalarType::uint8 : ScalarType::int32);
    const auto is_of_patch = [&](std::size_t f) { return texnumber->value(f) == 1; };
    EXPECT_EQ(count_ramp_triangles(soup, read_picture(folder_ / "out/bowl_patch.png"), is_of_patch), written.painted);
    EXPECT_EQ(count_ramp_triangles(soup, read_picture(folder_ / "out/pictures/a b.png"),
                                   [&](std::size_t f) { return texnumber->value(f) == 0; }),
              bowl.triangles.size());
    std::filesystem::remove_all(folder_ / "out");
    std::filesystem::create_directories(folder_ / "out");
  }
}

/// The picture of a PLY with texture coordinates at its vertices comes along, though no patch is painted.
TEST_F(WriteScan, ThePictureOfVerticesIsCopied) {
  const TriangleSoup bowl = read_mesh(folder_ / "in/bowl.obj").soup;
  std::ofstream ply(folder_ / "in/bowl.ply");
  ply << "ply\nformat ascii 1.0\ncomment TextureFile pictures/a b.png\nelement vertex " << bowl.points.size()
      << "\nproperty float x\nproperty float y\nproperty float z\nproperty float s\nproperty float t\nelement face "
      << bowl.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& p : bowl.points)
    ply << p.x() << ' ' << p.y() << ' ' << p.z() << ' ' << (p.x() + 1) / 2 << ' ' << (p.y() + 1) / 2 << '\n';
  for (const Triangle& t : bowl.triangles) ply << 3 << ' ' << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  ply.close();
  const WrittenScan written = fill("out/bowl.ply", {}, "in/bowl.ply");
  EXPECT_EQ(written.painted, 0U);
  EXPECT_EQ(read_bytes(folder_ / "out/pictures/a b.png"), read_bytes(folder_ / "in/pictures/a b.png"));
}

/// What lies beside the scan must not cost the fill.
TEST_F(WriteScan, OddFilesBesideTheScanAreNoReasonToFail) {
  std::string obj = read_bytes(folder_ / "in/bowl.obj");
  std::filesystem::create_directories(folder_ / "in/folder.mtl");
  write_bytes(folder_ / "in/empty.mtl", "");
  write_bytes(folder_ / "in/secret.mtl", "root:x:0:0\nnewmtl skin\nroot:y\nKd 1 1 1\n");
  for (const std::string& name :
       {std::string("folder.mtl"), std::string("empty.mtl"), std::string(300, 'a'), std::string("secret.mtl")}) {
    write_bytes(folder_ / "in/bowl.obj", "mtllib " + name + "\n" + obj);
    EXPECT_NO_THROW(fill("out/bowl.obj")) << name;
    EXPECT_TRUE(std::filesystem::exists(folder_ / "out/bowl.obj")) << name;
    EXPECT_EQ(read_bytes(folder_ / "out/bowl_patch.mtl").find("root"), std::string::npos)
        << "only what a material is made of";
    std::filesystem::remove_all(folder_ / "out");
    std::filesystem::create_directories(folder_ / "out");
  }
}

TEST_F(WriteScan, CoordinatesThatAreNoneAreNoTexture) {
  std::string obj = read_bytes(folder_ / "in/bowl.obj");
  for (const char* bad : {"vt nan nan", "vt 1e300 0", "vt inf 0.5", "vt -1e18 1e18"}) {
    std::istringstream lines(obj);
    std::ofstream out(folder_ / "in/bowl.obj");
    int count = 0;
    for (std::string line; std::getline(lines, line);)
      out << (line.substr(0, 3) == "vt " && ++count % 3 == 0 ? bad : line) << '\n';
    out.close();
    EXPECT_NO_THROW(fill("in/filled.obj")) << bad;
  }
}

TEST_F(WriteScan, BesideTheScanNothingIsCopied) {
  const WrittenScan written = fill("in/filled.obj");
  EXPECT_EQ(written.beside.size(), 2U);
  EXPECT_EQ(read_mesh(folder_ / "in/filled.obj").soup.attributes->material_libraries,
            (std::vector<std::string>{"my skin.mtl", "filled_patch.mtl"}));
}

TEST_F(WriteScan, MaterialsCanBeReferredTo) {
  WriteScanOptions options;
  options.materials = MaterialFiles::reference;
  options.texture = std::nullopt;
  EXPECT_TRUE(fill("out/bowl.obj", options).beside.empty());
  EXPECT_EQ(read_mesh(folder_ / "out/bowl.obj").soup.attributes->material_libraries,
            std::vector<std::string>{"../in/my skin.mtl"});
}

TEST_F(WriteScan, NoOtherFileIsReplaced) {
  write_bytes(folder_ / "out/my skin.mtl", "newmtl something else\n");
  EXPECT_THROW(fill("out/bowl.obj"), WriteError);
  EXPECT_EQ(read_bytes(folder_ / "out/my skin.mtl"), "newmtl something else\n");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/bowl.obj"));
}

/// Our own of the last time are replaced, those of others are not.
TEST_F(WriteScan, SomebodyElsesPictureStays) {
  write_bytes(folder_ / "in/filled_patch.png", "holiday");
  const auto libraries = [&] { return read_mesh(folder_ / "in/filled.obj").soup.attributes->material_libraries; };
  for (int time = 0; time < 2; ++time) {
    fill("in/filled.obj");
    EXPECT_EQ(libraries(), (std::vector<std::string>{"my skin.mtl", "filled_patch_2.mtl"}));
  }
  EXPECT_EQ(read_bytes(folder_ / "in/filled_patch.png"), "holiday");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "in/filled_patch_3.png"));
}

/// A filled scan is filled again under the same name elsewhere: its own picture of patches is not overwritten.
TEST_F(WriteScan, PatchesOfPatchesHaveTheirOwnNames) {
  fill("in/bowl_filled.obj");
  SurfaceModel model = make_surface_model(cut(read_mesh(folder_ / "in/bowl_filled.obj").soup, [](const Vec3& p) {
    return (p.head<2>() - Eigen::Vector2d(0.3, 0)).norm() < 0.2;
  }));
  fill_holes(model, {find_boundary_loops(model)[1]}, FillOptions{}, nullptr, CancelToken());
  OutputTransaction outputs;
  write_scan(outputs, folder_ / "out/bowl_filled.obj", model.soup, {});
  outputs.commit();
  const ScanAttributes scan = *read_mesh(folder_ / "out/bowl_filled.obj").soup.attributes;
  EXPECT_EQ(scan.material_libraries,
            (std::vector<std::string>{"my skin.mtl", "bowl_filled_patch.mtl", "bowl_filled_patch_2.mtl"}));
  EXPECT_EQ(scan.names[0].names, (std::vector<std::string>{"skin", "loopmend_patch", "loopmend_patch_2"}));
}

TEST_F(WriteScan, WhatIsMissingIsSaid) {
  std::filesystem::remove(folder_ / "in/pictures/a b.png");
  const WrittenScan written = fill("in/filled.obj");
  EXPECT_EQ(written.painted, 0U);
  ASSERT_EQ(written.remarks.size(), 1U);
  EXPECT_NE(written.remarks[0].english().find("a b.png"), std::string::npos);
  std::filesystem::remove(folder_ / "in/my skin.mtl");
  ASSERT_EQ(fill("in/filled2.obj").remarks.size(), 1U);
}

TEST(PictureFile, PngKeepsEveryPixelAndDamageIsRefused) {
  TemporaryFolder folder;
  Picture picture = ramp();
  picture.at(3, 4)[3] = 17;
  std::ostringstream stream;
  write_png(stream, picture);
  const std::string bytes = stream.str();
  write_bytes(folder / "a.png", bytes);
  EXPECT_EQ(read_picture(folder / "a.png").pixels, picture.pixels);
  for (std::size_t size : {std::size_t{5}, std::size_t{40}, bytes.size() / 2}) {
    write_bytes(folder / "cut.png", bytes.substr(0, size));
    EXPECT_THROW(read_picture(folder / "cut.png"), ReadError);
  }
  write_bytes(folder / "cut.jpg", "\xFF\xD8\xFF\xE0rest");
  EXPECT_THROW(read_picture(folder / "cut.jpg"), ReadError);
  write_bytes(folder / "none.tga", "no picture at all");
  EXPECT_THROW(read_picture(folder / "none.tga"), ReadError);
}

}  // namespace
}  // namespace loopmend
