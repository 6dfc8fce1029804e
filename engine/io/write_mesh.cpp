// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_mesh.h"

#include "core/error.h"
#include "io/atomic_file.h"
#include "io/gzip.h"
#include "io/not_kept.h"
#include "io/text_cursor.h"
#include "io/written_rows.h"
#include "mesh/scan_attributes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

/// Gathers text and bytes and passes them on in large pieces. Numbers are the shortest that read back as the same bits.
class Output {
 public:
  /// @param gzip  null: not compressed
  Output(std::ostream& stream, GzipWriter* gzip) : stream_(stream), gzip_(gzip) {}
  ~Output() {
    pass_on();
    if (gzip_) gzip_->finish();
  }
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
  Output& operator<<(std::int64_t value) { return number(value); }

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
    if (gzip_)
      gzip_->write(piece_);
    else
      stream_.write(piece_.data(), static_cast<std::streamsize>(piece_.size()));
    piece_.clear();
  }

  std::ostream& stream_;
  GzipWriter* gzip_;
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

/// What the file held beside; an empty table where there is none.
const ScanAttributes& attributes_of(const TriangleSoup& soup) {
  static const ScanAttributes none;
  return soup.attributes ? *soup.attributes : none;
}

bool has_rows(const CornerValues& values) { return values.count() > 0 && !values.at.empty(); }

bool has_colors(const std::vector<AttributeColumn>& columns) {
  return std::any_of(columns.begin(), columns.end(),
                     [](const AttributeColumn& column) { return role_of(column.name()) == AttributeRole::color; });
}

/// The faces of a PLY file may have a list of that name already.
bool writes_texture(const ScanAttributes& scan) {
  return has_rows(scan.texture) && !find_column(scan.faces, "texcoord");
}

/// Their numbers of vertices hold only while the points are where they were.
bool keeps_elements(const TriangleSoup& soup) { return soup.attributes && soup.point_rows.empty(); }

/// Null for a corner without one.
const double* corner_value(const CornerValues& values, int corner) {
  if (corner < 0 || values.dimension == 0) return nullptr;
  const int at = values.at[static_cast<std::size_t>(corner)];
  return at < 0 ? nullptr : &values.values[static_cast<std::size_t>(at) * static_cast<std::size_t>(values.dimension)];
}

const FaceNames* find_names(const ScanAttributes& scan, std::string_view keyword) {
  const auto found =
      std::find_if(scan.names.begin(), scan.names.end(), [&](const FaceNames& n) { return n.keyword == keyword; });
  return found == scan.names.end() ? nullptr : &*found;
}

/// The place of the column that becomes the two bytes behind each facet.
std::optional<std::size_t> find_stl_attribute(const ScanAttributes& scan) {
  for (std::size_t k = 0; k < scan.faces.size(); ++k)
    if (scan.faces[k].name() == "attribute" && scan.faces[k].type() == ScalarType::uint16 && !scan.faces[k].is_list())
      return k;
  return {};
}

const char* ply_name(ScalarType type) {
  switch (type) {
    case ScalarType::int8: return "char";
    case ScalarType::uint8: return "uchar";
    case ScalarType::int16: return "short";
    case ScalarType::uint16: return "ushort";
    case ScalarType::int32: return "int";
    case ScalarType::uint32: return "uint";
    case ScalarType::float32: return "float";
    case ScalarType::float64: break;
  }
  return "double";
}

/// One value after the other in the types of a PLY file, binary or as text.
class PlyValues {
 public:
  PlyValues(Output& out, Encoding encoding) : out_(out), encoding_(encoding) {}

