// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles of a soup with all that glTF and 3MF say of them, and the groups in which these formats have them.
#pragma once

#include "io/written_rows.h"
#include "mesh/material_table.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace loopmend {

struct WrittenTriangle {
  std::array<int, 3> points{};                                  ///< of the soup
  std::array<int, 3> texture{-1, -1, -1}, normals{-1, -1, -1};  ///< in CornerNumbers; all three or none
  int object = -1, material = -1;                               ///< in object_names(), in the material table
  AttributeRow row;
};
std::vector<WrittenTriangle> written_triangles(const TriangleSoup& soup);

/// Corner values of the file, and after them those of `continued`.
class CornerNumbers {
 public:
  CornerNumbers(const TriangleSoup& soup, CornerValues ScanAttributes::*values);
  std::size_t old_count() const { return old_count_; }
  /// 0 where there are fewer numbers per value.
  double value(int at, int component) const;

 private:
  const CornerValues *old_ = nullptr, *continued_ = nullptr;
  std::size_t old_count_ = 0;
};

/// As "o" has them.
std::vector<std::string> object_names(const TriangleSoup& soup);
/// Of the table that is to be written, or of the names alone that faces have; empty where there are none.
MaterialTable written_materials(const TriangleSoup& soup);

}  // namespace loopmend
