// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the first inputs of the fuzzers, small files of every kind: make_fuzz_seeds FOLDER makes FOLDER/ply, FOLDER/obj, ...
#include "document/session.h"
#include "io/picture_file.h"
#include "io/read_mesh.h"
#include "io/write_mesh.h"

#include <cstdio>

#include <jpeglib.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace loopmend;

/// A tetrahedron without one face, with colours where asked for.
TriangleSoup small_mesh() {
  TriangleSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1.5}};
  soup.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return soup;
}

const std::map<std::string, std::vector<std::string>> texts = {
    {"ply",
     {"ply\nformat ascii 1.0\ncomment c\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
      "z\nproperty "
      "uchar red\nproperty uchar green\nproperty uchar blue\nproperty float quality\nelement face 2\nproperty list "
      "uchar "
      "int vertex_indices\nproperty list uchar float texcoord\nproperty int texnumber\nelement other 1\nproperty list "
      "int "
      "short s\nend_header\n0 0 0 1 2 3 nan\n1 0 0 255 255 255 1\n1 1 0 0 0 0 2\n0 1 0 9 9 9 3\n4 0 1 2 3 8 0 0 1 0 1 "
      "1 0 1 "
      "0\n3 0 1 2 6 0 0 1 0 1 1 0\n2 7 -7\n",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\nelement "
      "tristrips "
      "1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n5 0 1 2 -1 3\n"}},
    {"obj",
     {"# c\nmtllib m.mtl\no a\ng b c\ns 1\nv 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nvt 0 0\nvt 1 0 0\nvt 1 1\nvn 0 "
      "0 1\nusemtl "
      "red\nf 1/1/1 2/2/1 3/3/1\nf -4//1 -2//1 -1//1\nf 1 2 \\\n3 4\nl 1 2\np 1\nkeyword 3\n",
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/ 2/ 3/\n// a comment\nf 1 2\n"}},
    {"stl",
     {"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid "
      "a\nsolid "
      "b\ncolor 1 0 0\nfacet normal 0 0 0\nouter loop\nvertex 0 0 1e3\nvertex 1 0 1\nvertex 0 1 -1\nendloop\nendfacet "
      "x\n"}},
    {"off",
     {"OFF\n4 2 0 # c\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n3 0 1 2 0.5 0.5 0.5 1\n",
      "STCNOFF 3 1 0\n0 0 0 0 0 1 1 1 1 1 0 0\n1 0 0 0 0 1 1 1 1 1 1 0\n0 1 0 0 0 1 1 1 1 1 0 1\n3 0 1 2\n",
      "off 3 1 3\n0 0 "
      "0\n1 0 0\n0 1 0\n3 0 1 2\n"}},
    {"gltf",
     {R"({"asset":{"version":"2.0","copyright":"c"},"scene":0,"scenes":[{"nodes":[1]}],"nodes":[{"mesh":0,"name":"a"},
{"children":[0],"translation":[1,2,3],"rotation":[0,0,1,0],"scale":[1,1,-2]}],"materials":[{"name":"m",
"pbrMetallicRoughness":{"baseColorFactor":[1,0.5,0,1],"baseColorTexture":{"index":0,"texCoord":0}},
"normalTexture":{"index":0,"texCoord":1}}],"textures":[{"source":0,"sampler":0}],"samplers":[{}],
"images":[{"uri":"data:image/png;base64,iVBORw0KGgo="}],"meshes":[{"primitives":[{"mode":4,"material":0,"indices":1,
"attributes":{"POSITION":0,"NORMAL":0,"TEXCOORD_0":2,"COLOR_0":3,"TANGENT":3}},
{"mode":5,"attributes":{"POSITION":0}},{"mode":6,"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
{"bufferView":1,"componentType":5121,"count":6,"type":"SCALAR"},
{"bufferView":0,"componentType":5123,"count":4,"type":"VEC2","byteOffset":4,"normalized":true},
{"bufferView":2,"componentType":5121,"count":4,"type":"VEC4","normalized":true}],
"bufferViews":[{"buffer":0,"byteLength":48,"byteStride":12},{"buffer":0,"byteOffset":48,"byteLength":6},
{"buffer":0,"byteOffset":8,"byteLength":40}],"buffers":[{"byteLength":54,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAA/AAECAAID"}]})"}},
    {"gltf-sparse",
     {R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0}},{"attributes":{"POSITION":1}}]}],
"accessors":[{"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":2,"indices":{"bufferView":0,"componentType":5121},
"values":{"bufferView":1}}},{"bufferView":1,"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,
"indices":{"bufferView":0,"byteOffset":1,"componentType":5121},"values":{"bufferView":1,"byteOffset":12}}}],
"bufferViews":[{"buffer":0,"byteLength":2},{"buffer":0,"byteOffset":4,"byteLength":36}],"buffers":[{"byteLength":40,
"uri":"data:application/octet-stream;base64,AQIAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAIA/AAAAQA=="}]})"}},
    {"model", {R"(<?xml version="1.0"?><model unit="inch" xmlns="a" xmlns:m="b/material/2015/02" requiredextensions="m">
<metadata name="Title">t &amp; u</metadata><resources><basematerials id="1"><base name="red" displaycolor="#FF0000"/>
</basematerials><m:colorgroup id="2"><m:color color="#00FF0080"/><m:color color="#0000FF"/></m:colorgroup>
<object id="3" name="part" pid="1" pindex="0"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/>
<vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1e-1"/></vertices><triangles><triangle v1="0" v2="1" v3="2"/>
<triangle v1="0" v2="1" v3="3" pid="2" p1="0" p2="1" p3="1"/></triangles></mesh></object>
<object id="4"><components><component objectid="3" transform="1 0 0 0 -1 0 0 0 1 5 0 0"/>
<component objectid="3"/></components></object></resources><build><item objectid="4"/></build></model>)"}},
    {"mtl",
     {"# c\nnewmtl red\nKa 1 0 0\nKd 1 0 0\nmap_Kd -s 1 1 1 -o 0 0 0 a picture.png\nmap_Bump -bm 0.5 bump.jpg\nnewmtl "
      "blue\nillum 2\nmap_Kd a.png\n\nnewmtl\nmap_Kd\n"}},
};

