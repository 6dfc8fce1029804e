// SPDX-License-Identifier: GPL-3.0-or-later
#include "gltf_test_support.h"
#include "io_test_support.h"
#include "mesh/boundary_loops.h"
#include "mesh/material_table.h"
#include "mesh/scan_attributes.h"

#include <cstdint>
#include <limits>

namespace loopmend {
namespace {

using Json = nlohmann::json;

class ReadGltf : public ReadTest {
 protected:
  ImportedMesh read_glb(const GltfFile& file) { return read(file.glb(), "a.glb"); }
  void expect_refused_both(const GltfFile& file, std::initializer_list<const char*> words) {
    expect_refused(file.glb(), "a.glb", words);
    expect_refused(file.text(), "a.gltf", words);
  }
};

TEST_F(ReadGltf, EveryContainerHoldsTheSame) {
  const GltfFile square = gltf_square();
  write_bytes(folder_ / "my buffer.bin", square.buffer);
  for (const auto& [bytes, name] :
       {std::pair(square.glb(), "a.glb"), std::pair(square.text(), "a.gltf"),
        std::pair(square.text_with("my%20buffer.bin"), "b.gltf"), std::pair("\xEF\xBB\xBF" + square.text(), "c.dat")}) {
    const ImportedMesh mesh = read(bytes, name);
    expect_valid(mesh);
    EXPECT_EQ(mesh.report.format, "glTF");
    EXPECT_TRUE(same_bits(mesh.soup.points, {{0, 0, static_cast<double>(0.1F)}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.soup.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(mesh.soup.attributes->coordinates, ScalarType::float32);
    EXPECT_EQ(mesh.soup.attributes->texture.values, (std::vector<double>{0, 0, 1, 0, 1, 1, 0, 1})) << "v upward";
    EXPECT_EQ(mesh.soup.attributes->texture.at, (std::vector<int>{0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(mesh.soup.attributes->unit, "meter");
    EXPECT_TRUE(mesh.report.not_kept.empty());
  }
}

TEST_F(ReadGltf, IndicesOfEachKindOrNone) {
  for (const int type : {5121, 5123, 5125, 0}) {
    GltfFile file = gltf_square();
    if (type == 5121)
      file.primitive()["indices"] = file.add(GltfFile::packed<std::uint8_t>({3, 2, 0}), 5121, 3, "SCALAR");
    if (type == 5123)
      file.primitive()["indices"] = file.add(GltfFile::packed<std::uint16_t>({3, 2, 0}), 5123, 3, "SCALAR");
    if (type == 5125)
      file.primitive()["indices"] = file.add(GltfFile::packed<std::uint32_t>({3, 2, 0}), 5125, 3, "SCALAR");
    if (type == 0) {
      file.primitive().erase("indices");
      file.json["accessors"][0]["count"] = file.json["accessors"][2]["count"] = 3;
    }
    const ImportedMesh mesh = read_glb(file);
    EXPECT_EQ(mesh.soup.points.size(), 3U) << type;
    EXPECT_EQ(mesh.soup.triangles, (Triangles{type == 0 ? Triangle{0, 1, 2} : Triangle{2, 1, 0}})) << type;
    EXPECT_EQ(to_string(mesh.report.not_kept), type == 0 ? "" : "vertices without faces (1)");
  }
}

TEST_F(ReadGltf, StripsAndFansBecomeTriangles) {
  GltfFile file = gltf_square();
  file.primitive()["indices"] = file.add(GltfFile::packed<std::uint16_t>({0, 1, 3, 2, 2}), 5123, 5, "SCALAR");
  file.primitive()["mode"] = 5;
  EXPECT_EQ(read_glb(file).soup.triangles, (Triangles{{0, 1, 3}, {1, 2, 3}})) << "the last triangle only leads on";
  file.primitive()["mode"] = 6;
  file.primitive()["indices"] = 1;
  file.json["accessors"][1]["count"] = 5;
  file.buffer.replace(48, 10, GltfFile::packed<std::uint16_t>({0, 1, 2, 3, 1}));
  EXPECT_EQ(read_glb(file).soup.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}));
  file.json["meshes"][0]["primitives"].push_back(file.primitive());
  file.primitive(0, 1)["mode"] = 1;
  EXPECT_EQ(to_string(read_glb(file).report.not_kept), "primitives of points and lines (1)");
}

/// Every edge of a texture's seam is two edges in the file; for the holes it is none.
TEST_F(ReadGltf, VerticesAtTheSamePlaceAreOne) {
  GltfFile file;
  const std::size_t positions =
      file.add(GltfFile::packed<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, -0.0F, 0, 1, 1, 0, 0, 1, 0}), 5126, 6, "VEC3");
  const std::size_t texture =
      file.add(GltfFile::packed<float>({0, 0, 0.4F, 0, 0.4F, 1, 0.6F, 0, 1, 0, 1, 1}), 5126, 6, "VEC2");
  file.primitive() = {{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", texture}}}};
  const ImportedMesh mesh = read_glb(file);
  EXPECT_EQ(mesh.soup.points.size(), 4U);
  EXPECT_EQ(mesh.report.vertices_welded, 2U);
  EXPECT_EQ(mesh.soup.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(mesh.soup.attributes->texture.count(), 6U);
  EXPECT_EQ(mesh.soup.attributes->texture.at, (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(find_boundary_loops(make_surface_model(mesh.soup)).size(), 1U);
}

TEST_F(ReadGltf, NodesPutTheirMeshesInPlace) {
  GltfFile file = gltf_square();
  file.json["nodes"] = {{{"mesh", 0}, {"name", "first"}},
                        {{"children", {2}}, {"translation", {10, 0, 0}}, {"scale", {2, 2, 2}}},
                        {{"mesh", 0}, {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}}},
                        {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 5, 1}}}};
  file.json["scenes"] = {{{"nodes", {3}}}, {{"nodes", {0, 1, 3}}}};
  file.json["scene"] = 1;
  const ImportedMesh mesh = read_glb(file);
  ASSERT_EQ(mesh.soup.points.size(), 12U);
  EXPECT_EQ(mesh.soup.points[1], Vec3(1, 0, 0));
  EXPECT_LT((mesh.soup.points[5] - Vec3(10, 2, 0)).norm(), 1e-12) << "turned by 90 degrees, scaled, moved";
  EXPECT_EQ(mesh.soup.points[9], Vec3(1, 0, 5));
  EXPECT_EQ(mesh.soup.triangles[4], (Triangle{8, 10, 9})) << "a mirror image is turned round";
  ASSERT_EQ(mesh.soup.attributes->names.size(), 1U);
  EXPECT_EQ(mesh.soup.attributes->names[0].names, (std::vector<std::string>{"first", "object_1", "object_2"}));
  EXPECT_EQ(mesh.soup.attributes->names[0].of_face, (std::vector<int>{0, 0, 1, 1, 2, 2}));
  EXPECT_EQ(to_string(mesh.report.not_kept), "transforms of nodes, which are applied (2)");
  file.json.erase("scene");
  EXPECT_EQ(read_glb(file).soup.points.size(), 4U);
}

TEST_F(ReadGltf, NormalsTurnWithTheirNode) {
  GltfFile file = gltf_square();
  file.primitive()["attributes"]["NORMAL"] = file.add(
      GltfFile::packed<std::int8_t>({0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0}), 5120, 4, "VEC3");
  file.json["accessors"].back()["normalized"] = true;
  file.json["bufferViews"].back()["byteStride"] = 4;
  file.json["nodes"] = {{{"mesh", 0}, {"rotation", {0, std::sqrt(0.5), 0, std::sqrt(0.5)}}, {"scale", {1, 1, 7}}}};
  const CornerValues normals = read_glb(file).soup.attributes->normals;
  ASSERT_EQ(normals.count(), 4U);
  EXPECT_NEAR(normals.values[0], 1, 1e-12);
  EXPECT_NEAR(normals.values[2], 0, 1e-12);
}

/// 0.5 linear is 188 in sRGB (IEC 61966-2-1).
TEST_F(ReadGltf, ColorsBecomeSrgb) {
  GltfFile file = gltf_square();
  auto& attributes = file.primitive()["attributes"];
  attributes["COLOR_0"] = file.add(GltfFile::packed<float>({0, 0.5F, 1, 1, 1, 1, 0, 0, 0, 2, -1, 0}), 5126, 4, "VEC3");
  EXPECT_EQ(read_glb(file).soup.colors,
            (std::vector<Color>{{0, 188, 255, 255}, {255, 255, 255, 255}, {0, 0, 0, 255}, {255, 0, 0, 255}}));
  attributes["COLOR_0"] = file.add(
      GltfFile::packed<std::uint16_t>({0, 0, 65535, 32768, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), 5123, 4, "VEC4");
  const ImportedMesh mesh = read_glb(file);
  EXPECT_EQ(mesh.soup.colors[0], (Color{0, 0, 255, 128})) << "alpha is no light";
  EXPECT_TRUE(mesh.report.has_colors);
}

TEST_F(ReadGltf, MaterialsAndPicturesAreKept) {
  GltfFile file = gltf_square();
  file.json["materials"] = {
      {{"name", "skin"},
       {"doubleSided", true},
       {"pbrMetallicRoughness", {{"baseColorFactor", {1, 0.5, 0, 1}}, {"baseColorTexture", {{"index", 0}}}}},
       {"occlusionTexture", {{"index", 0}, {"texCoord", 1}}}},
      Json::object()};
  file.json["textures"] = {{{"source", 1}}};
  file.json["images"] = {{{"uri", "../secret.png"}}, {{"uri", "data:image/png;base64,iVBORw=="}}};
  file.primitive()["material"] = 0;
  const ImportedMesh mesh = read_glb(file);
  const MaterialTable& table = *mesh.soup.attributes->materials;
  ASSERT_EQ(table.materials.size(), 2U);
  EXPECT_EQ(table.materials[0].picture, 1);
  EXPECT_EQ(table.materials[0].color, (Color{255, 188, 0, 255}));
  EXPECT_EQ(Json::parse(table.materials[0].source)["doubleSided"], true);
  EXPECT_FALSE(Json::parse(table.materials[0].source).contains("occlusionTexture"));
  EXPECT_EQ(table.materials[1].name, "material_1");
  EXPECT_NE(table.pictures[0].problem.english().find("outside the folder"), std::string::npos);
  EXPECT_EQ(table.pictures[1].bytes, "\x89PNG");
  EXPECT_EQ(to_string(mesh.report.not_kept), "pictures of materials at further texture coordinates (1)");
}

// -- Hostile files -----------------------------------------------------------------------------------------------------

TEST_F(ReadGltf, DamagedContainers) {
  const std::string glb = gltf_square().glb();
  expect_refused("glTF", "a.glb", {"ends too early"});
  for (const std::size_t size : {std::size_t{19}, std::size_t{100}, glb.size() - 1})
    expect_refused(glb.substr(0, size), "a.glb", {"ends too early"});
  std::string bytes = glb;
  bytes[4] = 1;
  expect_refused(bytes, "a.glb", {"version 1 of GLB"});
  bytes = glb;
  bytes[15] = '\x7F';
  expect_refused(bytes, "a.glb", {"chunk 0 says"});
  expect_refused(GltfFile::glb_of("{\"asset\":{\"version\":\"2.0\"}", ""), "a.glb", {"JSON text", "damaged", "byte"});
  expect_refused("{}", "a.gltf", {"\"asset\" is missing"});
  expect_refused("{\"asset\":{\"version\":\"1.0\"}}", "a.gltf", {"version \"1.0\""});
  expect_refused("{\"asset\":{\"version\":\"2.0\"}}", "a.gltf", {"no points and no faces"});
  expect_refused("{\"asset\":{\"version\":\"2.0\"},\"x\":1e999}", "a.gltf", {"too large"});
  expect_refused(std::string(200000, '{'), "a.gltf", {"JSON"});
  expect_refused("{\"asset\":{\"version\":\"2.0\"},\"x\":" + std::string(200000, '['), "a.gltf",
                 {"nested more than 64 deep"});
}

TEST_F(ReadGltf, NumbersOutsideTheirBuffer) {
  const auto refused = [&](const char* list, std::size_t index, const char* name, const Json& value,
                           std::initializer_list<const char*> words) {
    GltfFile file = gltf_square();
    file.json[list][index][name] = value;
    expect_refused_both(file, words);
  };
  refused("accessors", 0, "count", 5, {"accessor 0", "5"});
  refused("accessors", 0, "count", 9007199254740992, {"accessor 0"});
  refused("accessors", 0, "count", -1, {"\"count\"", "accessor 0"});
  refused("accessors", 0, "count", 1.5, {"\"count\""});
  refused("accessors", 0, "count", "4", {"\"count\""});
  refused("accessors", 0, "byteOffset", 1, {"accessor 0"});
  refused("accessors", 0, "byteOffset", 9007199254740991, {"accessor 0"});
  refused("accessors", 0, "componentType", 5124, {"unknown type"});
  refused("accessors", 0, "type", "MAT4", {"unknown type"});
  refused("accessors", 0, "type", "VEC2", {"POSITION has 2 numbers"});
  refused("accessors", 0, "bufferView", 7, {"element 7 of \"bufferViews\""});
  refused("accessors", 0, "sparse", Json::object(), {"accessor 0, sparse", "is missing"});
  refused("accessors", 1, "componentType", 5126, {"accessor 1"});
  refused("accessors", 1, "count", 5, {"three for each triangle"});
  refused("accessors", 2, "count", 3, {"3 elements for 4 positions"});
  refused("bufferViews", 0, "byteStride", 4, {"12 bytes", "4 bytes apart"});
  refused("bufferViews", 0, "byteStride", 1000, {"1000 bytes apart"});
  refused("bufferViews", 0, "byteStride", 16, {"accessor 0"});
  refused("bufferViews", 0, "byteOffset", 4000000000, {"buffer view 0"});
  refused("bufferViews", 0, "byteLength", 9007199254740992, {"buffer view 0"});
  refused("bufferViews", 0, "buffer", 1, {"element 1 of \"buffers\""});
}

TEST_F(ReadGltf, SparseListsOutsideTheirAccessor) {
  const auto refused = [&](const char* list, const char* name, const Json& value,
                           std::initializer_list<const char*> words) {
    GltfFile file = gltf_square();
    const std::size_t which = file.add(GltfFile::packed<std::uint8_t>({3}), 5121, 1, "SCALAR");
    const std::size_t what = file.add(GltfFile::packed<float>({0, 1, 0}), 5126, 1, "VEC3");
    Json sparse = {{"count", 1},
                   {"indices", {{"bufferView", which}, {"componentType", 5121}}},
                   {"values", {{"bufferView", what}}}};
    file.json["accessors"][0]["sparse"] = sparse;
    EXPECT_EQ(read_glb(file).soup.points.size(), 4U);
    (list[0] == '\0' ? sparse : sparse[list])[name] = value;
    file.json["accessors"][0]["sparse"] = sparse;
    expect_refused_both(file, words);
  };
  refused("", "count", 2, {"announces 2", "accessor 0, sparse"});
  refused("", "count", 9007199254740992, {"announces 9007199254740992"});
  refused("", "values", Json::object(), {"\"bufferView\" is missing"});
  refused("indices", "componentType", 5126, {"no unsigned numbers"});
  refused("indices", "bufferView", 9, {"element 9 of \"bufferViews\""});
  refused("values", "byteOffset", 4, {"announces 1", "sparse, byte 4 of 12"});
  GltfFile file = gltf_square();
  const std::size_t which = file.add(GltfFile::packed<std::uint8_t>({4}), 5121, 1, "SCALAR");
  file.json["accessors"][0]["sparse"] = {
      {"count", 1}, {"indices", {{"bufferView", which}, {"componentType", 5121}}}, {"values", {{"bufferView", 0}}}};
  expect_refused_both(file, {"replaces element 4", "there are 4, from 0 on"});
}

/// A few bytes asked for gigabytes of zeros.
TEST_F(ReadGltf, SparseListsTakeNoMoreThanTheFileIsWorth) {
  GltfFile file = gltf_square();
  const std::size_t which = file.add(GltfFile::packed<std::uint8_t>({0}), 5121, 1, "SCALAR");
  Json accessor = {{"componentType", 5126}, {"type", "VEC3"}, {"count", 3'000'000}};
  accessor["sparse"] = {
      {"count", 1}, {"indices", {{"bufferView", which}, {"componentType", 5121}}}, {"values", {{"bufferView", 0}}}};
  for (int k = 0; k < 2; ++k) {
    file.json["accessors"].push_back(accessor);
    Json primitive = file.primitive();
    primitive["attributes"] = {{"POSITION", file.json["accessors"].size() - 1}};
    if (k == 1) file.json["meshes"][0]["primitives"].push_back(primitive);
  }
  EXPECT_EQ(read_glb(file).soup.triangles.size(), 4U) << "one of them is asked for";
  Json primitive = file.primitive();
  primitive["attributes"]["POSITION"] = file.json["accessors"].size() - 2;
  primitive["attributes"].erase("TEXCOORD_0");
  file.json["meshes"][0]["primitives"].push_back(primitive);
  expect_refused_both(file, {"announces 3000000 elements"});
}

TEST_F(ReadGltf, IndicesAndCoordinatesThatAreNone) {
  GltfFile file = gltf_square();
  file.buffer.replace(52, 2, GltfFile::packed<std::uint16_t>({4}));
  expect_refused_both(file, {"vertex 4", "there are 4", "mesh 0, primitive 0"});
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    file = gltf_square();
    file.buffer.replace(12, 4, GltfFile::packed<float>({bad}));
    expect_refused_both(file, {"vertex 1", "not a finite number"});
  }
  file = gltf_square();
  file.json["nodes"] = {{{"mesh", 0}, {"scale", {1e300, 1, 1}}, {"children", {1}}},
                        {{"mesh", 0}, {"scale", {1e300, 1, 1}}}};
  file.json["scenes"] = {{{"nodes", {0}}}};
  expect_refused_both(file, {"too large"});
}

TEST_F(ReadGltf, NodesThatAreNoTree) {
  GltfFile file = gltf_square();
  file.json["nodes"] = {{{"children", {1}}}, {{"children", {0}}, {"mesh", 0}}};
  expect_refused_both(file, {"circles"});
  file.json["scenes"] = {{{"nodes", {0}}}};
  expect_refused_both(file, {"node 0", "tree"});
  file.json["nodes"] = {{{"mesh", 0}}};
  file.json["scenes"] = {{{"nodes", {0, 1}}}};
  expect_refused_both(file, {"a node that is not there"});
  file.json["scenes"] = {{{"nodes", {0}}}};
  file.json["nodes"] = {{{"mesh", 3}}};
  expect_refused_both(file, {"element 3 of \"meshes\""});
  file.json["nodes"] = {{{"mesh", 0}, {"matrix", {1, 2}}}};
  expect_refused_both(file, {"\"matrix\" has 2 numbers"});
  // As deep as it likes: no recursion.
  file.json["nodes"] = Json::array();
  for (int k = 0; k < 100000; ++k) file.json["nodes"].push_back({{"children", {k + 1}}});
  file.json["nodes"].push_back({{"mesh", 0}});
  EXPECT_EQ(read_glb(file).soup.triangles.size(), 2U);
}

/// A few bytes that ask for billions of triangles.
TEST_F(ReadGltf, TheSameTrianglesAgainAndAgain) {
  GltfFile file = gltf_square();
  std::string indices;
  for (int k = 0; k < 30000; ++k) indices += GltfFile::packed<std::uint8_t>({0, 1, 2});
  file.primitive()["indices"] = file.add(indices, 5121, 90000, "SCALAR");
  for (int k = 0; k < 2000; ++k) file.json["nodes"].push_back({{"mesh", 0}});
  expect_refused_both(file, {"again and again", "fewer instances"});
}

TEST_F(ReadGltf, FilesElsewhereAreNotRead) {
  write_bytes(folder_.path().parent_path() / "loopmend_outside.bin", gltf_square().buffer);
  for (const std::string uri : {"../loopmend_outside.bin", "%2e%2e/loopmend_outside.bin", "..\\loopmend_outside.bin",
                                "a/../../loopmend_outside.bin", "/etc/passwd"})
    expect_refused(gltf_square().text_with(uri), "a.gltf", {"outside the folder", "buffer 0"});
  for (const std::string uri : {"http://example.org/a.bin", "file:///etc/passwd", "C:\\a.bin"})
    expect_refused(gltf_square().text_with(uri), "a.gltf", {"not beside the file"});
  expect_refused(gltf_square().text_with("none.bin"), "a.gltf", {"\"none.bin\" cannot be read", "beside the file"});
  expect_refused(gltf_square().text_with("%zz"), "a.gltf", {"names no file"});
  expect_refused(gltf_square().text_with("data:,abc"), "a.gltf", {"base64"});
  expect_refused(gltf_square().text_with("data:;base64,a?b="), "a.gltf", {"damaged"});
  expect_refused(gltf_square().text_with("data:;base64,AAAA"), "a.gltf", {"announces", "there are 3"});
  std::filesystem::remove(folder_.path().parent_path() / "loopmend_outside.bin");
}

TEST_F(ReadGltf, CompressedMeshesAreRefusedWithAReason) {
  for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
    GltfFile file = gltf_square();
    file.json["extensionsRequired"] = {name};
    expect_refused_both(file, {name, "compressed", "Export it without mesh compression"});
  }
  GltfFile file = gltf_square();
  file.json["extensionsRequired"] = {"ACME_wonder"};
  expect_refused_both(file, {"ACME_wonder", "does not know"});
  file.json["extensionsRequired"] = {"KHR_mesh_quantization", "KHR_materials_unlit"};
  EXPECT_EQ(read_glb(file).soup.triangles.size(), 2U);
  file.json["accessors"][0].erase("bufferView");
  expect_refused_both(file, {"accessor 0", "has no data"});
}

}  // namespace
}  // namespace loopmend