  void put(ScalarType type, double value) {
    if (encoding_ == Encoding::ascii) return put_text(type, value);
    switch (type) {
      case ScalarType::int8: return out_.little_endian(static_cast<std::int8_t>(value));
      case ScalarType::uint8: return out_.little_endian(static_cast<std::uint8_t>(value));
      case ScalarType::int16: return out_.little_endian(static_cast<std::int16_t>(value));
      case ScalarType::uint16: return out_.little_endian(static_cast<std::uint16_t>(value));
      case ScalarType::int32: return out_.little_endian(static_cast<std::int32_t>(value));
      case ScalarType::uint32: return out_.little_endian(static_cast<std::uint32_t>(value));
      case ScalarType::float32: return out_.little_endian(static_cast<float>(value));
      case ScalarType::float64: return out_.little_endian(value);
    }
  }

  /// A row of the column; without one, a list of none or a 0.
  void put(const AttributeColumn& column, bool has_row, std::size_t row) {
    const std::size_t items = has_row ? column.items(row) : (column.is_list() ? 0 : 1);
    if (column.is_list()) put(*column.count_type(), static_cast<double>(items));
    for (std::size_t k = 0; k < items; ++k) put(column.type(), has_row ? column.value(row, k) : 0);
  }

  void end_row() {
    if (encoding_ == Encoding::ascii) out_ << '\n';
    first_ = true;
  }

 private:
  void put_text(ScalarType type, double value) {
    if (!std::exchange(first_, false)) out_ << ' ';
    if (type == ScalarType::float32)
      out_ << static_cast<float>(value);
    else if (type == ScalarType::float64)
      out_ << value;
    else
      out_ << static_cast<std::int64_t>(value);
  }

  Output& out_;
  Encoding encoding_;
  bool first_ = true;
};

class PlyWriter {
 public:
  PlyWriter(Output& out, const TriangleSoup& soup, Encoding encoding)
      : out_(out),
        values_(out, encoding),
        soup_(soup),
        encoding_(encoding),
        scan_(attributes_of(soup)),
        has_own_colors_(!soup.colors.empty() && !has_colors(scan_.points)) {}

  void write() {
    write_header();
    PointRows rows(soup_);
    for (std::size_t v = 0; v < soup_.points.size(); ++v) {
      for (const double x : soup_.points[v]) values_.put(scan_.coordinates, x);
      write_columns(scan_.points, rows.next(), &ScanAttributes::points);
      if (has_own_colors_)
        for (const unsigned char channel : soup_.colors[v]) values_.put(ScalarType::uint8, channel);
      values_.end_row();
    }
    for_each_face(soup_, [&](const WrittenFace& face) {
      values_.put(count_type_, static_cast<double>(face.vertices.size()));
      for (const int v : face.vertices) values_.put(ScalarType::int32, v);
      write_columns(scan_.faces, face.row, &ScanAttributes::faces);
      if (writes_texture(scan_)) write_texture(face);
      values_.end_row();
    });
    if (!keeps_elements(soup_)) return;
    for (const OtherElement& element : scan_.elements)
      for (std::size_t row = 0; row < element.rows; ++row) {
        for (const AttributeColumn& column : element.columns) values_.put(column, true, row);
        values_.end_row();
      }
  }

 private:
  void write_header() {
    out_ << "ply\nformat " << (encoding_ == Encoding::binary ? "binary_little_endian" : "ascii") << " 1.0\n";
    constexpr std::string_view ours = "comment Loopmend";
    out_ << ours << '\n';
    for (const std::string& remark : scan_.remarks)
      if (remark != ours) out_ << remark << '\n';
    out_ << "element vertex " << soup_.points.size() << '\n';
    for (const char* name : {"x", "y", "z"}) out_ << "property " << ply_name(scan_.coordinates) << ' ' << name << '\n';
    write_properties(scan_.points);
    if (has_own_colors_)
      for (const char* name : {"red", "green", "blue", "alpha"}) out_ << "property uchar " << name << '\n';
    std::size_t faces = 0, largest = 0;
    for_each_face(soup_, [&](const WrittenFace& face) {
      ++faces;
      largest = std::max(largest, face.vertices.size());
    });
    if (2 * largest > 255) count_type_ = ScalarType::int32;  // of the texture coordinates, too
    out_ << "element face " << faces << "\nproperty list " << ply_name(count_type_) << " int vertex_indices\n";
    write_properties(scan_.faces);
    if (writes_texture(scan_)) out_ << "property list " << ply_name(count_type_) << " float texcoord\n";
    if (keeps_elements(soup_))
      for (const OtherElement& element : scan_.elements) {
        out_ << "element " << element.name << ' ' << element.rows << '\n';
        write_properties(element.columns);
      }
    out_ << "end_header\n";
  }

