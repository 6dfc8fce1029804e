// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_mesh.h"

#include "core/error.h"
#include "io/atomic_file.h"
#include "io/not_kept.h"
#include "io/text_cursor.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>

namespace loopmend {

namespace {

/// Gathers text and bytes and passes them on in large pieces. Numbers are the shortest that read back as the same bits.
class Output {
 public:
  explicit Output(std::ostream& stream) : stream_(stream) {}
  ~Output() { pass_on(); }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  Output& operator<<(std::string_view text) {
    piece_ += text;
    if (piece_.size() > piece_size) pass_on();
    return *this;
  }
  Output& operator<<(char c) { return *this << std::string_view(&c, 1); }
  Output& operator<<(double value) { return number(value); }
  Output& operator<<(float value) { return number(value); }
  Output& operator<<(int value) { return number(value); }
  Output& operator<<(std::size_t value) { return number(value); }

  /// The value's bytes, lowest first.
  template <class T>
  void little_endian(T value) {
    auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    *this << std::string_view(bytes.data(), bytes.size());
  }

 private:
  static constexpr std::size_t piece_size = 1 << 16;

  template <class T>
  Output& number(T value) {
    char buffer[32];
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
    return *this << std::string_view(buffer, static_cast<std::size_t>(result.ptr - buffer));
  }

  void pass_on() {
    stream_.write(piece_.data(), static_cast<std::streamsize>(piece_.size()));
    piece_.clear();
  }

  std::ostream& stream_;
  std::string piece_;
};

/// Refuses what read_mesh would refuse: such a file would be lost work.
void require_valid(const TriangleSoup& soup) {
  const auto count = static_cast<int>(soup.points.size());
  if (!soup.colors.empty() && soup.colors.size() != soup.points.size()) {
    throw InvalidArgument("write_mesh: there are colours, but not one per point");
  }
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    if (!soup.points[v].allFinite()) throw InvalidArgument("write_mesh: point " + std::to_string(v) + " is not finite");
  }
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    for (const int v : soup.triangles[f]) {
      if (v < 0 || v >= count)
        throw InvalidArgument("write_mesh: triangle " + std::to_string(f) + " has an index out of range");
    }
  }
}

const Vec3& corner(const TriangleSoup& soup, const Triangle& triangle, std::size_t i) {
  return soup.points[static_cast<std::size_t>(triangle[i])];
}

/// The unit normal; zero for a triangle without area, as STL has it.
Vec3 unit_normal(const TriangleSoup& soup, const Triangle& t) {
  Vec3 u = corner(soup, t, 1) - corner(soup, t, 0);
  Vec3 v = corner(soup, t, 2) - corner(soup, t, 0);
  const double scale = std::max(u.cwiseAbs().maxCoeff(), v.cwiseAbs().maxCoeff());
  if (!(scale > 0.0) || !std::isfinite(scale)) return Vec3::Zero();
  const Vec3 n = (u / scale).cross(v / scale);
  const double length = n.norm();
  return length > 0.0 ? Vec3(n / length) : Vec3(Vec3::Zero());
}

void write_ply_header(Output& out, const TriangleSoup& soup, Encoding encoding) {
  out << "ply\nformat " << (encoding == Encoding::binary ? "binary_little_endian" : "ascii") << " 1.0\n";
  out << "comment Loopmend\n";
  out << "element vertex " << soup.points.size() << "\nproperty double x\nproperty double y\nproperty double z\n";
  if (!soup.colors.empty()) {
    out << "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n";
  }
  out << "element face " << soup.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
}

void write_ply_binary(Output& out, const TriangleSoup& soup) {
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    for (const double x : soup.points[v]) out.little_endian(x);
    if (soup.colors.empty()) continue;
    for (const unsigned char channel : soup.colors[v]) out << static_cast<char>(channel);
  }
  for (const Triangle& triangle : soup.triangles) {
    out << '\3';
    for (const int v : triangle) out.little_endian(static_cast<std::int32_t>(v));
  }
}

void write_ply_text(Output& out, const TriangleSoup& soup) {
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    const Vec3& p = soup.points[v];
    out << p[0] << ' ' << p[1] << ' ' << p[2];
    if (!soup.colors.empty()) {
      for (const unsigned char channel : soup.colors[v]) out << ' ' << static_cast<int>(channel);
    }
    out << '\n';
  }
  for (const Triangle& t : soup.triangles) out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
}

void write_ply(Output& out, const TriangleSoup& soup, Encoding encoding) {
  write_ply_header(out, soup, encoding);
  if (encoding == Encoding::binary) {
    write_ply_binary(out, soup);
  } else {
    write_ply_text(out, soup);
  }
}

void write_stl_binary(Output& out, const TriangleSoup& soup) {
  std::string header = "Loopmend binary STL";  // must not begin with "solid"
  header.resize(80, ' ');
  out << std::string_view(header);
  out.little_endian(static_cast<std::uint32_t>(soup.triangles.size()));
  for (const Triangle& triangle : soup.triangles) {
    for (const double x : unit_normal(soup, triangle)) out.little_endian(static_cast<float>(x));
    for (std::size_t i = 0; i < 3; ++i) {
      for (const double x : corner(soup, triangle, i)) out.little_endian(static_cast<float>(x));
    }
    out.little_endian(std::uint16_t{0});
  }
}

