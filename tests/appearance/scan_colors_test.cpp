// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/scan_colors.h"

#include "io/io_test_support.h"
#include "io/picture_file.h"
#include "io/read_mesh.h"
#include "mesh/boundary_loops.h"
#include "pipeline/initial_patch.h"
#include "samples/sample_scan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace loopmend {
namespace {

SurfaceModel model_of(const TemporaryFolder& folder, const char* name, const std::string& text) {
  std::ofstream(folder / name) << text;
  return make_surface_model(read_mesh(folder / name).soup);
}

constexpr const char* square = R"(ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
%VERTEX%element face 2
property list uchar int vertex_indices
%FACE%end_header
)";

std::string header(const std::string& vertex, const std::string& face) {
  std::string text = square;
  text.replace(text.find("%VERTEX%"), 8, vertex);
  text.replace(text.find("%FACE%"), 6, face);
  return text;
}

constexpr const char* bytes_of_color = "property uchar red\nproperty uchar green\nproperty uchar blue\n";

TEST(ScanColors, none_where_the_scan_has_none) {
  const ScanColors colors = scan_colors(make_surface_model(make_sample_scan()));
  EXPECT_TRUE(colors.at_vertices.empty());
  EXPECT_TRUE(colors.parts.empty());
}

TEST(ScanColors, of_vertices_need_no_parts) {
  const TemporaryFolder folder;
  const SurfaceModel model = model_of(
      folder, "v.ply",
      header(bytes_of_color, "") + "0 0 0 255 0 0\n1 0 0 0 255 0\n1 1 0 0 0 255\n0 1 0 9 8 7\n3 0 1 2\n3 0 2 3\n");
  const ScanColors colors = scan_colors(model);
  EXPECT_TRUE(colors.parts.empty());
  ASSERT_EQ(colors.at_vertices.size(), 4U);
  EXPECT_EQ(colors.at_vertices[3], (Color{9, 8, 7, 255}));
}

TEST(ScanColors, of_faces_part_the_vertices_between_them) {
  const TemporaryFolder folder;
  const SurfaceModel model = model_of(
      folder, "f.ply", header("", bytes_of_color) + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 200 0 0\n3 0 2 3 0 0 100\n");
  const ScanColors colors = scan_colors(model);
  ASSERT_EQ(colors.parts.size(), 1U);
  const ColoredPart& part = colors.parts.front();
  EXPECT_EQ(part.picture, nullptr);
  EXPECT_EQ(part.triangles.size(), 2U);
  EXPECT_EQ(part.view_vertex.size(), 6U) << "two vertices are shared by faces of different colours";
  EXPECT_EQ(std::count(part.colors.begin(), part.colors.end(), Color{200, 0, 0, 255}), 3);
  EXPECT_EQ(colors.at_vertices[0], (Color{100, 0, 50, 255})) << "the mean of its faces";
  EXPECT_EQ(colors.at_vertices[1], (Color{200, 0, 0, 255}));
}

TEST(ScanColors, of_faces_in_every_type_that_files_have) {
  const TemporaryFolder folder;
  const auto first_of = [&](const char* name, const std::string& text) {
    return scan_colors(model_of(folder, name, text)).at_vertices.at(1);
  };
  const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  EXPECT_EQ(first_of("s.ply", header("", "property ushort red\nproperty ushort green\nproperty ushort blue\n") +
                                  points + "3 0 1 2 65535 0 257\n3 0 2 3 0 0 0\n"),
            (Color{255, 0, 1, 255}));
  EXPECT_EQ(first_of("f.ply", header("", "property float red\nproperty float green\nproperty float blue\n") + points +
                                  "3 0 1 2 1 0 0.2\n3 0 2 3 nan 0 0\n"),
            (Color{255, 0, 51, 255}));
  EXPECT_EQ(first_of("b.off", "OFF\n4 2 0\n" + points + "3 0 1 2 255 0 51\n3 0 2 3 0 0 0\n"), (Color{255, 0, 51, 255}));
  EXPECT_EQ(first_of("r.off", "OFF\n4 2 0\n" + points + "3 0 1 2 1.0 0.0 0.2\n3 0 2 3 0 0 0\n"),
            (Color{255, 0, 51, 255}));
}

constexpr const char* textured = R"(mtllib m.mtl
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vt 0.25 0.5
vt 0.75 0.5
usemtl skin
f 1/1 2/1 3/1
usemtl paint
f 1 3 4
)";

