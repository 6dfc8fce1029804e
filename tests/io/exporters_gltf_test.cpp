// SPDX-License-Identifier: GPL-3.0-or-later
// glTF as modellers, photogrammetry and converters write it.
#include "exporter_variants.h"
#include "gltf_test_support.h"

#include <functional>

namespace loopmend {
namespace exporters_gltf {

using Json = nlohmann::json;
using Change = std::function<void(GltfFile&)>;

/// The square with one array for its places and one for its corners.
GltfFile square() {
  GltfFile file;
  file.json["scene"] = 0;
  file.json["scenes"] = {{{"nodes", {0}}}};
  file.json["nodes"] = {{{"mesh", 0}}};
  const std::size_t positions =
      file.add(GltfFile::packed<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}), 5126, 4, "VEC3");
  const std::size_t indices = file.add(GltfFile::packed<std::uint16_t>({0, 1, 2, 0, 2, 3}), 5123, 6, "SCALAR");
  file.primitive() = {{"attributes", {{"POSITION", positions}}}, {"indices", indices}};
  return file;
}

std::string glb(const Change& change) {
  GltfFile file = square();
  change(file);
  return file.glb();
}

void nothing(GltfFile&) {}

template <class T>
Change corners(std::initializer_list<T> numbers, int type, int mode = 4) {
  return [bytes = GltfFile::packed<T>(numbers), type, mode, count = numbers.size()](GltfFile& file) {
    file.primitive()["indices"] = file.add(bytes, type, count, "SCALAR");
    file.primitive()["mode"] = mode;
  };
}

/// No indices: the corners stand in a row.
Change places_in_a_row(std::initializer_list<float> numbers, int mode = 4) {
  return [bytes = GltfFile::packed<float>(numbers), mode, count = numbers.size() / 3](GltfFile& file) {
    file.primitive() = {{"attributes", {{"POSITION", file.add(bytes, 5126, count, "VEC3")}}}, {"mode", mode}};
  };
}

/// A further value of each vertex.
Change attribute(const char* name, std::string bytes, int type, const char* shape, bool is_normalized = false) {
  return [=](GltfFile& file) {
    const std::size_t accessor = file.add(bytes, type, 4, shape);
    if (is_normalized) file.json["accessors"][accessor]["normalized"] = true;
    file.primitive()["attributes"][name] = accessor;
  };
}

/// Places, normals and texture in one view, vertex by vertex.
void interleave(GltfFile& file) {
  std::string rows;
  for (const auto& [x, y] : {std::pair(0.F, 0.F), {1.F, 0.F}, {1.F, 1.F}, {0.F, 1.F}})
    rows += GltfFile::packed<float>({x, y, 0, 0, 0, 1, x, y});
  const std::size_t first = file.add(rows, 5126, 4, "VEC3");
  const Json view = file.json["accessors"][first]["bufferView"];
  file.json["bufferViews"][view.get<std::size_t>()]["byteStride"] = 32;
  Json& all = file.json["accessors"];
  all.push_back({{"bufferView", view}, {"byteOffset", 12}, {"componentType", 5126}, {"count", 4}, {"type", "VEC3"}});
  all.push_back({{"bufferView", view}, {"byteOffset", 24}, {"componentType", 5126}, {"count", 4}, {"type", "VEC2"}});
  file.primitive()["attributes"] = {{"POSITION", first}, {"NORMAL", first + 1}, {"TEXCOORD_0", first + 2}};
}

Change node(const Json& members) {
  return [=](GltfFile& file) { file.json["nodes"][0].update(members); };
}

Change root(const Json& members) {
  return [=](GltfFile& file) { file.json.update(members); };
}

/// Two primitives of one triangle each.
void split(GltfFile& file) {
  Json one = file.primitive(), other = file.primitive();
  one["indices"] = file.add(GltfFile::packed<std::uint16_t>({0, 1, 2}), 5123, 3, "SCALAR");
  other["indices"] = file.add(GltfFile::packed<std::uint8_t>({0, 2, 3}), 5121, 3, "SCALAR");
  file.json["meshes"][0]["primitives"] = {one, other};
}

/// Chunks after the two that the format names. @param kind  of four letters
std::string with_chunk(std::string glb, const char* kind, const std::string& content) {
  glb += GltfFile::packed({static_cast<std::uint32_t>(content.size())}) + kind + content;
  const std::string length = GltfFile::packed({static_cast<std::uint32_t>(glb.size())});
  return glb.replace(8, 4, length);
}

