// SPDX-License-Identifier: GPL-3.0-or-later
// From every format to every other: what a file holds beside the shape is in the output, or it is named.
#include "export/ramp.h"
#include "export/write_scan.h"

#include "io/gltf_test_support.h"
#include "io/io_test_support.h"
#include "io/picture_file.h"
#include "io/texture_files.h"
#include "mesh/scan_attributes.h"

#include <fstream>
#include <set>
#include <string>
#include <vector>

namespace loopmend {
namespace {

const std::string ply_text =
    "ply\nformat ascii 1.0\ncomment measured by hand\ncomment TextureFile skin.png\nobj_info 3 parts\nelement vertex "
    "4\n"
    "property float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float quality\nproperty list uchar int "
    "seen\n"
    "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\nproperty uchar red\n"
    "property uchar green\nproperty uchar blue\nproperty short label\nelement camera 1\nproperty float "
    "view\nend_header\n"
    "0 0 0 0 0 1 1 2 3 0.5 0\n1 0 0 0 0 1 4 5 6 0.25 1 7\n0 1 0 0 0 1 7 8 9 0 0\n1 1 0 0 0 1 7 8 9 0 0\n"
    "3 0 1 2 6 0 0 1 0 0 1 9 9 9 4\n3 1 3 2 6 1 0 1 1 0 1 8 8 8 5\n3.5\n";
/// Texture coordinates of vertices, under the names that programs use.
std::string ply_with_vertex_texture(const std::string& s, const std::string& t) {
  return "ply\nformat ascii 1.0\ncomment TextureFile skin.png\nelement vertex 4\nproperty float x\nproperty float y\n"
         "property float z\nproperty float " +
         s + "\nproperty float " + t +
         "\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
         "0 0 0 0 0\n1 0 0 1 0.25\n0 1 0 0 1\n1 1 0 1 1\n3 0 1 2\n3 1 3 2\n";
}
const std::string obj_text =
    "mtllib skin.mtl\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nv 1 1 0 1 1 1\nvt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\nvn 0 "
    "0 1\n"
    "o thing\ng left\nusemtl skin\ns 1\nf 1/1/1 2/2/1 3/3/1\ng right\ns 2\nf 2/2/1 4/4/1 3/3/1\n";
/// A face with a picture and one without, a vertex colour at some vertices alone, and what is no face.
const std::string mixed_obj_text =
    "mtllib skin.mtl\nv 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 5 5 5\nvt 0 0\nvt 1 0\nvt 0 1\n"
    "usemtl skin\nf 1/1 2/2 3/3\nf 2 4 3\nusemtl of_no_face\np 5\nl 1 2\n";
/// With what others write beside a picture: colours, a tangent, a second set of coordinates, a camera and a skin.
std::string glb_with_colors() {
  GltfFile file = gltf_square();
  using F = GltfFile;
  nlohmann::json& attributes = file.primitive()["attributes"];
  attributes["COLOR_0"] =
      file.add(F::packed<float>({1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 1, 0.5F}), 5126, 4, "VEC4");
  attributes["TANGENT"] = file.add(F::packed<float>({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}), 5126, 4, "VEC4");
  attributes["TEXCOORD_1"] = file.add(F::packed<float>({0, 0, 0, 0, 0, 0, 0, 0}), 5126, 4, "VEC2");
  attributes["_AGE"] = file.add(F::packed<float>({1, 2, 3, 4}), 5126, 4, "SCALAR");
  file.json["asset"]["copyright"] = "A museum";
  file.json["cameras"] = {{{"type", "perspective"}}};
  return file.glb();
}
const std::string off_text =
    "STCNOFF\n4 2 0\n0 0 0 0 0 1 255 0 0 255 0 0\n1 0 0 0 0 1 0 255 0 255 1 0\n0 1 0 0 0 1 0 0 255 255 0 1\n"
    "1 1 0 0 0 1 9 9 9 255 1 1\n3 0 1 2 255 0 0\n3 1 3 2 0 0 255\n";
const std::string facets_a =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
const std::string facets_b =
    "facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n";

std::string binary_stl() {
  std::string bytes = "COLOR=abcd of the part";
  bytes.resize(80, ' ');
  const std::uint32_t count = 1;
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  const float values[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  bytes.append(reinterpret_cast<const char*>(values), sizeof values);
  return bytes + "\x1f\x80";
}

class FormatPairs : public ::testing::Test {
 protected:
  FormatPairs() {
    write_bytes(folder_ / "rich.ply", ply_text);
    write_bytes(folder_ / "st.ply", ply_with_vertex_texture("s", "t"));
    write_bytes(folder_ / "uv.ply", ply_with_vertex_texture("texture_u", "texture_v"));
    write_bytes(folder_ / "rich.obj", obj_text);
    write_bytes(folder_ / "skin.mtl", "newmtl skin\nKd 1 1 1\nNs 10\nmap_Kd skin.png\n");
    write_bytes(folder_ / "mixed.obj", mixed_obj_text);
    write_bytes(folder_ / "colors.glb", glb_with_colors());
    write_bytes(folder_ / "rich.off", off_text);
    write_bytes(folder_ / "text.stl", "solid a\n" + facets_a + "endsolid\nsolid b\n" + facets_b + "endsolid\n");
    write_bytes(folder_ / "binary.stl", binary_stl());
    std::ofstream picture(folder_ / "skin.png", std::ios::binary);
    write_png(picture, ramp());
    picture.close();
    for (const char* name : {"rich.glb", "rich.gltf", "rich.3mf"}) {
      TriangleSoup soup = read_mesh(folder_ / "rich.obj").soup;
      write_scan(folder_ / name, soup);
    }
    if (!has_polydata()) return;
    for (const char* name : {"rich.vtp", "rich.vtk"}) {
      TriangleSoup soup = read_mesh(folder_ / "rich.ply").soup;
      write_scan(folder_ / name, soup);
    }
  }

  /// A build without VTK has none.
  static bool has_polydata() {
    try {
      check_mesh_writable(std::filesystem::temp_directory_path() / "x.vtp");
      return true;
    } catch (const WriteError&) {
      return false;
    }
  }

  static std::set<std::string> names_in(const std::vector<NotKept>& list) {
    std::set<std::string> names;
    for (const NotKept& entry : list) names.insert(in_other_words(entry.what.english()));
    return names;
  }

  /// The same data are called otherwise where a format has only its own name for them.
  static std::string in_other_words(const std::string& what) {
    if (what == "texture coordinates of faces") return "texture coordinates";
    if (what == "face properties \"attribute\"") return "face attributes";
    if (what == "face properties \"color\"") return "face colours";
    if (what == "pictures of materials" || what == "material libraries") return "pictures";
    return what;
  }

  /// Whether the faces have a picture that can be read.
  static bool shows_a_picture(const TriangleSoup& soup) {
    const TextureFiles files(*soup.attributes, soup.attributes->file.parent_path());
    const auto path = files.picture_of(0);
    const auto has_vertex = [&](const char* name) { return find_column(soup.attributes->points, name) != nullptr; };
    const bool has_coordinates =
        soup.attributes->texture.count() > 0 || (has_vertex("s") && has_vertex("t")) || has_vertex("texture_v");
    return path && files.read(*path).width == ramp().width && has_coordinates;
  }

  TemporaryFolder folder_;
};

TEST_F(FormatPairs, NothingIsLostWithoutAWord) {
  for (const char* from : {"rich.ply", "st.ply", "uv.ply", "rich.obj", "mixed.obj", "rich.off", "rich.glb", "rich.gltf",
                           "colors.glb", "rich.3mf", "text.stl", "binary.stl", "rich.vtp", "rich.vtk"})
    for (const char* to :
         {"out.ply", "out.obj", "out.off", "out.glb", "out.gltf", "out.3mf", "out.stl", "out.vtp", "out.vtk"}) {
      if (!has_polydata() && std::string(from + std::string(to)).find(".vt") != std::string::npos) continue;
      SCOPED_TRACE(std::string(from) + " to " + to);
      const TriangleSoup before = read_mesh(folder_ / from).soup;
      TriangleSoup soup = before;
      const WrittenScan written = write_scan(folder_ / to, soup);
      EXPECT_TRUE(written.remarks.empty());
      const TriangleSoup after = read_mesh(folder_ / to).soup;
      EXPECT_EQ(after.triangles.size(), before.triangles.size());
      const std::set<std::string> named = names_in(not_kept_by_format(folder_ / to, soup));
      const std::set<std::string> kept = names_in(carried_attributes(after));
      for (const std::string& what : names_in(carried_attributes(before))) {
        if (what == "pictures" || what.rfind("unit", 0) == 0) continue;
        EXPECT_TRUE(named.contains(what) || kept.contains(what)) << what;
      }
      EXPECT_TRUE(before.colors.empty() || named.contains("vertex colours") || !after.colors.empty());
      EXPECT_TRUE(!shows_a_picture(before) || named.contains("pictures") || shows_a_picture(after));
      std::filesystem::remove(folder_ / to);
    }
}

/// What the reader itself leaves out is counted, whatever is written later.
TEST_F(FormatPairs, WhatTheReaderLeavesOutIsNamed) {
  const auto left_out = [&](const char* from) { return names_in(read_mesh(folder_ / from).report.not_kept); };
  EXPECT_EQ(left_out("mixed.obj"), (std::set<std::string>{"lines", "names of no face", "points"}));
  EXPECT_EQ(left_out("colors.glb"),
            (std::set<std::string>{"cameras", "vertex attributes \"TANGENT\"", "vertex attributes \"TEXCOORD_1\"",
                                   "vertex attributes \"_AGE\""}));
}

/// What can be in a file that holds pictures is in it.
TEST_F(FormatPairs, PicturesOfPlyAndObjGoIntoGltf) {
  for (const char* from : {"rich.ply", "rich.obj"})
    for (const char* to : {"out.glb", "out.gltf"}) {
      SCOPED_TRACE(std::string(from) + " to " + to);
      TriangleSoup soup = read_mesh(folder_ / from).soup;
      write_scan(folder_ / to, soup);
      std::filesystem::rename(folder_ / "skin.png", folder_ / "elsewhere.png");  // the output has its own
      const TriangleSoup after = read_mesh(folder_ / to).soup;
      EXPECT_TRUE(shows_a_picture(after));
      const TextureFiles files(*after.attributes, folder_.path());
      EXPECT_EQ(files.read(*files.picture_of(1)).pixels, ramp().pixels);
      for (std::size_t k = 0; k < 3; ++k) {  // texture coordinates are the places, as in both files
        const auto at = 2 * static_cast<std::size_t>(after.attributes->texture.at[3 + k]);
        const Vec3& p = after.points[after.triangles[1][k]];
        EXPECT_EQ(after.attributes->texture.values[at], p.x());
        EXPECT_EQ(after.attributes->texture.values[at + 1], p.y());
      }
      std::filesystem::rename(folder_ / "elsewhere.png", folder_ / "skin.png");
    }
}

/// Coordinates of vertices, not of corners.
TEST_F(FormatPairs, TextureCoordinatesOfVerticesGoIntoGltf) {
  for (const char* from : {"st.ply", "uv.ply"})
    for (const char* to : {"out.glb", "out.gltf"}) {
      SCOPED_TRACE(std::string(from) + " to " + to);
      TriangleSoup soup = read_mesh(folder_ / from).soup;
      write_scan(folder_ / to, soup);
      EXPECT_TRUE(not_kept_by_format(folder_ / to, soup).empty());
      const TriangleSoup after = read_mesh(folder_ / to).soup;
      EXPECT_TRUE(shows_a_picture(after));
      const CornerValues& texture = after.attributes->texture;
      ASSERT_EQ(texture.at.size(), 6U);
      for (std::size_t corner = 0; corner < 6; ++corner) {  // as t is of the vertices (0, 0), (1, 0), (0, 1) and (1, 1)
        const Vec3& p = after.points[static_cast<std::size_t>(after.triangles[corner / 3][corner % 3])];
        const auto at = static_cast<std::size_t>(texture.at[corner]);
        EXPECT_FLOAT_EQ(static_cast<float>(texture.values[2 * at]), static_cast<float>(p.x()));
        EXPECT_FLOAT_EQ(static_cast<float>(texture.values[2 * at + 1]), p.y() > 0 ? 1.0F : p.x() > 0 ? 0.25F : 0.0F);
      }
    }
}

/// glTF asks for texture coordinates wherever a material has pictures.
TEST_F(FormatPairs, TrianglesWithoutTextureCoordinatesGetTheMaterialWithoutItsPictures) {
  TriangleSoup soup = read_mesh(folder_ / "mixed.obj").soup;
  write_scan(folder_ / "out.gltf", soup);
  const nlohmann::json json = nlohmann::json::parse(read_bytes(folder_ / "out.gltf"));
  ASSERT_EQ(json["meshes"][0]["primitives"].size(), 2U);
  ASSERT_EQ(json["materials"].size(), 3U);
  for (const nlohmann::json& primitive : json["meshes"][0]["primitives"]) {
    const nlohmann::json& material = json["materials"].at(primitive["material"].get<std::size_t>());
    const bool has_coordinates = primitive["attributes"].contains("TEXCOORD_0");
    EXPECT_EQ(material["pbrMetallicRoughness"].contains("baseColorTexture"), has_coordinates);
    EXPECT_EQ(material["name"], has_coordinates ? "skin" : "skin_without_picture");
  }
  soup = read_mesh(folder_ / "out.gltf").soup;  // once only
  write_scan(folder_ / "again.gltf", soup);
  EXPECT_EQ(nlohmann::json::parse(read_bytes(folder_ / "again.gltf"))["materials"].size(), 3U);
}

TEST_F(FormatPairs, APictureThatIsNotThereOrOfAnotherKindIsNamed) {
  for (const char* from : {"rich.ply", "rich.obj"}) {
    SCOPED_TRACE(from);
    std::filesystem::rename(folder_ / "skin.png", folder_ / "elsewhere.png");
    TriangleSoup soup = read_mesh(folder_ / from).soup;
    WrittenScan written = write_scan(folder_ / "out.glb", soup);
    ASSERT_EQ(written.remarks.size(), 1U);
    EXPECT_NE(written.remarks[0].english().find("skin.png is not there, and not in the output"), std::string::npos);
    write_bytes(folder_ / "skin.png", "BM and more bytes of a bitmap");
    soup = read_mesh(folder_ / from).soup;
    written = write_scan(folder_ / "out.glb", soup);
    ASSERT_EQ(written.remarks.size(), 1U);
    EXPECT_NE(written.remarks[0].english().find("skin.png is neither PNG nor JPEG"), std::string::npos);
    std::filesystem::rename(folder_ / "elsewhere.png", folder_ / "skin.png");
  }
}

}  // namespace
}  // namespace loopmend