  void write_properties(const std::vector<AttributeColumn>& columns) {
    for (const AttributeColumn& column : columns) {
      out_ << "property ";
      if (column.is_list()) out_ << "list " << ply_name(*column.count_type()) << ' ';
      out_ << ply_name(column.type()) << ' ' << column.name() << '\n';
    }
  }

  void write_columns(const std::vector<AttributeColumn>& columns, const AttributeRow& row,
                     std::vector<AttributeColumn> ScanAttributes::*table) {
    for (std::size_t k = 0; k < columns.size(); ++k)
      values_.put(row.table ? (row.table->*table)[k] : columns[k], row.table != nullptr, row.row);
  }

  /// Of OBJ, as MeshLab has them in PLY: two numbers for each corner.
  void write_texture(const WrittenFace& face) {
    const bool has_all = std::all_of(face.corners.begin(), face.corners.end(), [&](int corner) {
      return corner_value(face.row.table->texture, corner) != nullptr;
    });
    const std::size_t corners = has_all ? face.corners.size() : 0;
    values_.put(count_type_, static_cast<double>(2 * corners));
    for (std::size_t k = 0; k < corners; ++k)
      for (int c = 0; c < 2; ++c)
        values_.put(ScalarType::float32, c < face.row.table->texture.dimension
                                             ? corner_value(face.row.table->texture, face.corners[k])[c]
                                             : 0);
  }

  Output& out_;
  PlyValues values_;
  const TriangleSoup& soup_;
  Encoding encoding_;
  const ScanAttributes& scan_;
  bool has_own_colors_;
  ScalarType count_type_ = ScalarType::uint8;
};

void write_stl_binary(Output& out, const TriangleSoup& soup) {
  const ScanAttributes& scan = attributes_of(soup);
  std::string header = "Loopmend binary STL";  // must not begin with "solid"
  // Header and attributes belong together: by some conventions the one says what the other's bits mean.
  if (!scan.header.empty() && scan.header.substr(0, 5) != "solid") header = scan.header;
  header.resize(80, ' ');
  out << std::string_view(header);
  out.little_endian(static_cast<std::uint32_t>(soup.triangles.size()));
  const auto column = find_stl_attribute(scan);
  std::size_t new_triangles = 0;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const Triangle& triangle = soup.triangles[f];
    for (const double x : unit_normal(soup, triangle)) out.little_endian(static_cast<float>(x));
    for (std::size_t i = 0; i < 3; ++i) {
      for (const double x : corner(soup, triangle, i)) out.little_endian(static_cast<float>(x));
    }
    double attribute = 0;
    const int row = triangle_row(soup, f);
    if (column && row >= 0) attribute = scan.faces[*column].value(scan.face_of_triangle(static_cast<std::size_t>(row)));
    if (column && row < 0 && soup.continued) attribute = soup.continued->faces[*column].value(new_triangles);
    new_triangles += row < 0 ? 1 : 0;
    out.little_endian(static_cast<std::uint16_t>(attribute));
  }
}

/// What a face is called under a keyword; −1: nothing.
int name_of(const FaceNames& names, const AttributeRow& row) {
  if (!row.table) return -1;
  for (const FaceNames& mine : row.table->names)
    if (mine.keyword == names.keyword) return row.row < mine.of_face.size() ? mine.of_face[row.row] : -1;
  return -1;
}