std::vector<Variant> containers() {
  const std::string plain = square().text();
  return {
      {"binary", "a.glb", glb(nothing)},
      {"text with the buffer in it", "a.gltf", plain},
      {"media type gltf-buffer", "a.gltf", replaced_once(plain, "application/octet-stream", "application/gltf-buffer")},
      {"no media type", "a.gltf", replaced_once(plain, "data:application/octet-stream;", "data:;")},
      {"indented", "a.gltf", Json::parse(plain).dump(4)},
      {"lines of Windows", "a.gltf", replaced(Json::parse(plain).dump(2), "\n", "\r\n")},
      {"byte order mark", "a.gltf", "\xEF\xBB\xBF" + plain},
      {"blank lines before it", "a.gltf", "\n\n  " + plain},
      {"zeros after the JSON of a binary: some engines", "a.glb",
       GltfFile::glb_of(
           [] {
             GltfFile file = square();
             file.json["buffers"] = {{{"byteLength", file.buffer.size()}}};
             std::string json = file.json.dump();
             json.resize((json.size() + 4) / 4 * 4, '\0');
             return json;
           }(),
           square().buffer)},
      {"a chunk of a program's own", "a.glb", with_chunk(glb(nothing), "OWN1", "twelve bytes")},
      {"bytes after the end", "a.glb", glb(nothing) + std::string(16, '\0')},
      {"buffer longer than it says", "a.glb",
       GltfFile::glb_of(
           [] {
             GltfFile file = square();
             file.json["buffers"] = {{{"byteLength", file.buffer.size()}}};
             return file.json.dump();
           }(),
           square().buffer + "more")},
      {"version 2.1", "a.gltf", replaced_once(plain, "\"2.0\"", "\"2.1\"")},
      {"generator and extras", "a.glb",
       glb(root(
           {{"asset", {{"version", "2.0"}, {"generator", "Khronos"}, {"extras", {{"author", "x"}}}}}, {"extras", 7}}))},
      {"extensions that may be left out", "a.glb",
       glb(root({{"extensionsUsed", {"KHR_lights_punctual", "FB_ngon_encoding"}},
                 {"extensions", {{"KHR_lights_punctual", {{"lights", Json::array()}}}}}}))},
      {"extensions of materials that are required", "a.glb",
       glb(root({{"extensionsRequired", {"KHR_materials_unlit", "KHR_texture_transform"}}}))},
      {"name of another format", "a.obj", glb(nothing)},
      {"no name of a file", "a", plain},
  };
}

