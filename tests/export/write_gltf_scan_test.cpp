// SPDX-License-Identifier: GPL-3.0-or-later
// A textured glTF scan is filled and written: its own bytes, and a picture for the patch.
#include "export/write_scan.h"

#include "appearance/scan_colors.h"
#include "export/ramp.h"
#include "io/gltf_test_support.h"
#include "io/io_test_support.h"
#include "io/picture_file.h"
#include "io/texture_files.h"
#include "mesh/boundary_loops.h"
#include "mesh/material_table.h"
#include "mesh/scan_attributes.h"
#include "pipeline/fill_holes.h"
#include "samples/analytic_surfaces.h"

#include <algorithm>
#include <sstream>

namespace loopmend {
namespace {

/// A bowl with a hole in its middle, its texture the view from above, cut into two charts along x = 0: the vertices there
/// are in the file twice, with other texture coordinates.
GltfFile bowl() {
  const TriangleSoup soup = cut(make_graph([](double x, double y) { return 0.3 * (x * x + y * y); }, 1, 40),
                                [](const Vec3& p) { return p.head<2>().norm() < 0.4; });
  std::string positions, texture, indices;
  std::size_t count = 0, corners = 0;
  for (const bool is_right : {false, true}) {
    std::vector<int> number(soup.points.size(), -1);
    for (const Triangle& t : soup.triangles) {
      double middle = 0;
      for (const int v : t) middle += soup.points[static_cast<std::size_t>(v)].x();
      if ((middle > 0) != is_right) continue;
      for (const int v : t) {
        int& mine = number[static_cast<std::size_t>(v)];
        if (mine < 0) {
          const Vec3& p = soup.points[static_cast<std::size_t>(v)];
          mine = static_cast<int>(count++);
          for (const double x : p) positions += GltfFile::packed({static_cast<float>(x)});
          // The right chart is one picture further: pictures are repeated.
          texture += GltfFile::packed(
              {static_cast<float>((p.x() + 1) / 2 + is_right), static_cast<float>(1 - (p.y() + 1) / 2)});
        }
        indices += GltfFile::packed({static_cast<std::uint16_t>(mine)});
        ++corners;
      }
    }
  }
  GltfFile file;
  file.primitive() = {{"attributes",
                       {{"POSITION", file.add(positions, 5126, count, "VEC3")},
                        {"TEXCOORD_0", file.add(texture, 5126, count, "VEC2")}}},
                      {"indices", file.add(indices, 5123, corners, "SCALAR")},
                      {"material", 0}};
  file.json["materials"] = {
      {{"name", "skin"},
       {"doubleSided", true},
       {"normalTexture", {{"index", 0}}},
       {"pbrMetallicRoughness", {{"roughnessFactor", 0.9}, {"baseColorTexture", {{"index", 0}}}}}}};
  file.json["textures"] = {{{"source", 0}}};
  return file;
}

std::string png_of(const Picture& picture) {
  std::ostringstream stream;
  write_png(stream, picture);
  return stream.str();
}

class WriteGltfScan : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"in", "out"}) std::filesystem::create_directories(folder_ / name);
    file_.add(png_of(ramp()), 5121, 0, "SCALAR");
    file_.json["accessors"].erase(file_.json["accessors"].size() - 1);
    file_.json["images"] = {{{"bufferView", file_.json["bufferViews"].size() - 1}, {"mimeType", "image/png"}}};
    write_bytes(folder_ / "in/bowl.glb", file_.glb());
  }

  WrittenScan fill(const std::string& to, const char* from = "in/bowl.glb") {
    SurfaceModel model = make_surface_model(read_mesh(folder_ / from).soup);
    std::vector<BoundaryLoop> holes;
    for (const BoundaryLoop& loop : find_boundary_loops(model))
      if (loop.kind == LoopKind::hole) holes.push_back(loop);
    EXPECT_EQ(holes.size(), 1U) << "the seam of the texture is no hole";
    fill_holes(model, holes, FillOptions{}, nullptr, CancelToken());
    return write_scan(folder_ / to, model.soup);
  }

  /// The picture's colour at each corner of the faces of a material is what the ramp has at its place.
  static std::size_t expect_ramp(const TriangleSoup& soup, std::size_t material) {
    const ScanAttributes& scan = *soup.attributes;
    const TextureFiles files(scan, ".");
    std::size_t count = 0;
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
      if (files.material_number_of(f) != static_cast<int>(material)) continue;
      const Picture picture = count == 0 ? files.read(*files.picture_of(f)) : Picture();
      static Picture kept;
      if (count++ == 0) kept = picture;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& p = soup.points[static_cast<std::size_t>(soup.triangles[f][k])];
        const auto at = static_cast<std::size_t>(scan.texture.at[3 * f + k]);
        const double u = scan.texture.values[2 * at], v = scan.texture.values[2 * at + 1];
        const int x = std::clamp(static_cast<int>((u - (u > 1 ? 1 : 0)) * kept.width), 0, kept.width - 1);
        const int y = std::clamp(static_cast<int>((1 - v) * kept.height), 0, kept.height - 1);
        EXPECT_NEAR(kept.at(x, y)[0], 100 * (p.x() + 1), 6);
        EXPECT_NEAR(kept.at(x, y)[1], 100 * (p.y() + 1), 6);
      }
    }
    return count;
  }

  TemporaryFolder folder_;
  GltfFile file_ = bowl();
};