void write_stl_text(Output& out, const TriangleSoup& soup) {
  const FaceNames* solids = find_names(attributes_of(soup), "solid");
  std::string name = " loopmend";
  bool open = false;
  const auto close = [&] {
    if (std::exchange(open, false)) out << "endsolid" << name << '\n';
  };
  int solid = -1;
  std::size_t new_triangles = 0;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const Triangle& triangle = soup.triangles[f];
    if (solids) {
      const int row = triangle_row(soup, f);
      AttributeRow place;
      if (row >= 0)
        place = {soup.attributes.get(), soup.attributes->face_of_triangle(static_cast<std::size_t>(row))};
      else
        place = {soup.continued.get(), new_triangles++};
      if (const int next = name_of(*solids, place); next >= 0 && next != solid) {
        close();
        solid = next;
        name = solids->names[static_cast<std::size_t>(solid)];
      }
    }
    if (!std::exchange(open, true)) out << "solid" << name << '\n';
    const Eigen::Vector3f n = unit_normal(soup, triangle).cast<float>();  // readers compute it anew: keep it short
    out << "facet normal " << n[0] << ' ' << n[1] << ' ' << n[2] << "\n outer loop\n";
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = corner(soup, triangle, i);
      out << "  vertex " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    }
    out << " endloop\nendfacet\n";
  }
  if (soup.triangles.empty()) out << "solid" << name << '\n', open = true;
  close();
}

class ObjWriter {
 public:
  ObjWriter(Output& out, const TriangleSoup& soup)
      : out_(out),
        soup_(soup),
        scan_(attributes_of(soup)),
        normals_per_point_(!has_rows(scan_.normals) && find_column(scan_.points, "nx") &&
                           find_column(scan_.points, "ny") && find_column(scan_.points, "nz")) {}

  void write() {
    out_ << "# Loopmend\n";
    for (const std::string& library : scan_.material_libraries) out_ << "mtllib " << library << '\n';
    if (soup_.continued)
      for (const std::string& library : soup_.continued->material_libraries) out_ << "mtllib " << library << '\n';
    write_points();
    write_values("vt", &ScanAttributes::texture);
    if (!normals_per_point_) write_values("vn", &ScanAttributes::normals);
    for_each_face(soup_, [&](const WrittenFace& face) { write_face(face); });
  }

 private:
  void write_points() {
    for (std::size_t v = 0; v < soup_.points.size(); ++v) {
      const Vec3& p = soup_.points[v];
      out_ << "v " << p[0] << ' ' << p[1] << ' ' << p[2];
      if (!soup_.colors.empty()) {
        for (std::size_t c = 0; c < 3; ++c) out_ << ' ' << soup_.colors[v][c] / 255.0;  // the format knows no alpha
      }
      out_ << '\n';
    }
    if (!normals_per_point_) return;
    PointRows rows(soup_);
    for (std::size_t v = 0; v < soup_.points.size(); ++v) {
      const AttributeRow row = rows.next();
      out_ << "vn";
      for (const char* name : {"nx", "ny", "nz"})
        out_ << ' ' << (row.table ? find_column(row.table->points, name)->value(row.row) : 0);
      out_ << '\n';
    }
  }

  void write_values(const char* keyword, CornerValues ScanAttributes::*values) {
    for (const ScanAttributes* table : {&scan_, soup_.continued.get()}) {
      if (!table) continue;
      const CornerValues& all = table->*values;
      for (std::size_t k = 0; k < all.count(); ++k) {
        out_ << keyword;
        for (int c = 0; c < all.dimension; ++c)
          out_ << ' ' << all.values[k * static_cast<std::size_t>(all.dimension) + static_cast<std::size_t>(c)];
        out_ << '\n';
      }
    }
  }

