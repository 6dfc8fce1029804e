// SPDX-License-Identifier: GPL-3.0-or-later
// What a file holds beside points, faces and display colours, kept as it was read so that it can be written again.
#pragma once

#include "core/types.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace loopmend {

struct MaterialTable;

enum class ScalarType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_in_bytes(ScalarType type);
bool is_integer(ScalarType type);
bool is_signed(ScalarType type);

/// One property of all points, faces or other rows, every value in the type of the file. Every type fits into a double.
class AttributeColumn {
 public:
  /// @param count_type  of the numbers of items, for a column of lists
  AttributeColumn(std::string name, ScalarType type, std::optional<ScalarType> count_type = {});

  const std::string& name() const { return name_; }
  ScalarType type() const { return type_; }
  std::optional<ScalarType> count_type() const { return count_type_; }
  bool is_list() const { return count_type_.has_value(); }

  std::size_t rows() const;
  std::size_t items(std::size_t row) const { return is_list() ? ends_[row] - begin(row) : 1; }
  double value(std::size_t row, std::size_t item = 0) const;

  /// Rounded and clamped to the type where it is one of integers; a number that is none becomes 0 there.
  void push(double value);
  /// One more item of the list that end_list() closes.
  void push_item(double value) { append(value); }
  void end_list() { ends_.push_back(bytes_.size() / size_in_bytes(type_)); }
  void reserve(std::size_t rows);
  void pop_row();

 private:
  std::size_t begin(std::size_t row) const { return row == 0 ? 0 : ends_[row - 1]; }
  void append(double value);

  std::string name_;
  ScalarType type_;
  std::optional<ScalarType> count_type_;
  std::vector<std::byte> bytes_;
  std::vector<std::size_t> ends_;  ///< of lists: per row, in items
};

/// A table of values, and which of them each corner of each face has: texture coordinates and normals of OBJ.
struct CornerValues {
  int dimension = 0;           ///< numbers per value; 0: the file has none
  std::vector<double> values;  ///< all of them, also those that no corner uses
  std::vector<int> at;         ///< per corner of the file's faces, one face after the other; −1: none

  std::size_t count() const { return dimension > 0 ? values.size() / static_cast<std::size_t>(dimension) : 0; }
};

/// Names that faces have under one keyword: materials, groups, objects, smoothing groups.
struct FaceNames {
  std::string keyword;             ///< "usemtl", "g", "o", "s", "solid"
  std::vector<std::string> names;  ///< in the order of the file
  std::vector<int> of_face;        ///< per face of the file; −1: none yet
};

/// Rows of a PLY element that is neither vertex nor face.
struct OtherElement {
  std::string name;
  std::size_t rows = 0;
  std::vector<AttributeColumn> columns;
};

/// Rows of points and faces are numbered as in the file; TriangleSoup says which of them its points and triangles have.
struct ScanAttributes {
  std::string format;                            ///< of the file: "PLY", "STL", "OBJ", "OFF", "glTF", "3MF" or "VTK"
  std::filesystem::path file;                    ///< absolute; material files are looked for in its folder
  ScalarType coordinates = ScalarType::float64;  ///< float32 where the file says so
  std::vector<AttributeColumn> points, faces;
  std::vector<std::string>
      remarks;  ///< of a PLY header: "comment …", "obj_info …"; of `continued`: as material_libraries
  std::vector<OtherElement> elements;
  CornerValues texture, normals;
  std::vector<FaceNames> names;
  std::vector<std::string> material_libraries;  ///< of `continued`: all that are to be named, unless it has none
  /// Of glTF and 3MF, null for others; of `continued`: the one to be written, unless it has none.
  std::shared_ptr<const MaterialTable> materials;
  std::string unit;    ///< "meter" in glTF; 3MF: "millimeter" and others; empty: not known
  std::string header;  ///< binary STL: its 80 bytes
  std::size_t point_count = 0, triangle_count = 0;

  /// The faces of the file; no ends where all are triangles, null where they are not needed.
  std::vector<int> corners;
  std::vector<std::size_t> ends;
  /// Where some are no triangles: which face each triangle comes from, and the triangles.
  std::vector<int> face_of;
  Triangles triangles;

  std::size_t face_of_triangle(std::size_t row) const {
    return face_of.empty() ? row : static_cast<std::size_t>(face_of[row]);
  }
  std::size_t first_corner(std::size_t face) const {
    return ends.empty() ? 3 * face : (face == 0 ? 0 : ends[face - 1]);
  }
  std::size_t corner_end(std::size_t face) const { return ends.empty() ? 3 * face + 3 : ends[face]; }
};

/// The column of that name; null where there is none.
const AttributeColumn* find_column(const std::vector<AttributeColumn>& columns, std::string_view name);

/// What a column of numbers stands for, by the names that exporters use.
enum class AttributeRole {
  color,   ///< red, green, blue, alpha under their usual names
  normal,  ///< nx, ny, nz
  other
};
AttributeRole role_of(std::string_view name);

/// Whether values between those of two rows say something: colours, and numbers with fractions.
bool is_smooth(const AttributeColumn& column);

/// Adds the value or list of a row of `from`; of no row, which is −1, 0 or an empty list.
void copy_row(const AttributeColumn& from, int row, AttributeColumn& to);

}  // namespace loopmend
