// SPDX-License-Identifier: GPL-3.0-or-later
// Files cut off at every byte, and files with bytes changed: an error or a valid mesh, never a crash, never a part.
#include "io/write_mesh.h"

#include "io_test_support.h"
#include "support/processor_time.h"

#include <random>

namespace loopmend {
namespace {

struct Sample {
  const char* name;
  std::string bytes;
};

/// One small file of each format and encoding; the last number of each text has one digit.
std::vector<Sample> samples() {
  const TemporaryFolder folder;
  std::vector<Sample> result;
  TriangleSoup soup;
  soup.points = {{0.5, 0.25, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, -2.5}};
  soup.triangles = {{0, 1, 2}, {1, 3, 2}};
  const auto add = [&](const char* name, Encoding encoding) {
    write_mesh(folder / name, soup, encoding);
    result.push_back({name, read_bytes(folder / name)});
  };
  for (const Encoding encoding : {Encoding::ascii, Encoding::binary}) {
    add("a.ply", encoding);
    add("a.stl", encoding);
  }
  add("a.off", Encoding::ascii);
  soup.colors.assign(4, Color{10, 200, 30, 255});
  add("c.ply", Encoding::binary);
  add("c.ply", Encoding::ascii);
  add("c.off", Encoding::ascii);
  add("c.glb", Encoding::binary);
  add("c.gltf", Encoding::ascii);
  add("c.3mf", Encoding::binary);
  std::string big =
      "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty char x\nproperty char y\nproperty char z\n"
      "element face 1\nproperty list uchar uchar vertex_indices\nproperty list char short junk\nend_header\n";
  big += std::string("\0\0\0\1\0\0\0\1\0\3\0\1\2\1\0\7", 16);
  result.push_back({"b.ply", big});
  return result;
}

class Damage : public ReadTest {};

TEST_F(Damage, CutOffAtEveryByteIsRefusedOrComplete) {
  for (const Sample& sample : samples()) {
    const TriangleSoup whole = read(sample.bytes, sample.name).soup;
    int complete = 0;
    for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
      try {
        const ImportedMesh mesh = read(std::string_view(sample.bytes).substr(0, size), sample.name);
        if (!mesh.report.oddities.empty()) {  // text STL cut off between two facets: read, and said
          EXPECT_NE(to_string(mesh.report.oddities).find("endsolid"), std::string::npos);
          continue;
        }
        ++complete;
        EXPECT_TRUE(same_bits(mesh.soup.points, whole.points)) << sample.name << " cut to " << size;
        EXPECT_EQ(mesh.soup.triangles, whole.triangles) << sample.name << " cut to " << size;
        EXPECT_EQ(mesh.soup.colors, whole.colors) << sample.name << " cut to " << size;
      } catch (const ReadError&) {
      }
    }
    // Only the last line end, or the name after "endsolid", may be missing.
    EXPECT_LE(complete, sample.name == std::string("a.stl") ? 10 : 1) << sample.name;
  }
}

// OBJ announces no counts: a file cut off between two faces, or in the digits of the last corner, cannot be told from a
// whole one. All that can be asked is that no face but the last differs.
TEST_F(Damage, ObjCutOffAtEveryByteIsRefusedOrABeginning) {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\nf 2 3 4\n";
  const TriangleSoup whole = read(text, "a.obj").soup;
  for (std::size_t size = 0; size < text.size(); ++size) {
    try {
      const ImportedMesh mesh = read(std::string_view(text).substr(0, size), "a.obj");
      expect_valid(mesh);
      ASSERT_TRUE(same_bits(mesh.soup.points, whole.points));
      ASSERT_TRUE(std::equal(mesh.soup.triangles.begin(), mesh.soup.triangles.end(), whole.triangles.begin()));
    } catch (const ReadError&) {
    }
  }
}

std::string mutated(std::string bytes, std::mt19937& random) {
  const auto place = [&] { return random() % bytes.size(); };
  const int changes = 1 + static_cast<int>(random() % 3);
  for (int i = 0; i < changes && !bytes.empty(); ++i) {
    static const std::string likely = "0123456789-+.eE \n\r\t/#\\vfnidx\"\xFF";
    const char c = random() % 2 == 0 ? likely[random() % likely.size()] : static_cast<char>(random() % 256);
    switch (random() % 5) {
      case 0: bytes[place()] = c; break;
      case 1: bytes[place()] = static_cast<char>(bytes[place()] ^ (1 << (random() % 8))); break;
      case 2: bytes.insert(place(), 1, c); break;
      case 3: bytes.erase(place(), 1 + random() % 4); break;
      case 4: {
        const std::size_t from = place();
        bytes.insert(place(), bytes.substr(from, random() % 16));
        break;
      }
    }
  }
  return bytes;
}

TEST_F(Damage, ChangedBytesAreRefusedOrAValidMesh) {
  std::vector<Sample> all = samples();
  all.push_back(
      {"a.obj",
       "# c\nmtllib m\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nf 1 2 3 4\nf -1/1 -2/1 \\\n-3/1\n"});
  std::mt19937 random(20240607);
  int read_well = 0;
  int refused = 0;
  for (int round = 0; round < 600; ++round) {
    for (const Sample& sample : all) {
      const std::string bytes = mutated(sample.bytes, random);
      const double start = test::processor_seconds();
      try {
        expect_valid(read(bytes, sample.name));
        ++read_well;
      } catch (const ReadError& error) {
        ++refused;
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      }
      ASSERT_LT(test::processor_seconds() - start, 2) << bytes;
      ASSERT_FALSE(HasFailure()) << bytes;
    }
  }
  EXPECT_GT(read_well, 100);
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace loopmend