TEST(ScanColors, of_a_picture_and_a_material) {
  const TemporaryFolder folder;
  Picture picture(2, 1);
  picture.at(0, 0) = {255, 0, 0, 255};
  picture.at(1, 0) = {0, 0, 255, 255};
  std::ofstream png(folder / "p.png", std::ios::binary);
  write_png(png, picture);
  png.close();
  std::ofstream(folder / "m.mtl") << "newmtl skin\nmap_Kd p.png\nnewmtl paint\nKd 0 1 0\n";
  const ScanColors colors = scan_colors(model_of(folder, "t.obj", textured));
  EXPECT_TRUE(colors.problems.empty());
  ASSERT_EQ(colors.parts.size(), 2U);
  const auto with_picture = std::find_if(colors.parts.begin(), colors.parts.end(),
                                         [](const ColoredPart& part) { return part.picture != nullptr; });
  ASSERT_NE(with_picture, colors.parts.end());
  EXPECT_EQ(with_picture->texture, (std::vector<float>{0.25F, 0.5F, 0.25F, 0.5F, 0.25F, 0.5F}));
  EXPECT_EQ(colors.at_vertices[1], (Color{255, 0, 0, 255})) << "sampled from the picture";
  EXPECT_EQ(colors.at_vertices[3], (Color{0, 255, 0, 255})) << "of the material";
}

TEST(ScanColors, a_missing_picture_is_told_and_the_rest_is_drawn) {
  const TemporaryFolder folder;
  std::ofstream(folder / "m.mtl") << "newmtl skin\nmap_Kd lost.png\nnewmtl paint\nKd 0 1 0\n";
  const ScanColors colors = scan_colors(model_of(folder, "t.obj", textured));
  ASSERT_EQ(colors.problems.size(), 1U);
  EXPECT_NE(colors.problems.front().english().find("lost.png"), std::string::npos);
  EXPECT_EQ(colors.at_vertices[3], (Color{0, 255, 0, 255}));
}

TEST(ScanColors, patches_go_on_within_the_range_around_them) {
  TriangleSoup soup = make_sample_scan();
  for (const Vec3& p : soup.points)
    soup.colors.push_back({static_cast<unsigned char>(std::clamp(128 + 60 * p.x(), 0.0, 255.0)), 40, 200, 255});
  const SurfaceModel model = make_surface_model(soup);
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  const auto hole =
      std::find_if(loops.begin(), loops.end(), [](const BoundaryLoop& loop) { return loop.kind == LoopKind::hole; });
  ASSERT_NE(hole, loops.end());
  const InitialPatch initial = make_initial_patch(model, {*hole}, {}, {});
  ASSERT_TRUE(initial.patch);
  const Patch& patch = *initial.patch;
  ASSERT_GT(patch.free_count, 0);
  const std::vector<Color> colors = patch_colors(patch, scan_colors(model).at_vertices);
  int low = 255, high = 0;
  for (std::size_t v = 0; v < colors.size(); ++v)
    if (patch.ring[v] == 1) {
      low = std::min<int>(low, colors[v][0]);
      high = std::max<int>(high, colors[v][0]);
    }
  for (std::size_t v = 0; v < static_cast<std::size_t>(patch.free_count); ++v) {
    EXPECT_GE(colors[v][0], low);
    EXPECT_LE(colors[v][0], high);
    EXPECT_EQ(colors[v][1], 40);
    EXPECT_EQ(colors[v][2], 200);
  }
}

}  // namespace
}  // namespace loopmend
