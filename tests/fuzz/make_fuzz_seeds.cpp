// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the first inputs of the fuzzers, small files of every kind: make_fuzz_seeds FOLDER makes FOLDER/ply, FOLDER/obj, ...
#include "io/picture_file.h"
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
  for (const char* kind : {"ply", "obj", "stl", "off", "ply.gz", "mtl", "png", "jpg"})
    std::filesystem::create_directories(folder / kind);
  for (const auto& [kind, seeds] : texts)
    for (std::size_t k = 0; k < seeds.size(); ++k)
      std::ofstream(folder / kind / (std::to_string(k) + "." + kind), std::ios::binary) << seeds[k];
  for (const char* kind : {"ply", "obj", "stl", "off", "ply.gz"}) {
    write_mesh(folder / kind / (std::string("binary.") + kind), small_mesh(), Encoding::binary);
    write_mesh(folder / kind / (std::string("text.") + kind), small_mesh(), Encoding::ascii);
  }
  for (const int channels : {3, 4}) {
    std::ofstream out(folder / "png" / (std::to_string(channels) + ".png"), std::ios::binary);
    write_png(out, small_picture(channels));
  }
  write_jpeg(folder / "jpg" / "a.jpg");
  return 0;
}
