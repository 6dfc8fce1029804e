// SPDX-License-Identifier: GPL-3.0-or-later
// One libFuzzer target for each kind of file, told by FUZZ_NAME, its extension, and FUZZ_MESH, FUZZ_PACKED_MODEL,
// FUZZ_MATERIALS or FUZZ_PICTURE. A file is read, or refused with a ReadError; what was read keeps its promises, and can be written.
#include "core/error.h"
#include "io/file_content.h"
#include "io/material_library.h"
#include "io/picture_file.h"
#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "io/zip_archive.h"
#include "mesh/boundary_loops.h"
#include "mesh/surface_model.h"

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

using namespace loopmend;

/// In memory where that is possible: a million files an hour.
std::filesystem::path input_file() {
  const std::filesystem::path memory = "/dev/shm";
  const std::filesystem::path folder =
      std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path();
  return folder / ("loopmend-fuzz-" + std::to_string(::getpid()) + "." FUZZ_NAME);
}

void require(bool holds, const char* promise) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

/// Formats that put triangles in another order.
[[maybe_unused]] void require_count(const TriangleSoup& soup, const std::filesystem::path& path) {
  try {
    write_mesh(path, soup, Encoding::binary);
  } catch (const WriteError&) {
    return;  // coordinates beyond the range of floats
  }
  require(read_mesh(path).soup.triangles.size() == soup.triangles.size(), "all triangles are read again");
  std::filesystem::remove(path);
}

[[maybe_unused]] void read_a_mesh(const std::filesystem::path& path) {
  const ImportedMesh mesh = read_mesh(path);
  require(!mesh.soup.triangles.empty(), "a mesh has a face");
  for (const Vec3& p : mesh.soup.points)
    require(p.allFinite() || mesh.report.unreferenced_vertices > 0, "places are finite");
  const int count = static_cast<int>(mesh.soup.points.size());
  for (const Triangle& t : mesh.soup.triangles)
    for (const int v : t) require(v >= 0 && v < count, "corners are vertices");
  if (mesh.soup.triangles.size() > 2000) return;
  SurfaceModel model;
  try {
    model = make_surface_model(mesh.soup);
  } catch (const InvalidArgument&) {
    return;  // every face is degenerate
  }
  for (const BoundaryLoop& loop : find_boundary_loops(model)) require(loop.edges() > 0, "a loop has edges");
  const std::filesystem::path written = path.string() + ".written.ply";
  write_mesh(written, model.soup, Encoding::binary);
  const ImportedMesh again = read_mesh(written);
  require(again.soup.triangles == model.soup.triangles, "what was written is read again");
  std::filesystem::remove(written);
  if (mesh.report.format == "glTF") require_count(model.soup, path.string() + ".written.glb");
  if (mesh.report.format == "3MF") require_count(model.soup, path.string() + ".written.3mf");
}

/// The text of a 3MF model, packed as these files are.
[[maybe_unused]] void read_a_model(const std::filesystem::path& path) {
  const std::string text = load_bytes(path).bytes;
  const std::filesystem::path packed = path.string() + ".3mf";
  std::ofstream(packed, std::ios::binary) << zip_archive({{"3D/3dmodel.model", text}});
  read_a_mesh(packed);
}

void read_it(const std::filesystem::path& path) {
#if defined(FUZZ_MESH)
  read_a_mesh(path);
#elif defined(FUZZ_PACKED_MODEL)
  read_a_model(path);
#elif defined(FUZZ_MATERIALS)
  read_material_library(path);
#elif defined(FUZZ_PICTURE)
  const Picture picture = read_picture(path);
  require(picture.width > 0 && picture.height > 0, "a picture has pixels");
#endif
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path path = input_file();
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    read_it(path);
  } catch (const ReadError& error) {
    require(std::string(error.what()).find('\n') == std::string::npos, "a refusal is one line");
  }
  return 0;
}