Picture small_picture(int channels) {
  Picture picture(5, 3);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 5; ++x) {
      const auto shade = static_cast<unsigned char>(7 * x + 20 * y);
      picture.at(x, y) = {shade, 40, 200, static_cast<unsigned char>(channels == 3 ? 255 : shade)};
    }
  return picture;
}

/// One inner vertex in a square hole.
Patch small_patch() {
  Patch patch;
  patch.free_count = 1;
  patch.patch_triangles = 4;
  patch.positions = {{0, 0, 0.1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {2, 2, 0}};
  patch.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {1, 5, 2}};
  patch.ring = {0, 1, 1, 1, 1, 2};
  patch.view_vertex = {-1, 0, 1, 2, 3, 4};
  patch.loops = {{1, 2, 3, 4}};
  patch.loop_numbers = {1};
  patch.center = Vec3::Zero();
  patch.scale = 1;
  return patch;
}

/// A surface that lies in the session itself, a scan, and a patch of each.
Session small_session() {
  Session session;
  session.scans.push_back(
      {{}, 7, QStringLiteral("made"), std::make_shared<const TriangleSoup>(small_mesh()), {}, nullptr});
  session.scans.push_back({QStringLiteral("/scans/a.ply"), 8, {}, nullptr, {}, nullptr});
  for (int scan = 0; scan < 2; ++scan) {
    auto state = std::make_shared<PatchState>();
    state->patch = small_patch();
    state->message = verbatim("a message");
    state->recipe.runs.resize(1);
    state->seams.resize(1);
    state->seams_before.resize(1);
    session.patches.push_back({scan, {1}, state, scan == 0 ? Acceptance::accepted : Acceptance::pending});
  }
  return session;
}

void write_sessions(const std::filesystem::path& folder) {
  const auto write_bytes = [&](const char* name, const QByteArray& bytes) {
    std::ofstream(folder / name, std::ios::binary).write(bytes.data(), bytes.size());
  };
  const auto write = [&](const char* name, const Session& session) {
    write_bytes(name, to_bytes(session, QStringLiteral("/scans")));
  };
  Session session = small_session();
  write("patches.loopmend", session);
  session.view = SessionView{};
  session.view->from = {Vec3(0, 0, 0), Vec3(0, 0, 5), Vec3(0, 1, 0)};
  session.patches.resize(1);
  write("view.loopmend", session);
  session.patches.clear();
  session.scans.resize(1);
  write("surface.loopmend", session);
  const auto file = std::make_shared<const KeptFile>(
      KeptFile{QStringLiteral("a.off"), qCompress(QByteArray("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"))});
  session = small_session();
  session.scans.back().unit = "mm";
  write_bytes("packed.loopmend", pack(to_bytes(session, QStringLiteral("/scans")), {nullptr, file}));
  session.patches.clear();
  session.scans.erase(session.scans.begin());
  write_bytes("packed_scan.loopmend", pack(to_bytes(session, QStringLiteral("/scans")), {file}));
}

void write_jpeg(const std::filesystem::path& path) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) std::abort();
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  jpeg_stdio_dest(&jpeg, file);
  jpeg.image_width = 8;
  jpeg.image_height = 6;
  jpeg.input_components = 3;
  jpeg.in_color_space = JCS_RGB;
  jpeg_set_defaults(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  for (int row = 0; row < 6; ++row) {
    std::vector<JSAMPLE> pixels(24);
    for (int k = 0; k < 24; ++k) pixels[static_cast<std::size_t>(k)] = static_cast<JSAMPLE>(10 * k + row);
    JSAMPROW line = pixels.data();
    jpeg_write_scanlines(&jpeg, &line, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  std::fclose(file);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder = argv[1];
  for (const char* kind :
       {"ply", "obj", "stl", "off", "ply.gz", "glb", "gltf", "3mf", "model", "mtl", "png", "jpg", "session"})
    std::filesystem::create_directories(folder / kind);
  for (const auto& [name, seeds] : texts) {
    const std::string kind = name.substr(0, name.find('-'));
    for (std::size_t k = 0; k < seeds.size(); ++k)
      std::ofstream(folder / kind / (name + std::to_string(k) + "." + kind), std::ios::binary) << seeds[k];
  }
  for (const char* kind : {"ply", "obj", "stl", "off", "ply.gz", "glb", "gltf", "3mf"}) {
    write_mesh(folder / kind / (std::string("binary.") + kind), small_mesh(), Encoding::binary);
    write_mesh(folder / kind / (std::string("text.") + kind), small_mesh(), Encoding::ascii);
  }
  write_mesh(folder / "glb" / "rich.glb", read_mesh(folder / "gltf" / "gltf0.gltf").soup);
  for (const int channels : {3, 4}) {
    std::ofstream out(folder / "png" / (std::to_string(channels) + ".png"), std::ios::binary);
    write_png(out, small_picture(channels));
  }
  write_jpeg(folder / "jpg" / "a.jpg");
  write_sessions(folder / "session");
  return 0;
}