std::vector<Variant> arrays() {
  const std::string quantized = GltfFile::packed<std::uint16_t>({0, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0});
  return {
      {"corners of 8 bits", "a.glb", glb(corners<std::uint8_t>({0, 1, 2, 0, 2, 3}, 5121))},
      {"corners of 32 bits", "a.glb", glb(corners<std::uint32_t>({0, 1, 2, 0, 2, 3}, 5125))},
      {"no indices", "a.glb", glb(places_in_a_row({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0}))},
      {"strip", "a.glb", glb(corners<std::uint16_t>({0, 1, 3, 2}, 5123, 5))},
      {"strip with jumps", "a.glb", glb(corners<std::uint16_t>({0, 1, 2, 2, 0, 0, 0, 2, 3}, 5123, 5))},
      {"strip without indices", "a.glb", glb(places_in_a_row({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, 5))},
      {"fan", "a.glb", glb(corners<std::uint16_t>({0, 1, 2, 3}, 5123, 6))},
      {"fan without indices", "a.glb", glb(places_in_a_row({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, 6))},
      {"interleaved", "a.glb", glb(interleave)},
      {"places of 16 bits in rows of 8 bytes: quantized", "a.glb", glb([&](GltfFile& file) {
         const std::size_t accessor = file.add(quantized, 5123, 4, "VEC3");
         file.json["bufferViews"][accessor]["byteStride"] = 8;
         file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
         file.primitive()["attributes"]["POSITION"] = accessor;
       })},
      {"places of 8 bits, normalized and scaled",
       "a.glb",
       glb([&](GltfFile& file) {
         const std::size_t accessor = file.add(
             GltfFile::packed<std::int8_t>({0, 0, 0, 0, 127, 0, 0, 0, 127, 127, 0, 0, 0, 127, 0, 0}), 5120, 4, "VEC3");
         file.json["bufferViews"][accessor]["byteStride"] = 4;
         file.json["accessors"][accessor]["normalized"] = true;
         file.json["nodes"][0]["scale"] = {3, 3, 3};
         file.primitive()["attributes"]["POSITION"] = accessor;
       }),
       "",
       4,
       2,
       {0, 0, 9}},
      {"colours of bytes", "a.glb", glb(attribute("COLOR_0", std::string(16, '\x7F'), 5121, "VEC4", true))},
      {"colours of floats without alpha", "a.glb",
       glb(attribute("COLOR_0", GltfFile::packed<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, .5F, .5F, .5F}), 5126, "VEC3"))},
      {"colours of 16 bits", "a.glb", glb(attribute("COLOR_0", std::string(32, '\x7F'), 5123, "VEC4", true))},
      {"texture of normalized 16 bits", "a.glb",
       glb(attribute("TEXCOORD_0", std::string(16, '\x7F'), 5123, "VEC2", true))},
      {"tangents, joints and weights", "a.glb", glb([](GltfFile& file) {
         attribute("TANGENT", std::string(64, '\0'), 5126, "VEC4")(file);
         attribute("JOINTS_0", std::string(16, '\0'), 5121, "VEC4")(file);
         attribute("WEIGHTS_0", std::string(64, '\0'), 5126, "VEC4")(file);
       })},
      {"attributes of a program's own", "a.glb",
       glb(attribute("_FEATURE_ID_0", std::string(16, '\0'), 5126, "SCALAR"))},
      {"vertices that no corner names", "a.glb", glb(corners<std::uint8_t>({0, 1, 2}, 5121)), "", 3, 1, {0, 0, 0.5}},
      {"two primitives over one array", "a.glb", glb(split)},
      {"lines beside the triangles", "a.glb", glb([](GltfFile& file) {
         Json lines = file.primitive();
         lines["mode"] = 1;
         file.json["meshes"][0]["primitives"].push_back(lines);
       })},
      {"morph targets", "a.glb", glb([](GltfFile& file) {
         file.primitive()["targets"] = {{{"POSITION", 0}}};
       })},
      {"places changed by a sparse list",
       "a.glb",
       glb([](GltfFile& file) {
         const std::size_t which = file.add(GltfFile::packed<std::uint8_t>({1, 2}), 5121, 2, "SCALAR");
         const std::size_t what = file.add(GltfFile::packed<float>({2, 0, 0, 2, 1, 0}), 5126, 2, "VEC3");
         file.json["accessors"][0]["sparse"] = {{"count", 2},
                                                {"indices", {{"bufferView", which}, {"componentType", 5121}}},
                                                {"values", {{"bufferView", what}}}};
       }),
       "",
       4,
       2,
       {0, 0, 2}},
      {"places of a sparse list alone", "a.glb", glb([](GltfFile& file) {
         const std::size_t which = file.add(GltfFile::packed<std::uint16_t>({1, 2, 3}), 5123, 3, "SCALAR");
         const std::size_t what = file.add(GltfFile::packed<float>({1, 0, 0, 1, 1, 0, 0, 1, 0}), 5126, 3, "VEC3");
         Json& accessor = file.json["accessors"][0];
         accessor.erase("bufferView");
         accessor["sparse"] = {{"count", 3},
                               {"indices", {{"bufferView", which}, {"componentType", 5123}}},
                               {"values", {{"bufferView", what}}}};
       })},
  };
}