void write_stl_text(Output& out, const TriangleSoup& soup) {
  out << "solid loopmend\n";
  for (const Triangle& triangle : soup.triangles) {
    const Eigen::Vector3f n = unit_normal(soup, triangle).cast<float>();  // readers compute it anew: keep it short
    out << "facet normal " << n[0] << ' ' << n[1] << ' ' << n[2] << "\n outer loop\n";
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = corner(soup, triangle, i);
      out << "  vertex " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    }
    out << " endloop\nendfacet\n";
  }
  out << "endsolid loopmend\n";
}

void write_stl(Output& out, const TriangleSoup& soup, Encoding encoding) {
  if (encoding == Encoding::binary) {
    write_stl_binary(out, soup);
  } else {
    write_stl_text(out, soup);
  }
}

void write_obj(Output& out, const TriangleSoup& soup) {
  out << "# Loopmend\n";
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    const Vec3& p = soup.points[v];
    out << "v " << p[0] << ' ' << p[1] << ' ' << p[2];
    if (!soup.colors.empty()) {
      for (std::size_t c = 0; c < 3; ++c) out << ' ' << soup.colors[v][c] / 255.0;  // the format knows no alpha
    }
    out << '\n';
  }
  for (const Triangle& t : soup.triangles) out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
}

void write_off(Output& out, const TriangleSoup& soup) {
  out << (soup.colors.empty() ? "OFF\n" : "COFF\n");
  out << soup.points.size() << ' ' << soup.triangles.size() << " 0\n";
  write_ply_text(out, soup);  // the rows are the same
}

/// Binary STL holds floats: a coordinate beyond their range would become infinite.
void require_float_range(const std::filesystem::path& path, const TriangleSoup& soup) {
  for (const Vec3& point : soup.points) {
    if (std::isfinite(static_cast<float>(point.cwiseAbs().maxCoeff()))) continue;
    throw WriteError(path, "the coordinates are too large for binary STL", "Save as PLY, or scale the mesh down.");
  }
}

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = ascii_lower(c);
  return extension;
}

enum class Format { ply, stl, obj, off };

Format format_of(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".ply") return Format::ply;
  if (extension == ".stl") return Format::stl;
  if (extension == ".obj") return Format::obj;
  if (extension == ".off") return Format::off;
  throw WriteError(path, extension.empty() ? "the name has no extension" : "unknown format \"" + extension + "\"",
                   "Choose a name that ends in .ply, .stl, .obj or .off.");
}

}  // namespace

void check_mesh_writable(const std::filesystem::path& path) {
  format_of(path);
  check_writable(path);
}

namespace {

void write_soup(std::ostream& stream, Format format, const TriangleSoup& soup, Encoding encoding) {
  Output out(stream);
  switch (format) {
    case Format::ply: return write_ply(out, soup, encoding);
    case Format::stl: return write_stl(out, soup, encoding);
    case Format::obj: return write_obj(out, soup);
    case Format::off: return write_off(out, soup);
  }
}

/// The writer for this path, once it is clear that the soup can be written there.
std::function<void(std::ostream&)> writer_for(const std::filesystem::path& path, const TriangleSoup& soup,
                                              Encoding encoding) {
  require_valid(soup);
  const Format format = format_of(path);
  if (format == Format::stl && encoding == Encoding::binary) require_float_range(path, soup);
  return [&soup, format, encoding](std::ostream& stream) { write_soup(stream, format, soup, encoding); };
}

}  // namespace

void write_mesh(const std::filesystem::path& path, const TriangleSoup& soup, Encoding encoding) {
  write_file_atomically(path, writer_for(path, soup, encoding));
}

void write_mesh(OutputTransaction& outputs, const std::filesystem::path& path, const TriangleSoup& soup,
                Encoding encoding) {
  outputs.add(path, writer_for(path, soup, encoding));
}

std::vector<NotKept> not_kept_by_format(const std::filesystem::path& path, const TriangleSoup& soup) {
  std::vector<NotKept> list;
  const Format format = format_of(path);
  if (format == Format::obj) {
    const auto see_through = [](const Color& color) { return color[3] != 255; };
    const auto count = std::count_if(soup.colors.begin(), soup.colors.end(), see_through);
    count_not_kept(list, "alpha values", static_cast<std::size_t>(count));
  }
  if (format != Format::stl) return list;
  std::vector<char> used(soup.points.size(), 0);
  for (const Triangle& triangle : soup.triangles)
    for (const int v : triangle) used[static_cast<std::size_t>(v)] = 1;
  count_not_kept(list, "vertex colours", soup.colors.size());
  count_not_kept(list, "vertices without faces", static_cast<std::size_t>(std::count(used.begin(), used.end(), 0)));
  return list;
}

double largest_rounding(const std::filesystem::path& path, std::span<const Vec3> points, Encoding encoding) {
  if (format_of(path) != Format::stl || encoding != Encoding::binary) return 0;
  double largest = 0;
  for (const Vec3& point : points) largest = std::max(largest, (point.cast<float>().cast<double>() - point).norm());
  return largest;
}

}  // namespace loopmend
