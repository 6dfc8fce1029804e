// SPDX-License-Identifier: GPL-3.0-or-later
// What real exporters write beside the formats: it is read, and counted.
#include "io_test_support.h"
#include "mesh/scan_attributes.h"

#include <cstdint>
#include <cstring>
#include <vector>

namespace loopmend {
namespace {

struct Variant {
  const char* name;
  std::string bytes;
  std::size_t triangles;
  const char* oddities;  ///< empty: nothing odd
};

const std::string obj_vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
const std::string ply_head =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 2\nproperty list uchar int vertex_indices\nproperty float quality\nend_header\n0 0 0\n1 0 0\n0 1 0\n";
const std::string first_facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n";
const std::string other_facet =
    "facet normal nan nan nan\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\n";
constexpr const char* few = "faces of fewer than three corners, left out (1)";
constexpr const char* lone = "vertices without a place that no face uses, now at the origin (1)";

std::string binary_stl(std::uint32_t count, std::size_t facets, const std::string& after) {
  std::string bytes(80, 'x');
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  for (std::size_t k = 0; k < facets; ++k) {
    const float values[12] = {
        0, 0, 1, static_cast<float>(k), 0, 0, static_cast<float>(k) + 1, 0, 0, static_cast<float>(k), 1, 0};
    bytes.append(reinterpret_cast<const char*>(values), sizeof values);
    bytes.append(2, '\0');
  }
  return bytes + after;
}

std::vector<Variant> variants() {
  return {
      {"two.obj", obj_vertices + "f 1 2\nf 1 2 3\n", 1, few},
      {"none.obj", obj_vertices + "f\nf 1 2 3\n", 1, few},
      {"slashes.obj", "// exported by hand\n" + obj_vertices + "f 1 2 3\n", 1, "comments that begin with // (1)"},
      {"word.obj", obj_vertices + "my_exporter_note 1 2\nf 1 2 3\n", 1, "unknown statements (1)"},
      {"nan.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nf 1 2 3\n", 1, lone},
      {"two.ply", ply_head + "1 1 0\n2 0 1 0.5\n3 0 1 2 0.25\n", 1, few},
      {"zero.ply", ply_head + "1 1 0\n3 0 1 2 0.25\n0 7\n", 1, few},
      {"nan.ply", ply_head + "nan nan nan\n3 0 1 2 1\n3 2 1 0 1\n", 2, lone},
      {"qnan.ply", ply_head + "1.#QNAN 0 0\n3 0 1 2 1.#QNAN\n3 2 1 0 1\n", 2, lone},
      {"lower.off", "off\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 1, "keyword in lower case (1)"},
      {"lower.off", "coff 3 1 0\n0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n3 0 1 2\n", 1, "keyword in lower case (1)"},
      {"two.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1 255 0 0\n3 0 1 2 0 255 0\n", 1, few},
      {"nan.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 nan 0\n3 0 1 2\n", 1, lone},
      {"plain.stl", "solid\n" + first_facet + "endfacet\n" + other_facet + "endfacet\nendsolid\n", 2, ""},
      {"words.stl", "solid\n" + first_facet + "endfacet # 1\n" + other_facet + "endfacet 2\nendsolid\n", 2,
       "words after \"endloop\" or \"endfacet\" (2)"},
      {"one_line.stl",
       "solid "
       "a\n" +
           first_facet +
           "endfacet facet normal 0 0 1 outer loop vertex 1 0 0 vertex 1 1 0 vertex 0 1 0 "
           "endloop endfacet endsolid\n",
       2, ""},
      {"color.stl",
       "solid\ncolor 1 0 0\n# half\n" + first_facet + "endfacet\n; more\n" + other_facet + "endfacet\nendsolid\n", 2,
       "remarks between the facets (3)"},
      {"no_end.stl", "solid\n" + first_facet + "endfacet\n", 1, "missing \"endsolid\" (the file may be cut off) (1)"},
      {"two_solids.stl", "solid a\n" + first_facet + "endfacet\nsolid b\n" + other_facet + "endfacet\nendsolid b\n", 2,
       "missing \"endsolid\" (the file may be cut off) (1)"},
      {"after.stl", binary_stl(2, 2, "some exporter's own block of bytes, which is longer than a single facet of 50"),
       2, "bytes after the last triangle, left out (77)"},
      {"uncounted.stl", binary_stl(0, 2, ""), 2, "count of triangles that is 0: taken from the file's size (1)"},
  };
}

class Oddities : public ReadTest {};

TEST_F(Oddities, AreReadAndCounted) {
  for (const Variant& variant : variants()) {
    SCOPED_TRACE(variant.name + std::string(": ") + variant.bytes.substr(0, 60));
    try {
      const ImportedMesh mesh = read(variant.bytes, variant.name);
      EXPECT_EQ(mesh.report.triangles, variant.triangles);
      EXPECT_EQ(to_string(mesh.report.oddities), variant.oddities);
      for (const Vec3& p : mesh.soup.points) EXPECT_TRUE(p.allFinite());
    } catch (const ReadError& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

/// The row of a face that goes, goes too.
TEST_F(Oddities, PropertiesStayWithTheirFaces) {
  const ImportedMesh mesh = read(ply_head + "1 1 0\n2 0 1 0.5\n3 0 1 2 0.25\n", "two.ply");
  ASSERT_EQ(mesh.soup.attributes->faces.size(), 1U);
  ASSERT_EQ(mesh.soup.attributes->faces[0].rows(), 1U);
  EXPECT_EQ(mesh.soup.attributes->faces[0].value(0), 0.25);
}

TEST_F(Oddities, DamageIsStillRefused) {
  expect_refused("v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n", "used.obj", {"vertex 3", "finite", "line 3"});
  expect_refused(obj_vertices + "ff 1 2 3\n", "garbled.obj", {"\"ff\""});
  expect_refused(obj_vertices + "call other.obj\nf 1 2 3\n", "call.obj", {"\"call\""});
  expect_refused("solid\n" + first_facet + "endfacet\nfacte normal 0 0 1\nendsolid\n", "garbled.stl", {"facte"});
  expect_refused(binary_stl(1, 2, ""), "fewer.stl", {"announces 1"});
  expect_refused(binary_stl(1, 1000, "7 bytes"), "many_more.stl", {"announces 1"});
}

}  // namespace
}  // namespace loopmend