  void write_face(const WrittenFace& face) {
    for (std::size_t k = 0; k < scan_.names.size(); ++k) {
      const FaceNames& names = scan_.names[k];
      if (names.keyword == "solid") continue;
      now_.resize(scan_.names.size(), -1);
      const int mine = name_of(names, face.row);
      if (mine < 0 || mine == now_[k]) continue;
      now_[k] = mine;
      const std::vector<std::string>& words =
          face.row.table == &scan_ ? names.names : find_names(*face.row.table, names.keyword)->names;
      out_ << names.keyword;
      if (!words[static_cast<std::size_t>(mine)].empty()) out_ << ' ' << words[static_cast<std::size_t>(mine)];
      out_ << '\n';
    }
    out_ << 'f';
    for (std::size_t k = 0; k < face.vertices.size(); ++k) {
      out_ << ' ' << face.vertices[k] + 1;
      const int texture = number(face, k, &ScanAttributes::texture);
      const int normal = normals_per_point_ ? face.vertices[k] + 1 : number(face, k, &ScanAttributes::normals);
      if (texture > 0 || normal > 0) out_ << '/';
      if (texture > 0) out_ << texture;
      if (normal > 0) out_ << '/' << normal;
    }
    out_ << '\n';
  }

  /// Of a corner's value in the file, from 1; 0: none. A face has it at all corners or at none.
  int number(const WrittenFace& face, std::size_t k, CornerValues ScanAttributes::*values) const {
    if (face.corners.empty()) return 0;
    const CornerValues& mine = face.row.table->*values;
    if (mine.dimension == 0) return 0;
    for (const int corner : face.corners)
      if (corner < 0 || mine.at[static_cast<std::size_t>(corner)] < 0) return 0;
    const int first = face.row.table == &scan_ ? 1 : 1 + static_cast<int>((scan_.*values).count());
    return first + mine.at[static_cast<std::size_t>(face.corners[k])];
  }

  Output& out_;
  const TriangleSoup& soup_;
  const ScanAttributes& scan_;
  bool normals_per_point_;
  std::vector<int> now_;  // per keyword
};

void write_off(Output& out, const TriangleSoup& soup) {
  const ScanAttributes& scan = attributes_of(soup);
  const bool has_normals =
      find_column(scan.points, "nx") && find_column(scan.points, "ny") && find_column(scan.points, "nz");
  const bool has_texture = find_column(scan.points, "s") && find_column(scan.points, "t");
  const bool has_colors = !soup.colors.empty();
  const AttributeColumn* face_color = scan.format == "OFF" ? find_column(scan.faces, "color") : nullptr;
  out << (has_texture ? "ST" : "") << (has_colors ? "C" : "") << (has_normals ? "N" : "") << "OFF\n";
  std::size_t faces = 0;
  for_each_face(soup, [&](const WrittenFace&) { ++faces; });
  out << soup.points.size() << ' ' << faces << " 0\n";
  PointRows rows(soup);
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    const AttributeRow row = rows.next();
    const auto put = [&](const char* name) {
      out << ' ' << (row.table ? find_column(row.table->points, name)->value(row.row) : 0);
    };
    const Vec3& p = soup.points[v];
    out << p[0] << ' ' << p[1] << ' ' << p[2];
    if (has_normals)
      for (const char* name : {"nx", "ny", "nz"}) put(name);
    if (has_colors)
      for (const unsigned char channel : soup.colors[v]) out << ' ' << static_cast<int>(channel);
    if (has_texture)
      for (const char* name : {"s", "t"}) put(name);
    out << '\n';
  }
  for_each_face(soup, [&](const WrittenFace& face) {
    out << face.vertices.size();
    for (const int v : face.vertices) out << ' ' << v;
    if (face_color && face.row.table) {
      const AttributeColumn& column = *find_column(face.row.table->faces, "color");
      for (std::size_t k = 0; k < column.items(face.row.row); ++k) out << ' ' << column.value(face.row.row, k);
    }
    out << '\n';
  });
}

