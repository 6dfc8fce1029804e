// SPDX-License-Identifier: GPL-3.0-or-later
// The shared corpus of hostile and odd files, and the example meshes: the outcome of each, looked at one by one. The
// files stay where they are (LOOPMEND_SHARED_DIR); without that folder these tests are skipped.
#include "io_test_support.h"
#include "support/processor_time.h"

#include <set>
#include <vector>

namespace loopmend {
namespace {

/// Either the size of the mesh, or words of the refusal.
struct Outcome {
  const char* name;
  std::size_t vertices;
  std::size_t faces;
  std::size_t triangles;
  const char* words;  ///< empty: the file is read
};

// The *_afl_* files are what a fuzzer made of OBJ files: each breaks off at its first statement that is none.
const std::vector<Outcome> malformed = {
    {"assimp_OutOfMemory.off", 0, 0, 0, "line 2)"},
    {"assimp_box_UTF16BE.obj", 0, 0, 0, "UTF-16"},
    {"assimp_box_longline.obj", 8, 6, 944, ""},
    {"assimp_box_without_lineending.obj", 8, 6, 12, ""},
    {"assimp_concave_polygon.obj", 64, 1, 64, ""},
    {"assimp_crash-30d6d0f7c529b3b66b4131700b7a4580cd7082df.ply", 0, 0, 0, "line 7)"},
    {"assimp_cube_binary_header_with_RN_newline.ply", 8, 12, 12, ""},
    {"assimp_cube_binary_starts_with_nl.ply", 8, 6, 12, ""},
    {"assimp_empty.obj", 0, 0, 0, "empty"},
    {"assimp_empty.off", 0, 0, 0, "empty"},
    {"assimp_empty.ply", 0, 0, 0, "empty"},
    {"assimp_invalid.off", 0, 0, 0, "line 7)"},
    {"assimp_issue623.ply", 0, 0, 0, "line 15)"},
    {"assimp_malformed.obj", 0, 0, 0, "line 28)"},
    {"assimp_malformed2.obj", 8, 5, 10, ""},
    {"assimp_malformed_property_index_oob.3mf", 0, 0, 0, "member 1000000"},
    {"assimp_multiple_spaces.obj", 4, 1, 1, ""},
    {"assimp_number_formats.obj", 0, 0, 0, "line 11)"},
    {"assimp_only_a_part_of_vertexcolors.obj", 5, 3, 3, ""},
    {"assimp_point_cloud.obj", 0, 0, 0, "points but no faces"},
    {"assimp_points.ply", 0, 0, 0, "points but no faces"},
    {"assimp_regr_3429812.obj", 4, 3, 4, ""},
    {"assimp_testline.obj", 0, 0, 0, "points but no faces"},
    {"assimp_testmixed.obj", 8, 6, 12, ""},
    {"assimp_triangle_with_empty_solid.stl", 3, 1, 1, ""},
    {"assimp_triangle_with_two_solids.stl", 6, 2, 2, ""},
    {"draco_empty_name.obj", 3, 1, 1, ""},
    {"draco_inf_nan.obj", 0, 0, 0, "line 1)"},
    {"lfspointer_suzanne.obj", 0, 0, 0, "Git LFS pointer"},
    {"lfspointer_suzanne.ply", 0, 0, 0, "Git LFS pointer"},
    {"lfspointer_suzanne.stl", 0, 0, 0, "Git LFS pointer"},
    {"lfspointer_teapot.off", 0, 0, 0, "Git LFS pointer"},
    {"lox_mesh_with_removed_elements.ply", 4, 2, 2, ""},
    {"lox_no_faces_ascii.ply", 0, 0, 0, "points but no faces"},
    {"lox_no_faces_bbe.ply", 0, 0, 0, "points but no faces"},
    {"lox_no_vertex_props_ascii.ply", 0, 0, 0, "no coordinates"},
    {"lox_no_vertex_props_bbe.ply", 0, 0, 0, "no coordinates"},
    {"lox_no_vertex_props_ble.ply", 0, 0, 0, "no coordinates"},
    {"lox_triangle_with_comments_bbe.ply", 3, 1, 1, ""},
    {"lox_unusual_order_ascii.ply", 4, 2, 2, ""},
    {"lox_unusual_order_bbe.ply", 4, 2, 2, ""},
    {"lox_unusual_order_ble.ply", 4, 2, 2, ""},
    {"numpystl_CubeInvalidUnicode.stl", 8, 12, 12, ""},
    {"numpystl_Moon_Chinese.stl", 60, 116, 116, ""},
    {"numpystl_StarWithEmptyHeader.stl", 36, 68, 68, ""},
    {"numpystl_triamid.stl", 7, 10, 10, ""},
    {"o3dv_empty_meshes.obj", 6, 2, 2, ""},
    {"o3dv_single_triangle_no_normal.stl", 3, 1, 1, ""},
    {"o3dv_two_meshes_with_same_name.obj", 4, 2, 2, ""},
    {"plyrs_all_atomic_types_ok_ascii.ply", 0, 0, 0, "no element"},
    {"plyrs_empty_2_ok_ascii.ply", 0, 0, 0, "no points and no faces"},
    {"plyrs_empty_2_ok_little_endian.ply", 0, 0, 0, "no points and no faces"},
    {"plyrs_empty_ok_ascii.ply", 0, 0, 0, "no points and no faces"},
    {"plyrs_exponent_values_ok_ascii.ply", 0, 0, 0, "no element"},
    {"plyrs_greg_turk_example2_ok_ascii.ply", 8, 7, 12, ""},
    {"plyrs_header_min_ok_ascii.ply", 0, 0, 0, "no element"},
    {"plyrs_house_2_ok_little_endian.ply", 5, 3, 3, ""},
    {"plyrs_leading_spaces_ok_ascii.ply", 0, 0, 0, "no element"},
    {"plyrs_single_elements_err_ascii.ply", 0, 0, 0, "line 5)"},
    {"plyrs_single_elements_ok_ascii.ply", 0, 0, 0, "no element"},
    {"tinyobj_afl_000002_sig11.obj", 0, 0, 0, "line 4)"},
    {"tinyobj_afl_000005_sig11.obj", 0, 0, 0, "line 8)"},
    {"tinyobj_afl_000008_sig11.obj", 0, 0, 0, "line 12)"},
    {"tinyobj_afl_000011_sig11.obj", 0, 0, 0, "line 24)"},
    {"tinyobj_afl_000014_sig11.obj", 0, 0, 0, "line 3)"},
    {"tinyobj_afl_000017_sig11.obj", 0, 0, 0, "line 26)"},
    {"tinyobj_afl_000020_sig06.obj", 0, 0, 0, "line 2)"},
    {"tinyobj_afl_000023_sig11.obj", 0, 0, 0, "line 5)"},
    {"tinyobj_afl_000026_sig11.obj", 0, 0, 0, "line 3)"},
    {"tinyobj_afl_000029_sig11.obj", 0, 0, 0, "line 1)"},
    {"tinyobj_afl_000032_sig11.obj", 0, 0, 0, "line 7)"},
    {"tinyobj_afl_000035_sig11.obj", 0, 0, 0, "line 3)"},
    {"tinyobj_afl_000038_sig11.obj", 0, 0, 0, "line 2)"},
    {"tinyobj_afl_000041_sig11.obj", 0, 0, 0, "line 4)"},
    {"tinyobj_afl_000044_sig11.obj", 0, 0, 0, "line 2)"},
    {"tinyobj_afl_000047_sig06.obj", 0, 0, 0, "line 2)"},
    {"tinyobj_afl_000050_sig11.obj", 0, 0, 0, "line 2)"},
    {"tinyobj_afl_000053_sig11.obj", 0, 0, 0, "line 2)"},
    {"tinyobj_afl_000056_sig06.obj", 0, 0, 0, "line 2)"},
    {"tinyobj_afl_000059_sig06.obj", 0, 0, 0, "line 7)"},
    {"tinyobj_afl_000062_sig06.obj", 0, 0, 0, "line 1)"},
    {"tinyobj_afl_000065_sig06.obj", 0, 0, 0, "line 1)"},
    {"tinyobj_afl_000068_sig06.obj", 0, 0, 0, "line 2)"},
    {"tinyobj_afl_000071_sig11.obj", 0, 0, 0, "line 3)"},
    {"tinyobj_afl_000074_sig06.obj", 0, 0, 0, "line 2)"},
    {"tinyobj_afl_000077_sig06.obj", 0, 0, 0, "line 1)"},
    {"tinyobj_clusterfuzz-4877060179886080.obj", 0, 0, 0, "line 1)"},
    {"tinyobj_invalid-face-definition.obj", 0, 0, 0, "points but no faces"},
    {"tinyobj_issue-161-inconsistent-f.obj", 8, 12, 12, ""},
    {"tinyobj_issue-330.obj", 7, 2, 3, ""},
    {"tinyobj_leading-decimal-dot-issue-201.obj", 3, 1, 1, ""},
    {"tinyobj_line-prim.obj", 0, 0, 0, "points but no faces"},
    {"tobj_empty_name_triangle.obj", 3, 1, 1, ""},
    {"tobj_invalid_index.obj", 0, 0, 0, "line 12)"},
    {"trimesh_busted.STL", 1941, 3878, 3878, ""},
    {"trimesh_comments.off", 8, 6, 12, ""},
    {"trimesh_cube_compressed.obj", 8, 12, 12, ""},
    {"trimesh_empty.obj", 0, 0, 0, "no points and no faces"},
    {"trimesh_empty.ply", 0, 0, 0, "no points and no faces"},
    {"trimesh_empty.stl", 0, 0, 0, "no points and no faces"},
    {"trimesh_face_in_group_name.obj", 0, 0, 0, "points but no faces"},
    {"trimesh_face_in_group_name_mid_file.obj", 5, 2, 2, ""},
    {"trimesh_metadata.ply", 4, 2, 2, ""},
    {"trimesh_multi.ply", 4, 1, 2, ""},
    {"trimesh_nancolor.obj", 8, 12, 12, ""},
    {"trimesh_negative_indices.obj", 8, 6, 12, ""},
    {"trimesh_notenoughindices.obj", 3, 1, 1, ""},
    {"trimesh_obj_empty.obj", 0, 0, 0, "no points and no faces"},
    {"trimesh_obj_points.obj", 0, 0, 0, "points but no faces"},
    {"trimesh_obj_wireframe.obj", 0, 0, 0, "points but no faces"},
    {"trimesh_obj_with_no_face_in_chunk.obj", 3, 1, 1, ""},
    {"trimesh_ply_empty_ascii.ply", 0, 0, 0, "no points and no faces"},
    {"trimesh_ply_empty_bin.ply", 0, 0, 0, "no points and no faces"},
    {"trimesh_ply_empty_header.ply", 0, 0, 0, "no element"},
    {"trimesh_ply_points_ascii.ply", 0, 0, 0, "points but no faces"},
    {"trimesh_ply_points_bin.ply", 0, 0, 0, "points but no faces"},
    {"trimesh_points_ascii_with_lists.ply", 0, 0, 0, "points but no faces"},
    {"trimesh_points_emptyascii.ply", 0, 0, 0, "line 23)"},
    {"trimesh_points_emptyface.ply", 0, 0, 0, "points but no faces"},
    {"trimesh_polygonfaces.obj", 5, 1, 3, ""},
    {"trimesh_singlevn.obj", 4, 2, 2, ""},
    {"trimesh_soup.stl", 300, 100, 100, ""},
    {"trimesh_stl_empty_ascii.stl", 0, 0, 0, "no points and no faces"},
    {"trimesh_stl_empty_bin.stl", 0, 0, 0, "no points and no faces"},
    {"trimesh_two_objects_mixed_case_names.stl", 16, 24, 24, ""},
    {"trimesh_whitespace.off", 8, 6, 12, ""},
};

const std::vector<Outcome> examples = {
    {"bunny.ply", 35947, 69451, 69451, ""},      {"cycloidal.ply", 21384, 43368, 43368, ""},
    {"demosthenes.obj", 8394, 16719, 16719, ""}, {"doll.obj", 9992, 19985, 19985, ""},
    {"dragon.ply", 437645, 871414, 871414, ""},  {"hammer.obj", 30082, 60160, 60160, ""},
    {"head.ply", 32870, 65736, 65736, ""},       {"head_holes.ply", 32192, 64131, 64131, ""},
    {"lps_head.ply", 8838, 17672, 17672, ""},    {"plane_holes.obj", 8519, 16747, 16747, ""},
    {"quadknot.obj", 1440, 1440, 2880, ""},
};

std::filesystem::path shared_folder() {
#ifdef LOOPMEND_SHARED_DIR
  return LOOPMEND_SHARED_DIR;
#else
  return "/nowhere";
#endif
}

void expect_outcome(const std::filesystem::path& path, const Outcome& expected) {
  SCOPED_TRACE(expected.name);
  const double start = test::processor_seconds();
  try {
    const ImportedMesh mesh = read_mesh(path);
    expect_valid(mesh);
    EXPECT_STREQ(expected.words, "") << "was read";
    EXPECT_EQ(mesh.report.vertices, expected.vertices);
    EXPECT_EQ(mesh.report.faces, expected.faces);
    EXPECT_EQ(mesh.report.triangles, expected.triangles);
  } catch (const ReadError& error) {
    EXPECT_STRNE(expected.words, "") << error.what();
    EXPECT_NE(std::string(error.what()).find(expected.words), std::string::npos) << error.what();
  }
  EXPECT_LT(test::processor_seconds() - start, 10);
}

TEST(Corpus, EveryMalformedFileHasItsOutcome) {
  const std::filesystem::path folder = shared_folder() / "malformed";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
  std::set<std::string> known = {"MANIFEST.csv"};
  for (const Outcome& outcome : malformed) {
    known.insert(outcome.name);
    expect_outcome(folder / outcome.name, outcome);
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    EXPECT_TRUE(known.contains(entry.path().filename().string())) << entry.path() << " has no expected outcome";
  }
}

TEST(Corpus, ExampleMeshesAreReadWhole) {
  const std::filesystem::path folder = shared_folder() / "data";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
  for (const Outcome& outcome : examples) expect_outcome(folder / outcome.name, outcome);
}

TEST(Corpus, QuadsWithColors) {
  const std::filesystem::path path = shared_folder() / "data" / "quadknot.obj";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
  const ImportedMesh mesh = read_mesh(path);
  EXPECT_EQ(mesh.report.polygons_triangulated, 1440U);
  EXPECT_EQ(mesh.soup.colors[0], (Color{192, 192, 192, 255}));
  EXPECT_EQ(mesh.soup.points[0], Vec3(4.512684, 28.688660, -76.556808));
}

TEST(Corpus, BunnyKeepsItsUnreferencedVertices) {
  const std::filesystem::path path = shared_folder() / "data" / "bunny.ply";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
  const ImportedMesh mesh = read_mesh(path);
  EXPECT_EQ(mesh.report.unreferenced_vertices, 1113U);
  EXPECT_EQ(mesh.soup.points[0], Vec3(-0.0378297F, 0.12794F, 0.00447467F));
}

}  // namespace
}  // namespace loopmend
