// SPDX-License-Identifier: GPL-3.0-or-later
// Telling the format, and files that are no mesh at all.
#include "io_test_support.h"

#include <clocale>

namespace loopmend {
namespace {

class ReadMesh : public ReadTest {};

const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string stl =
    "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";

TEST_F(ReadMesh, ContentTellsTheFormatWhateverTheName) {
  for (const char* name : {"a.ply", "a.STL", "a.obj", "a.off", "a.txt", "a"}) {
    EXPECT_EQ(read(ply, name).report.format, "PLY") << name;
    EXPECT_EQ(read(stl, name).report.format, "STL") << name;
    EXPECT_EQ(read(obj, name).report.format, "OBJ") << name;
    EXPECT_EQ(read(off, name).report.format, "OFF") << name;
  }
}

TEST_F(ReadMesh, NamesWithBlanksAndUmlauts) { EXPECT_EQ(read(obj, "ein Löffel (2).obj").soup.points.size(), 3U); }

TEST_F(ReadMesh, RefusesForeignContentInItsOwnWords) {
  const std::string pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 12\n";
  for (const char* name : {"a.ply", "a.stl", "a.obj", "a.off"}) {
    expect_refused(pointer, name, {"Git LFS pointer", "git lfs pull"});
    expect_refused("", name, {"empty"});
    expect_refused("PK\x03\x04rest", name, {"ZIP"});
    expect_refused("\x1F\x8Brest", name, {"compressed", "damaged"});
  }
  expect_refused("hello world\n", "a.txt", {"not a mesh format", "PLY, STL, OBJ, OFF, glTF and 3MF"});
  expect_refused(std::string(1000, '\0'), "a.bin", {"not a mesh format"});
}

TEST_F(ReadMesh, RefusesUtf16WithAndWithoutMark) {
  std::string little, big;
  for (const char c : obj) {
    little += std::string{c, '\0'};
    big += std::string{'\0', c};
  }
  for (const std::string& text : {"\xFF\xFE" + little, "\xFE\xFF" + big, little, big}) {
    expect_refused(text, "a.obj", {"UTF-16", "UTF-8"});
  }
}

TEST_F(ReadMesh, RefusesWhatIsNoFile) {
  const auto refusal = [&](const std::filesystem::path& path) -> std::string {
    try {
      read_mesh(path);
    } catch (const ReadError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal(folder_ / "missing.ply").find("no such file"), std::string::npos);
  EXPECT_NE(refusal(folder_ / "missing/a.ply").find("no such file"), std::string::npos);
  EXPECT_NE(refusal("").find("no such file"), std::string::npos);
  EXPECT_NE(refusal(folder_.path()).find("folder"), std::string::npos);
}

TEST_F(ReadMesh, TheLocaleDoesNotMatter) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  bool found = false;
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) found = found || std::setlocale(LC_ALL, name);
  EXPECT_EQ(read("v 0.5 0 0\nv 1 0 1e-400\nv 0 1 0\nf 1 2 3\n", "a.obj").soup.points[0][0], 0.5);
  std::setlocale(LC_ALL, before.c_str());
  if (!found) GTEST_SKIP() << "no locale with a decimal comma is installed; read in the C locale only";
}

}  // namespace
}  // namespace loopmend