std::vector<Variant> nodes() {
  const Json matrix = {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1};  // a quarter turn, twice as large
  return {
      {"no scene", "a.glb", glb([](GltfFile& file) { file.json.erase("scenes"), file.json.erase("scene"); })},
      {"no nodes: a mesh alone", "a.glb",
       glb([](GltfFile& file) { file.json.erase("scenes"), file.json.erase("scene"), file.json.erase("nodes"); })},
      {"no number of the scene", "a.glb", glb([](GltfFile& file) { file.json.erase("scene"); })},
      {"matrix", "a.glb", glb(node({{"matrix", matrix}})), "", 4, 2, {0, 0, 4}},
      {"move, turn and scale",
       "a.glb",
       glb(node({{"translation", {1, 2, 3}},
                 {"rotation", {0.7071067811865476, 0, 0, 0.7071067811865476}},
                 {"scale", {2, 1, 1}}})),
       "",
       4,
       2,
       {0, -2, 0}},
      {"y is up: every exporter's turn",
       "a.glb",
       glb(node({{"rotation", {-0.7071068, 0, 0, 0.7071068}}})),
       "",
       4,
       2,
       {0, 1, 0}},
      {"mirrored", "a.glb", glb(node({{"scale", {-1, 1, 1}}}))},
      {"one mesh at two places",
       "a.glb",
       glb([](GltfFile& file) {
         file.json["nodes"].push_back({{"mesh", 0}, {"translation", {4, 0, 0}}});
         file.json["scenes"][0]["nodes"] = {0, 1};
       }),
       "",
       8,
       4,
       {0, 0, 2}},
      {"child of an empty node",
       "a.glb",
       glb([](GltfFile& file) {
         file.json["nodes"].push_back({{"children", {0}}, {"scale", {1, 3, 1}}, {"name", "root"}});
         file.json["scenes"][0]["nodes"] = {1};
       }),
       "",
       4,
       2,
       {0, 0, 3}},
      {"cameras and lights in the tree", "a.glb", glb([](GltfFile& file) {
         file.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}};
         file.json["nodes"].push_back({{"camera", 0}});
         file.json["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
         file.json["scenes"][0]["nodes"] = {0, 1, 2};
       })},
      {"another scene", "a.glb", glb([](GltfFile& file) {
         file.json["scenes"] = {{{"nodes", Json::array()}}, {{"nodes", {0}}}};
         file.json["scene"] = 1;
       })},
  };
}

std::vector<Refusal> refusals() {
  const std::string damaged = "The file is damaged or incomplete; export or copy it again.";
  const std::string uncompressed = "Export it without mesh compression.";
  const std::string alone = "Put the buffer beside the file, or export one .glb file.";
  return {
      {"Draco", "a.glb", glb(root({{"extensionsRequired", {"KHR_draco_mesh_compression"}}})),
       "the mesh is compressed with \"KHR_draco_mesh_compression\", which Loopmend does not know "
       "(extensionsRequired). " +
           uncompressed},
      {"meshopt", "a.glb", glb(root({{"extensionsRequired", {"EXT_meshopt_compression"}}})),
       "the mesh is compressed with \"EXT_meshopt_compression\", which Loopmend does not know (extensionsRequired). " +
           uncompressed},
      {"version 1", "a.gltf", replaced_once(square().text(), "\"2.0\"", "\"1.0\""),
       "version \"1.0\" of glTF (asset). Loopmend reads glTF 2; export it again as such."},
      {"buffer that was not copied along", "a.gltf", square().text_with("a.bin"),
       "the buffer \"a.bin\" cannot be read (buffer 0). " + alone},
      {"buffer on a server", "a.gltf", square().text_with("https://example.org/a.bin"),
       "\"https://example.org/a.bin\" is not beside the file (buffer 0). " + alone},
      {"buffer in another folder", "a.gltf", square().text_with("../a.bin"),
       "\"../a.bin\" is outside the folder of the file, where nothing is read (buffer 0). " + alone},
      {"signed indices", "a.glb", glb(corners<std::int16_t>({0, 1, 2}, 5122)),
       "its indices are no unsigned numbers (mesh 0, primitive 0). " + damaged},
      {"corner that is not there", "a.glb", glb(corners<std::uint8_t>({0, 1, 4}, 5121)),
       "face 0 names vertex 4, but there are 4, from 0 on (mesh 0, primitive 0). " + damaged},
      {"corners that are no triangles", "a.glb", glb(corners<std::uint8_t>({0, 1, 2, 3}, 5121)),
       "4 corners, which are not three for each triangle (mesh 0, primitive 0). " + damaged},
      {"cut off", "a.glb", glb(nothing).substr(0, 500),
       "the file ends too early, in a GLB file of " + std::to_string(glb(nothing).size()) +
           " bytes (byte 500). It is incomplete; export or copy it again."},
      {"lines alone", "a.glb", glb([](GltfFile& file) { file.primitive()["mode"] = 1; }),
       "holds no points and no faces. Loopmend needs a surface: export the mesh together with its faces."},
  };
}

class ExportersGltf : public ExporterTest {};

TEST_F(ExportersGltf, Containers) { expect_read(containers()); }
TEST_F(ExportersGltf, Arrays) { expect_read(arrays()); }
TEST_F(ExportersGltf, Nodes) { expect_read(nodes()); }
TEST_F(ExportersGltf, AreRefusedWithTheReason) { expect_refusals(refusals()); }

}  // namespace exporters_gltf
}  // namespace loopmend