/// Binary STL holds floats: a coordinate beyond their range would become infinite.
void require_float_range(const std::filesystem::path& path, const TriangleSoup& soup) {
  for (const Vec3& point : soup.points) {
    if (std::isfinite(static_cast<float>(point.cwiseAbs().maxCoeff()))) continue;
    throw WriteError(path, "the coordinates are too large for binary STL", "Save as PLY, or scale the mesh down.");
  }
}

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = without_gzip_name(path).extension().string();
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
                   "Choose a name that ends in .ply, .stl, .obj or .off, compressed .ply.gz and so on.");
}

}  // namespace

void check_mesh_writable(const std::filesystem::path& path) {
  format_of(path);
  check_writable(path);
}

namespace {

void write_soup(std::ostream& stream, GzipWriter* gzip, Format format, const TriangleSoup& soup, Encoding encoding) {
  Output out(stream, gzip);
  switch (format) {
    case Format::ply: return PlyWriter(out, soup, encoding).write();
    case Format::stl: return encoding == Encoding::binary ? write_stl_binary(out, soup) : write_stl_text(out, soup);
    case Format::obj: return ObjWriter(out, soup).write();
    case Format::off: return write_off(out, soup);
  }
}

/// The writer for this path, once it is clear that the soup can be written there.
std::function<void(std::ostream&)> writer_for(const std::filesystem::path& path, const TriangleSoup& soup,
                                              Encoding encoding) {
  require_valid(soup);
  const Format format = format_of(path);
  if (format == Format::stl && encoding == Encoding::binary) require_float_range(path, soup);
  return [&soup, format, encoding, compressed = has_gzip_name(path)](std::ostream& stream) {
    if (!compressed) return write_soup(stream, nullptr, format, soup, encoding);
    GzipWriter gzip(stream);
    write_soup(stream, &gzip, format, soup, encoding);
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

namespace {

/// What a column holds, in words. Columns that belong together share theirs.
std::string words_for(const std::string& element, const AttributeColumn& column, const std::string& format) {
  const auto is_one_of = [&](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), column.name()) != names.end();
  };
  const bool of_faces = element == "face";
  if (role_of(column.name()) == AttributeRole::normal) return of_faces ? "face normals" : "normals";
  if (is_one_of({"s", "t", "u", "v", "texture_u", "texture_v", "texcoord"}))
    return of_faces ? "texture coordinates of faces" : "texture coordinates";
  if (of_faces && (role_of(column.name()) == AttributeRole::color || (format == "OFF" && column.name() == "color")))
    return "face colours";
  if (of_faces && format == "STL") return "face attributes";
  return element + " properties \"" + column.name() + "\"";
}

const char* words_for_names(std::string_view keyword) {
  if (keyword == "usemtl") return "materials";
  if (keyword == "o") return "objects";
  if (keyword == "s") return "smoothing groups";
  return keyword == "solid" ? "separate solids" : "groups";
}

/// What a file has room for; without a format, nothing.
struct Room {
  std::optional<Format> format;
  Encoding encoding = Encoding::binary;

  bool is(Format other) const { return format == other; }
};

/// Colours of vertices are said by themselves.
bool holds(const Room& room, const TriangleSoup& soup, bool of_faces, const AttributeColumn& column) {
  const ScanAttributes& scan = attributes_of(soup);
  const std::string& name = column.name();
  const AttributeRole role = role_of(name);
  if (room.is(Format::ply)) return true;
  if (!of_faces && role == AttributeRole::color && !soup.colors.empty()) return true;
  if (room.is(Format::stl)) {
    const auto attribute = find_stl_attribute(scan);
    return of_faces && room.encoding == Encoding::binary && attribute && &scan.faces[*attribute] == &column;
  }
  if (room.is(Format::off) && of_faces) return scan.format == "OFF" && name == "color";
  if (room.is(Format::off) && (name == "s" || name == "t")) return true;
  return (room.is(Format::off) || room.is(Format::obj)) && !of_faces && role == AttributeRole::normal;
}

void add_columns(std::vector<NotKept>& list, const Room& room, const TriangleSoup& soup, bool of_faces) {
  const ScanAttributes& scan = attributes_of(soup);
  for (const AttributeColumn& column : of_faces ? scan.faces : scan.points) {
    if (holds(room, soup, of_faces, column)) continue;
    const std::string words = words_for(of_faces ? "face" : "vertex", column, scan.format);
    const bool known = std::any_of(list.begin(), list.end(), [&](const NotKept& entry) { return entry.what == words; });
    if (!known) count_not_kept(list, words, column.rows());
  }
}

std::size_t count_names(const FaceNames& names) {
  return static_cast<std::size_t>(std::count_if(names.names.begin(), names.names.end(), [&](const std::string& name) {
    return !(names.keyword == "s" && (name == "off" || name == "0"));
  }));
}

void add_attributes(std::vector<NotKept>& list, const Room& room, const TriangleSoup& soup) {
  const ScanAttributes& scan = attributes_of(soup);
  add_columns(list, room, soup, false);
  add_columns(list, room, soup, true);
  const bool obj = room.is(Format::obj), ply = room.is(Format::ply);
  if (!obj && !(ply && writes_texture(scan))) count_not_kept(list, "texture coordinates", scan.texture.count());
  if (!obj) count_not_kept(list, "normals", scan.normals.count());
  for (const FaceNames& names : scan.names) {
    const bool solid = names.keyword == "solid";
    const bool kept = solid ? room.is(Format::stl) && room.encoding == Encoding::ascii : obj;
    const std::size_t count = count_names(names);
    if (!kept && !(solid && count <= 1)) count_not_kept(list, words_for_names(names.keyword), count);
  }
  if (!obj) count_not_kept(list, "material libraries", scan.material_libraries.size());
  if (!(ply && keeps_elements(soup)))
    for (const OtherElement& element : scan.elements)
      count_not_kept(list, "elements \"" + element.name + "\"", element.rows);
}

}  // namespace

std::vector<NotKept> not_kept_by_format(const std::filesystem::path& path, const TriangleSoup& soup,
                                        Encoding encoding) {
  std::vector<NotKept> list;
  const Format format = format_of(path);
  if (format == Format::obj) {
    const auto see_through = [](const Color& color) { return color[3] != 255; };
    const auto count = std::count_if(soup.colors.begin(), soup.colors.end(), see_through);
    count_not_kept(list, "alpha values", static_cast<std::size_t>(count));
  }
  if (format == Format::stl) {
    std::vector<char> used(soup.points.size(), 0);
    for (const Triangle& triangle : soup.triangles)
      for (const int v : triangle) used[static_cast<std::size_t>(v)] = 1;
    count_not_kept(list, "vertex colours", soup.colors.size());
    count_not_kept(list, "vertices without faces", static_cast<std::size_t>(std::count(used.begin(), used.end(), 0)));
  }
  add_attributes(list, {format, encoding}, soup);
  return list;
}

std::vector<NotKept> carried_attributes(const TriangleSoup& soup) {
  std::vector<NotKept> list;
  add_attributes(list, {}, soup);
  return list;
}

bool holds_floats(const std::filesystem::path& path, const TriangleSoup& soup, Encoding encoding) {
  const Format format = format_of(path);
  if (format == Format::stl) return encoding == Encoding::binary;
  return format == Format::ply && attributes_of(soup).coordinates == ScalarType::float32;
}

double largest_rounding(const std::filesystem::path& path, const TriangleSoup& soup, Encoding encoding,
                        std::size_t points) {
  if (!holds_floats(path, soup, encoding)) return 0;
  double largest = 0;
  for (const Vec3& point : std::span(soup.points).first(std::min(points, soup.points.size())))
    largest = std::max(largest, (point.cast<float>().cast<double>() - point).norm());
  return largest;
}

}  // namespace loopmend