TEST_F(WriteGltfScan, ThePatchIsPaintedInTheFileItself) {
  const TriangleSoup before = read_mesh(folder_ / "in/bowl.glb").soup;
  for (const char* name : {"out/bowl.glb", "out/bowl.gltf"}) {
    const WrittenScan written = fill(name);
    EXPECT_GT(written.painted, 200U);
    EXPECT_TRUE(written.remarks.empty());
    EXPECT_TRUE(written.beside.empty());
    const TriangleSoup soup = read_mesh(folder_ / name).soup;
    const MaterialTable& table = *soup.attributes->materials;
    ASSERT_EQ(table.materials.size(), 2U);
    EXPECT_EQ(table.pictures[0].bytes, png_of(ramp())) << "as it was";
    EXPECT_EQ(table.materials[0].source, before.attributes->materials->materials[0].source);
    const nlohmann::json patch = nlohmann::json::parse(table.materials[1].source);
    EXPECT_EQ(patch["name"], "loopmend_patch");
    EXPECT_EQ(patch["doubleSided"], true);
    EXPECT_EQ(patch["pbrMetallicRoughness"]["roughnessFactor"], 0.9);
    EXPECT_FALSE(patch.contains("normalTexture")) << "that of other texture coordinates";
    EXPECT_EQ(expect_ramp(soup, 0), before.triangles.size());
    EXPECT_EQ(expect_ramp(soup, 1), written.painted);
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / "out"), {}), 2);
}

/// The untouched part comes out again, vertex by vertex in its order, the seam split.
TEST_F(WriteGltfScan, TheScansOwnArraysAreInTheOutput) {
  fill("out/bowl.glb");
  const std::string bytes = read_bytes(folder_ / "out/bowl.glb");
  for (const std::size_t view : {0UL, 1UL}) {
    const nlohmann::json& where = file_.json["bufferViews"][view];
    EXPECT_NE(bytes.find(file_.buffer.substr(where["byteOffset"], where["byteLength"])), std::string::npos) << view;
  }
}

TEST_F(WriteGltfScan, ThePatchOfAPatchHasItsOwnMaterial) {
  fill("out/bowl.glb");
  TriangleSoup soup = cut(read_mesh(folder_ / "out/bowl.glb").soup,
                          [](const Vec3& p) { return (p.head<2>() - Eigen::Vector2d(0.6, 0)).norm() < 0.15; });
  SurfaceModel model = make_surface_model(std::move(soup));
  std::vector<BoundaryLoop> holes;
  for (const BoundaryLoop& loop : find_boundary_loops(model))
    if (loop.kind == LoopKind::hole) holes.push_back(loop);
  fill_holes(model, holes, FillOptions{}, nullptr, CancelToken());
  write_scan(folder_ / "out/again.glb", model.soup);
  const TriangleSoup again = read_mesh(folder_ / "out/again.glb").soup;
  ASSERT_EQ(again.attributes->materials->materials.size(), 3U);
  EXPECT_EQ(again.attributes->materials->materials[2].name, "loopmend_patch_2");
  EXPECT_GT(expect_ramp(again, 2), 10U);
}

TEST_F(WriteGltfScan, APictureBesideTheScanGoesIntoTheOutput) {
  file_.json["images"] = {{{"uri", "my%20skin.png"}}};
  write_bytes(folder_ / "in/my skin.png", png_of(ramp()));
  write_bytes(folder_ / "in/bowl.gltf", file_.text());
  fill("out/bowl.glb", "in/bowl.gltf");
  EXPECT_EQ(read_mesh(folder_ / "out/bowl.glb").soup.attributes->materials->pictures[0].bytes, png_of(ramp()));
  std::filesystem::remove(folder_ / "in/my skin.png");
  const WrittenScan without = fill("out/without.glb", "in/bowl.gltf");
  EXPECT_EQ(without.painted, 0U);
  ASSERT_FALSE(without.remarks.empty());
  EXPECT_NE(without.remarks.front().english().find("my skin.png"), std::string::npos);
  EXPECT_TRUE(read_mesh(folder_ / "out/without.glb").soup.attributes->materials->pictures.empty());
}

TEST_F(WriteGltfScan, ItsColorsAreDrawn) {
  const SurfaceModel model = make_surface_model(read_mesh(folder_ / "in/bowl.glb").soup);
  const ScanColors colors = scan_colors(model);
  EXPECT_TRUE(colors.problems.empty());
  ASSERT_EQ(colors.parts.size(), 1U);
  EXPECT_EQ(colors.parts[0].picture->width, 200);
  for (std::size_t v = 0; v < colors.at_vertices.size(); ++v) {
    const Vec3& p = model.soup.points[static_cast<std::size_t>(model.soup_vertex[v])];
    if (std::abs(p.x()) > 0.95 || std::abs(p.y()) > 0.95) continue;  // there the picture is repeated
    EXPECT_NEAR(colors.at_vertices[v][0], 100 * (p.x() + 1), 3);
  }
  file_.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0.5, 0, 1}}}}}};
  write_bytes(folder_ / "in/plain.glb", file_.glb());
  EXPECT_EQ(scan_colors(make_surface_model(read_mesh(folder_ / "in/plain.glb").soup)).at_vertices[0],
            (Color{255, 188, 0, 255}));
}

}  // namespace
}  // namespace loopmend
