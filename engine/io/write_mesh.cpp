// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_mesh.h"

#include "core/error.h"
#include "core/single_precision.h"
#include "io/atomic_file.h"
#include "io/file_content.h"
#include "io/format_writers.h"
#include "io/gzip.h"
#include "io/polydata.h"
#include "io/text_cursor.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <span>
#include <string>

namespace loopmend {

namespace {

/// Refuses what read_mesh would refuse: such a file would be lost work.
void require_valid(const TriangleSoup& soup) {
  const auto count = static_cast<int>(soup.points.size());
  if (!soup.colors.empty() && soup.colors.size() != soup.points.size()) {
    throw InvalidArgument(say("write_mesh: there are colours, but not one per point"));
  }
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    if (!soup.points[v].allFinite()) throw InvalidArgument(say("write_mesh: point %1 is not finite", v));
  }
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    for (const int v : soup.triangles[f]) {
      if (v < 0 || v >= count) throw InvalidArgument(say("write_mesh: triangle %1 has an index out of range", f));
    }
  }
}

/// Binary STL holds floats: a coordinate beyond their range would become infinite.
void require_float_range(const std::filesystem::path& path, const TriangleSoup& soup) {
  for (const Vec3& point : soup.points) {
    if (std::isfinite(static_cast<float>(point.cwiseAbs().maxCoeff()))) continue;
    throw WriteError(path, say("the coordinates are too large for binary STL"),
                     say("Save as PLY, or scale the mesh down."));
  }
}

}  // namespace

Format format_of(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".ply") return Format::ply;
  if (extension == ".stl") return Format::stl;
  if (extension == ".obj") return Format::obj;
  if (extension == ".off") return Format::off;
  if (extension == ".glb") return Format::glb;
  if (extension == ".gltf") return Format::gltf;
  if (extension == ".3mf") return Format::three_mf;
  if (extension == ".vtp" || extension == ".vtk") return Format::polydata;
  throw WriteError(path, extension.empty() ? say("the name has no extension") : say("unknown format \"%1\"", extension),
                   say("Choose a name that ends in .ply, .stl, .obj, .off, .glb, .gltf, .3mf, .vtp or .vtk, compressed "
                       ".ply.gz and so on."));
}

void check_mesh_writable(const std::filesystem::path& path) {
  if (format_of(path) == Format::polydata) require_polydata_program(path);
  check_writable(path);
}

namespace {

void write_soup(std::ostream& stream, GzipWriter* gzip, const std::filesystem::path& path, const TriangleSoup& soup,
                Encoding encoding) {
  Output out(stream, gzip);
  switch (format_of(path)) {
    case Format::ply: write_ply(out, soup, encoding); break;
    case Format::stl: write_stl(out, soup, encoding); break;
    case Format::obj: write_obj(out, soup); break;
    case Format::off: write_off(out, soup); break;
    case Format::glb: write_gltf(out, path, soup, GltfContainer::binary); break;
    case Format::gltf: write_gltf(out, path, soup, GltfContainer::text); break;
    case Format::three_mf: write_3mf(out, soup); break;
    case Format::polydata: write_polydata(out, path, soup, encoding); break;
  }
  out.finish();
}

/// The writer for this path, once it is clear that the soup can be written there.
std::function<void(std::ostream&)> writer_for(const std::filesystem::path& path, const TriangleSoup& soup,
                                              Encoding encoding) {
  require_valid(soup);
  const Format format = format_of(path);
  if (format == Format::stl && encoding == Encoding::binary) require_float_range(path, soup);
  return [&soup, path, encoding, compressed = has_gzip_name(path)](std::ostream& stream) {
    if (!compressed) return write_soup(stream, nullptr, path, soup, encoding);
    GzipWriter gzip(stream);
    write_soup(stream, &gzip, path, soup, encoding);
  };
}

}  // namespace

void write_mesh(const std::filesystem::path& path, const TriangleSoup& soup, Encoding encoding) {
  write_file_atomically(path, writer_for(path, soup, encoding));
}

void write_mesh(OutputTransaction& outputs, const std::filesystem::path& path, const TriangleSoup& soup,
                Encoding encoding) {
  outputs.add(path, writer_for(path, soup, encoding));
}

bool holds_floats(const std::filesystem::path& path, const TriangleSoup& soup, Encoding encoding) {
  const Format format = format_of(path);
  if (format == Format::stl) return encoding == Encoding::binary;
  if (format == Format::glb || format == Format::gltf) return true;
  return (format == Format::ply || format == Format::polydata) &&
         attributes_of(soup).coordinates == ScalarType::float32;
}

double largest_rounding(const std::filesystem::path& path, const TriangleSoup& soup, Encoding encoding,
                        std::size_t points) {
  if (!holds_floats(path, soup, encoding)) return 0;
  const Format format = format_of(path);
  const Vec3 shift = format == Format::glb || format == Format::gltf ? gltf_shift(soup) : Vec3(Vec3::Zero());
  double largest = 0;
  for (const Vec3& point : std::span(soup.points).first(std::min(points, soup.points.size())))
    largest = std::max(largest, (as_floats(point - shift) + shift - point).norm());
  return largest;
}

}  // namespace loopmend
