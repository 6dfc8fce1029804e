// SPDX-License-Identifier: GPL-3.0-or-later
// Which row of the scan's attributes each point, face and corner of a file has that is written.
#pragma once

#include "mesh/scan_attributes.h"
#include "mesh/triangle_soup.h"

#include <cstddef>
#include <functional>
#include <span>

namespace loopmend {

/// A row of a table; without a table there is nothing to say.
struct AttributeRow {
  const ScanAttributes* table = nullptr;
  std::size_t row = 0;
};

/// The rows of the points in their order: next() for one point after the other.
class PointRows {
 public:
  explicit PointRows(const TriangleSoup& soup) : soup_(soup) {}
  AttributeRow next();

 private:
  const TriangleSoup& soup_;
  std::size_t point_ = 0, new_points_ = 0;
};

/// A face as it is written: a polygon of the file where all of its triangles are as they were, else one triangle.
struct WrittenFace {
  std::span<const int> vertices;  ///< soup points
  AttributeRow row;               ///< of the table's faces
  std::span<const int> corners;   ///< for each vertex its corner in the table's CornerValues; −1: none
};

/// Calls `each` for all faces in their order.
void for_each_face(const TriangleSoup& soup, const std::function<void(const WrittenFace&)>& each);

/// The same for formats that hold triangles alone: also those of polygons, one by one.
void for_each_triangle(const TriangleSoup& soup, const std::function<void(const WrittenFace&)>& each);

}  // namespace loopmend
