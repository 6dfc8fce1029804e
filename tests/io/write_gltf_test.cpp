// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/single_precision.h"
#include "gltf_test_support.h"
#include "io/write_mesh.h"
#include "io_test_support.h"
#include "mesh/material_table.h"
#include "mesh/scan_attributes.h"
#include "samples/analytic_surfaces.h"

#include <algorithm>
#include <cstring>

namespace loopmend {
namespace {

using Json = nlohmann::json;

class WriteGltf : public ReadTest {
 protected:
  ImportedMesh again(const TriangleSoup& soup, const char* name = "again.glb") {
    write_mesh(folder_ / name, soup);
    return read_mesh(folder_ / name);
  }
  /// The JSON text of a GLB file.
  Json json_of(const char* name) {
    const std::string bytes = read_bytes(folder_ / name);
    std::uint32_t size = 0;
    std::memcpy(&size, bytes.data() + 12, sizeof size);
    return Json::parse(bytes.substr(20, size));
  }
};

TriangleSoup rounded(TriangleSoup soup) {
  for (Vec3& p : soup.points) p = as_floats(p);
  return soup;
}

TEST_F(WriteGltf, FloatsKeepEveryBit) {
  TriangleSoup soup = rounded(make_icosphere(3));
  soup.points[0] = {1.5e-45, -1e30, 3};  // a denormal float
  soup = rounded(soup);
  for (const char* name : {"a.glb", "a.gltf", "a.glb.gz"}) {
    const ImportedMesh mesh = again(soup, name);
    EXPECT_TRUE(same_bits(mesh.soup.points, soup.points)) << name;
    EXPECT_EQ(mesh.soup.triangles, soup.triangles) << name;
    EXPECT_EQ(largest_rounding(name, soup, Encoding::binary), 0);
  }
}

/// The largest and smallest coordinates must be said; validators compare them with the bytes.
TEST_F(WriteGltf, SaysTheBoxOfThePositions) {
  again(rounded(make_icosphere(1)));
  const Json json = json_of("again.glb");
  const Json& positions =
      json["accessors"][json["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<std::size_t>()];
  EXPECT_EQ(positions["count"], 42);
  float low = 0, high = 0;
  for (const Vec3& p : make_icosphere(1).points) {
    low = std::min(low, static_cast<float>(p.x()));
    high = std::max(high, static_cast<float>(p.x()));
  }
  EXPECT_EQ(positions["min"][0].get<float>(), low);
  EXPECT_EQ(positions["max"][0].get<float>(), high);
  for (const Json& view : json["bufferViews"]) EXPECT_EQ(view["byteOffset"].get<int>() % 4, 0);
}

/// A scan in national coordinates: floats of half a metre there, of micrometres about a place of its own.
TEST_F(WriteGltf, ScansFarFromTheOriginGetANode) {
  TriangleSoup soup = make_icosphere(3);
  for (Vec3& p : soup.points) p += Vec3(4'500'000.25, 5'300'000.5, 0);
  const ImportedMesh mesh = again(soup);
  double largest = 0;
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    largest = std::max(largest, (mesh.soup.points[v] - soup.points[v]).norm());
  EXPECT_LT(largest, 2e-7);
  EXPECT_NEAR(largest_rounding("a.glb", soup, Encoding::binary), largest, 1e-9);
  EXPECT_TRUE(json_of("again.glb")["nodes"][0].contains("translation"));
  EXPECT_TRUE(same_bits(again(mesh.soup).soup.points, mesh.soup.points)) << "the second time nothing is rounded";
}

TEST_F(WriteGltf, EveryColorComesBack) {
  TriangleSoup soup = rounded(make_icosphere(4));
  ASSERT_GE(soup.points.size(), 256U);
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    const auto shade = static_cast<unsigned char>(v % 256);
    soup.colors.push_back({shade, static_cast<unsigned char>(255 - shade), 7, shade});
  }
  EXPECT_EQ(again(soup).soup.colors, soup.colors);
}

/// Split vertices come out as they went in, in their order, byte by byte: positions, texture, normals.
TEST_F(WriteGltf, SeamsAreSplitAgain) {
  GltfFile file;
  const std::string positions = GltfFile::packed<float>({0, 1, 0, 0, 0, 0, 1, 1, 0, 1, 0, 0, 0, 0, 0, 1, 1, 0});
  const std::string texture = GltfFile::packed<float>({1, 1, 0.3F, 1e-3F, 0.4F, 1, 0.6F, 0, 0, 0.7F, -2, 1.25F});
  const std::string normals = GltfFile::packed<float>({0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 0, -1, 0, 0.6F, 0.8F, 0, 0, 1});
  file.primitive() = {{"attributes",
                       {{"POSITION", file.add(positions, 5126, 6, "VEC3")},
                        {"TEXCOORD_0", file.add(texture, 5126, 6, "VEC2")},
                        {"NORMAL", file.add(normals, 5126, 6, "VEC3")}}},
                      {"indices", file.add(GltfFile::packed<std::uint16_t>({2, 0, 1, 4, 3, 5}), 5123, 6, "SCALAR")}};
  const ImportedMesh mesh = read(file.glb(), "a.glb");
  EXPECT_EQ(mesh.soup.points.size(), 4U);
  again(mesh.soup);
  const std::string written = read_bytes(folder_ / "again.glb");
  const std::size_t at = written.find(positions);
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(written.substr(at, positions.size() + normals.size() + texture.size()), positions + normals + texture);
  EXPECT_NE(written.find(GltfFile::packed<std::uint16_t>({2, 0, 1, 4, 3, 5})), std::string::npos);
}

TEST_F(WriteGltf, ObjectsAndMaterialsComeBack) {
  GltfFile file = gltf_square();
  file.json["asset"]["copyright"] = "A museum";
  file.json["materials"] = {{{"name", "skin"},
                             {"extensions", {{"KHR_materials_unlit", Json::object()}}},
                             {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 1}}}}}},
                            {{"name", "skin"}, {"alphaMode", "MASK"}}};
  file.json["samplers"] = {{{"wrapS", 33071}}};
  file.json["textures"] = {{{"source", 0}}, {{"source", 1}, {"sampler", 0}}};
  file.json["images"] = {{{"uri", "gone/../../gone.png"}}, {{"uri", "data:image/png;base64,iVBORw=="}}};
  file.json["nodes"] = {{{"mesh", 0}, {"name", "left"}}, {{"mesh", 1}, {"name", "right"}, {"translation", {0, 4, 0}}}};
  file.primitive()["material"] = 0;
  file.json["meshes"].push_back(file.json["meshes"][0]);
  file.primitive(1)["material"] = 1;
  const ImportedMesh first = read(file.glb(), "a.glb");
  for (const char* name : {"again.glb", "again.gltf"}) {
    const ImportedMesh second = again(first.soup, name);
    EXPECT_TRUE(same_bits(second.soup.points, first.soup.points));
    EXPECT_EQ(second.soup.triangles, first.soup.triangles);
    const ScanAttributes &old = *first.soup.attributes, &now = *second.soup.attributes;
    ASSERT_EQ(now.names.size(), 2U);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(now.names[k].names, old.names[k].names);
      EXPECT_EQ(now.names[k].of_face, old.names[k].of_face);
    }
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_EQ(now.materials->materials[k].source, old.materials->materials[k].source);
    ASSERT_EQ(now.materials->pictures.size(), 1U) << "the one that was refused is not there";
    EXPECT_EQ(now.materials->pictures[0].bytes, "\x89PNG");
    EXPECT_EQ(now.materials->materials[0].picture, 0);
  }
  const Json json = json_of("again.glb");
  EXPECT_EQ(json["asset"]["copyright"], "A museum");
  EXPECT_EQ(json["extensionsUsed"], Json::array({"KHR_materials_unlit"}));
  EXPECT_EQ(json["samplers"], file.json["samplers"]);
}

