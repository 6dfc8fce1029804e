// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/format_writers.h"
#include "io/ply_values.h"

#include <vector>

namespace loopmend {

namespace {

bool has_colors(const std::vector<AttributeColumn>& columns) {
  return std::any_of(columns.begin(), columns.end(),
                     [](const AttributeColumn& column) { return role_of(column.name()) == AttributeRole::color; });
}

/// Null for a corner without one.
const double* corner_value(const CornerValues& values, int corner) {
  if (corner < 0 || values.dimension == 0) return nullptr;
  const int at = values.at[corner];
  return at < 0 ? nullptr : &values.values[static_cast<std::size_t>(at) * static_cast<std::size_t>(values.dimension)];
}

class PlyWriter {
 public:
  PlyWriter(Output& out, const TriangleSoup& soup, Encoding encoding)
      : out_(out),
        values_(out, encoding),
        soup_(soup),
        encoding_(encoding),
        scan_(attributes_of(soup)),
        has_own_colors_(!soup.colors.empty() && !has_colors(scan_.points)) {
    if (!soup.continued) return;
    more_point_columns_ = beyond(soup.continued->points, scan_.points.size());
    more_face_columns_ = beyond(soup.continued->faces, scan_.faces.size());
  }

  void write() {
    write_header();
    PointRows rows(soup_);
    for (std::size_t v = 0; v < soup_.points.size(); ++v) {
      for (const double x : soup_.points[v]) values_.put(scan_.coordinates, x);
      const AttributeRow row = rows.next();
      write_columns(scan_.points, row, &ScanAttributes::points);
      write_more(more_point_columns_, row);
      if (has_own_colors_)
        for (const unsigned char channel : soup_.colors[v]) values_.put(ScalarType::uint8, channel);
      values_.end_row();
    }
    for_each_face(soup_, [&](const WrittenFace& face) {
      values_.put(count_type_, static_cast<double>(face.vertices.size()));
      for (const int v : face.vertices) values_.put(ScalarType::int32, v);
      write_columns(scan_.faces, face.row, &ScanAttributes::faces);
      write_more(more_face_columns_, face.row);
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
  static std::vector<AttributeColumn> beyond(const std::vector<AttributeColumn>& columns, std::size_t count) {
    return {columns.begin() + static_cast<std::ptrdiff_t>(std::min(count, columns.size())), columns.end()};
  }

  void write_header() {
    out_ << "ply\nformat " << (encoding_ == Encoding::binary ? "binary_little_endian" : "ascii") << " 1.0\n";
    out_ << remark_of_loopmend << '\n';
    const bool has_more = soup_.continued && !soup_.continued->remarks.empty();
    for (const std::string& remark : has_more ? soup_.continued->remarks : scan_.remarks)
      if (remark != remark_of_loopmend) out_ << remark << '\n';
    out_ << "element vertex " << soup_.points.size() << '\n';
    for (const char* name : {"x", "y", "z"}) out_ << "property " << ply_name(scan_.coordinates) << ' ' << name << '\n';
    write_properties(scan_.points);
    write_properties(more_point_columns_);
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
    write_properties(more_face_columns_);
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

  void write_more(const std::vector<AttributeColumn>& columns, const AttributeRow& row) {
    for (const AttributeColumn& column : columns)
      values_.put(column, row.table == soup_.continued.get() && row.table != nullptr, row.row);
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
  std::vector<AttributeColumn> more_point_columns_, more_face_columns_;  ///< of what is new alone; 0 for the others
  ScalarType count_type_ = ScalarType::uint8;
};

}  // namespace

void write_ply(Output& out, const TriangleSoup& soup, Encoding encoding) { PlyWriter(out, soup, encoding).write(); }

}  // namespace loopmend