TEST_F(WriteGltf, NormalsAndNamesOfOtherFormats) {
  const ImportedMesh obj = read(
      "o part\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nusemtl red\nf 1/1/1 2/2/1 "
      "3/3/1\nusemtl blue\nf 1//1 3//1 4//1\n",
      "a.obj");
  EXPECT_EQ(to_string(not_kept_by_format("a.glb", obj.soup)), "");
  const ImportedMesh glb = again(obj.soup);
  EXPECT_EQ(glb.soup.triangles.size(), 2U);
  EXPECT_EQ(glb.soup.points.size(), 4U);
  const ScanAttributes& scan = *glb.soup.attributes;
  EXPECT_EQ(scan.texture.at, (std::vector<int>{0, 1, 2, -1, -1, -1}));
  EXPECT_EQ(scan.normals.count(), 6U);
  ASSERT_EQ(scan.names.size(), 2U);
  EXPECT_EQ(scan.names[0].names, std::vector<std::string>{"part"});
  EXPECT_EQ(scan.names[1].names, (std::vector<std::string>{"red", "blue"}));
  EXPECT_EQ(scan.names[1].of_face, (std::vector<int>{0, 1}));
}

TEST_F(WriteGltf, WhatHasNoRoomIsSaid) {
  TriangleSoup soup = awkward_soup();
  EXPECT_EQ(to_string(not_kept_by_format("a.glb", soup)), "vertices without faces (1)");
  EXPECT_THROW(write_mesh(folder_ / "a.glb", soup), WriteError) << "1e300 is no float";
  EXPECT_EQ(folder_.file_count(), 0U);
}

}  // namespace
}  // namespace loopmend
